"""A syringe pump: a plunger that a servo moves by rack and pinion."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Annotated, Any, ClassVar, Literal

from pydantic import AfterValidator, BeforeValidator, Field, model_validator

from viscodesign.scene.integer import Integer, as_integer
from viscodesign.scene.per_inlet import ByInlet, named
from viscodesign.scene.pumps.base import PumpSpec
from viscodesign.scene.pumps.servo_motor import SERVOS
from viscodesign.scene.spec_part import KeyFault, SpecPart, invalid, invalid_at, raise_faults
from viscodesign.units import Charge, Force, Length, Voltage, Volume

MAX_SERVO_COUNTS = 1023
MAX_SERVO_ID = 253
"""Highest id of the Dynamixel protocol, where 254 is the broadcast id."""
ServoName: Any = Literal[tuple(SERVOS)]
"""One of the types in the table."""


def _ids(given: Any) -> Any:
    """Servo ids, one or per inlet; checked here, as a union would report both of its members."""
    ids = {name: as_integer(value) for name, value in named(given).items()}
    raise_faults(
        KeyFault(
            (name,) if name else (),
            f"a servo id must be an integer from 0 to {MAX_SERVO_ID}; got {value!r}",
        )
        for name, value in ids.items()
        if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= MAX_SERVO_ID
    )
    if not ids or len(set(ids.values())) < len(ids):
        raise invalid("each inlet needs its own servo id, all different")
    return ids if isinstance(given, Mapping) else ids[""]


class LimitSwitchSpec(SpecPart):
    """Digital inputs that stop the plunger at the ends of its travel."""

    low: str = Field(description="Digital input of the switch at the withdrawn end, such as D1")
    high: str = Field(description="Digital input of the switch at the pushed end, such as D2")
    normally: Literal["closed", "open"] = Field(
        "closed", description="State of the switches while the plunger is between them"
    )


def _own_pins(given: Any) -> Any:
    """Switches, each on its own pin."""
    taken: dict[str, str] = {}
    faults = []
    for name, pair in named(given or {}).items():
        for end, pin in (("low", pair.low), ("high", pair.high)):
            path = (name, end) if name else (end,)
            same = re.sub(r"(?<=^D)0+(?=\d)", "", pin)  # D01 is D1
            if same in taken:
                faults.append(KeyFault(path, f"pin {pin!r} is already used by {taken[same]}"))
            taken[same] = ".".join(path)
    raise_faults(faults)
    return given


class ServoPumpSpec(PumpSpec):
    """A syringe driven by a servo with rack and pinion."""

    name: ClassVar[str] = "servo"
    order: ClassVar[int] = 0
    parts_per_inlet: ClassVar[dict[str, str]] = {
        **PumpSpec.parts_per_inlet,
        "servo_id": "servo",
        "limit_switches": "limit switches",
    }

    kind: Literal["servo"] = Field("servo", description="The principle of the pump")
    syringe_diameter: Length = Field(
        gt=0, description="Inner diameter of the barrel", examples=["34.9 mm"]
    )
    syringe_stroke: Length = Field(0.1045, gt=0, description="Usable stroke of the plunger")
    pinion_diameter: Length = Field(0.0296, gt=0, description="Pitch diameter")
    servo: ServoName = Field("ax18a", description="Model of the servo")
    servo_id: Annotated[int | dict[str, int], BeforeValidator(_ids)] = Field(
        1, description="One id, or one per inlet by name"
    )
    supply_voltage: Voltage = Field(11.1, gt=0, description="Voltage at the servos")
    dead_volume: Volume = Field(
        5e-6, ge=0, description="Volume between plunger and inlet that it cannot displace"
    )
    battery_capacity: Charge = Field(
        450e-3 * 3600, gt=0, description="Battery capacity, shared by all servos"
    )
    plunger_friction: Force = Field(
        5.0, ge=0, description="Kinetic friction of the plunger (assumed)"
    )
    gear_play: float = Field(2.0, ge=0, description="Backlash of the gears in servo counts")
    home: Integer = Field(
        200, ge=0, le=MAX_SERVO_COUNTS, description="Servo counts with the plunger at its start"
    )
    travel: tuple[Integer, Integer] = Field(
        (100, 1000), description="Lowest and highest servo counts that the plunger may have"
    )
    push: Literal["up", "down"] = Field(
        "up", description="Direction of the servo counts as the plunger is pushed in"
    )
    filled_length: Length | None = Field(
        None,
        gt=0,
        description="Filled barrel length at home; default: the withdrawn end of travel is full",
        examples=["60 mm"],
    )
    limit_switches: Annotated[ByInlet[LimitSwitchSpec] | None, AfterValidator(_own_pins)] = Field(
        None, description="One pair for the first inlet, or one pair per inlet by name"
    )

    def axes(self, inlets: int) -> tuple[int, ...]:
        return tuple(named(self.servo_id).values())

    @model_validator(mode="after")
    def _check_travel(self) -> ServoPumpSpec:
        low, high = self.travel
        if not 0 <= low < high <= MAX_SERVO_COUNTS:
            raise invalid_at(
                "travel",
                f"must satisfy 0 <= low < high <= {MAX_SERVO_COUNTS} counts; got [{low}, {high}]",
            )
        if not low <= self.home <= high:
            raise invalid_at("home", f"must be within travel, {low} to {high}; got {self.home}")
        return self
