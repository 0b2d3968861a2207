"""The contract of every solver, and their agreement with each other."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.scene.scene import Scene
from viscodesign.simulation.build_problem import Settings, build, suggest_settings
from viscodesign.simulation.solve_once import Run, solve, tip_difference
from viscodesign.solve.solvers.idas import Idas
from viscodesign.solve.solvers.rosenbrock import Rosenbrock
from viscodesign.solve.transient import DEFAULT_SOLVER, SPARE_SOLVER, solver_catalogue

SHORT = "run={duration: 0.4 s, output_interval: 0.05 s}"
CORNERS = "input={kind: square, high: 20 kPa, low: 0, frequency: 5, duty: 0.3}"
SCENES = {
    "one-way": (SHORT, "effects={pressure_distribution: on, others: off}"),
    "damped, two-way": (SHORT, "effects={pressure_distribution: on, inertia: on, damping: on, feedback: on, others: off}"),
    "massless": (SHORT, "loads.gravity=on", "effects={pressure_distribution: on, gravity: on, others: off}"),
    "gas, turbulent, with corners": (SHORT, CORNERS, "effects={pressure_distribution: on, gas_compressibility: on, fluid_inertance: on, flow_regime: on, others: off}"),
}  # fmt: skip
SOLVERS = list(solver_catalogue())


def solved(scene: Scene, solver: str, tolerance: float) -> Run:
    quantities = SceneQuantities(scene)
    effects = select_effects(quantities).effects
    return solve(quantities, effects, Settings(1, tolerance, solver))


def test_the_default_solver_is_listed_first() -> None:
    assert SOLVERS[0] == DEFAULT_SOLVER
    assert SPARE_SOLVER in SOLVERS
    assert len(SOLVERS) >= 3


@pytest.mark.parametrize("overrides", SCENES.values(), ids=SCENES)
@pytest.mark.parametrize("solver", SOLVERS)
def test_solvers_agree(solver: str, overrides: tuple[str, ...]) -> None:
    """Different methods by different authors give the same tip and pressures."""
    scene = leg(*overrides)
    other = DEFAULT_SOLVER if solver != DEFAULT_SOLVER else SPARE_SOLVER
    one, two = solved(scene, solver, 1e-6), solved(scene, other, 1e-8)
    assert one.is_complete
    length = scene.actuator.length
    assert tip_difference(one.motion, two.motion) <= 2e-5 * length
    apart = np.max(np.abs(one.motion.pressure - two.motion.pressure))
    assert apart <= 1e-4 * np.max(np.abs(two.motion.pressure))


@pytest.mark.parametrize("solver", SOLVERS)
def test_balances_hold(solver: str) -> None:
    run = solved(leg(*SCENES["damped, two-way"]), solver, 1e-6)
    assert run.motion.invariants.volume_imbalance_rel is not None
    assert run.motion.invariants.volume_imbalance_rel <= 1e-12
    assert run.motion.invariants.energy_imbalance_rel is not None
    assert run.motion.invariants.energy_imbalance_rel <= 1e-4


@pytest.mark.parametrize("solver", SOLVERS)
def test_error_follows_the_tolerance(solver: str) -> None:
    scene = leg(*SCENES["damped, two-way"])
    exact = solved(scene, DEFAULT_SOLVER, 1e-10)
    runs = [solved(scene, solver, tolerance) for tolerance in (1e-3, 1e-5)]
    errors = [tip_difference(run.motion, exact.motion) for run in runs]
    assert errors[1] <= errors[0] / 8
    # The default solver's, where the solver does not take these equations.
    per_tolerance = solver_catalogue()[runs[1].solution.solver].tip_error_per_tolerance
    assert errors[1] <= 3 * per_tolerance * 1e-5 * scene.actuator.length


UNDAMPED = (
    "actuator.damping_time=0", "loads.tip_force.x=0.3 N", "input={kind: constant, value: 0}",
    "run={duration: 0.5 s, output_interval: 10 ms, start: rest}",
    "effects={inertia: on, others: off}", "accuracy=0.1 %",
)  # fmt: skip


def test_undamped_vibration_needs_few_steps() -> None:
    """Nine periods of a released beam, for which BDF needs thousands of steps."""
    quantities = SceneQuantities(leg(*UNDAMPED))
    effects = select_effects(quantities).effects
    settings = suggest_settings(quantities, effects)
    assert settings.solver == DEFAULT_SOLVER
    run = solve(quantities, effects, settings)
    assert run.is_complete
    assert run.solution.work.steps <= 400
    assert (run.motion.invariants.energy_imbalance_rel or 0.0) <= 2e-2


TAKEN = {
    "one-way": SCENES["one-way"],
    "gas": SCENES["gas, turbulent, with corners"],
    # A junction whose tubes' flows are all unknowns: the line of its pressure is a tube's, which
    # must touch it; here the first one does not.
    "turbulent fork": (
        SHORT,
        "bellows.count=8",
        "network={layout: custom, tube_length: 40 mm, tube_radius: 0.5 mm, tubes: [{from: inlet, to: R1}, {from: R1, to: j}, {from: j, to: R2}, {from: j, to: L1}]}",
        "effects={flow_regime: on, pressure_distribution: on, others: off}",
    ),
}


@pytest.mark.parametrize("scene", TAKEN)
def test_every_equation_has_its_own_unknown_as_rosenbrock_needs(scene: str) -> None:
    overrides = TAKEN[scene]
    quantities = SceneQuantities(leg(*(str(word) for word in overrides)))
    problem = build(quantities, select_effects(quantities).effects, Settings(1, 1e-6))
    assert Rosenbrock.takes(problem)
    assert Idas.takes(problem)
    assert solved(leg(*(str(word) for word in overrides)), "rosenbrock", 1e-5).is_complete
