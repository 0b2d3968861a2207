"""Events end a run at one time, whatever outputs are asked for and whichever solver meets them."""

from __future__ import annotations

import re

import pytest

from tests.scenes import leg
from viscodesign import Scene, simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.simulation.build_problem import suggest_settings
from viscodesign.simulation.solve_once import Run, solve
from viscodesign.solve.event_failures import EventError

DURATION = 2.0
DIP = "input={{kind: table, rows: [[0, 0], [1, {}], [2, 0]]}}"
"""Down in one second, and up again before the next output of a coarse run."""
FLOOR = "effects={collapse: off, gas_compressibility: on, pressure_distribution: on, others: off}"
SOFT = "bellows.extension_per_pressure=0.5 m"
"""A section shortens ten times as much as those of the leg."""
CRUSHED = "effects={pressure_distribution: on, inertia: on, damping: on, others: off}"
INTERVALS = (2.0, 0.3, 0.02)


def scene(interval: float, *changes: str) -> Scene:
    run = f"run={{duration: {DURATION} s, output_interval: {interval} s}}"
    return leg("bellows.count=4", run, *changes)


def solved(scene: Scene, **changes: str) -> Run:
    quantities = SceneQuantities(scene)
    effects = select_effects(quantities).effects
    return solve(quantities, effects, suggest_settings(quantities, effects))


def event(run: Run) -> EventError:
    failure = run.motion.failure
    assert isinstance(failure, EventError)
    assert run.motion.time[-1] < failure.time_s
    return failure


@pytest.mark.parametrize("interval", INTERVALS)
def test_an_equilibrium_vanishes_at_its_exact_time(interval: float) -> None:
    """Both bellows shorten their section by k p: it vanishes where 2 k p = -1."""
    crushed = scene(interval, SOFT, DIP.format("-150 kPa"), "effects={others: off}")
    slope = SceneQuantities(crushed).bellow.stretch_per_pressure
    found = event(solved(crushed))
    assert found.time_s == pytest.approx(1 / (2 * slope) / 150e3, abs=1e-6 * DURATION)
    assert (found.quantity, found.where) == ("stretch", "section 1")


@pytest.mark.parametrize(
    ("changes", "quantity"),
    [
        ((DIP.format("-90 kPa"), FLOOR), "volume"),
        ((DIP.format("-150 kPa"), SOFT, "effects={pressure_distribution: on, others: off}"),
         "stretch"),
        ((DIP.format("-150 kPa"), SOFT, CRUSHED), "stretch"),
    ],
    ids=["a gas runs out", "linear modes", "inertia"],
)  # fmt: skip
def test_an_event_does_not_hang_on_the_outputs(changes: tuple[str, ...], quantity: str) -> None:
    runs = [solved(scene(interval, *changes)) for interval in INTERVALS]
    times = [event(run).time_s for run in runs]
    assert {event(run).quantity for run in runs} == {quantity}
    assert times == pytest.approx([times[0]] * len(times), abs=1e-6 * DURATION)
    assert not any(run.solution.attempts for run in runs)  # nothing else finds what is not there


def test_effects_chosen_by_the_outputs_do_not_move_an_event() -> None:
    """What is neglected at the outputs alone may still decide when a bellow is empty."""
    choice = "effects={collapse: off, gas_compressibility: on}"
    found = [simulate(scene(iv, DIP.format("-90 kPa"), choice)).failure for iv in INTERVALS]
    times = [re.findall(r"at t = (\S+) s", failure or "") for failure in found]
    assert times[0]
    assert times == [times[0]] * len(times)
