"""What a person reads of a run and of a check."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Literal

import numpy as np
import pytest

from tests.trajectories import VERDICTS, made_run
from viscodesign.cli.texts.check_text import (
    full_notice_lines,
    notice_lines,
    scale_lines,
    share,
    verdict_lines,
)
from viscodesign.cli.texts.run_text import MAX_RETRIES, summary_lines
from viscodesign.results.findings import Classification, RetryAttempt, Scales, Verdict
from viscodesign.results.trajectory import Accuracy, Trajectory

FILES = [Path("runs/leg/trajectory.csv"), Path("runs/leg/summary.json")]


def _summary(trajectory: Trajectory) -> str:
    return "\n".join(summary_lines(trajectory, Path("runs/leg"), FILES))


def test_a_run_in_a_dozen_lines(trajectory: Trajectory) -> None:
    text = _summary(trajectory)
    assert "leg: quadrant III" in text
    assert "complete: 1 s of motion in 0.6 s, 123 steps" in text
    assert "x -10.0 to 20.0 mm, z 100.0 to 109.0 mm, angle -11 to 23 deg" in text
    assert "0.109 mm, 0.1 % of the length (requested 0.545 mm, 0.5 %)" in text
    assert "included         feedback" in text
    assert "neglected        inertia" in text
    assert "runs/leg: trajectory.csv, summary.json" in text


def test_the_loop_is_printed_where_there_is_one(trajectory: Trajectory) -> None:
    """A triangle that is passed clockwise."""
    text = _summary(trajectory)
    assert "loop             30.0 mm wide, 9.0 mm high, path 52.3 mm, area -0.85 cm^2" in text
    assert "loop" not in _summary(trajectory.with_arrays(time=np.zeros(1), tip=np.zeros((1, 3))))


def test_how_far_the_left_column_is_behind() -> None:
    run = made_run()
    lag = run.metrics["column_lag_s"]
    assert f", L {lag:.3g} s behind R" in _summary(run)
    still = made_run(inlet=lambda time: 0 * time + 3e4)
    assert "behind" not in _summary(still)


def test_a_run_outside_of_its_model_says_so(trajectory: Trajectory) -> None:
    assert "outside of the model" not in _summary(trajectory)
    outside = replace(trajectory, violations=(*trajectory.warnings, trajectory.warnings[0]))
    assert "validity         outside of the model: negative_volume, reynolds;" in _summary(outside)
    (stated,) = (line for line in _summary(outside).splitlines() if "tip error  " in line)
    assert stated.endswith(", of a model that does not hold here")
    assert "does not hold" not in _summary(trajectory)


def test_an_error_of_pinned_effects_says_so(trajectory: Trajectory) -> None:
    def stated(mode: Literal["auto", "off"], *, present: bool = True) -> str:
        own = Verdict("x", mode, False, 0.1, "f", "why", present=present)
        run = replace(trajectory, effects=(own,), violations=())
        return next(line for line in _summary(run).splitlines() if "tip error  " in line)

    assert stated("off") == f"{stated('auto')}, of the model as pinned"
    assert stated("off", present=False) == stated("auto")


def test_retries_are_printed(trajectory: Trajectory) -> None:
    assert "retry" not in _summary(trajectory)
    rungs = (
        RetryAttempt(0.25, "order 2 at most", False, "the steps shrink to nothing"),
        RetryAttempt(0.25, "Rodas5P instead", True, "the steps shrink to nothing"),
    )
    text = _summary(replace(trajectory, ladder=rungs))
    assert "retry            at 0.25 s: order 2 at most, failed" in text
    assert "retry            at 0.25 s: Rodas5P instead, succeeded" in text


def test_of_many_retries_the_first_are_printed(trajectory: Trajectory) -> None:
    rungs = tuple(RetryAttempt(0.1 * k, f"attempt {k}", False, "") for k in range(MAX_RETRIES + 3))
    text = _summary(replace(trajectory, ladder=rungs))
    assert text.count("  retry ") == MAX_RETRIES
    assert f"attempt {MAX_RETRIES - 1}" in text
    assert f"attempt {MAX_RETRIES}," not in text


def test_an_error_that_was_not_estimated(trajectory: Trajectory) -> None:
    text = _summary(replace(trajectory, accuracy=Accuracy(0.000545, None, "not verified")))
    assert "not verified (requested 0.545 mm, 0.5 %)" in text


def test_a_run_that_never_began(trajectory: Trajectory) -> None:
    failed = replace(trajectory, status="failed")
    empty = failed.with_arrays(time=np.empty(0), tip=np.empty((0, 3)))
    assert "failed: 0 s of motion" in _summary(empty)
    assert "no output" in _summary(empty)


def test_every_warning_once_with_its_code(trajectory: Trajectory) -> None:
    lines = notice_lines(trajectory.warnings)
    assert lines == [
        "  negative_volume: below its floor (R1, t = 0.25 s) [and 1 more of this kind]",
        "  reynolds: turbulent (inlet-R1)",
    ]


def test_before_a_run_every_warning_in_full(trajectory: Trajectory) -> None:
    lines = full_notice_lines([*trajectory.warnings, trajectory.warnings[0]])
    assert lines == [
        "  negative_volume: below its floor (R1, t = 0.25 s)",
        "  negative_volume: below its floor (L1, t = 0.5 s)",
        "  reynolds: turbulent (inlet-R1)",
    ]


def test_a_constant_input_has_no_swing(classification: Classification) -> None:
    scales = Scales(t_s=0.03, t_f=0.16, t_i=float("inf"), t_net=1.0)
    text = "\n".join(scale_lines(replace(classification, scales=scales)))
    assert "t_i        infinite" in text
    assert "t_s/t_i    0  " in text


@pytest.mark.parametrize("columns", [None, "60", "80", "100"])
def test_decisions_are_a_table_followed_by_reasons(
    monkeypatch: pytest.MonkeyPatch, columns: str | None
) -> None:
    if columns is not None:
        monkeypatch.setenv("COLUMNS", columns)
        monkeypatch.setattr("sys.stdout.isatty", lambda: True, raising=False)
    text = "\n".join(verdict_lines(VERDICTS))
    words = " ".join(text.split())
    assert "effect verdict mode tip [mm] of budget weight" in words
    assert "pressure_distribution included auto 114 > 1000 % 0.5" in words
    assert "flow_regime included auto infinite required 0.5" in words
    assert "gravity neglected off 0.2 36.7 % 0.5" in words
    assert "fluid_inertance neglected auto < 1e-06 < 0.001 % 0.5" in words
    assert "tip_load neglected on 0 0 % 0.5" in words
    assert "gravity weight = a / b neglected: made up" in words
    if columns is not None:
        assert all(len(line) <= int(columns) for line in text.splitlines())


def test_the_table_has_one_line_per_effect_included_ones_first() -> None:
    lines = verdict_lines(VERDICTS)
    names = [line.split()[0] for line in lines[2 : 2 + len(VERDICTS)]]
    assert names == [
        "pressure_distribution", "gas_compressibility", "flow_regime", "inertia", "damping",
        "fluid_mass", "fluid_inertance", "gravity", "feedback", "tip_load", "material_curve",
    ]  # fmt: skip
    assert [line.split()[0] for line in lines if " weight = " in line] == names


@pytest.mark.parametrize(
    ("part", "shown"),
    [
        (0.0, "0 %"),
        (1e-6, "< 0.001 %"),
        (0.1873, "18.7 %"),
        (9.996, "1000 %"),
        (10.1, "> 1000 %"),
        (math.inf, "required"),
        (math.nan, "unknown"),
    ],
)
def test_shares_are_bounded_where_they_mean_little(part: float, shown: str) -> None:
    assert share(part) == shown
