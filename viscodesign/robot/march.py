"""A robot's motion by equal steps, recorded."""

from __future__ import annotations

from collections.abc import Callable
from copy import copy

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.gait_energy import GaitEnergy
from viscodesign.results.robot_motion import RobotMotion
from viscodesign.robot.energy import GaitEnergyLedger
from viscodesign.robot.leg_network import barrel_volume
from viscodesign.robot.leg_pose import BODY, FOOT
from viscodesign.robot.robot_model import RobotModel
from viscodesign.robot.time_step import RobotState, Step, StepSolver

FROZEN = 1e12
"""Damping time over the step by which a leg keeps its strains."""
MAX_HALVINGS = 6
"""Halvings of a step that does not converge."""
Progress = Callable[[float], None]
"""Told the fraction done."""


@dataclass(frozen=True, eq=False)
class RecordedWalk:
    """A motion, and what its solution left."""

    motion: RobotMotion
    velocities: np.ndarray
    """(T, size)"""
    states: tuple[RobotState, ...]
    """At the recorded rows."""
    whole: np.ndarray
    """Whether a step was done as a whole, and not in halves (T - 1,)."""
    gas_imbalance: float
    """Largest part of a bellow's content that its pressure does not account for."""
    energy: GaitEnergy
    stop: BaseException | None
    """What ended it early: a `SolveError`, or Ctrl-C."""


@dataclass(frozen=True)
class StepPlan:
    """How a motion is cut into steps."""

    period: float
    per_cycle: int
    cycles: int
    every: int
    """Steps from one recorded row to the next."""

    @property
    def count(self) -> int:
        """Steps of the whole motion."""
        return self.per_cycle * self.cycles

    def times(self) -> np.ndarray:
        """Times of all steps, the start first (T,) [s]."""
        return self.period / self.per_cycle * np.arange(self.count + 1)


def march(
    model: RobotModel,
    start: RobotState,
    pressures: Callable[[np.ndarray], np.ndarray],
    plan: StepPlan,
    progress: Progress | None = None,
) -> RecordedWalk:
    """The motion from a state; ``pressures`` of the sources at times (T,): gauge (T, S) [Pa].

    Where a step fails, or Ctrl-C comes, the motion ends before it, and tells so. Raises
    `SolveError` where the first step fails.
    """
    times = plan.times()
    sources = pressures(times)
    solver = StepSolver(model, plan.period / plan.per_cycle)
    table = StepTable(model, len(times))
    states, worst, now, ledger = [start], 0.0, start, GaitEnergyLedger(model)
    table.put(0, start)
    stop: BaseException | None = None
    for k in range(1, len(times)):
        try:
            steps = advanced(solver, now, sources[k - 1], sources[k])
        except (SolveError, KeyboardInterrupt) as error:
            if k == 1:
                raise
            stop, times = error, times[:k]
            break
        for step in steps:
            ledger.add(step)
        last = steps[-1]
        now = last.after
        table.put(k, now)
        table.whole[k - 1] = last.solver is solver
        if k % plan.every == 0:
            states.append(now)
            worst = max(worst, last.gas_imbalance())
            if progress is not None:
                progress(k / plan.count)
    table = table.until(len(times))
    motion = _motion(model, table, times, sources[: len(times)], states, plan)
    energy = ledger.balance(max(float(times[-1]) - plan.period, 0.0))
    return RecordedWalk(motion, table.velocity, tuple(states), table.whole, worst, energy, stop)


def advanced(solver: StepSolver, now: RobotState, begin: np.ndarray, end: np.ndarray) -> list[Step]:
    """The steps to a state a step later; ``begin``, ``end``: sources [Pa].

    A step that does not converge is halved, with the sources half way in its middle. Raises
    `SolveError` where that does not help.
    """
    try:
        return [Step(solver, now, solver.advance(now, end), begin, end)]
    except SolveError:
        if solver.halvings == MAX_HALVINGS:
            raise
    finer, middle = solver.halved(), (begin + end) / 2
    first = advanced(finer, now, begin, middle)
    return [*first, *advanced(finer, first[-1].after, middle, end)]


class StepTable:
    """Numbers of all steps."""

    def __init__(self, model: RobotModel, count: int) -> None:
        self.place = np.zeros((count, model.size))
        self.velocity = np.zeros((count, model.size))
        self.whole = np.ones(count - 1, dtype=bool)
        self.forces = np.zeros((count, 2 * model.count))
        self.drawn = np.zeros((count, len(model.source_names)))

    def until(self, count: int) -> StepTable:
        """The first ``count`` rows."""
        found = copy(self)
        for name in ("place", "velocity", "forces", "drawn"):
            setattr(found, name, getattr(self, name)[:count])
        found.whole = self.whole[: count - 1]
        return found

    def put(self, k: int, state: RobotState) -> None:
        """Write the numbers of a step."""
        self.place[k], self.velocity[k] = state.place, state.velocity
        self.forces[k], self.drawn[k] = state.contact_forces, state.drawn


def _motion(
    model: RobotModel,
    table: StepTable,
    times: np.ndarray,
    sources: np.ndarray,
    states: list[RobotState],
    plan: StepPlan,
) -> RobotMotion:
    count, place = model.count, table.place
    feet = place[:, BODY:].reshape(len(times), count, FOOT).copy()
    feet[:, :, 1] = -feet[:, :, 1] - model.feet.radius
    slip_rows = model.contact_rows[count:]
    heights = np.array([float(np.mean(model.hip_heights(row))) for row in place])
    body = np.column_stack([place[:, 0], heights, place[:, 2], place[:, 3]])
    body[:, 0] -= body[0, 0]
    fluid = model.groups[0].functions.design.fluid
    left = np.max(table.drawn, axis=0) - table.drawn
    return RobotMotion(
        legs=model.leg_names,
        sources=model.source_names,
        source_of=model.source_of,
        foot_radius=model.feet.radius,
        period=plan.period,
        time=times,
        body=body,
        feet=feet,
        normal=table.forces[:, :count],
        friction=table.forces[:, count:],
        slip=np.vstack([np.zeros(count), np.diff(place, axis=0) @ slip_rows.T]),
        pressure=sources,
        delivered=table.drawn,
        barrel=barrel_volume(fluid, left, sources),
        rows=np.arange(0, len(times), plan.every),
        axes=np.array([_axes(model, state) for state in states]),
    )


def _axes(model: RobotModel, state: RobotState) -> np.ndarray:
    """x and height of the ends of all sections of every leg (L, n, 2) [m]."""
    longest = max(len(group.functions.design.free_sections) for group in model.groups)
    found = np.full((model.count, longest + 1, 2), np.nan)
    for group, legs in zip(model.groups, state.legs, strict=True):
        rows = len(group.legs)
        kept = [legs.content, np.zeros((rows, 1)), np.tile([0.0, FROZEN], (rows, 1))]
        (points,) = group.functions.axis.rows(
            [state.place[group.places], legs.load, legs.pressure, group.mounts, legs.strains,
             *kept],
            rows,
        )  # fmt: skip
        own = points.reshape(rows, -1, 2) * [1.0, -1.0]
        found[group.legs, : own.shape[1]] = own
    return found
