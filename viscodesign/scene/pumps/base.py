"""What the sections of all kinds of pump share."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal, Self

from pydantic import AfterValidator, Field

from viscodesign.scene.integer import Integer
from viscodesign.scene.per_inlet import ByInlet, in_order, named
from viscodesign.scene.spec_part import KeyFault, SpecPart, copied, invalid_at, raise_faults
from viscodesign.units import GaugeOrAbsolutePressure, ReferencedPressure


class SensorSpec(SpecPart):
    """The pressure sensor's analog channel."""

    channel: Integer = Field(ge=0, le=7, description="Analog input that it is connected to")
    on: Literal["auto", "board", "phidget"] = Field(
        "auto",
        description="Where it is connected; auto: the board, or a kit if the board has no pins",
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


class PumpSpec(SpecPart):
    """A pump of any kind; a kind is a file with one subclass, and one in `viscodesign/pump/kinds`.

    A subclass adds `name` and ``kind: Literal[name]``, by which a spec selects it.
    """

    name: ClassVar[str]
    parts_per_inlet: ClassVar[dict[str, str]] = {"sensor": "pressure sensor"}
    """Keys that may be given per inlet, and what they describe."""

    kind: str = Field(description="The principle of the pump")
    max_pressure: GaugeOrAbsolutePressure = Field(
        25e3, description="Software limit, such as '25 kPa gauge' or '140 kPa abs'"
    )
    feeds: Integer = Field(
        1,
        ge=1,
        le=1000,
        description="Equal actuators side by side on each inlet, of which the spec describes one",
    )
    sensor: Annotated[ByInlet[SensorSpec] | None, AfterValidator(_own_channels)] = Field(
        None, description="One for the first inlet, or one per inlet by name"
    )

    def with_gauge_pressures(self, ambient: float) -> Self:
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

    def in_order_of(self, inlets: tuple[str, ...]) -> Self:
        """The pump with its parts per inlet in the order of the inlets."""
        parts = {name: in_order(getattr(self, name), inlets) for name in self.parts_per_inlet}
        return copied(self, parts)

    def axes(self, inlets: int) -> tuple[int, ...]:
        """Ids of the axes, in the order of the inlets."""
        return tuple(range(1, inlets + 1))
