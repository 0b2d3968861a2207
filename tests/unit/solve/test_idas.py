"""Messages of failed integrations."""

from __future__ import annotations

import itertools
from typing import Any

import pytest

from tests.scenes import leg, problem_of
from viscodesign.solve.solvers.base import Work
from viscodesign.solve.solvers.idas import REASONS, Idas, reason_of
from viscodesign.solve.statics import equilibrium


@pytest.mark.parametrize("code", REASONS)
def test_return_codes_are_explained(code: str) -> None:
    text = f'.../casadi/interfaces/sundials/idas_interface.cpp:620: IDASolve returned "{code}".'
    assert reason_of(RuntimeError(text)) == f"{REASONS[code]} ({code})"


def test_other_errors_are_stripped_of_file_names() -> None:
    text = "Error:\n.../casadi/core/function.cpp:12: something else\n"
    assert reason_of(RuntimeError(text)) == "something else"
    assert reason_of(RuntimeError("")) == "no reason given"


def test_failure_at_a_corner_falls_back_to_smooth_stretches(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    scene = leg(
        "bellows.count=4",
        "input={kind: trapezoid, high: 5 kPa, rise: 0.1 s, hold: 0.2 s, fall: 0.1 s, rest: 0.1 s}",
        "run={duration: 1.2 s, output_interval: 0.05 s}",
        "effects={pressure_distribution: on, others: off}",
    )
    problem = problem_of(scene)
    start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    last, corners = len(problem.schedule.edges) - 1, problem.schedule.pieces.changes
    whole, _ = Idas(problem, 1e-7)(start, 0, last, Work())
    calls: list[tuple[int, int]] = []
    solve = Idas._solve

    def lame(self: Idas, here: Any, first: int, stop: int, *rest: Any) -> Any:
        calls.append((first, stop))
        if any(first < corner < stop for corner in corners):
            raise RuntimeError('IDASolve returned "IDA_CONV_FAIL"')
        return solve(self, here, first, stop, *rest)

    monkeypatch.setattr(Idas, "_solve", lame)
    limping = Idas(problem, 1e-7)
    parts, failure = limping(start, 0, last, Work())
    assert failure is None
    marks = [0, *corners.tolist(), last]
    assert calls == [(0, last), *itertools.pairwise(marks)]
    for one, other in zip(whole, parts, strict=True):
        assert other == pytest.approx(one, abs=1e-5)
    # It has learnt that.
    calls.clear()
    limping(start, 0, last, Work())
    assert calls == list(itertools.pairwise(marks))
