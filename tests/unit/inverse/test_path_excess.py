"""A found path that passes every wanted point and strays in between loses, and says so."""

from __future__ import annotations

import itertools
from pathlib import Path

import numpy as np
import pytest
import yaml

from tests.unit.inverse.tasks import SPEC, small, task
from viscodesign import design, simulate
from viscodesign.inverse.tip_residuals import PathResiduals, distance
from viscodesign.inverse.wanted_path import WantedPath

COUNT = 180
TOP = COUNT // 4
STEP = 1e-6


def round_way(radius: float, middle: float = 0.0) -> np.ndarray:
    """A circle from its right end, without its end."""
    angle = 2 * np.pi * np.arange(COUNT) / COUNT
    return np.column_stack([middle + radius * np.cos(angle), radius * np.sin(angle)])


def wanted(way: np.ndarray, *, closed: bool) -> WantedPath:
    line = np.concatenate([way, way[:1]]) if closed else way
    return WantedPath(way[::4], None, closed, "free", line=line)


def test_a_round_besides_is_as_far_off_as_its_middle() -> None:
    """A circle of radius 1, then one of half the size inside that touches it."""
    circle = round_way(1.0)
    only = distance(wanted(circle, closed=True), circle, 0.01)
    assert only.excess_m == pytest.approx(0.0, abs=1e-9)
    assert only.meets(0.01)
    both = distance(
        wanted(circle, closed=True), np.concatenate([circle, round_way(0.5, 0.5)]), 0.01
    )
    assert both.rms_m < 1e-9
    assert both.excess_m == pytest.approx(1.0, abs=1e-3)
    assert both.excess_at == pytest.approx((0.0, 0.0), abs=1e-9)
    assert not both.meets(0.01)
    assert both.total_m > only.total_m


def test_the_ways_to_and_from_an_open_path_are_no_part_of_it() -> None:
    """A half circle, reached from far below and left to there; then with a round in between."""
    half = round_way(1.0)[: COUNT // 2 + 1]
    below = np.linspace(-3.0, 0.0, 40)[:-1]
    there = np.column_stack([np.ones(39), below])
    back = np.column_stack([-np.ones(39), below[::-1]])
    path = wanted(half, closed=False)
    found = distance(path, np.concatenate([there, half, back]), 0.01)
    assert found.excess_m == pytest.approx(0.0, abs=1e-9)
    bump = half[TOP] + 0.3 * (round_way(1.0)[::4] - [1.0, 0.0])
    found = distance(path, np.concatenate([there, half[: TOP + 1], bump, half[TOP:], back]), 0.01)
    assert found.strays
    # Its middle is 0.3 to the left of the top.
    assert found.excess_m == pytest.approx(np.hypot(0.3, 1.0) + 0.3 - 1.0, abs=1e-3)


class GrowingLoops:
    """A tip on an outer round and an inner one, by width, turn and the inner size."""

    def tip(self, values: np.ndarray) -> np.ndarray:
        width, turn, inner = values
        outer = round_way(1.0) * [width, 0.7]
        both = np.concatenate([outer, round_way(inner, width - inner) * [1.0, 0.7]])
        cos, sin = np.cos(turn), np.sin(turn)
        found: np.ndarray = both @ np.array([[cos, sin], [-sin, cos]])
        return found

    def slopes(self, values: np.ndarray) -> np.ndarray:
        steps = STEP * np.eye(len(values))
        ends = [(self.tip(values + own), self.tip(values - own)) for own in steps]
        return np.stack([(high - low) / (2 * STEP) for high, low in ends], axis=2)


def test_slopes_of_what_strays_are_those_of_differences() -> None:
    values, path = np.array([1.2, 0.2, 0.45]), wanted(round_way(1.0), closed=True)
    plain = PathResiduals(GrowingLoops(), path)
    residuals = PathResiduals(GrowingLoops(), path, allowed_m=0.05)
    first = len(plain(values))
    strays = residuals(values)[first:]
    assert np.count_nonzero(strays) > COUNT
    exact = residuals.jacobian(values)[first:]
    for k, own in enumerate(STEP * np.eye(3)):
        ends = [residuals(values + sign * own)[first:] for sign in (1, -1)]
        differences = (ends[0] - ends[1]) / (2 * STEP)
        assert exact[:, k] == pytest.approx(differences, abs=1e-6)
    assert np.sum(strays**2) == pytest.approx(
        distance(path, GrowingLoops().tip(values), 0.05).stray_m ** 2
    )


def test_a_design_that_strays_is_not_met_and_says_where(tmp_path: Path) -> None:
    """Of a limit cycle with an inner round the outer one is wanted, and nothing else is free."""
    source = {"kind": "harmonics", "period": 14.0, "mean": 2e3, "cosine": [6e3, 9e3]}
    run = {"duration": 14.0, "output_interval": 14 / 128, "start": "periodic"}
    tip = simulate(small(input=source, run=run), verify=False).tip[:-1, :2]
    first, last = crossing(tip)
    outer = np.concatenate([tip[last + 1 :], tip[: first + 1]])
    free = {"input.cosine[0]": ["5.9 kPa", "6.1 kPa"]}
    target = {"rows": outer.tolist(), "closed": True}
    path = task(tmp_path, free, target, tolerance="0.01 mm")
    (tmp_path / "spec.yaml").write_text(yaml.safe_dump({**SPEC, "input": source}))
    found = design(path)
    assert found.confirmed_rms_m is not None
    assert found.confirmed_rms_m < 0.01e-3
    assert found.status == "not_met"
    assert "strays from the path, up to" in found.reason
    inner = tip[first + 1 : last + 1]
    line = np.concatenate([outer, outer[:1]])
    fine = np.concatenate([np.linspace(a, b, 50) for a, b in itertools.pairwise(line)])
    farthest = max(np.linalg.norm(fine - own, axis=1).min() for own in inner)
    assert found.excess_m == pytest.approx(farthest, rel=0.05)
    assert found.document()["excess_m"] == found.excess_m


def crossing(way: np.ndarray) -> tuple[int, int]:
    """The rows before which a loop crosses itself."""
    steps = np.roll(way, -1, axis=0) - way
    for a in range(len(way)):
        for b in range(a + 2, len(way)):
            sides = np.column_stack([steps[a], -steps[b]])
            if abs(np.linalg.det(sides)) > 0.0:
                shares = np.linalg.solve(sides, way[b] - way[a])
                if np.all((shares > 0) & (shares < 1)):
                    return a, b
    raise AssertionError("the loop does not cross itself")
