"""`pump:` the syringe pump, for the `pump` commands."""

from __future__ import annotations

import re
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BeforeValidator, Field, model_validator

from viscodesign.scene.per_inlet import ByInlet, in_order, named
from viscodesign.scene.spec_part import (
    KeyFault,
    SpecPart,
    copied,
    invalid,
    invalid_at,
    raise_faults,
)
from viscodesign.units import (
    Charge,
    Force,
    GaugeOrAbsolutePressure,
    Length,
    ReferencedPressure,
    Voltage,
    Volume,
)

MAX_SERVO_COUNTS = 1023
MAX_SERVO_ID = 253
"""Of the Dynamixel protocol, where 254 is the broadcast id."""
PARTS_PER_INLET = {
    "servo_id": "servo",
    "sensor": "pressure sensor",
    "limit_switches": "limit switches",
}
"""Keys that may be given per inlet, and what they describe."""


def _ids(given: Any) -> Any:
    """Servo ids, one or per inlet; checked here, as a union would report both of its members."""
    ids = named(given)
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
    return given


class SensorSpec(SpecPart):
    """The pressure sensor's analog channel."""

    channel: int = Field(ge=0, le=7, description="Analog input that it is connected to")
    on: Literal["auto", "board", "phidget"] = Field(
        "auto",
        description="Where it is connected; auto: the board, or a kit if the board has no pins",
    )


class LimitSwitchSpec(SpecPart):
    """Digital inputs that stop the plunger at the ends of its travel."""

    low: str = Field(description="Digital input of the switch at the withdrawn end, such as D1")
    high: str = Field(description="Digital input of the switch at the pushed end, such as D2")
    normally: Literal["closed", "open"] = Field(
        "closed", description="State of the switches while the plunger is between them"
    )


def _own_channels(given: Any) -> Any:
    """Sensors of several inlets, each on its own channel."""
    taken: dict[tuple[int, str], str] = {}
    faults = []
    for name, sensor in named(given or {}).items():
        # `auto` may become either.
        places = [(sensor.channel, on) for on in ("board", "phidget") if sensor.on in ("auto", on)]
        if owner := next((taken[place] for place in places if place in taken), None):
            message = f"channel {sensor.channel} is already used by the inlet '{owner}'"
            faults.append(KeyFault((name, "channel"), message))
        taken |= dict.fromkeys(places, name)
    raise_faults(faults)
    return given


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


class PumpSpec(SpecPart):
    """A syringe driven by a servo with rack and pinion."""

    syringe_diameter: Length = Field(
        gt=0, description="Inner diameter of the barrel", examples=["34.9 mm"]
    )
    syringe_stroke: Length = Field(0.1045, gt=0, description="Usable stroke of the plunger")
    pinion_diameter: Length = Field(0.0296, gt=0, description="Pitch diameter")
    servo: Literal["ax12a", "ax18a"] = Field("ax18a", description="Model of the servo")
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
    max_pressure: GaugeOrAbsolutePressure = Field(
        25e3, description="Software limit, such as '25 kPa gauge' or '140 kPa abs'"
    )
    home: int = Field(
        200, ge=0, le=MAX_SERVO_COUNTS, description="Servo counts with the plunger at its start"
    )
    travel: tuple[int, int] = Field(
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
    sensor: Annotated[ByInlet[SensorSpec] | None, AfterValidator(_own_channels)] = Field(
        None, description="One for the first inlet, or one per inlet by name"
    )
    limit_switches: Annotated[ByInlet[LimitSwitchSpec] | None, AfterValidator(_own_pins)] = Field(
        None, description="One pair for the first inlet, or one pair per inlet by name"
    )

    def with_gauge_pressures(self, ambient: float) -> PumpSpec:
        """The pump with its pressures as gauge [Pa]; a fault if the reference is ambiguous."""
        limit = self.max_pressure
        if not isinstance(limit, ReferencedPressure):
            return self
        if not limit.reference and limit > ambient:
            kpa, above = f"{limit / 1e3:g} kPa", f"{(limit - ambient) / 1e3:.4g} kPa"
            raise invalid_at(
                "max_pressure",
                f"{kpa} exceeds the ambient pressure of {ambient / 1e3:g} kPa: it may be gauge or "
                f"absolute; write '{kpa} gauge', or '{kpa} abs' ({above} gauge)",
            )
        gauge = limit.gauge(ambient)
        if gauge <= 0.0:
            absolute = limit.reference == "abs"
            least = f"the ambient pressure of {ambient / 1e3:g} kPa" if absolute else "0 kPa gauge"
            given = f"{limit / 1e3:g} kPa {'abs' if absolute else 'gauge'}"
            raise invalid_at("max_pressure", f"must be above {least}; got {given}")
        return copied(self, {"max_pressure": ReferencedPressure.of(gauge, "gauge")})

    def in_order_of(self, inlets: tuple[str, ...]) -> PumpSpec:
        """The pump with its parts per inlet in the order of the inlets."""
        parts = {name: in_order(getattr(self, name), inlets) for name in PARTS_PER_INLET}
        return copied(self, parts)

    @model_validator(mode="after")
    def _check_travel(self) -> PumpSpec:
        low, high = self.travel
        if not 0 <= low < high <= MAX_SERVO_COUNTS:
            raise invalid_at(
                "travel",
                f"must satisfy 0 <= low < high <= {MAX_SERVO_COUNTS} counts; got [{low}, {high}]",
            )
        if not low <= self.home <= high:
            raise invalid_at("home", f"must be within travel, {low} to {high}; got {self.home}")
        return self
