"""The equations of a leg over one step, and their derivatives, as functions of numbers."""

from __future__ import annotations

import sys
from dataclasses import astuple, fields
from functools import lru_cache, partial

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.formula_store import FormulaStore
from viscodesign.model.structure_digest import structure_digest
from viscodesign.model.taped_function import TapedFunction
from viscodesign.native.code_cache import written_by
from viscodesign.robot import leg_network, leg_pose, leg_rod
from viscodesign.robot.leg_design import LegDesign
from viscodesign.robot.leg_network import contents, inflows, section_pressures
from viscodesign.robot.leg_pose import (
    BODY,
    FOOT,
    MOUNT,
    Mount,
    foot_below,
    points_of_leg,
    tip_seen_from_leg,
)
from viscodesign.robot.leg_rod import STRAIN_POINTS, RodLoad, RodSection, RodShooting, ShotRod
from viscodesign.storage.cached_property import cached_property

SX = ca.SX
LOAD = 3
"""Force x and z at the tip, moment at the clamp."""


@dataclass(frozen=True, eq=False)
class LegSymbols:
    """All that the equations of a leg depend on."""

    place: SX
    """Body (4,), then foot (3,)."""
    load: SX
    pressures: SX
    mount: SX
    strains_before: SX
    """Curvatures, then stretches, at the points of all sections."""
    contents_before: SX
    source: SX
    """Gauge pressure of the leg's source [Pa]."""
    step: SX
    """Step [s], and damping time over the step [1]."""

    @classmethod
    def of(cls, design: LegDesign) -> LegSymbols:
        """Those of a design."""
        sections, nodes = len(design.free_sections), len(design.nodes)
        sizes = {
            "place": BODY + FOOT,
            "load": LOAD,
            "pressures": nodes,
            "mount": MOUNT,
            "strains_before": 2 * STRAIN_POINTS * sections,
            "contents_before": nodes,
            "source": 1,
            "step": 2,
        }
        return cls(*(SX.sym(name, size) for name, size in sizes.items()))

    def listed(self) -> list[SX]:
        """In the order of the functions' arguments."""
        return [
            *(self.place, self.load, self.pressures, self.mount),
            *(self.strains_before, self.contents_before, self.source, self.step),
        ]


class LegEquations:
    """The formulas of a leg over a step of implicit Euler."""

    def __init__(self, design: LegDesign) -> None:
        self.design = design
        own = self.symbols = LegSymbols.of(design)
        self.rod = shot_rod(design, own.load, own.pressures, own.strains_before, own.step[1])
        body, foot = own.place[:BODY], own.place[BODY:]
        self.seen = tip_seen_from_leg(body, foot, Mount.of(own.mount))

    def residual(self) -> SX:
        """The rod meets the foot [m, m, rad / m]; every node's content is what flowed in [1]."""
        own, design = self.symbols, self.design
        into, _ = inflows(design, own.pressures, own.source)
        held = contents(design, own.pressures, self.rod)
        balances = [
            (held[k] - own.contents_before[k] - own.step[0] * into[k]) / design.bellow.rest_volume
            for k in range(len(held))
        ]
        return ca.vertcat(self.rod.tip - self.seen, *balances)

    def reaction(self) -> SX:
        """What the leg's strains take from body and foot: their generalised forces (7,) [N, N m].

        It is minus what the leg does to them.
        """
        x, z, moment = ca.vertsplit(self.symbols.load)
        tip_moment = moment - x * self.seen[1] + z * self.seen[0]
        work = ca.vertcat(x, z, tip_moment)
        return ca.jtimes(self.seen, self.symbols.place, work, True)

    def axis(self) -> SX:
        """x and z of the ends of all sections over the ground's axes (2, S + 1) [m]."""
        nodes = ca.horzcat(*(node[:2] for node in self.rod.nodes))
        own = self.symbols
        return points_of_leg(own.place[:BODY], nodes, Mount.of(own.mount))

    def after(self) -> list[SX]:
        """Strains at the points, and the flows into the nodes and out of the source."""
        own = self.symbols
        into, drawn = inflows(self.design, own.pressures, own.source)
        strains = ca.vertcat(*self.rod.curvatures, *self.rod.stretches)
        return [strains, ca.vertcat(*into, drawn)]


def shot_rod(design: LegDesign, load: SX, pressures: SX, before: SX, rate: SX) -> ShotRod:
    """The rod at the pressures of its bellows; ``before``: strains a step before."""
    free, law = design.free_sections, design.bellow
    half = STRAIN_POINTS * len(free)
    sections = [
        RodSection(
            law.curvature_per_pressure * difference,
            law.stretch_per_pressure * total,
            before[STRAIN_POINTS * j : STRAIN_POINTS * (j + 1)],
            before[half + STRAIN_POINTS * j : half + STRAIN_POINTS * (j + 1)],
            free[j],
        )
        for j, (difference, total) in enumerate(section_pressures(design, ca.vertsplit(pressures)))
    ]
    return RodShooting(design, RodLoad(*ca.vertsplit(load)), rate).shoot(sections)


@dataclass(frozen=True, eq=False)
class LegFunctions:
    """The compiled equations of a design; rows of arguments are legs."""

    design: LegDesign
    linearised: TapedFunction
    """Residual and reaction, then their dense derivatives with respect to unknowns and place."""
    plain: TapedFunction
    """Residual and reaction."""
    after: TapedFunction
    hanging: TapedFunction
    """Tip (3,), contents and strains of a leg by load, pressures, strains before and step."""
    foot: TapedFunction
    """Foot by body, tip and mount."""
    axis: TapedFunction
    """x and z of the ends of all sections, in turn."""

    @property
    def unknowns(self) -> int:
        """Numbers of a leg that follow from its place: load and pressures."""
        return LOAD + len(self.design.nodes)


class _LegFormulas:
    """The formulas of a design's functions, made when they are first asked for."""

    def __init__(self, design: LegDesign) -> None:
        self._design = design

    @cached_property
    def _equations(self) -> LegEquations:
        return LegEquations(self._design)

    def function(self, name: str) -> ca.Function:
        """The function that `LegFunctions` has under a name, with dense columns as results."""
        makers = {
            "linearised": self._linearised,
            "plain": self._plain,
            "after": self._after,
            "hanging": self._hanging,
            "foot": self._foot,
            "axis": self._axis,
        }
        arguments, results = makers[name]()
        columns = [ca.densify(ca.vec(result)) for result in results]
        return ca.Function(name, arguments, columns, {"cse": True})

    def _linearised(self) -> tuple[list[SX], list[SX]]:
        equations, own = self._equations, self._equations.symbols
        both = [equations.residual(), equations.reaction()]
        unknown, formulas = ca.vertcat(own.load, own.pressures), ca.vertcat(*both)
        slopes = [ca.densify(ca.jacobian(formulas, by)) for by in (unknown, own.place)]
        return own.listed(), [*both, *slopes]

    def _plain(self) -> tuple[list[SX], list[SX]]:
        equations = self._equations
        return equations.symbols.listed(), [equations.residual(), equations.reaction()]

    def _after(self) -> tuple[list[SX], list[SX]]:
        return self._equations.symbols.listed(), self._equations.after()

    def _hanging(self) -> tuple[list[SX], list[SX]]:
        own, rod = self._equations.symbols, self._equations.rod
        held = ca.vertcat(*contents(self._design, own.pressures, rod))
        strains = ca.vertcat(*rod.curvatures, *rod.stretches)
        by_load = ca.densify(ca.jacobian(rod.tip, own.load))
        arguments = [own.load, own.pressures, own.strains_before, own.step]
        return arguments, [rod.tip, by_load, held, strains]

    def _foot(self) -> tuple[list[SX], list[SX]]:
        body, seen, mount = SX.sym("body", BODY), SX.sym("tip", 3), SX.sym("mount", MOUNT)
        return [body, seen, mount], [foot_below(body, seen, Mount.of(mount))]

    def _axis(self) -> tuple[list[SX], list[SX]]:
        return self._equations.symbols.listed(), [self._equations.axis()]


@lru_cache(16)
def leg_functions(design: LegDesign) -> LegFunctions:
    """The functions of a design, made once, and kept on disk for other processes."""
    formulas = _LegFormulas(design)
    key = ("leg", written_by(*FORMULATING), astuple(design))
    store = FormulaStore(structure_digest(key))

    def taped(name: str) -> TapedFunction:
        make = partial(formulas.function, name)
        return TapedFunction(store.tape(_LegFormulas, (name,), make), make)

    names = (field.name for field in fields(LegFunctions) if field.name != "design")
    return LegFunctions(design, **{name: taped(name) for name in names})


FORMULATING = (leg_network, leg_pose, leg_rod, sys.modules[__name__])
"""Modules whose code makes the formulas of a leg, beside those below this room."""


def matrices(entries: np.ndarray, rows: int) -> np.ndarray:
    """Matrices (m, rows, columns) from their columns one after the other (m, rows * columns)."""
    return np.swapaxes(entries.reshape(len(entries), -1, rows), 1, 2)
