"""Events end a run at one time, whatever outputs are asked for and whichever solver meets them."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.scenes import leg, problem_of
from viscodesign import Scene, Trajectory, simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.simulation.build_problem import suggest_settings
from viscodesign.simulation.solve_once import Run, solve
from viscodesign.solve.event_failures import EventError, emptied_bellow
from viscodesign.solve.events import VANISHING_STRETCH
from viscodesign.solve.obstacles import FLOOR_REL_TOL

DURATION = 2.0
DIP = "input={{kind: table, rows: [[0, 0], [1, {}], [2, 0]]}}"
"""Down in one second, and up again before the next output of a coarse run."""
FLOOR = "effects={collapse: off, gas_compressibility: on, pressure_distribution: on, others: off}"
SOFT = "bellows.extension_per_pressure=0.5 m"
"""A section shortens ten times as much as those of the leg."""
COARSE = 0.3
"""A tolerance whose solutions miss a limit, or meet one that is not there."""
CRUSHED = "effects={pressure_distribution: on, inertia: on, damping: on, others: off}"
SUDDEN = (
    "input={kind: table, rows: [[0, 0], [0.9, 0], [0.95, -400 kPa], [1.05, -400 kPa], [1.1, 0]]}"
)
"""Sections are pressed to nothing while the pressure falls; on the way there solutions part."""
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
    """Both bellows shorten their section by k p: 1 % of it is left where 2 k p = -0.99."""
    crushed = scene(interval, SOFT, DIP.format("-150 kPa"), "effects={others: off}")
    slope = SceneQuantities(crushed).bellow.stretch_per_pressure
    found = event(solved(crushed))
    assert found.time_s == pytest.approx(
        (1 - VANISHING_STRETCH) / (2 * slope) / 150e3, abs=1e-6 * DURATION
    )
    assert (found.quantity, found.where) == ("stretch", "section 1")


@pytest.mark.parametrize(
    ("changes", "quantity"),
    [
        ((DIP.format("-90 kPa"), FLOOR), "volume"),
        ((DIP.format("-150 kPa"), SOFT, "effects={pressure_distribution: on, others: off}"),
         "stretch"),
        ((DIP.format("-150 kPa"), SOFT, CRUSHED), "stretch"),
        ((SUDDEN, "bellows.count=16", "network.tube_radius=1 mm", "ambient_pressure=10 bar",
          CRUSHED), "stretch"),
    ],
    ids=["a gas runs out", "linear modes", "inertia", "a blow"],
)  # fmt: skip
def test_an_event_does_not_hang_on_the_outputs(changes: tuple[str, ...], quantity: str) -> None:
    runs = [solved(scene(interval, *changes)) for interval in INTERVALS]
    times = [event(run).time_s for run in runs]
    assert {event(run).quantity for run in runs} == {quantity}
    assert times == pytest.approx([times[0]] * len(times), abs=1e-6 * DURATION)
    assert not any(run.solution.attempts for run in runs)  # nothing else finds what is not there


def test_a_run_tells_the_time_of_its_event_to_all_digits(tmp_path: Path) -> None:
    run = simulate(scene(2.0, SOFT, DIP.format("-150 kPa"), "effects={others: off}"))
    slope = SceneQuantities(scene(2.0, SOFT)).bellow.stretch_per_pressure
    exact = (1 - VANISHING_STRETCH) / (2 * slope) / 150e3
    assert run.failure_time_s == pytest.approx(exact, abs=1e-6 * DURATION)
    run.save(tmp_path)
    assert run.summary()["failure_time_s"] == run.failure_time_s
    assert Trajectory.read(tmp_path).failure_time_s == run.failure_time_s


SLOW = 60.0
"""Duration of a run in which a gas-filled bellow slowly reaches its minimum volume [s]."""
SLOW_DIP = f"input={{kind: table, rows: [[0, 0], [{SLOW / 2}, -90 kPa], [{SLOW}, 0]]}}"
FLOWING = "effects={pressure_distribution: on, others: off}"


def solved_by(solver: str | None, *outputs: float, changes: tuple[str, ...]) -> Run:
    """A run with outputs at these times; ``solver``: None for the one that is chosen."""
    run = f"run={{duration: {outputs[-1]} s, output_times: {[0.0, *outputs]}}}"
    quantities = SceneQuantities(leg("bellows.count=4", run, *changes))
    effects = select_effects(quantities).effects
    settings = suggest_settings(quantities, effects)
    if solver is not None:
        settings = replace(settings, solver=solver, is_free=False)
    return solve(quantities, effects, settings)


@pytest.mark.parametrize(
    ("solver", "changes"),
    [
        ("rosenbrock", (SLOW_DIP, FLOOR)),
        ("idas", (SLOW_DIP, FLOOR)),
        ("modes", (SLOW_DIP.replace("-90", "-150"), SOFT, FLOWING)),
        (None, (SLOW_DIP.replace("-90", "-150"), SOFT, "effects={others: off}")),
    ],
    ids=["rosenbrock", "idas", "modes", "quasi-static"],
)
def test_no_event_snaps_to_an_output_close_to_it(
    solver: str | None, changes: tuple[str, ...]
) -> None:
    """A solution within its tolerance may meet the event on the other side of the output."""
    time = event(solved_by(solver, SLOW, changes=changes)).time_s
    for output in (time - 1e-4, time + 1e-4):
        found = event(solved_by(solver, output, SLOW, changes=changes)).time_s
        assert found == pytest.approx(time, abs=1e-6 * SLOW)
        assert abs(found - output) > 0.5e-4


@pytest.mark.parametrize("outputs", [[SLOW], [7.0, 19.0, SLOW]], ids=["one", "some"])
def test_what_lasts_for_an_instant_between_all_looks_is_seen(outputs: list[float]) -> None:
    """Two bellows shorten their section by 2 k p, to 1e-7 less than its last 1 % at the trough."""
    slope = SceneQuantities(leg("bellows.count=4", SOFT)).bellow.stretch_per_pressure
    least = (1 - VANISHING_STRETCH) / (2 * slope)
    for share, is_met in ((1 + 1e-7, True), (1 - 1e-7, False)):
        sine = f"input={{kind: sine, amplitude: {least * share}, frequency: 0.0173 Hz}}"
        run = solved_by(None, *outputs, changes=(SOFT, sine, "effects={others: off}"))
        assert run.is_complete is not is_met
        if is_met:
            exact = (math.pi + math.asin(1 / share)) / (2 * math.pi * 0.0173)
            assert event(run).time_s == pytest.approx(exact, abs=1e-6 * SLOW)


def test_a_run_that_ends_before_its_second_output_shows_the_way_there() -> None:
    crushed = (SOFT, DIP.format("-150 kPa"), "effects={others: off}")
    run, dense = (simulate(scene(interval, *crushed), verify=False) for interval in (2.0, 0.02))
    assert run.failure_time_s is not None
    assert run.failure_time_s == pytest.approx(dense.failure_time_s, abs=1e-6 * DURATION)
    assert len(run.time) == len(run.shape) == 50
    assert run.time[-1] == pytest.approx(run.failure_time_s, rel=0.03)
    # Without flow the rod shortens with the pressure, which falls at a constant rate.
    assert run.tip[:, 1] == pytest.approx(np.interp(run.time, dense.time, dense.tip[:, 1]))


def test_effects_chosen_by_the_outputs_do_not_move_an_event() -> None:
    """What is neglected at the outputs alone may still decide when a bellow is empty."""
    choice = "effects={collapse: off, gas_compressibility: on}"
    found = [simulate(scene(iv, DIP.format("-90 kPa"), choice)).failure for iv in INTERVALS]
    times = [re.findall(r"at t = (\S+) s", failure or "") for failure in found]
    assert times[0]
    assert times == [times[0]] * len(times)


@pytest.mark.parametrize("gas", ["auto", "on"])
def test_a_gas_that_may_be_neglected_meets_the_floor_as_one_that_may_not(gas: str) -> None:
    """At 1 % of the length `auto` finds no need for the gas law; bellows of -1.8 V_0 are none."""
    choice = f"effects={{collapse: off, gas_compressibility: {gas}, others: auto}}"
    run = simulate(leg(choice, "accuracy=1 %", config="leg_16_straight_air"), verify=False)
    assert run.status == "failed"
    assert "reached its minimum (collapsed) volume" in (run.failure or "")
    assert run.failure_time_s == pytest.approx(1.435386, abs=1e-5 * 8)


def test_a_spec_that_rules_the_gas_law_out_keeps_its_linear_motion() -> None:
    """As in the paper, whose bellows have no minimum; the run says that it is outside."""
    pinned = "effects={pressure_distribution: on, inertia: on, damping: on, others: off}"
    assert solved(leg(pinned, "run={duration: 2 s, output_interval: 0.1 s}")).is_complete


RATE = 1e-6
"""Drawn by the syringe [m3/s]."""
BARREL = 20e-3


def drawn(seconds: float, interval: float, *changes: str) -> Scene:
    """A syringe that draws for so long from bellows filled with water, and then holds."""
    speed = RATE / (math.pi * BARREL**2 / 4)
    syringe = (
        f"input={{kind: syringe, diameter: {BARREL} m, start: 50 mm, "
        f"speeds: [[0 s, {-speed} m/s], [{seconds} s, 0 m/s]]}}"
    )
    run = f"run={{duration: 10 s, output_interval: {interval} s}}"
    return leg("bellows.count=4", "fluid=water", syringe, run, *changes)


@pytest.mark.parametrize("interval", [10.0, 0.5])
def test_a_syringe_draws_no_more_than_the_bellows_hold(interval: float) -> None:
    """At one pressure, all of them are at their minimum when that much has been drawn."""
    overdrawn = drawn(10.0, interval, "effects={others: off}")
    law = SceneQuantities(overdrawn).bellow
    left = law.floor_volume * (1 - FLOOR_REL_TOL)
    found = event(solved(overdrawn))
    # The barrel's water gives 1e-5 of its own volume, 16 mL, as the pressure falls.
    assert found.time_s == pytest.approx(4 * (law.rest_volume - left) / RATE, rel=1e-4)
    assert found.quantity == "volume"
    assert "syringe draws more" in str(found)


def test_walls_that_meet_end_it_at_a_vacuum() -> None:
    times = [event(solved(drawn(10.0, interval))).time_s for interval in (10.0, 0.5)]
    assert times == pytest.approx([times[0]] * 2, abs=1e-5)
    law = SceneQuantities(drawn(10.0, 0.5)).bellow
    assert times[0] == pytest.approx(4 * (law.rest_volume - law.floor_volume) / RATE, rel=0.05)


@pytest.mark.parametrize("changes", [(7.0,), (10.0, "fluid=air")], ids=["less", "a gas"])
def test_what_can_be_drawn_is_drawn(changes: tuple[float, *tuple[str, ...]]) -> None:
    seconds, *others = changes
    assert solved(drawn(seconds, 0.5, *others)).is_complete


def test_sections_pressed_to_nothing_end_a_run_in_few_steps() -> None:
    """Hardly any friction, no damping: a run that looked at its outputs alone took 10^5 steps."""
    fluid = "{name: thin, viscosity: 2e-8 Pa*s, density: 1.2 kg/m^3, gas_constant: 287.05}"
    crushed = leg(
        "bellows.count=48",
        f"fluid={fluid}",
        "effects={pressure_distribution: on, inertia: on, others: off}",
        "run={duration: 10 s, output_interval: 0.5 s}",
    )
    run = solved(crushed)
    assert 0.5 < event(run).time_s < 1.0
    assert run.solution.work.steps < 2_000
    assert not run.solution.attempts


def test_the_share_that_an_emptied_bellow_keeps_is_of_its_own_volume() -> None:
    """The content of a node has that of its tubes as well, where they store fluid."""
    tubes = "effects={tube_compliance: on, gas_compressibility: on, others: auto}"
    emptied = leg("bellows.count=4", tubes)
    problem, rest = problem_of(emptied), SceneQuantities(emptied).bellow.rest_volume
    failure = emptied_bellow(problem, 1.0, np.array([0.5, 0.25, 0.5, 0.5]) * rest)
    assert f"{problem.bellows[1]} reached" in str(failure)
    assert "with 0.25 of its rest volume" in str(failure)


def test_an_event_of_a_coarse_solution_alone_ends_no_run() -> None:
    """The section keeps its last 1 % down to 102.47 kPa, as ever smaller tolerances tell.

    At which troughs above a coarse solution loses it is a matter of round-off.
    """
    lost = (
        _pressed(trough)
        for trough in np.arange(102.2, 102.42, 0.02)
        if "compressed" in str(simulate(_pressed(trough), tolerance=COARSE, verify=False).failure)
    )
    run = simulate(next(lost), tolerance=COARSE)
    assert run.status == "complete"
    assert _told_of_events(run) == ["borderline_event"]


def test_an_event_of_a_finer_solution_elsewhere_is_told() -> None:
    runs = [simulate(_pressed(trough), tolerance=COARSE) for trough in np.arange(102.5, 106, 0.5)]
    assert {run.status for run in runs} == {"failed"}
    assert {code for run in runs for code in _told_of_events(run)} == {"uncertain_event"}


def _pressed(trough: float) -> Scene:
    return scene(2.0, SOFT, DIP.format(f"-{trough:g} kPa"), CRUSHED)


def _told_of_events(run: Trajectory) -> list[str]:
    told = [warning for warning in run.warnings if warning.code.endswith("_event")]
    assert all("coarser mesh the run ends at t = " in warning.message for warning in told)
    return [warning.code for warning in told]
