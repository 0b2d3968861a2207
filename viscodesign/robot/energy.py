"""The energy of a robot over its steps: what is stored, what does work, and what is lost.

Over a step of implicit Euler the balance is an identity but for the fluid, whose works are
integrated by the trapezoidal rule: what the steps themselves take is counted apart, as a loss.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.physics.friction_problem import OPEN
from viscodesign.results.gait_energy import GaitEnergy
from viscodesign.robot.leg_design import LegDesign
from viscodesign.robot.leg_network import barrel_volume, flow, specific_work
from viscodesign.robot.leg_rod import STRAIN_POINTS
from viscodesign.robot.robot_model import LegGroup, RobotModel
from viscodesign.robot.time_step import Step

STEPS_AT_ONCE = 100
"""Steps that are balanced at once."""
WORKS = ("pump", "coupling", "friction")
LOSSES = ("tubes", "material", "impacts", "steps")
SIMPSON = np.array([1.0, 4.0, 1.0]) / 6
"""Weights of the points of a section."""


class GaitEnergyLedger:
    """Works, losses and stored energy of consecutive steps."""

    def __init__(self, model: RobotModel) -> None:
        self.model = model
        self._steps: list[Step] = []
        self._blocks: list[np.ndarray] = []
        self._landed = np.zeros(model.count, dtype=bool)
        """Feet that came down in the step before."""

    def add(self, step: Step) -> None:
        """Add the step that follows those before."""
        self._steps.append(step)
        if len(self._steps) == STEPS_AT_ONCE:
            self._close()

    def balance(self, cycle_begin: float) -> GaitEnergy:
        """Of the whole motion, and of the last cycle, which begins at a time [s]."""
        if self._steps:
            self._close()
        rows = np.concatenate(self._blocks)
        time, sums = rows[:, 0], np.cumsum(rows[:, 1:], axis=0)
        count = len(WORKS) + len(LOSSES)
        stored = sums[:, count:]
        done, lost = sums[:, : len(WORKS)], sums[:, len(WORKS) : count]
        off = stored.sum(axis=1) + lost.sum(axis=1) - done.sum(axis=1)
        swing = float(np.ptp(np.append(stored.sum(axis=1), 0.0)))
        scale = max(swing, float(np.max(np.abs(done[:, :2]))))
        before = np.searchsorted(time, cycle_begin * (1 + 1e-9))
        last = sums[-1] - (sums[before - 1] if before else 0.0)
        return GaitEnergy(
            work_j=dict(zip(WORKS, done[-1].tolist(), strict=True)),
            loss_j=dict(zip(LOSSES, lost[-1].tolist(), strict=True)),
            stored_j=float(stored[-1].sum()),
            cycle_work_j=dict(zip(WORKS, last[: len(WORKS)].tolist(), strict=True)),
            cycle_loss_j=dict(zip(LOSSES, last[len(WORKS) : count].tolist(), strict=True)),
            cycle_stored_j=float(last[count:].sum()),
            imbalance_rel=float(np.max(np.abs(off)) / scale) if scale else 0.0,
        )

    def _close(self) -> None:
        """Balance the steps at hand: a row for each."""
        steps, self._steps = self._steps, []
        step = np.array([own.solver.step for own in steps])
        friction, impacts, stepped, moved = self._of_bodies(steps)
        legs = [self._of_legs(index, group, steps) for index, group in enumerate(self.model.groups)]
        pump, coupling, tubes, material, rod_steps, elastic, fluid = np.sum(legs, axis=0)
        begin = np.array([own.begun.time for own in steps])
        self._blocks.append(
            np.column_stack([
                *(begin + step, pump, coupling, friction),
                *(tubes, material, impacts, stepped + rod_steps),
                *(moved, elastic, fluid),
            ])
        )  # fmt: skip

    def _of_bodies(self, steps: Sequence[Step]) -> tuple[np.ndarray, ...]:
        """Work of friction, losses in impacts and by the steps, and energy gained (n,) each [J]."""
        model, count = self.model, self.model.count
        places = np.array([steps[0].begun.place, *(own.after.place for own in steps)])
        velocities = np.array([steps[0].begun.velocity, *(own.after.velocity for own in steps)])
        forces = np.array([own.after.contact_forces for own in steps])
        moved, faster = np.diff(places, axis=0), np.diff(velocities, axis=0)
        slips = moved @ model.contact_rows[count:].T
        kinetic = np.diff(velocities**2 @ model.masses) / 2
        gained = kinetic - moved @ model.weights
        falls = np.array([own.fall for own in steps])
        stopped = faster * (faster - falls) @ model.masses / 2
        stopped_normal = np.sum(
            forces[:, :count] * np.array([model.gaps(p) for p in places[:-1]]), 1
        )
        is_impact = self._impacts(steps)
        impacts = stopped_normal + np.where(is_impact, stopped, 0.0)
        friction = np.sum(forces[:, count:] * slips, axis=1)
        return friction, impacts, np.where(is_impact, 0.0, stopped), gained

    def _impacts(self, steps: Sequence[Step]) -> np.ndarray:
        """Whether a foot comes down in a step (n,), or came down in the one before.

        The gap closes in the first; the velocity that closed it is lost in the second.
        """
        found = []
        for own in steps:
            was = np.array([state == OPEN for state in own.begun.contact_states])
            now = np.array([state == OPEN for state in own.after.contact_states])
            landed = was & ~now
            found.append(bool(np.any(landed | self._landed)))
            self._landed = landed
        return np.array(found)

    def _of_legs(self, index: int, group: LegGroup, steps: Sequence[Step]) -> np.ndarray:
        """Of a group of legs: works of pump and coupling, losses in tubes, by damping and by the
        steps, elastic and fluid energy gained (7, n) [J]."""
        states = [steps[0].begun.legs[index], *(own.after.legs[index] for own in steps)]
        sources = np.array([steps[0].begin, *(own.end for own in steps)])[:, group.sources]
        step = np.array([own.solver.step for own in steps])
        design = group.functions.design
        pressures = np.array([own.pressure for own in states])
        bellows = pressures[:, :, : design.bellows]
        contents = np.array([own.content[:, : design.bellows] for own in states])
        rod = _Rod.of(design, np.array([own.strains for own in states]), bellows)
        fluid = _Fluid.of(design, contents, bellows)
        unpaired = _means(fluid.driven - rod.conjugate_volumes(design))
        coupling = np.sum(unpaired * np.diff(bellows, axis=0), axis=(1, 2))
        pumped, lost = _flow_powers(design, pressures, sources)
        rate = self.model.damping_time / step
        moved = np.diff(rod.strains, axis=0)
        return np.array([
            step * _means(pumped),
            coupling,
            step * _means(lost),
            rate * rod.integral(design, moved, moved * _stiffness(design)),
            rod.integral(design, np.diff(rod.resultants, axis=0) / 2, moved),
            np.diff(rod.integral(design, rod.resultants / 2, rod.elastic)),
            np.diff(fluid.energy),
        ])  # fmt: skip


@dataclass(frozen=True, eq=False)
class _Rod:
    """Strains of the rods of legs; the second axis from the end: curvature, stretch."""

    strains: np.ndarray
    """(n, l, 2, sections, STRAIN_POINTS)"""
    elastic: np.ndarray
    """Those beyond what pressure does."""
    resultants: np.ndarray
    """Elastic moment [N m] and normal force [N]; none where a section is stiff."""

    @classmethod
    def of(cls, design: LegDesign, strains: np.ndarray, bellows: np.ndarray) -> _Rod:
        sections = len(design.free_sections)
        whole = strains.reshape(*strains.shape[:2], 2, sections, STRAIN_POINTS)
        placed = np.zeros((len(design.sections), sections))
        placed[np.arange(len(placed)), list(design.sections)] = 1.0
        law, free = design.bellow, np.array(design.free_sections, dtype=float)
        difference = (bellows * np.array(design.sides)) @ placed * free
        total = bellows @ placed * free
        by_pressure = np.stack(
            [law.curvature_per_pressure * difference, law.stretch_per_pressure * total], axis=2
        )
        elastic = whole - by_pressure[..., None]
        resultants = elastic * _stiffness(design) * free[:, None]
        return cls(whole, elastic, resultants)

    def integral(self, design: LegDesign, left: np.ndarray, right: np.ndarray) -> np.ndarray:
        """Of a product over all rods (n,)."""
        return np.asarray(design.section_length * np.sum(left * right * SIMPSON, axis=(1, 2, 3, 4)))

    def conjugate_volumes(self, design: LegDesign) -> np.ndarray:
        """Volumes that bellows would give up to the resultants if the coupling were reciprocal
        (n, l, B) [m3]."""
        law = design.bellow
        means = design.section_length * np.sum(self.resultants * SIMPSON, axis=-1)
        own = means[..., list(design.sections)]
        bent = law.curvature_per_pressure * np.array(design.sides) * own[:, :, 0]
        return np.asarray(bent + law.stretch_per_pressure * own[:, :, 1])


@dataclass(frozen=True, eq=False)
class _Fluid:
    """What fills the bellows of legs."""

    driven: np.ndarray
    """Volume beyond that of a free wall at the same pressure (n, l, B) [m3]."""
    energy: np.ndarray
    """Of walls and fluid (n,) [J]."""

    @classmethod
    def of(cls, design: LegDesign, contents: np.ndarray, bellows: np.ndarray) -> _Fluid:
        law, fluid = design.bellow, design.fluid
        volumes = barrel_volume(fluid, contents, bellows)
        driven = volumes - law.rest_volume - law.compliance * bellows
        energy = law.compliance * bellows**2 / 2 + bellows * driven
        energy += contents * specific_work(fluid, bellows) - bellows * volumes
        return cls(driven, energy.sum(axis=(1, 2)))


def _stiffness(design: LegDesign) -> np.ndarray:
    """Bending [N m2] and extension [N], to be multiplied with strains."""
    return np.array([design.bending_stiffness, design.extension_stiffness])[:, None, None]


def _flow_powers(
    design: LegDesign, pressures: np.ndarray, sources: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Power that sources give and tubes lose (n,) [W], at pressures (n, l, m) and (n, l)."""
    ends = np.concatenate([pressures, sources[:, :, None]], axis=2)
    works = specific_work(design.fluid, ends)
    given, lost = np.zeros((2, len(ends)))
    for tube in design.tubes:
        rate = flow(design.fluid, tube, ends[..., tube.start], ends[..., tube.end], np)
        lost += np.sum(rate * (works[..., tube.start] - works[..., tube.end]), axis=1)
        for node, sign in ((tube.start, 1.0), (tube.end, -1.0)):
            if node < 0:
                given += sign * np.sum(rate * works[..., node], axis=1)
    return given, lost


def _means(values: np.ndarray) -> np.ndarray:
    """Of neighbours along the first axis."""
    return np.asarray((values[1:] + values[:-1]) / 2)
