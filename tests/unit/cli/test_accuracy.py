"""`viscodesign accuracy` as a user meets it."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.studies import made_study
from tests.unit.cli.conftest import CONFIGS, Call
from viscodesign.cli.texts.accuracy_text import cost_lines
from viscodesign.cli.texts.layout import percentage, seconds
from viscodesign.results.accuracy_study import AccuracyStudy

QUICK = ("--set", "bellows.count=4", "--set", "effects={pressure_distribution: on, others: off}",
         "--set", "run={duration: 0.5 s, output_interval: 50 ms}")  # fmt: skip


@pytest.fixture
def given(monkeypatch: pytest.MonkeyPatch) -> Callable[[AccuracyStudy], list[dict[str, Any]]]:
    """Puts a study in place of measuring one; returns what it was asked with."""

    def put(study: AccuracyStudy) -> list[dict[str, Any]]:
        asked: list[dict[str, Any]] = []

        def instead(scene: object, **options: Any) -> AccuracyStudy:
            asked.append(options)
            return study

        monkeypatch.setattr("viscodesign.accuracy", instead, raising=False)
        return asked

    return put


Given = Callable[[AccuracyStudy], list[dict[str, Any]]]


def test_a_real_study_of_a_small_scene(call: Call, tmp_path: Path, leg: Path) -> None:
    outcome = call("accuracy", leg, *QUICK, "-o", tmp_path / "a", "--no-plots")
    assert outcome.status == 0
    assert "for 0.5 % (requested)" in outcome.out
    assert "recommended" in outcome.out
    assert {file.name for file in (tmp_path / "a").iterdir()} == {"accuracy.csv", "accuracy.json"}
    told = json.loads((tmp_path / "a" / "accuracy.json").read_text())
    assert told["status"] == "complete"
    assert told["recommended"]["tip_error_rel"] <= 0.005


def test_costs_and_recommendation_in_words(
    call: Call, given: Given, tmp_path: Path, leg: Path
) -> None:
    asked = given(made_study())
    outcome = call("accuracy", leg, "-o", tmp_path)
    assert outcome.status == 0
    assert asked[0]["limit"] == 60.0
    text = " ".join(outcome.out.split())
    auto = "auto (distributed, inertial); idas, 1 edge per section"
    assert f"for 1 % 12 ms {auto}, tolerance 3e-3" in text
    assert f"for 0.1 % 20 ms {auto}, tolerance 1e-4" in text
    assert f"recommended {auto}, tolerance 3e-3: 12 ms, error 0.4 %" in text
    assert "to use it from Python: simulate(scene, tolerance=3e-3)" in text
    assert f"simulate starts with {auto}, tolerance 1e-4: 20 ms, error 0.08 %" in text
    assert "the recommended setting takes 40 % less time" in text
    assert "converged to 0.00067 mm, 0.00067 % of the length" in text
    assert "notes skipped: time limit: something" in text
    assert "accuracy.png" in text
    assert outcome.err == ""


@pytest.mark.parametrize("columns", ["60", "100"])
def test_lines_fit_the_terminal(monkeypatch: pytest.MonkeyPatch, columns: str) -> None:
    monkeypatch.setenv("COLUMNS", columns)
    monkeypatch.setattr("sys.stdout.isatty", lambda: True, raising=False)
    lines = cost_lines(made_study(), 0.005, Path("runs/leg"), [Path("accuracy.csv")])
    assert all(len(line) <= int(columns) for line in lines)


def test_a_bounded_error_and_an_error_not_reached_say_so() -> None:
    text = "\n".join(cost_lines(made_study(requested_rel=5e-5), None, Path("x"), []))
    assert "error <= 0.002 %" in text
    assert (
        "--set effects.feedback=on; from Python: viscodesign.simulation.solve_once.solve with"
        in text
    )
    assert "Settings(2, 1e-6, 'idas')" in text
    text = "\n".join(cost_lines(made_study(requested_rel=1e-6), None, Path("x"), []))
    assert "not reached in this study" in text
    assert "none: no setting in this study reaches the requested 0.0001 %" in text


def test_of_many_notes_some_are_printed() -> None:
    notes = tuple(f"note {k}" for k in range(9))
    text = "\n".join(cost_lines(made_study(notes=notes), None, Path("x"), []))
    assert "note 4" in text
    assert "note 5" not in text
    assert "and 4 more in accuracy.json" in text


@pytest.mark.parametrize(
    ("budget", "words"),
    [
        (
            "20 ms",
            "within 20 ms: auto (distributed, inertial); idas, 1 edge per section, tolerance 1e-4: 20 ms",
        ),
        ("0.06", "within 60 ms: everything"),
        ("100 us", "no setting solves within 0.1 ms: the cheapest takes 1 ms, IV"),
    ],
)
def test_a_budget_names_the_most_accurate_setting(
    call: Call, given: Given, tmp_path: Path, leg: Path, budget: str, words: str
) -> None:
    given(made_study())
    outcome = call("accuracy", leg, "-o", tmp_path, "--no-plots", "--budget", budget)
    assert outcome.status == 0
    assert words in outcome.out
    assert "budget" in json.loads((tmp_path / "accuracy.json").read_text())


@pytest.mark.parametrize("option", ["--budget", "--limit"])
@pytest.mark.parametrize(
    ("time", "words"),
    [
        ("20 mm", "'20 mm' is a length; expected a time, such as '20 ms'"),
        ("soon", "expected a time, such as '20 ms'"),
        ("0 s", "must be above zero, such as '20 ms'; got '0 s'"),
        ("-1", "must be above zero, such as '20 ms'; got '-1'"),
    ],
)
def test_an_invalid_time_is_refused_first(
    call: Call, tmp_path: Path, option: str, time: str, words: str
) -> None:
    outcome = call("accuracy", tmp_path / "none.yaml", f"{option}={time}")
    assert outcome.status == 2
    assert outcome.err.startswith(f"{option}: ")
    assert words in outcome.err


def test_json_is_one_document_and_nothing_else(
    call: Call, given: Given, tmp_path: Path, leg: Path
) -> None:
    given(made_study())
    outcome = call("accuracy", leg, "-o", tmp_path, "--json", "--limit", "5 min")
    told = json.loads(outcome.out)
    assert outcome.err == ""
    files = told.pop("files")
    assert [Path(file).name for file in files] == ["accuracy.csv", "accuracy.json", "accuracy.png"]
    assert told == json.loads((tmp_path / "accuracy.json").read_text())


def test_quiet_says_nothing(call: Call, given: Given, tmp_path: Path, leg: Path) -> None:
    given(made_study())
    outcome = call("accuracy", leg, "-o", tmp_path, "-q", "--no-plots")
    assert (outcome.status, outcome.out, outcome.err) == (0, "", "")


def test_an_unusable_folder_is_refused_before_solving(
    call: Call, given: Given, tmp_path: Path, leg: Path
) -> None:
    (tmp_path / "mine.txt").write_text("")
    asked = given(made_study())
    outcome = call("accuracy", leg, "-o", tmp_path)
    assert outcome.status == 2
    assert "--force" in outcome.err
    assert asked == []


def test_an_interrupted_study_is_written_and_ends_with_130(
    call: Call, given: Given, tmp_path: Path, leg: Path
) -> None:
    given(made_study(status="interrupted"))
    outcome = call("accuracy", leg, "-o", tmp_path, "--no-plots")
    assert outcome.status == 130
    assert "interrupted after 12 s with 7 points measured" in outcome.err
    assert str(tmp_path) in outcome.err
    assert json.loads((tmp_path / "accuracy.json").read_text())["status"] == "interrupted"


PRINTS_WHEN_IT_MEASURES = """
import sys
from viscodesign.cli.main import main
from viscodesign.studies.timed_runs import TimedRuns

measure = TimedRuns.measure

def printing(*given):
    print("measuring", flush=True)
    TimedRuns.measure = measure
    return measure(*given)

TimedRuns.measure = printing
sys.exit(main())
"""


@pytest.mark.skipif(os.name != "posix", reason="POSIX signals")
def test_ctrl_c_keeps_what_is_done(tmp_path: Path) -> None:
    words = [
        "accuracy",
        str(CONFIGS / "leg_16_straight_air.yaml"),
        "-o",
        str(tmp_path),
        "--no-plots",
        "--limit",
        "10 min",
        *QUICK,
    ]
    process = subprocess.Popen(
        [sys.executable, "-c", PRINTS_WHEN_IT_MEASURES, *words, "--set", "effects=auto"],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    )  # fmt: skip
    assert process.stdout is not None
    assert process.stdout.readline() == "measuring\n"
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "interrupted" in err
    assert "Traceback" not in err
    assert json.loads((tmp_path / "accuracy.json").read_text())["status"] == "interrupted"
    assert "reference" in out


@pytest.mark.parametrize(
    ("part", "words"),
    [(1e-4, "0.01 %"), (0.0126, "1.3 %"), (7.3e-6, "0.00073 %"), (1e-9, "1.0e-07 %")],
)
def test_percentages(part: float, words: str) -> None:
    assert percentage(part) == words


@pytest.mark.parametrize(
    ("time_s", "words"), [(0.00123, "1.2 ms"), (0.0123, "12 ms"), (0.123, "120 ms"), (12.3, "12 s")]
)
def test_times(time_s: float, words: str) -> None:
    assert seconds(time_s) == words
