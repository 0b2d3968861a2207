"""`pump:` the drive, for the `pump` commands."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Annotated, Any, Literal

from pydantic import AfterValidator, BeforeValidator, Field, model_validator

from viscodesign.scene.per_inlet import ByInlet, in_order, named
from viscodesign.scene.section import Complaint, Part, refuse, refuse_any, refuse_at
from viscodesign.units import (
    Charge,
    CountedPressure,
    Force,
    Length,
    StatedPressure,
    Voltage,
    Volume,
)

SERVO_COUNTS = 1023
HIGHEST_ID = 253
"""Of the Dynamixel protocol; 254 speaks to all servos."""


def _ids(given: Any) -> Any:
    """Servo ids, one or by inlet; said here since a union would tell of both its sides."""
    ids = named(given)
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
    on: Literal["auto", "board", "phidget"] = Field(
        "auto", description="Where it hangs; auto: on the board, or on a kit where that has no pins"
    )


class LimitSwitches(Part):
    """Digital inputs that stop the plunger at its ends."""

    low: str
    high: str
    normally: Literal["closed", "open"] = "closed"


def _own_channels(given: Any) -> Any:
    """Sensors of several inlets, each on a channel of its own."""
    refuse_any(_shared_channels(named(given or {})))
    return given


def _shared_channels(sensors: dict[str, Sensor]) -> Iterator[Complaint]:
    taken: dict[tuple[int, str], str] = {}
    for name, sensor in sensors.items():
        # `auto` may turn out as either.
        places = [(sensor.channel, on) for on in ("board", "phidget") if sensor.on in ("auto", on)]
        if owner := next((taken[place] for place in places if place in taken), None):
            message = f"{sensor.channel} is the channel of the inlet '{owner}' already"
            yield Complaint((name, "channel"), message)
        taken |= dict.fromkeys(places, name)


def _own_pins(given: Any) -> Any:
    """Switches, each on a pin of its own."""
    refuse_any(_shared_pins(named(given or {})))
    return given


def _shared_pins(switches: dict[str, LimitSwitches]) -> Iterator[Complaint]:
    taken: dict[str, str] = {}
    for name, pair in switches.items():
        for end, pin in (("low", pair.low), ("high", pair.high)):
            path = (name, end) if name else (end,)
            same = re.sub(r"(?<=^D)0+(?=\d)", "", pin)  # D01 is D1
            if same in taken:
                yield Complaint(path, f"{pin!r} is the pin of {taken[same]} already")
            taken[same] = ".".join(path)


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
    battery_capacity: Charge = Field(450e-3 * 3600, gt=0, description="Of all servos together")
    plunger_friction: Force = Field(5.0, ge=0, description="Of a moving plunger; an assumption")
    gear_play: float = Field(2.0, ge=0, description="Counts lost when the plunger turns back")
    max_pressure: CountedPressure = Field(
        25e3,
        description="Software cap, like '25 kPa gauge' or '140 kPa abs'; gauge once it is read",
    )
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
    sensor: Annotated[ByInlet[Sensor] | None, AfterValidator(_own_channels)] = Field(
        None, description="One, of the first inlet; or one for each inlet by its name"
    )
    limit_switches: Annotated[ByInlet[LimitSwitches] | None, AfterValidator(_own_pins)] = Field(
        None, description="One pair, of the first inlet; or one for each inlet by its name"
    )

    def above(self, ambient: float) -> Pump:
        """The same with its pressures above the ambient [Pa]; a fault where that is not clear."""
        stated = self.max_pressure
        if not isinstance(stated, StatedPressure):
            return self
        if not stated.counted and stated > ambient:
            kpa, above = f"{stated / 1e3:g} kPa", f"{(stated - ambient) / 1e3:.4g} kPa"
            raise refuse_at(
                "max_pressure",
                f"{kpa} is above the ambient of {ambient / 1e3:g} kPa and could be meant either "
                f"way; write '{kpa} gauge', or '{kpa} abs' ({above} gauge)",
            )
        gauge = stated.gauge(ambient)
        if gauge <= 0.0:
            kind = "abs" if stated.counted == "abs" else "gauge"
            least = f"the ambient of {ambient / 1e3:g} kPa" if kind == "abs" else "0 kPa gauge"
            raise refuse_at("max_pressure", f"{stated / 1e3:g} kPa {kind} is not above {least}")
        return self.model_copy(update={"max_pressure": gauge})

    def in_order_of(self, inlets: tuple[str, ...]) -> Pump:
        """The same with all that it says by inlet in the order of the inlets."""
        names = ("servo_id", "sensor", "limit_switches")
        return self.model_copy(update={n: in_order(getattr(self, n), inlets) for n in names})

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
