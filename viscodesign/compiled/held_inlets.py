"""A scene under inlets that are held from one interval to the next: for control loops."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from numbers import Real

import numpy as np

from viscodesign.compiled.problem_at import problem_at
from viscodesign.compiled.reading import Members, places_of
from viscodesign.compiled.scene_numbers import ProblemNumbers
from viscodesign.compiled.solution import MotionFunction
from viscodesign.effects.base import Effect
from viscodesign.errors import SpecError, did_you_mean
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.formulation import formulate
from viscodesign.simulation.build_problem import (
    Settings,
    assemble,
    resolvable_body,
    sizes_of,
    wide_tubes,
)
from viscodesign.solve.problem import Pieces, Problem, Schedule
from viscodesign.solve.solvers.rodas_native import NativeSteps
from viscodesign.solve.statics import Start

Inlets = float | Mapping[str, float]
"""By inlet: pressure above the baseline [Pa], or volume that its plunger has pushed out [m3]; a
number alone for the only inlet."""


@dataclass(frozen=True)
class ControlState:
    """A scene at an instant."""

    time: float
    """Since the start [s]."""
    outputs: Mapping[str, float]
    """Every column of `trajectory.csv` but flows that are not unknowns, SI, pressures gauge."""
    unknowns: Start
    parameters: np.ndarray
    """Parameters of the equations, for the values that the run began with."""
    size: float | None = None
    """First step that suits what follows [s]."""


class HeldInlets:
    """Goes on from a state by intervals in which every inlet is held.

    Made of the problem of a run, whose equations but for the inlets it shares. Raises
    `NativeUnavailable` where native code does not take them.
    """

    def __init__(
        self,
        quantities: SceneQuantities,
        effects: Sequence[Effect],
        settings: Settings,
        run: Problem,
    ) -> None:
        members = Members.of(quantities)
        self._inlets = members.inlets
        self._problem = _held_problem(quantities, effects, run)
        self._tolerance = settings.tolerance
        self._columns = list(places_of(self._problem, members))
        self._motion = MotionFunction(
            self._problem, settings.tolerance, members, self._columns, start="equilibrium"
        )

    def begin(self, parameters: np.ndarray, inlets: Inlets | None) -> ControlState:
        """The equilibrium with the inlets held. Raises `SolveError` where there is none."""
        given = dict.fromkeys(self._inlets, 0.0) if inlets is None else inlets
        numbers = self._numbers(parameters, given, 0.0, 1.0)
        problem = problem_at(self._problem, np.zeros(1), numbers)
        begin = self._motion.begin(NativeSteps(problem, self._tolerance), numbers)
        states, unknowns = problem.equations.states.count, problem.unknowns
        start = Start(begin[:states], begin[states:unknowns])
        return self._state(problem, numbers, 0.0, start, None)

    def step(self, state: ControlState, dt: float, inlets: Inlets) -> ControlState:
        """The state after ``dt`` [s]. Raises `SolveError` where the solution fails."""
        if not isinstance(dt, Real) or not 0.0 < dt < np.inf:
            raise SpecError.plain(f"dt: must be a positive number of seconds; got {dt!r}")
        if len(state.parameters) != len(self._problem.equations.parameter_values):
            raise SpecError.plain("state: belongs to another compiled function")
        end = state.time + dt
        numbers = self._numbers(state.parameters, inlets, state.time, end)
        problem = problem_at(self._problem, np.array([end]), numbers)
        part = self._motion.advance(
            NativeSteps(problem, self._tolerance),
            state.unknowns,
            (state.time, numbers.pieces[0]),
            np.array([end]),
            state.size,
        )
        return self._state(problem, numbers, end, part.end, part.size)

    def _state(
        self,
        problem: Problem,
        numbers: ProblemNumbers,
        time: float,
        unknowns: Start,
        size: float | None,
    ) -> ControlState:
        values = np.concatenate([unknowns.states, unknowns.algebraics])[None]
        read = self._motion.reading(problem, np.array([time]), numbers, values)
        found = dict(zip(self._columns, read.columns[0].tolist(), strict=True))
        return ControlState(time, found, unknowns, numbers.parameters, size)

    def _numbers(
        self, parameters: np.ndarray, inlets: Inlets, begin: float, end: float
    ) -> ProblemNumbers:
        """Numbers of an interval."""
        given = inlets if isinstance(inlets, Mapping) else {self._inlets[0]: inlets}
        unknown = [name for name in given if name not in self._inlets]
        if unknown or len(given) < len(self._inlets):
            names = ", ".join(self._inlets)
            hint = did_you_mean(unknown[0], self._inlets) if unknown else ""
            raise SpecError.plain(f"inlets: needs one value each for {names}{hint}")
        listed = [given[name] for name in self._inlets]
        if not all(isinstance(value, Real) and np.isfinite(value) for value in listed):
            raise SpecError.plain(f"inlets: must be finite numbers; got {listed}")
        values = np.array(listed, dtype=float)
        return ProblemNumbers(parameters, values[None], values, np.array([begin, end]))


def _held_problem(quantities: SceneQuantities, effects: Sequence[Effect], run: Problem) -> Problem:
    """The problem of a run with a constant at every inlet, which is its only coefficient."""
    system = assemble(quantities, effects, run.rod, resolvable_body(quantities), held=True)
    system.wide = wide_tubes(quantities)
    still = np.zeros(len(quantities.scene.inputs))
    schedule = Schedule(
        edges=np.array([0.0, 1.0]),
        pieces=Pieces(still[None], np.zeros(1, dtype=np.int64), 1),
        outputs=np.array([1]),
        initial_piece=still,
    )
    equations = formulate(system, sizes_of(quantities))
    return replace(run, equations=equations, schedule=schedule, has_straight_inputs=True)
