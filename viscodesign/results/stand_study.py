"""How a robot stands. Plain data: `report` draws it, the command line prints it."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import json_ready
from viscodesign.results.provenance import provenance


@dataclass(frozen=True)
class StanceRow:
    """A robot that stands at one gauge pressure with one payload."""

    gauge_pressure_pa: float
    payload_kg: float
    weight_n: float
    """Weight of robot and payload."""
    height_m: float
    """Mean height of the hips over the ground; NaN where it does not stand."""
    pitch_rad: float
    roll_rad: float
    sway_limit_n: float
    """Weight from which on it sways."""
    tip_stiffness_n_per_m: float
    """Stiffness of a leg's tip under its share of weight, sideways in its plane, free to turn."""

    @property
    def stands(self) -> bool:
        """Whether the stance is stable."""
        return self.weight_n < self.sway_limit_n


@dataclass(frozen=True)
class Fall:
    """How a robot falls whatever its legs bear."""

    how: str
    """A verb: it 'slides' or 'tips over'."""
    why: str


@dataclass(frozen=True)
class CrouchRow:
    """What it takes to lower a robot by its pressure."""

    height_ratio: float
    """Height of the legs, hip to foot centre, over that at the spec's gauge pressure."""
    gauge_pressure_pa: float
    """NaN where no pressure lowers it so far."""
    liquid_volume_m3: float
    """That a pump draws from its legs, if the fluid were incompressible."""
    barrel_volume_m3: float
    """That the drawn fluid fills at the lowered pressure: the barrel that a pump needs."""
    reason: str = ""
    """Why no pressure lowers it so far; empty where one does."""


@dataclass(frozen=True)
class StandStudy:
    """Height, sway, stiffness and crouch of a robot."""

    name: str
    own: StanceRow
    """At the spec's gauge pressure and payload."""
    by_gauge: tuple[StanceRow, ...]
    by_payload: tuple[StanceRow, ...]
    crouch: tuple[CrouchRow, ...]
    pump: str
    """Source whose legs need the largest barrel."""
    fall: Fall | None = None
    """How it falls whatever its legs bear; None where it stands, or sways under its weight."""

    def __repr__(self) -> str:
        return f"<StandStudy {self.name}: {1e3 * self.own.height_m:.4g} mm high>"

    def document(self) -> dict[str, Any]:
        """As in `stand.json`."""
        found: dict[str, Any] = json_ready({
            "name": self.name,
            **asdict(self.own),
            "stands": self.own.stands,
            "fall": None if self.fall is None else asdict(self.fall),
            "by_gauge": [asdict(row) for row in self.by_gauge],
            "by_payload": [asdict(row) for row in self.by_payload],
            "crouch": [asdict(row) for row in self.crouch],
            "crouch_pump": self.pump,
            "provenance": provenance(),
        })  # fmt: skip
        return found
