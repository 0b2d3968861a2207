"""Several rods in one system: each is a chain of its own, from a clamp of its own.

What a rod has one of, several have side by side: coordinates, sections, energies. Nothing
but the fluid connects them. The sections of all rods are counted in a row, those of the first
rod first.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Self

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.chain import Chain
from viscodesign.model.rod import (
    ROD_VALUES,
    Body,
    PointMass,
    RodDiscretisation,
    RodParameters,
    RodSymbols,
    Values,
)
from viscodesign.model.step_geometry import StepGeometry

SX = ca.SX


def several_bodies(members: Sequence[Body]) -> Body:
    """Bodies side by side; the one that a force displaces farthest stands for all."""
    softest = min(members, key=lambda own: own.bending_stiffness / own.length**2)
    sections = sum(own.sections for own in members)
    return replace(softest, sections=sections, varied=None, members=tuple(members))


class SeveralTipsError(TypeError):
    """Several rods have several tips: each of `RodSymbols.rods` answers for its own."""


class SeveralRodsSymbols(RodSymbols):
    """The symbols of rods side by side; ``rods`` are those of each."""

    def __init__(self, rods: Sequence[RodSymbols], parameters: RodParameters) -> None:
        super().__init__(parameters)
        self._rods = tuple(rods)
        self._sections = [own.intrinsic_curvature.numel() for own in rods]
        self.coordinate_size = parameters.length
        self.coordinates = ca.vertcat(*(own.coordinates for own in rods))
        self.rates = ca.vertcat(*(own.rates for own in rods))
        self.internal = ca.vertcat(*(own.internal for own in rods))
        self.intrinsic_curvature = ca.vertcat(*(own.intrinsic_curvature for own in rods))
        self.intrinsic_stretch = ca.vertcat(*(own.intrinsic_stretch for own in rods))
        self.tip_moment = SX.sym("tip_moment")
        self.section_length = ca.vertcat(
            *(
                ca.repmat(own.section_length, n, 1)
                for own, n in zip(rods, self._sections, strict=True)
            )
        )

    @property
    def rods(self) -> Sequence[RodSymbols]:
        return self._rods

    @property
    def section_angles(self) -> SX:
        return ca.vertcat(*(own.section_angles for own in self.rods))

    @property
    def section_rates(self) -> SX:
        return ca.vertcat(*(own.section_rates for own in self.rods))

    @property
    def strain_rates(self) -> SX:
        return ca.vertcat(*(own.strain_rates for own in self.rods))

    @property
    def strain_rate_values(self) -> SX:
        return ca.vertcat(*(own.strain_rate_values for own in self.rods))

    @property
    def tip(self) -> SX:
        raise SeveralTipsError

    @property
    def tip_angle(self) -> SX:
        raise SeveralTipsError

    @property
    def section_ends(self) -> list[SX]:
        return [end for own in self.rods for end in own.section_ends]

    def tip_turns(self) -> list[SX]:
        return []  # no moment acts on any of the tips

    @property
    def force_size(self) -> SX:
        return self.bending_stiffness / self.coordinate_size**2

    @property
    def internal_size(self) -> SX:
        return ca.vertcat(*(own.internal_size for own in self.rods))

    @property
    def internal_scale(self) -> SX:
        return ca.vertcat(*(own.internal_scale for own in self.rods))

    def masses(self) -> list[PointMass]:
        return [point for own in self.rods for point in own.masses()]

    def add_tip_mass(self, mass: SX) -> None:
        raise SeveralTipsError

    def add_carried_mass(self, per_section: list[SX]) -> None:
        for own, part in zip(self.rods, self._split(per_section), strict=True):
            own.add_carried_mass(part)

    def dissipation_powers(self, time: SX) -> list[SX]:
        each = zip(self.rods, self._of_sections(time), strict=True)
        return [power for own, part in each for power in own.dissipation_powers(part)]

    def rotary_energies(self, inertia_per_length: SX) -> list[SX]:
        each = zip(self.rods, self._of_sections(inertia_per_length), strict=True)
        return [energy for own, part in each for energy in own.rotary_energies(part)]

    def elastic_energies(self) -> list[SX]:
        return [energy for own in self.rods for energy in own.elastic_energies()]

    def stored_energies(self) -> list[SX]:
        return [energy for own in self.rods for energy in own.stored_energies()]

    def outputs(self) -> dict[str, SX]:
        each = [own.outputs() for own in self.rods]
        return {name: ca.vertcat(*(own[name] for own in each)) for name in each[0]}

    def _split(self, per_section: list[SX]) -> Iterator[list[SX]]:
        found = iter(per_section)
        for count in self._sections:
            yield [next(found) for _ in range(count)]

    def _of_sections(self, values: SX) -> list[SX]:
        """Numbers of the sections of each rod, from one for all or (S,)."""
        return parts_of(values, self._sections)


def parts_of(values: SX, sections: Sequence[int]) -> list[SX]:
    """Numbers of the sections of each rod, from one for all or (S,)."""
    if values.is_scalar():
        return [values] * len(sections)
    return list(ca.vertsplit(values, [0, *np.cumsum(sections).tolist()]))


@dataclass(frozen=True)
class SeveralRods(RodDiscretisation):
    """Chains side by side: ``edges_per_section`` are those of the rod with most sections.

    One with fewer has as many edges in all, or a few more.
    """

    is_shearable: bool = False

    @classmethod
    def suggested(cls, body: Body, accuracy: float, largest_turn: float) -> Self:
        most = max(own.sections for own in body.members)
        meshes = [Chain.suggested(own, accuracy, largest_turn) for own in body.members]
        return cls(body, max(-(-mesh.edges // most) for mesh in meshes))

    @property
    def chains(self) -> list[Chain]:
        """The mesh of every rod."""
        most = max(own.sections for own in self.body.members)
        found = [
            Chain(own, math.ceil(self.edges_per_section * most / own.sections))
            for own in self.body.members
        ]
        return [chain.shearable() for chain in found] if self.is_shearable else found

    @property
    def _joints(self) -> np.ndarray:
        """Where the sections of every rod but the first begin."""
        return np.cumsum([own.sections for own in self.body.members])[:-1]

    def shearable(self) -> SeveralRods:
        return replace(self, is_shearable=True)

    def symbols(self, parameters: RodParameters) -> SeveralRodsSymbols:
        own = tuple(replace(one, tip_moment=SX(0)) for one in parameters.members)
        shear = parameters.shear_stiffness
        if shear is not None:
            parts = parts_of(shear, [body.sections for body in self.body.members])
            own = tuple(
                replace(one, shear_stiffness=part) for one, part in zip(own, parts, strict=True)
            )
        each = zip(self.chains, own, strict=True)
        return SeveralRodsSymbols([chain.symbols(one) for chain, one in each], parameters)

    def unloaded_coordinates(self, curvature: np.ndarray, stretch: np.ndarray) -> np.ndarray:
        parts = zip(
            self.chains,
            np.split(curvature, self._joints),
            np.split(stretch, self._joints),
            strict=True,
        )
        places, angles = [], []
        for chain, bent, drawn in parts:
            found = chain.unloaded_coordinates(bent, drawn)
            # All rods are scaled by the length of the one that stands for them.
            places.append(found[: 2 * chain.edges] * (chain.body.length / self.body.length))
            angles.append(found[2 * chain.edges :])
        return np.concatenate([*places, *angles])

    def rods(self, values: Values) -> list[tuple[RodDiscretisation, Values]]:
        ends = np.cumsum([chain.edges for chain in self.chains])[:-1]
        joints = {"intrinsic_curvature": self._joints, "intrinsic_stretch": self._joints}
        cut = {
            name: np.split(
                values[name], 2 * ends if name == "position" else joints.get(name, ends), axis=1
            )
            for name in (*joints, *ROD_VALUES)
            if name in values
        }
        return [
            (chain, {name: parts[k] for name, parts in cut.items()})
            for k, chain in enumerate(self.chains)
        ]

    def section_strains(self, values: Values) -> tuple[np.ndarray, np.ndarray]:
        each = [rod.section_strains(own) for rod, own in self.rods(values)]
        stretch, turn = zip(*each, strict=True)
        return np.concatenate(stretch, axis=1), np.concatenate(turn, axis=1)

    def axis(self, values: Values, points: int) -> tuple[np.ndarray, np.ndarray]:
        raise TypeError("several rods have several axes: ask each of `rods`")

    def angle_jump(self, values: Values) -> tuple[int, int] | None:
        found, first = [], 0
        for rod, own in self.rods(values):
            jump = rod.angle_jump(own)
            found += [] if jump is None else [(jump[0], first + jump[1])]
            first += rod.body.sections
        return min(found, default=None)

    def elimination_order(self) -> tuple[np.ndarray, np.ndarray]:
        """The orders of the rods, one after the other."""
        edges = [chain.edges for chain in self.chains]
        internal, places, angles = 0, 2 * sum(edges), 4 * sum(edges)
        orders, inner = [], []
        for chain in self.chains:
            own, is_internal = chain.elimination_order()
            count = 2 * chain.edges
            offset = np.where(
                own < count,
                internal,
                np.where(own < 2 * count, places - count, angles - 2 * count),
            )
            orders.append(own + offset)
            inner.append(is_internal)
            internal, places, angles = internal + count, places + count, angles + chain.edges
        return np.concatenate(orders), np.concatenate(inner)

    def step_geometry(self, coordinates: slice) -> StepGeometry:
        found, start = [], coordinates.start
        for chain in self.chains:
            own = slice(start, start + 2 * chain.edges)
            found.append((own, chain.step_geometry(own)))
            start = own.stop
        return StepsOfSeveral(found)


class StepsOfSeveral(StepGeometry):
    """Each rod steps in its own way; all else goes straight."""

    def __init__(self, parts: Sequence[tuple[slice, StepGeometry]]) -> None:
        self._parts = parts

    def step(self, y: np.ndarray, step: np.ndarray) -> np.ndarray:
        after = np.asarray(y + step)
        for own, geometry in self._parts:
            after[own] = geometry.step(y, step)[own]
        return after

    def extrapolate(self, before: np.ndarray, now: np.ndarray, ratio: float) -> np.ndarray:
        after = np.asarray(now + ratio * (now - before))
        for own, geometry in self._parts:
            after[own] = geometry.extrapolate(before, now, ratio)[own]
        return after
