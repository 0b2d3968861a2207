"""The numbers of an actuator as a leg."""

from __future__ import annotations

import numpy as np

from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.bellow_law import BellowLaw, places
from viscodesign.model.graph import Graph
from viscodesign.physics import tube
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import copied


@dataclass(frozen=True)
class FilledFluid:
    """What fills the legs."""

    ambient: float
    """Absolute [Pa]."""
    exponent: float | None
    """Polytropic exponent of a gas; None for a liquid, which is taken as incompressible."""
    density: float
    """At ambient pressure [kg/m3]."""
    viscosity: float
    """[Pa s]"""


@dataclass(frozen=True)
class LegTube:
    """A tube between two nodes of a leg; -1 is the source."""

    name: str
    start: int
    end: int
    radius: float
    """[m]"""
    resistance: float
    """To slow flow [Pa s/m3]."""
    end_loss: float
    """Pressure lost at both ends per flow squared [Pa s2/m6]."""


@dataclass(frozen=True)
class LegDesign:
    """An actuator as a leg: stiffness, bellows, tubes and what fills them, in SI."""

    length: float
    section_length: float
    bending_stiffness: float
    extension_stiffness: float
    free_sections: tuple[bool, ...]
    """Whether a section bends and stretches, clamp first."""
    bellow: BellowLaw
    volume_per_force: float
    """[m3/N]"""
    volume_per_moment: float
    """[m3/(N m)]"""
    nodes: tuple[str, ...]
    """Bellows, then junctions."""
    sections: tuple[int, ...]
    """Section of each bellow, from 0 at the clamp."""
    sides: tuple[float, ...]
    """+1 for a bellow left of the axis, -1 for one to the right."""
    tubes: tuple[LegTube, ...]
    fluid: FilledFluid

    @property
    def bellows(self) -> int:
        """Number of bellows."""
        return len(self.sections)

    def strains(self, pressures: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Intrinsic curvature [1/m] and stretch [1] of every section (S,), at gauge [Pa] (B,)."""
        own = pressures[: self.bellows]
        difference = np.bincount(self.sections, np.multiply(self.sides, own))
        total = np.bincount(self.sections, own)
        free = np.array(self.free_sections, dtype=float)
        law = self.bellow
        return (
            free * law.curvature_per_pressure * difference,
            free * law.stretch_per_pressure * total,
        )


def leg_design(scene: Scene) -> LegDesign:
    """The leg that an actuator is; its blocked sections are those that pillars keep stiff."""
    quantities = SceneQuantities(copied(scene, {"section_changes": None}))
    body, bellows, graph = quantities.body, scene.bellows, quantities.graph
    place = places(graph)
    blocked = scene.sections.blocked
    free = [True] * graph.sections if blocked is None else (~blocked).tolist()
    return LegDesign(
        length=body.length,
        section_length=body.section_length,
        bending_stiffness=body.bending_stiffness,
        extension_stiffness=body.extension_stiffness,
        free_sections=tuple(free),
        bellow=quantities.bellow,
        volume_per_force=bellows.length * bellows.area_per_force,
        volume_per_moment=bellows.length * bellows.area_per_moment,
        nodes=(*graph.bellows, *graph.junctions),
        sections=tuple(place[name].section for name in graph.bellows),
        sides=tuple(place[name].side for name in graph.bellows),
        tubes=_tubes(scene, graph, quantities.resistances),
        fluid=_fluid(scene),
    )


def _tubes(scene: Scene, graph: Graph, resistances: dict[str, float]) -> tuple[LegTube, ...]:
    index = {name: k for k, name in enumerate((*graph.bellows, *graph.junctions))}
    index |= dict.fromkeys(graph.inlets, -1)
    loss = scene.network.entrance_loss + scene.network.exit_loss
    return tuple(
        LegTube(
            t.name,
            index[t.start],
            index[t.end],
            t.radius,
            resistances[t.name],
            tube.local_loss_coefficient(scene.fluid.density, loss, t.radius),
        )
        for t in graph.tubes
    )


def _fluid(scene: Scene) -> FilledFluid:
    fluid = scene.fluid
    exponent = fluid.polytropic_exponent if fluid.is_gas else None
    return FilledFluid(scene.ambient_pressure, exponent, fluid.density, fluid.viscosity)
