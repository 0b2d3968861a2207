"""The actuator behind a simulated pump, in real time: the coupled model, tick by tick."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from viscodesign.checks.contact import refuse_contact
from viscodesign.effects.catalogue import catalogue
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.postprocess.outputs import Outputs
from viscodesign.pump.planning.demand import PumpDemand, feed_line_at
from viscodesign.pump.planning.demand_kinds import demand_kind, pump_of
from viscodesign.pump.planning.scene_variants import planned, with_inputs
from viscodesign.pump.simulated.plant import Plant
from viscodesign.scene.pumps.base import PumpSpec
from viscodesign.scene.scene import Scene
from viscodesign.simulation.build_problem import build, suggest_settings
from viscodesign.solve.problem import Pieces, Problem, Schedule, evaluate_along
from viscodesign.solve.solvers.base import Solver, Work
from viscodesign.solve.solvers.quasi_static import QuasiStatic
from viscodesign.solve.statics import Start, equilibrium
from viscodesign.solve.transient import SPARE_SOLVER, solver_catalogue

STEP_TOLERANCE = 1e-3  # of the integrator: about half a percent of the length at the tip
LONGEST_INTERVAL = 0.05  # a longer tick is cut into such [s]
ANY_LENGTH = "rosenbrock"  # the solver that takes intervals of any length without being made anew
INTERVAL = 0.01  # intervals of any other; what is left over waits for the next tick [s]


class ActuatorPlant(Plant):
    """Gauge pressures at the inlets, and the tip, of a scene's actuator.

    Filled at the baseline with all axes at home, it begins in equilibrium, there or where a
    first `advance` by no time puts them. `advance` raises `SolveError` where the model fails.
    """

    def __init__(self, scene: Scene) -> None:
        pump, scene = pump_of(scene), planned(scene)
        self._axes, self._problem = _driven_problem(scene, pump)
        self._solver = _solver(self._problem)
        self._any_length = not isinstance(self._solver, solver_catalogue()[SPARE_SOLVER])
        self._owed = 0.0
        self._work = Work()
        self._begin(np.zeros(len(scene.inputs)))

    @property
    def steps(self) -> int:
        """Steps of the integrator so far."""
        return self._work.steps

    def advance(self, seconds: float, positions: np.ndarray) -> np.ndarray:
        """Gauge pressures (P,) [Pa] after some time in which the axes move evenly to a place.

        ``positions`` (P,) in SI; a plunger goes no further than its barrel is filled.
        """
        places = zip(self._axes, positions, strict=True)
        goal = np.array([float(axis.possible(position)) for axis, position in places])
        begin = self._position
        if seconds <= 0.0 and self._work.steps == 0:
            self._begin(goal)
        count, length = self._intervals(seconds)
        for k in range(1, count + 1):
            self._tick(length, begin + k / count * (goal - begin))
        return self.pressure

    def _begin(self, position: np.ndarray) -> None:
        """Equilibrium with the axes at a place."""
        schedule = self._schedule(INTERVAL, position, position)
        self._here = equilibrium(self._problem, 0.0, schedule.initial_piece)
        self._read(schedule, position)

    def _intervals(self, seconds: float) -> tuple[int, float]:
        """Number and length [s] of the intervals of a tick."""
        if seconds <= 0.0:
            return 0, 0.0
        if self._any_length:
            count = int(np.ceil(seconds / LONGEST_INTERVAL - 1e-9))
            return count, seconds / count
        self._owed += seconds
        count = int(self._owed / INTERVAL + 1e-9)
        self._owed -= count * INTERVAL
        return count, INTERVAL

    def _tick(self, seconds: float, goal: np.ndarray) -> None:
        """One interval of the integrator."""
        schedule = self._schedule(seconds, self._position, goal)
        self._solver.problem = replace(self._problem, schedule=schedule)
        (states, algebraics, _), failure = self._solver(self._here, 0, 1, self._work)
        if failure is not None:
            raise failure
        self._here = Start(states[:, -1], algebraics[:, -1])
        self._read(schedule, goal)

    def _schedule(self, seconds: float, begin: np.ndarray, end: np.ndarray) -> Schedule:
        """One interval in which the axes move evenly."""
        first, last = (
            np.array([axis.input_value(p) for axis, p in zip(self._axes, place, strict=True)])
            for place in (begin, end)
        )
        piece = np.stack((first, (last - first) / seconds, 0.0 * first), axis=1).ravel()
        pieces = Pieces(piece[None, :], np.array([0]), 1)
        return Schedule(np.array([0.0, seconds]), pieces, np.array([0, 1]), piece)

    def _read(self, schedule: Schedule, position: np.ndarray) -> None:
        self._position = position
        problem = replace(self._problem, schedule=schedule)
        values = evaluate_along(problem, self._here.states[:, None], self._here.algebraics[:, None])
        self.pressure: np.ndarray = values["inlet_pressure"][0].copy()  # (P,) gauge [Pa]
        outputs = Outputs(problem, 0, 0, 1, np.zeros(1), values)
        self.tip: np.ndarray = outputs.tips(np.zeros(1, dtype=int))[0]  # x, z [m], angle [rad]


def _driven_problem(scene: Scene, pump: PumpSpec) -> tuple[list[PumpDemand], Problem]:
    """The axes at the scene's inlets, at home, and its equations with them."""
    refuse_contact(SceneQuantities(scene), "a simulated pump")
    names = select_effects(SceneQuantities(scene)).active
    times, home = np.array([0.0, 1.0]), np.zeros(2)
    axes = [
        demand_kind(pump)(
            scene, pump, name, feed_line_at(scene, name, names), times, 0.0, home, home
        )
        for name in scene.inputs
    ]
    inputs = {axis.inlet: axis.source(times, home) for axis in axes}
    quantities = SceneQuantities(with_inputs(scene, inputs))
    effects = [kind.of(quantities) for name, kind in catalogue().items() if name in names]
    return axes, build(quantities, effects, suggest_settings(quantities, effects))


def _solver(problem: Problem) -> Solver:
    if not problem.equations.states.count:
        return QuasiStatic(problem, STEP_TOLERANCE)
    kind = solver_catalogue()[ANY_LENGTH]
    if not (kind.takes(problem) and kind.fits(problem)):
        kind = solver_catalogue()[SPARE_SOLVER]
    return kind(problem, STEP_TOLERANCE)
