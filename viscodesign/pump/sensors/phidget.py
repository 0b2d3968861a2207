"""The sensor on a Phidgets interface kit, by the vendor's library (extra `phidgets`)."""

from __future__ import annotations

import importlib
from types import ModuleType
from typing import Any

from viscodesign.errors import PumpError
from viscodesign.pump.sensors.base import PressureSource, SensorError

ATTACH_TIME_MS = 5000


class Phidget(PressureSource):
    """A ratio input of a Phidget interface kit."""

    def __init__(self, channel: int) -> None:
        library = _library("Phidget22.Devices.VoltageRatioInput")
        self._failure: type[Exception] = _library("Phidget22.PhidgetException").PhidgetException
        self._input: Any = None
        try:
            self._input = library.VoltageRatioInput()
            self._input.setChannel(channel)
            self._input.openWaitForAttachment(ATTACH_TIME_MS)
        except self._failure as error:
            self.close()
            raise SensorError(
                f"no Phidget interface kit found for channel {channel} ({error}). Is it "
                "plugged in, and does it have a udev rule?"
            ) from None
        except OSError as error:
            raise SensorError(
                f"the Phidgets library failed to start ({error}); it needs libusb-1.0: "
                "sudo apt install libusb-1.0-0"
            ) from None

    def ratio(self) -> float:
        try:
            return float(self._input.getVoltageRatio())
        except self._failure as error:
            raise SensorError(f"the Phidget interface kit does not answer ({error})") from None

    def close(self) -> None:
        if self._input is not None:
            self._input.close()
            self._input = None


def _library(name: str) -> ModuleType:
    try:
        return importlib.import_module(name)
    except ImportError:
        raise PumpError(
            "a pressure sensor on a Phidget interface kit needs the extra `phidgets`: "
            "pip install 'viscodesign[phidgets]'"
        ) from None
