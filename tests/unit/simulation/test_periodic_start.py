"""Runs that start on the limit cycle of their inputs."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from tests.scenes import in_order, leg
from viscodesign import Scene, simulate
from viscodesign.effects.select import select_effects
from viscodesign.errors import SpecError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.simulation.build_problem import build, cycle_schedule, suggest_settings
from viscodesign.solve.limit_cycle import LimitCycle, limit_cycle
from viscodesign.solve.statics import equilibrium
from viscodesign.solve.transient import suitable_solver

NETWORK_ALONE = "effects={pressure_distribution: on, others: off}"
ISLAND = (
    "network={layout: custom, tube_radius: 0.325 mm, tube_length: 37.5 mm, tubes: "
    "[{from: inlet, to: R1}, {from: R1, to: R2}, {from: L1, to: L2}]}"
)


def sine(frequency: float, mean: float = 5e3, amplitude: float = 15e3) -> str:
    return (
        f"input={{kind: sine, mean: {mean!r}, amplitude: {amplitude!r}, frequency: {frequency!r}}}"
    )


def run(periods: float, frequency: float, start: str) -> str:
    time, interval = periods / frequency, 1 / (20 * frequency)
    return f"run={{duration: {time!r}, output_interval: {interval!r}, start: {start}}}"


def cycle_of(scene: Scene) -> LimitCycle:
    """The cycle that a first run of a scene starts on."""
    quantities = SceneQuantities(scene)
    effects = select_effects(quantities).effects
    settings = suggest_settings(quantities, effects)
    problem = build(quantities, effects, settings)
    begin = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    assert scene.period is not None
    solver = suitable_solver(problem, settings.solver, settings.is_free)
    one = replace(problem, schedule=cycle_schedule(scene, scene.period))
    return limit_cycle(one, begin, settings.tolerance, solver)


@pytest.mark.parametrize("frequency", [0.5, 20.0])
def test_a_linear_network_starts_on_its_exact_cycle(frequency: float) -> None:
    mean, amplitude, rate = 5e3, 15e3, 2 * np.pi * frequency
    scene = leg(
        sine(frequency, mean, amplitude),
        NETWORK_ALONE,
        "accuracy=0.001 %",
        run(1, frequency, "periodic"),
    )
    found = simulate(scene)
    quantities = SceneQuantities(scene)
    (component,) = quantities.graph.components()
    laplacian = quantities.laplacian(component)
    (first,) = (t for t in quantities.graph.tubes if t.start == "inlet")
    drive = np.zeros(len(laplacian))
    drive[component.bellows.index(first.end)] = 1 / quantities.resistances[first.name]
    matrix = laplacian + 1j * rate * quantities.bellow.compliance * np.eye(len(laplacian))
    turns = np.exp(1j * rate * found.time)[:, None]
    exact = mean + amplitude * np.imag(turns * np.linalg.solve(matrix, drive))
    error = in_order(found.pressure, found.bellows, list(component.bellows)) - exact
    assert found.status == "complete"
    assert np.max(np.abs(error)) <= 1e-5 * amplitude


@pytest.mark.parametrize(
    ("config", "pulse", "frequency", "periods"),
    [
        ("leg_16_straight_air", sine(0.5), 0.5, 12),
        ("leg_16_straight_air", sine(5.0), 5.0, 40),
        ("leg_16_straight_water_auto", sine(0.5), 0.5, 150),
        ("branched_tree", "name=branched_tree", 0.5, 5),
    ],
)
def test_it_moves_as_a_run_does_after_many_periods(
    config: str, pulse: str, frequency: float, periods: int
) -> None:
    scene = leg(pulse, run(1, frequency, "periodic"), "accuracy=0.1 %", config=config)
    found = simulate(scene)
    kept = [verdict.name for verdict in found.effects if verdict.taken]
    effects = ", ".join(f"{name}: on" for name in kept)
    late = simulate(
        leg(
            pulse,
            run(periods, frequency, "equilibrium"),
            f"effects={{{effects}, others: off}}",
            "accuracy=0.01 %",
            config=config,
        ),
        verify=False,
    )
    apart = np.linalg.norm((found.tip - late.tip[-len(found.tip) :])[:, :2], axis=1)
    assert found.accuracy.estimated_tip_error_m is not None
    assert np.max(apart) <= found.accuracy.estimated_tip_error_m
    assert np.ptp(found.tip[:, 0]) > 100 * found.accuracy.estimated_tip_error_m


@pytest.mark.parametrize(
    ("make", "most"),
    [
        (lambda: leg(sine(0.5), run(1, 0.5, "periodic")), 9),
        (lambda: leg(sine(5.0), run(1, 5.0, "periodic")), 20),
        (lambda: leg(sine(50.0), run(1, 50.0, "periodic")), 40),
        (lambda: leg(sine(0.5), NETWORK_ALONE, run(1, 0.5, "periodic")), 12),
    ],
)
def test_few_periods_are_solved(make: Callable[[], Scene], most: int) -> None:
    assert cycle_of(make()).periods <= most


def test_a_sealed_part_keeps_what_it_was_filled_with() -> None:
    scene = ("bellows.count=4", ISLAND, sine(1.0))
    found = simulate(leg(*scene, run(1, 1.0, "periodic")), verify=False)
    late = simulate(leg(*scene, run(12, 1.0, "equilibrium")), verify=False)
    island = [found.bellows.index(name) for name in ("L1", "L2")]
    pressure = found.pressure[:, island]
    assert np.ptp(pressure) > 1.0  # the rod bends, and its walls press on what is sealed in
    assert found.invariants.volume_imbalance_rel is not None
    assert found.invariants.volume_imbalance_rel < 1e-6
    assert pressure == pytest.approx(late.pressure[-len(pressure) :, island], abs=10.0)


@pytest.mark.parametrize(
    ("pulse", "words"),
    [
        ("input={kind: constant, value: 5 kPa}", "no input changes"),
        ("input={kind: step, value: 5 kPa, time: 1 s}", "'inlet' \\(step\\) does not"),
    ],
)
def test_inputs_that_do_not_repeat_are_refused(pulse: str, words: str) -> None:
    with pytest.raises(SpecError, match=rf"run\.start.*{words}.*run\.start: equilibrium"):
        leg(pulse, "run.start=periodic")


def test_periods_that_do_not_meet_are_refused() -> None:
    waves = [f"{{kind: sine, amplitude: 1 kPa, frequency: {f}}}" for f in ("1", "1.4142136")]
    inputs = f"inputs={{left: {waves[0]}, right: {waves[1]}}}"
    with pytest.raises(SpecError, match=r"'left' 1 s, 'right' 0\.707107 s\) do not meet"):
        leg(inputs, "run.start=periodic", config="antagonistic_two_inlets")
