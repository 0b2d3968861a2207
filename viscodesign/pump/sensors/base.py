"""Absolute pressure sensors, what is wrong with one, and one on an analog input of a board.

The sensor is the Phidgets 1140: kPa = ratio / 0.002421 + 3.478, with ratio = output over supply.
Source: the vendor's library (phidget22 3.26, sensor type 1140), whose figures agree with its
sensing element, MPXH6400A; that one's data sheet gives 1.5 % of span as its error, 0 to 85 degC,
and 0.2 to 4.8 V at 5 V.
"""

from __future__ import annotations

from collections.abc import Callable

from viscodesign.errors import PumpError
from viscodesign.pump.boards.controller import Controller

SLOPE = 0.002421 / 1e3  # ratio for a pascal
OFFSET = 3.478e3  # [Pa]
LOWEST, HIGHEST = 20e3, 400e3  # absolute pressures between which it is valid [Pa]
LOWEST_RATIO, HIGHEST_RATIO = 20 / 1024, 1003 / 1024  # beyond these the sensor is open or shorted


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
