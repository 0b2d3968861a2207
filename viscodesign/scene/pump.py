"""`pump:` the drive, for the `pump` commands."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, model_validator

from viscodesign.scene.base import Complaint, Part, refuse, refuse_any, refuse_at
from viscodesign.units import Length, Pressure, Voltage, Volume

SERVO_COUNTS = 1023
HIGHEST_ID = 253
"""Of the Dynamixel protocol; 254 speaks to all servos."""


def _ids(given: Any) -> Any:
    """Servo ids, one or by inlet; said here since a union would tell of both its sides."""
    ids = given if isinstance(given, dict) else {"": given}
    refuse_any(
        Complaint(
            (name,) if name else (),
            f"{value!r} is given; a servo id is a whole number from 0 to {HIGHEST_ID}",
        )
        for name, value in ids.items()
        if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= HIGHEST_ID
    )
    if not ids or len(set(ids.values())) < len(ids):
        raise refuse("the servos of several inlets need an id each, all different")
    return given


class Sensor(Part):
    """The pressure sensor's analog channel."""

    channel: int = Field(ge=0, le=7)


class LimitSwitches(Part):
    """Digital inputs that stop the plunger at its ends."""

    low: str
    high: str
    normally: Literal["closed", "open"] = "closed"


class Pump(Part):
    """A syringe moved by a servo with rack and pinion."""

    syringe_diameter: Length = Field(gt=0, description="Inner diameter of the barrel")
    syringe_stroke: Length = Field(0.1045, gt=0)
    pinion_diameter: Length = Field(0.0296, gt=0, description="Pitch diameter")
    servo: Literal["ax12a", "ax18a"] = "ax18a"
    servo_id: Annotated[int | dict[str, int], BeforeValidator(_ids)] = Field(
        1, description="One id, or one for each inlet by its name"
    )
    supply_voltage: Voltage = Field(11.1, gt=0)
    dead_volume: Volume = Field(5e-6, ge=0)
    max_pressure: Pressure = Field(25e3, gt=0, description="Gauge; software cap")
    home: int = Field(200, ge=0, le=SERVO_COUNTS, description="Counts, plunger at its start")
    travel: tuple[int, int] = (100, 1000)
    push: Literal["up", "down"] = Field(
        "up", description="Whether counts rise or fall as the plunger is pushed in"
    )
    filled_length: Length | None = Field(
        None,
        gt=0,
        description="Of the barrel, plunger at home; else the drawn-out end of travel is full",
    )
    sensor: Sensor | None = None
    limit_switches: LimitSwitches | None = None

    @model_validator(mode="after")
    def _travel_fits(self) -> Pump:
        low, high = self.travel
        if not 0 <= low < high <= SERVO_COUNTS:
            raise refuse_at(
                "travel", f"[{low}, {high}]; allowed are 0 <= low < high <= {SERVO_COUNTS} counts"
            )
        if not low <= self.home <= high:
            raise refuse_at("home", f"{self.home} lies outside of travel, {low} to {high}")
        return self
