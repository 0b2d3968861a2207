"""The sensor on a Phidgets interface kit, by the vendor's library (extra `phidgets`)."""

from __future__ import annotations

import contextlib
import importlib
from collections.abc import Callable, Iterator
from types import ModuleType

from viscodesign.errors import PumpError
from viscodesign.pump.sensors.base import SensorError, pressure_of

ATTACH_TIME_MS = 5000


@contextlib.contextmanager
def phidget_sensor(channel: int) -> Iterator[Callable[[], float]]:
    """What reads the absolute pressure [Pa] at a ratio input of a kit, released on leaving."""
    library = _library("Phidget22.Devices.VoltageRatioInput")
    failure: type[Exception] = _library("Phidget22.PhidgetException").PhidgetException

    def read() -> float:
        try:
            return pressure_of(float(ratio_input.getVoltageRatio()))
        except failure as error:
            raise SensorError(f"the Phidget interface kit does not answer ({error})") from None

    with contextlib.ExitStack() as opened:
        try:
            ratio_input = library.VoltageRatioInput()
            opened.callback(ratio_input.close)
            ratio_input.setChannel(channel)
            ratio_input.openWaitForAttachment(ATTACH_TIME_MS)
        except failure as error:
            raise SensorError(
                f"no Phidget interface kit found for channel {channel} ({error}). Is it "
                "plugged in, and does it have a udev rule?"
            ) from None
        except OSError as error:
            raise SensorError(
                f"the Phidgets library failed to start ({error}); it needs libusb-1.0: "
                "sudo apt install libusb-1.0-0"
            ) from None
        yield read


def _library(name: str) -> ModuleType:
    try:
        return importlib.import_module(name)
    except ImportError:
        raise PumpError(
            "a pressure sensor on a Phidget interface kit needs the extra `phidgets`: "
            "pip install 'viscodesign[phidgets]'"
        ) from None
