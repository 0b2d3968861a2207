"""`pump plan` as a user calls it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.unit.cli.conftest import CONFIGS, Call

PUMP = ("--set", "pump={syringe_diameter: 34.9 mm, home: 500}")
SHORT = ("--set", "run={duration: 1 s}", "--set", "input={kind: constant, value: 8 kPa}")
LEG = CONFIGS / "leg_4_air_auto.yaml"


def test_a_feasible_plan_is_printed_and_written(call: Call, tmp_path: Path) -> None:
    found = call("pump", "plan", LEG, *PUMP, *SHORT, "-o", tmp_path)
    assert found.status == 0
    assert ": feasible" in found.out
    assert "AX-18A" in found.out
    assert "--set" not in found.out
    assert sorted(file.name for file in tmp_path.iterdir()) == [
        "plan.csv",
        "plan.json",
        "plan.png",
    ]


def test_an_infeasible_plan_exits_with_4_and_keeps_its_files(call: Call, tmp_path: Path) -> None:
    low = ("--set", "pump.max_pressure=5 kPa gauge")
    found = call("pump", "plan", LEG, *PUMP, *low, *SHORT, "-o", tmp_path, "--no-plots")
    assert found.status == 4
    assert "INFEASIBLE" in found.out
    assert "--set 'pump.max_pressure=8 kPa gauge'" in found.out
    assert "labelled infeasible" in found.err
    assert json.loads((tmp_path / "plan.json").read_text())["feasible"] is False


def test_json_is_all_that_is_printed(call: Call, tmp_path: Path) -> None:
    found = call("pump", "plan", LEG, *PUMP, *SHORT, "-o", tmp_path, "--json", "--no-plots")
    document = json.loads(found.out)
    assert document["feasible"] is True
    assert document["accuracy"]["tip_error_m"] > 0.0
    assert {"verdicts", "together", "numbers", "limits", "files"} <= set(document)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ((), "pump: missing"),
        (("--set", "pump={syringe_diameter: 34.9 mm, max_pressure: 140 kPa}"), "'140 kPa abs'"),
    ],
)
def test_a_faulty_spec_exits_with_2_and_writes_nothing(
    words: tuple[str, ...], told: str, call: Call, tmp_path: Path
) -> None:
    folder = tmp_path / "new"
    found = call("pump", "plan", LEG, *words, "-o", folder)
    assert found.status == 2
    assert told in found.err
    assert not folder.exists()


def test_an_input_that_may_be_absolute_is_asked_about(call: Call, tmp_path: Path) -> None:
    high = ("--set", "input={kind: constant, value: 140 kPa}")
    found = call("pump", "plan", LEG, *PUMP, *SHORT, *high, "-o", tmp_path, "--no-plots")
    assert found.status == 2
    assert "140 kPa abs' (38.67 kPa gauge)" in found.err
    said = ("--set", "input={kind: constant, value: 140 kPa gauge}")
    found = call("pump", "plan", LEG, *PUMP, *SHORT, *said, "-o", tmp_path, "--no-plots")
    assert found.status == 4
    assert "140 kPa abs" not in found.out


def test_another_folders_files_are_left_alone(call: Call, tmp_path: Path) -> None:
    (tmp_path / "thesis.doc").write_text("mine")
    assert call("pump", "plan", LEG, *PUMP, *SHORT, "-o", tmp_path).status == 2


def test_a_run_and_a_plan_share_a_folder(call: Call, tmp_path: Path) -> None:
    quiet = ("-q", "--no-plots")
    assert call("simulate", LEG, *SHORT, "-o", tmp_path, *quiet).status == 0
    assert call("pump", "plan", LEG, *PUMP, *SHORT, "-o", tmp_path, *quiet).status == 0
    assert call("simulate", LEG, *SHORT, "-o", tmp_path, *quiet).status == 0
    names = {file.name for file in tmp_path.iterdir()}
    assert {"summary.json", "plan.json", "plan.csv"} <= names
