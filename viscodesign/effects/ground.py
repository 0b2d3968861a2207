"""Ground: a rigid surface that the actuator may touch, with Coulomb friction."""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar, Self

import casadi as ca

from viscodesign.effects.base import Effect, Trait
from viscodesign.errors import Fault
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.rod import Body, RodSymbols
from viscodesign.model.system import System, rod_endings
from viscodesign.references import LiteratureReference
from viscodesign.scene.ground import Ground

SX = ca.SX


@dataclass(frozen=True)
class GroundContact(Effect):
    """Unilateral contact of the tip, or of every section's end, with a rigid line or circle.

    What touches is pushed, never pulled, and does not sink in. It sticks or slides by Coulomb's
    law; a round tip rolls.
    """

    name: ClassVar[str] = "ground"
    order: ClassVar[int] = 7  # after shear, which replaces the rod
    traits: ClassVar[frozenset[Trait]] = frozenset({Trait.CONTACT})
    formula: ClassVar[str] = "1 where a ground is stated"
    own_rule: ClassVar[str] = (
        "It is included where a spec defines it, also with `others: off`; "
        "`effects.ground: off` leaves it out."
    )
    validity: ClassVar[str] = (
        "A rigid surface at rest, one coefficient of friction, impacts without rebound, and "
        "contact at the points named by `loads.ground.touches` alone."
    )
    source: ClassVar[str] = (
        "Signorini's and Coulomb's laws in implicit time steps, after Moreau (1988)."
    )
    references: ClassVar[tuple[LiteratureReference, ...]] = (
        LiteratureReference(
            "moreau1988",
            "book",
            {
                "author": "Moreau, Jean Jacques",
                "title": "Unilateral Contact and Dry Friction in Finite Freedom Dynamics, in: "
                "Nonsmooth Mechanics and Applications, CISM Courses and Lectures 302",
                "publisher": "Springer",
                "year": "1988",
            },
        ),
    )
    keys: ClassVar[tuple[str, ...]] = ("loads.ground",)

    grounds: tuple[Ground | None, ...]
    """What each rod may touch."""
    names: tuple[str, ...] = ("",)
    """What the names of each rod's points begin with."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        scene = quantities.scene
        names = tuple(f"{name}." for name in scene.members) or ("",)
        return cls(tuple(own.ground for own in scene.loads_of_rods), names)

    def present(self, quantities: SceneQuantities) -> bool:
        return any(own is not None for own in self.grounds)

    def indispensable(self, quantities: SceneQuantities) -> bool:
        return True  # nothing can be said of a contact before the motion is known

    def weight(self, quantities: SceneQuantities) -> float:
        return float(self.present(quantities))

    def reason(self, quantities: SceneQuantities) -> str:
        told = [
            f"the {_TOUCHING[own.touches]}{of and f' of {of[:-1]}'} may touch a rigid {own.kind}"
            for of, own in zip(self.names, self.grounds, strict=True)
            if own is not None
        ]
        return "; ".join(told) or "there is no ground to touch"

    def refusals(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Fault]:
        if not self.present(quantities) or self.name not in active:
            return
        if quantities.scene.run.start == "periodic":
            yield Fault(
                "a motion with contact has no periodic start; write equilibrium or rest, and a "
                "run.duration in which it settles",
                "run.start",
            )
        body = quantities.body
        for own, rod, name in zip(self.grounds, body.members or (body,), self.names, strict=True):
            if own is not None:
                yield from _inside(own, rod, f"actuators.{name}" if name else "")

    def join(self, system: System) -> None:
        each = zip(system.rod.rods, self.grounds, self.names, rod_endings(system), strict=True)
        for rod, own, name, ending in each:
            if own is not None:
                _touch(system, rod, own, name, ending)


def _inside(ground: Ground, body: Body, key: str) -> Iterator[Fault]:
    """Whether parts of a straight actuator are in the ground, where none of it may be.

    ``key``: what stands before ``loads.ground``.
    """
    sections, length = body.sections, body.length
    ends = [length * (k + 1) / sections for k in range(sections)]
    for z in ends if ground.touches == "sections" else ends[-1:]:
        radius = ground.foot_radius if z == ends[-1] else 0.0
        depth = -_surface(_numbers(ground), SX([0.0, z]), radius, SX([0.0, length]))[0]
        if float(depth) > 0:
            yield Fault(
                f"the straight actuator is {1e3 * float(depth):.3g} mm inside the ground at "
                f"z = {1e3 * z:.4g} mm; move the ground, or turn it to its other side",
                f"{key}loads.ground",
            )
            return


def _touch(system: System, rod: RodSymbols, ground: Ground, name: str, ending: str) -> None:
    """Let a rod touch its ground; ``ending``: what its parameters end with."""
    numbers = {
        key: system.parameter(f"ground.{key}{ending}", value)
        for key, value in _numbers(ground).items()
    }
    friction, foot = system.parameter(f"ground.friction{ending}", ground.friction), None
    if ground.foot_radius:
        foot = system.parameter(f"ground.foot_radius{ending}", ground.foot_radius)
    ends = rod.section_ends
    length = rod.section_length * len(ends) if ending else system.length
    straight = ca.vertcat(0, length)
    *inner, tip = (f"{name}{point}" for point in ground.points(len(ends)))
    for point, end in zip(inner, ends, strict=False):
        system.add_contact(point, *_surface(numbers, end, 0, straight), friction)
    own = _surface(numbers, ends[-1], 0 if foot is None else foot, straight)
    system.add_contact(tip, *own, friction, foot)


_TOUCHING = {"tip": "tip", "sections": "axis at the ends of the sections"}


def _numbers(ground: Ground) -> dict[str, float]:
    """The surface in numbers: where it is, and its direction or its radius."""
    if ground.kind == "line":
        assert ground.point is not None
        assert ground.normal is not None
        return {"x": ground.point.x, "z": ground.point.z, "normal": ground.normal}
    assert ground.centre is not None
    assert ground.radius is not None
    return {"x": ground.centre.x, "z": ground.centre.z, "radius": ground.radius}


def _surface(
    numbers: dict[str, SX] | dict[str, float], point: SX, radius: SX | float, straight: SX
) -> tuple[SX, SX]:
    """Distance from the surface, and path along it, of a disc of a radius around a point [m].

    ``straight``: the tip of the straight actuator, from where the path around a circle counts.
    """
    place = ca.vertcat(numbers["x"], numbers["z"])
    away = point - place
    if "normal" in numbers:
        sin, cos = ca.sin(numbers["normal"]), ca.cos(numbers["normal"])
        return away[0] * sin + away[1] * cos - radius, away[0] * cos - away[1] * sin
    reach, first = numbers["radius"] + radius, straight - place
    across = away[0] * first[1] - away[1] * first[0]
    return ca.norm_2(away) - reach, reach * ca.atan2(across, ca.dot(first, away))
