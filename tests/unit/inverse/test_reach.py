"""The set of points that a tip can visit, and inputs that bring it to a point."""

from __future__ import annotations

import itertools
import signal
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.path import Path as Outline

from tests.unit.inverse.tasks import small
from viscodesign import ReachStudy, Scene, Trajectory, load, reach, simulate
from viscodesign.cli.texts.reach_text import reach_lines
from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.errors import SolveError, SpecError, UsageError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.inverse.arc_rod import ArcRod
from viscodesign.inverse.path_excess import _from_line
from viscodesign.inverse.quick_motion import QuickMotion
from viscodesign.inverse.reach import _bellows
from viscodesign.inverse.reach_edge import HarmonicExtremes
from viscodesign.inverse.tree_graph import tree_of

LIMITS = (-20e3, 25e3)
SLOW = {"pressure_distribution": "on", "others": "off"}


@pytest.fixture(scope="module")
def study() -> ReachStudy:
    return reach(small(effects=SLOW), limits=LIMITS)


def test_no_input_by_chance_leaves_the_set_and_some_come_near_its_edge(study: ReachStudy) -> None:
    """Periodic inputs of three harmonics that touch both limits."""
    chance, outline = np.random.default_rng(2), Outline(study.edge)
    source = {"kind": "harmonics", "period": 4.0, "cosine": [1e3] * 3, "sine": [1e3] * 3}
    run = {"duration": 4.0, "output_interval": 0.1, "start": "periodic"}
    scene = small(input=source, run=run)
    graph = tree_of(scene.graph)
    assert graph is not None
    keys = FreeKeys(scene, ["input.cosine[*]", "input.sine[*]", "input.mean", "input.period"])
    motion, found = QuickMotion(keys, graph), []
    turns = 2 * np.pi * np.outer(np.arange(400) / 400, [1, 2, 3])
    for _ in range(150):
        own = chance.normal(size=6) / [1, 2, 3, 1, 2, 3]
        level = np.cos(turns) @ own[:3] + np.sin(turns) @ own[3:]
        scale = (LIMITS[1] - LIMITS[0]) / np.ptp(level) * 0.999
        mean = LIMITS[0] - scale * level.min() + 10
        found.append(motion.tip(np.array([*(scale * own), mean, 10 ** chance.uniform(-0.5, 2)])))
    points = np.concatenate(found)
    outside = points[~outline.contains_points(points)]
    beyond = [np.linalg.norm(study.edge - point, axis=1).min() for point in outside]
    # The edge is a polygon: what bulges over its sides is a hundredth of its size.
    assert max(beyond, default=0.0) < 0.01 * np.ptp(study.edge)
    assert len(outside) < 0.02 * len(points)


def test_points_of_the_edge_are_where_a_run_brings_the_tip(study: ReachStudy) -> None:
    assert study.edge_error_m is not None
    assert study.edge_error_m < 5e-6


def test_fewer_harmonics_reach_less_and_two_inlets_more(study: ReachStudy) -> None:
    one = reach(small(), limits=LIMITS, harmonics=1).area_m2
    assert one < study.area_m2 < study.area_two_inlets_m2


def test_harmonics_keep_their_limits_between_samples() -> None:
    extreme = HarmonicExtremes(_bellows(small()), LIMITS, 3)
    phases = 2 * np.pi * np.linspace(0, 1, 3001)
    wave = np.array([2e3, *[26e3, 0.0, -5e3], *[0.0, 1e3, 0.0]])
    kept = extreme.within(wave)
    orders = range(1, 4)
    levels = kept[0] + sum(
        kept[k] * np.cos(k * phases) + kept[3 + k] * np.sin(k * phases) for k in orders
    )
    assert LIMITS[0] - 10 < levels.min() < levels.max() < LIMITS[1] + 10
    assert max(levels.max() - LIMITS[1], LIMITS[0] - levels.min()) > -10
    assert kept[0] == wave[0]


def test_the_published_leg_covers_so_much() -> None:
    """22.4 cm2 by a sampled prototype of the same network and rod."""
    leg = load("configs/leg_16_straight_air.yaml")
    found = reach(leg.replace({"effects": SLOW}), limits=(-25e3, 30e3))
    assert 1e4 * found.area_m2 == pytest.approx(22.4, rel=0.006)


def test_inputs_at_their_limits_leave_the_set_by_tenths_of_a_millimetre_at_most() -> None:
    """Steps between the limits, whose tips are at the edge: two thirds of them are near it."""
    leg = load("configs/leg_16_straight_air.yaml", {"effects": SLOW})
    found, chance = reach(leg, limits=(-25e3, 30e3)), np.random.default_rng(1)
    bellows, rod = _bellows(leg), ArcRod.of(SceneQuantities(leg))
    rate, modes = bellows.modes()
    drive = modes.T @ bellows.feed / bellows.stored
    pressures = []
    for _ in range(3000):
        own = modes.T @ np.full(16, chance.uniform(-25e3, 30e3))
        for _ in range(chance.integers(1, 7)):
            left = np.exp(-rate * 10 ** chance.uniform(-2.5, 1.2) / rate[0])
            own = own * left + drive * chance.choice([-25e3, 30e3]) / rate * (1 - left)
        pressures.append(modes @ own)
    tips, edge = rod.tip(np.array(pressures)), np.concatenate([found.edge, found.edge[:1]])
    away = np.linalg.norm(_from_line(edge, tips), axis=1)
    outside = away[~Outline(found.edge).contains_points(tips)]
    assert outside.max() < 0.2e-3
    assert np.mean(outside > 0.1e-3) < 0.02
    assert np.mean(away < 1e-3) > 0.5


def test_a_point_is_reached_by_the_runs_own_effects() -> None:
    target = simulate(small(), verify=False).tip[20, :2]
    found = reach(small(), limits=(-25e3, 25e3), at=tuple(target), time=6.0).point
    assert found is not None
    assert found.is_reached
    assert found.miss_m < 0.02e-3
    assert np.abs(found.pressures).max() <= 25e3
    run = simulate(load(found.spec_text))
    assert np.linalg.norm(run.tip[-1, :2] - target) == pytest.approx(found.miss_m, abs=1e-5)


def test_a_point_out_of_reach_is_so_far_away() -> None:
    """Straight above a rod that cannot stretch so far: the distance is known."""
    scene, at = small(), (0.0, 0.04)
    found = reach(scene, limits=(0.0, 20e3), at=at, time=60.0).point
    longest = simulate(small(input={"kind": "constant", "value": 20e3}), verify=False).tip[0, 1]
    assert found is not None
    assert not found.is_reached
    assert found.out_of_reach_m == pytest.approx(0.04 - longest, rel=5e-3)
    assert found.evaluations <= 60


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ({"limits": (2e3, 1e3)}, "the lower one first"),
        ({"limits": (0.0, 1e3), "at": (0.0,)}, "needs x and z"),
        ({"limits": (0.0, 1e3), "at": (0.0, float("nan"))}, "needs x and z"),
        ({"limits": (0.0, 1e3), "at": (20.0, 105.0)}, "are these metres"),
        ({"limits": (0.0, 1e3), "time": 2.0}, "needs a point"),
        ({"limits": (0.0, 1e3), "at": (0.0, 0.03), "time": -1.0}, "above 0 s"),
        ({"limits": (0.0, 1e3), "harmonics": 0}, "harmonics: must be"),
    ],
)
def test_what_makes_no_sense_is_refused(words: dict[str, Any], message: str) -> None:
    with pytest.raises(UsageError, match=message):
        reach(small(), **words)


def test_limits_below_vacuum_are_refused() -> None:
    with pytest.raises(SpecError, match=r"limits: .* is -98\.6\d? kPa absolute"):
        reach(small(), limits=(-200e3, 1e3))


def test_points_of_the_edge_that_fail_are_told(monkeypatch: pytest.MonkeyPatch) -> None:
    calls = itertools.count()

    def failing(scene: Scene, **words: Any) -> Trajectory:
        if next(calls) == 1:
            raise SolveError("no equilibrium", quantity="tip", where="rod")
        return simulate(scene, **words)

    monkeypatch.setattr("viscodesign.inverse.reach.simulate", failing)
    found = reach(small(effects=SLOW), limits=LIMITS)
    assert found.edge_failures == ("no equilibrium",)
    assert found.edge_error_m is not None
    said = "\n".join(reach_lines(found, Path("out"), []))
    assert "a point of the edge could not be simulated: no equilibrium" in said


def test_ctrl_c_keeps_the_edge(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(scene: Scene, **words: Any) -> Trajectory:
        signal.raise_signal(signal.SIGINT)
        return simulate(scene, **words)

    monkeypatch.setattr("viscodesign.inverse.reach.simulate", interrupted)
    found = reach(small(effects=SLOW), limits=LIMITS)
    assert found.interrupted
    assert found.area_m2 > 0.0
    assert found.edge_error_m is None


def test_ctrl_c_keeps_the_input_that_came_nearest(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*_: Any) -> None:
        signal.raise_signal(signal.SIGINT)
        raise KeyboardInterrupt

    monkeypatch.setattr("viscodesign.inverse.reach_point.confirm", interrupted)
    found = reach(small(), limits=(-25e3, 25e3), at=(0.0, 0.028), time=6.0)
    assert found.interrupted
    assert found.point is not None
    assert not found.point.is_verified
    assert found.document()["validity"] is found.document()["tip_m"][0] is None
    assert load(found.point.spec_text).inputs["inlet"].name == "table"
    said = "\n".join(reach_lines(found, Path("out"), []))
    assert "not verified; the input is input.csv" in said
