"""The parts of a run's time sum to all of it."""

from __future__ import annotations

import time

import pytest

from tests.scenes import leg
from viscodesign import simulate
from viscodesign.results.trajectory import Cost
from viscodesign.simulation import stopwatch
from viscodesign.simulation.stopwatch import Stopwatch

PARTS = ("load_s", "choose_s", "build_s", "solve_s", "verify_s", "read_s", "write_s")
SHORT = ("bellows.count=4", "run={duration: 0.5 s, output_interval: 10 ms}")


class Clock:
    """A clock that stands still unless it is moved."""

    now = 100.0

    def perf_counter(self) -> float:
        return self.now


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> Clock:
    found = Clock()
    monkeypatch.setattr(stopwatch, "clock", found)
    return found


def timed(clock: Clock, *, is_only_solution: bool) -> Cost:
    """10 s: 3 of them choosing, 0.5 assembling, 4 known of the solution, 2.5 elsewhere."""
    watch = Stopwatch()
    for part, spent in (("choose", 1.0), ("read", 0.5), ("choose", 2.0)):
        with watch(part):
            clock.now += spent
    clock.now += 6.5
    known = Cost(build_s=1.0, solve_s=2.0, read_s=1.0, steps=7)
    return watch.share_out(known, is_only_solution=is_only_solution)


def test_what_is_left_went_into_other_solutions(clock: Clock) -> None:
    cost = timed(clock, is_only_solution=False)
    assert (cost.choose_s, cost.read_s, cost.verify_s) == (3.0, 1.5, 2.5)
    assert (cost.total_s, cost.steps) == (10.0, 7)


def test_or_into_reading_where_there_are_no_others(clock: Clock) -> None:
    cost = timed(clock, is_only_solution=True)
    assert (cost.choose_s, cost.read_s, cost.verify_s) == (3.0, 4.0, 0.0)
    assert cost.total_s == 10.0


def test_what_is_interrupted_counts(clock: Clock) -> None:
    watch = Stopwatch()

    def interrupted() -> None:
        with watch("choose"):
            clock.now += 2.0
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    assert watch.share_out(Cost(), is_only_solution=True).choose_s == 2.0


@pytest.mark.parametrize("ways", [{"verify": False}, {"verify": True}, {"prove": True}])
def test_a_run_accounts_for_all_its_time(ways: dict[str, bool]) -> None:
    began = time.perf_counter()
    cost = simulate(leg(*SHORT), **ways).cost
    spent = time.perf_counter() - began
    assert cost.total_s == pytest.approx(sum(getattr(cost, part) for part in PARTS), rel=1e-12)
    assert all(getattr(cost, part) >= 0 for part in PARTS)
    assert 0.7 * spent < cost.total_s < spent
    assert min(cost.choose_s, cost.build_s, cost.solve_s, cost.read_s) > 0
    assert (cost.load_s, cost.write_s) == (0.0, 0.0)
    assert (cost.verify_s > 0) is (ways != {"verify": False})
