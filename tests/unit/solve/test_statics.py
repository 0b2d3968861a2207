"""Steady states that plain Newton does not find: fast flow, and snapping bellows."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg, problem_of
from viscodesign import simulate
from viscodesign.errors import SolveError
from viscodesign.solve.initial_guess import unloaded
from viscodesign.solve.problem import evaluate

THROUGH = (
    "inputs={inlet: {kind: constant, value: 0}, other: {kind: constant, value: 30 kPa}}",
    "input=null",
    "network={layout: custom, tube_length: 37.5 mm, tube_radius: 0.325 mm, tubes: [{from: inlet, to: R1}, {from: R1, to: R2}, {from: R2, to: other}, {from: R2, to: R3}]}",
    "run={duration: 0.1 s}",
)
CURVE = "bellows.curve={rows: [[-20 kPa, -4e-5, 0, 0], [0, 0, 0, 0], [20 kPa, 5e-5, 0, 0], [10 kPa, 1e-4, 0, 0], [40 kPa, 2e-4, 0, 0]]}"
SNAPPING = (CURVE, "effects={material_curve: on, pressure_distribution: on, others: off}")


@pytest.mark.parametrize("viscosity", [1e-3, 1e-6, 1e-9, 1e-12])
def test_steady_flow_converges_at_any_reynolds_number(viscosity: float) -> None:
    """Three equal tubes in series share the pressure under any law: Re up to 1e12."""
    run = simulate(
        leg(
            *THROUGH,
            f"fluid={{name: own, viscosity: {viscosity}, density: 1000}}",
            "effects={flow_regime: on, pressure_distribution: on, others: off}",
        ),
        verify=False,
    )
    assert run.status == "complete", run.failure
    names = [run.bellows.index(name) for name in ("R1", "R2", "R3")]
    assert run.pressure[-1, names] == pytest.approx(np.array([1e4, 2e4, 2e4]), rel=1e-9)
    through = run.flow[-1, [run.tubes.index(name) for name in ("inlet-R1", "R1-R2", "R2-other")]]
    assert np.ptp(through) <= 1e-9 * np.max(np.abs(through))


@pytest.mark.parametrize("pressure", [-15e3, 0.0, 15e3, 19.9e3])
def test_a_snapping_bellow_starts_on_its_first_stable_branch(pressure: float) -> None:
    run = simulate(
        leg(*SNAPPING, f"input={{kind: constant, value: {pressure}}}", "run={duration: 0.1 s}"),
        verify=False,
    )
    assert run.status == "complete", run.failure
    assert run.pressure == pytest.approx(pressure, abs=1e-6)
    area = (run.volume - 0.010 * 0.012 * 0.018) / 0.018
    assert np.max(np.abs(area)) <= 5e-5
    if pressure:
        assert np.sign(area[-1, 0]) == np.sign(pressure)
    else:
        assert abs(area[-1, 0]) <= 1e-15


def test_a_start_beyond_the_snap_is_refused_with_a_remedy() -> None:
    with pytest.raises(SolveError, match="snaps") as caught:
        simulate(leg(*SNAPPING, "input={kind: constant, value: 25 kPa}"))
    assert "run.start: rest" in str(caught.value)
    later = simulate(
        leg(
            *SNAPPING, "input={kind: constant, value: 25 kPa}", "run={duration: 20 s, start: rest}"
        ),
        verify=False,
    )
    assert later.status == "complete", later.failure
    assert later.pressure[-1] == pytest.approx(25e3, rel=0.02)
    assert later.volume[-1].min() > 0.018 * 1.5e-4


def test_sealed_parts_are_filled_at_the_unloaded_shape() -> None:
    """The straight initial guess carries forces, which displace volume; the result must not."""
    scene = leg(
        "bellows.count=4",
        "bellows.area_per_pressure=1e-10",
        "network={layout: custom, tube_length: 37.5 mm, tube_radius: 0.325 mm, tubes: [{from: inlet, to: R1}, {from: R1, to: L1}, {from: R2, to: L2}]}",
        "input={kind: constant, value: 20 kPa}",
        "run={duration: 0.1 s}",
        "effects={pressure_distribution: on, gravity: on, feedback: on, others: off}",
        "loads.gravity={tilt: 60 deg}",
        "bellows.area_per_moment=0",
        "bellows.area_per_force=3e-9",
        "gauge_pressure=5 kPa",
    )
    problem = problem_of(scene)
    piece = problem.schedule.pieces[0]
    y = unloaded(problem, 0.0, piece)
    residual, *_ = evaluate(problem.equations.static_function, y, *problem.tail(0.0, piece, 0.0))
    assert np.max(np.abs(np.asarray(residual))) < 1e-8
