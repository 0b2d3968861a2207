"""The servos that drive a syringe pump, in the numbers of their maker (ROBOTIS e-manual)."""

from __future__ import annotations

import math

from viscodesign.lazy_dataclass import dataclass

STEADY_SHARE = 1 / 5
"""Share of the stall torque up to which the maker promises steady motion: "Stable motions are
possible with robots designed for loads with 1/5 or less of the stall torque"."""


@dataclass(frozen=True)
class ServoType:
    """A type of servo of the AX series, in SI, at its rated voltage.

    What all types share is no field: 1024 counts over 300 degrees, and the units and addresses that
    `viscodesign/pump/ax/protocol` has. A servo with others, such as an MX-28 (4096 counts over 360
    degrees), would be planned and driven in wrong units: it is a kind of pump of its own.
    """

    title: str
    model: int  # number by which it identifies itself
    stall_torque: float  # [N m]
    stall_current: float  # [A]
    no_load_speed: float  # [rad/s]
    rated_voltage: float = 12.0  # and the highest allowed [V]
    lowest_voltage: float = 9.0  # [V]
    temperature_limit: int = 70  # factory setting, at which it shuts itself off [degC]
    max_torque: int = 1023  # factory setting [1/1023 of stall]


def _rpm(value: float) -> float:
    return value * 2 * math.pi / 60


SERVOS = {
    "ax12a": ServoType("AX-12A", 12, 1.5, 1.5, _rpm(59.0)),
    "ax18a": ServoType("AX-18A", 18, 1.8, 2.2, _rpm(97.0), temperature_limit=75, max_torque=983),
}
"""Types by their name in `pump.servo`. Another one of the series is a line here."""


def servos_by_model() -> dict[int, ServoType]:
    """Types by the model number that they give."""
    return {servo.model: servo for servo in SERVOS.values()}


def model_title(model: int) -> str:
    """Name of the type with this model number, or the number."""
    known = servos_by_model().get(model)
    return known.title if known else f"model {model}"
