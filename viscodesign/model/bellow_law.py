"""Linear laws of a bellow: strains and volume under pressure, equations (1), (9) and (10)."""

from __future__ import annotations

from dataclasses import field, fields
from typing import TYPE_CHECKING

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.graph import Graph
from viscodesign.model.scene_number import SCENE_NUMBER, Numbers, mean_of

if TYPE_CHECKING:
    from casadi import SX


@dataclass(frozen=True)
class BellowLaw:
    """The linear laws of one bellow, in SI."""

    length: float = field(metadata=SCENE_NUMBER)
    rest_volume: float = field(metadata=SCENE_NUMBER)
    compliance: float = field(metadata=SCENE_NUMBER)
    curvature_per_pressure: float = field(metadata=SCENE_NUMBER)
    stretch_per_pressure: float = field(metadata=SCENE_NUMBER)
    floor_volume: float = field(metadata=SCENE_NUMBER)


@dataclass(frozen=True, eq=False)
class BellowLaws:
    """The linear laws of all bellows, each number one for all or an array in graph order (B,)."""

    length: Numbers = field(metadata=SCENE_NUMBER)
    rest_volume: Numbers = field(metadata=SCENE_NUMBER)
    compliance: Numbers = field(metadata=SCENE_NUMBER)
    curvature_per_pressure: Numbers = field(metadata=SCENE_NUMBER)
    stretch_per_pressure: Numbers = field(metadata=SCENE_NUMBER)
    floor_volume: Numbers = field(metadata=SCENE_NUMBER)

    @property
    def typical(self) -> BellowLaw:
        """The law whose numbers are the means of all."""
        return BellowLaw(**{f.name: mean_of(getattr(self, f.name)) for f in fields(self)})


@dataclass(frozen=True)
class BellowPlace:
    """Position of a bellow: its section (from 0 at the clamp) and its side."""

    section: int
    side: float
    """+1 left of the axis, -1 right (R in the paper)."""


def places(graph: Graph) -> dict[str, BellowPlace]:
    """Section and side of every bellow, by name."""
    count = graph.sections
    return {
        name: BellowPlace(k % count, -1.0 if k < count else 1.0)
        for k, name in enumerate(graph.bellows)
    }


def in_pairs(graph: Graph, values: dict[str, SX]) -> list[tuple[SX, SX]]:
    """Values (left, right) of every section, clamp first."""
    right, left = graph.bellows[: graph.sections], graph.bellows[graph.sections :]
    return [(values[own], values[other]) for own, other in zip(left, right, strict=True)]
