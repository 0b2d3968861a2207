"""Runs that crawl are ended by name, and a long march answers a signal within one look."""

from __future__ import annotations

import os
import signal
from typing import Any

import pytest

from tests.scenes import leg
from viscodesign import Scene, simulate
from viscodesign.native.unavailable import NativeUnavailable
from viscodesign.results.trajectory import RunInterruptedError
from viscodesign.solve import progress_watch
from viscodesign.solve.progress_watch import PATIENCE, Patience, ProgressWatch
from viscodesign.solve.solvers.rodas_formulas import FormulaSteps
from viscodesign.solve.solvers.rodas_native import NativeSteps
from viscodesign.solve.solvers.rodas_stretch import CONTROL

LOOKS = 2 * CONTROL.steps_at_once
TOLERANCE = 1e-6


def ringing() -> Scene:
    """A rod without damping, whose steps are those of its fastest vibrations."""
    return leg(
        "bellows.count=4",
        "effects={inertia: on, others: off}",
        "input={kind: step, value: 5 kPa, time: 0.01 s}",
        "run={duration: 6 s, output_interval: 0.5 s}",
    )


def test_a_rate_is_judged_once_there_are_steps_enough() -> None:
    watch = ProgressWatch(0.0, 1.0, max_steps=1_000_000)
    assert watch.crawl(PATIENCE.steps - 1, 1e-12) is None
    failure = watch.crawl(PATIENCE.steps, 1e-12)
    assert failure is not None
    assert (failure.quantity, failure.time_s) == ("work", 1e-12)
    assert "2e+16 steps" in str(failure)
    assert watch.crawl(2 * PATIENCE.steps, 0.5) is None


def test_steps_that_stand_still_crawl() -> None:
    failure = ProgressWatch(0.5, 1.0, max_steps=1_000).crawl(PATIENCE.steps, 0.5)
    assert failure is not None
    assert "endless" in str(failure)


@pytest.mark.parametrize("native", [True, False], ids=["native code", "formulas"])
def test_a_run_that_crawls_keeps_what_it_has(native: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = simulate(ringing(), verify=False, tolerance=TOLERANCE)
    assert whole.status == "complete"
    assert whole.cost.steps > 3 * LOOKS
    if not native:
        monkeypatch.setattr("viscodesign.solve.solvers.rosenbrock.NativeSteps", unavailable)
    monkeypatch.setattr(progress_watch, "PATIENCE", Patience(LOOKS, max_times=1e-4))
    found = simulate(ringing(), verify=False, tolerance=TOLERANCE)
    assert found.status == "failed"
    assert found.failure is not None
    assert "the run hardly advances at t = " in found.failure
    assert found.cost.steps <= 2 * LOOKS
    assert found.tip == pytest.approx(whole.tip[: len(found.tip)], abs=1e-6)
    assert not found.ladder


def unavailable(*_: Any) -> Any:
    raise NativeUnavailable("switched off")


@pytest.mark.skipif(os.name != "posix", reason="POSIX signals")
@pytest.mark.parametrize("kind", [NativeSteps, FormulaSteps])
def test_a_signal_ends_a_march_at_the_next_look(
    kind: type[Any], monkeypatch: pytest.MonkeyPatch
) -> None:
    """All of the run is one march: nothing but its own looks can end it."""
    pressed: list[int] = []
    own = kind._crossing

    def pressing(self: Any, *words: Any) -> Any:
        if not pressed:
            pressed.append(1)
            os.kill(os.getpid(), signal.SIGINT)
        return own(self, *words)

    monkeypatch.setattr(kind, "_crossing", pressing)
    if kind is FormulaSteps:
        monkeypatch.setattr("viscodesign.solve.solvers.rosenbrock.NativeSteps", unavailable)
    with pytest.raises(RunInterruptedError) as stopped:
        simulate(ringing(), verify=False, tolerance=TOLERANCE)
    partial = stopped.value.trajectory
    assert partial is not None
    assert partial.status == "interrupted"
    assert partial.cost.steps <= 2 * LOOKS
