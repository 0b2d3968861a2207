"""Absolute pressure sensors: on an analog input of a board, or on an interface kit.

The sensor is the Phidgets 1140: kPa = ratio / 0.002421 + 3.478, with ratio = output over supply.
Source: the vendor's library (phidget22 3.26, sensor type 1140), whose figures agree with its
sensing element, MPXH6400A; that one's data sheet gives 1.5 % of span as its error, 0 to 85 degC,
and 0.2 to 4.8 V at 5 V.
"""

from __future__ import annotations

import contextlib
import importlib
from collections.abc import Callable, Iterator
from types import ModuleType

from viscodesign.errors import PumpError
from viscodesign.pump.boards.controller import Controller

SLOPE = 0.002421 / 1e3  # ratio for a pascal
OFFSET = 3.478e3  # [Pa]
LOWEST, HIGHEST = 20e3, 400e3  # absolute pressures between which it is valid [Pa]
LOWEST_RATIO, HIGHEST_RATIO = 20 / 1024, 1003 / 1024  # beyond these the sensor is open or shorted

ATTACH_TIME_MS = 5000  # for an interface kit to answer [ms]


def absolute_pressure(ratio: float) -> float:
    """Absolute pressure of an output over supply [Pa]."""
    return ratio / SLOPE + OFFSET


def ratio_of(pressure: float) -> float:
    """Output over supply at an absolute pressure [Pa]."""
    return (pressure - OFFSET) * SLOPE


class SensorError(PumpError):
    """The pressure is not known: the sensor is open, shorted, frozen or out of its range."""

    rule = "sensor"


def pressure_of(ratio: float) -> float:
    """Absolute pressure [Pa]; raises `SensorError` where the output is not a pressure."""
    if not LOWEST_RATIO <= ratio <= HIGHEST_RATIO:
        raise SensorError(
            f"the pressure sensor is open or shorted: it gives {ratio:.3f} of its supply. "
            "Check its plug and its channel (`pump.sensor.channel`)"
        )
    pressure = absolute_pressure(ratio)
    if not LOWEST <= pressure <= HIGHEST:
        raise SensorError(
            f"{pressure / 1e3:.1f} kPa absolute is outside the pressure sensor's range, "
            "20 to 400 kPa"
        )
    return pressure


def board_sensor(board: Controller, channel: int) -> Callable[[], float]:
    """What reads the absolute pressure [Pa] of a sensor on an analog input of the board.

    As precise as the board's converter. Raises `PumpError` where the board has no such inputs.
    """
    if not board.has_pins:
        raise PumpError(
            f"the board {board.name} has no analog inputs: leave out `pump.sensor`, connect it "
            "to a kit (`pump.sensor.on: phidget`), or use a board that has them"
        )

    def read() -> float:
        ratio = board.analog(channel)
        if ratio is None:
            raise PumpError(f"the board {board.name} has no analog input {channel}")
        return pressure_of(ratio)

    return read


@contextlib.contextmanager
def phidget_sensor(channel: int) -> Iterator[Callable[[], float]]:
    """What reads the absolute pressure [Pa] at a ratio input of a Phidgets kit.

    By the vendor's library (extra `phidgets`); released on leaving.
    """
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
