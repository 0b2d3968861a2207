"""`viscodesign design`: its files, its words and its exit codes."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.unit.inverse.tasks import PULSE, small, task
from viscodesign import load
from viscodesign.cli.main import main


def test_its_files_and_its_document(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = task(tmp_path, PULSE, small(input__start=17e3), tolerance="0.02 mm")
    out = tmp_path / "out"
    assert main(["design", str(target), "-o", str(out), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert {Path(file).name for file in document["files"]} == {
        "spec.yaml", "result.json", "history.csv", "design.png",
    }  # fmt: skip
    assert document["status"] == "met"
    assert document["parameters"]["input.start"] == pytest.approx(17e3, rel=1e-2)
    assert json.loads((out / "result.json").read_text())["rms_m"] == document["rms_m"]
    assert load(out / "spec.yaml").inputs["inlet"].model_dump()["start"] == pytest.approx(
        document["parameters"]["input.start"]
    )


def test_a_design_that_is_not_met_is_written_and_exits_with_3(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target = task(tmp_path, {"input.drop": ["10 kPa", "20 kPa"]}, small(), tolerance="0.02 mm")
    out = tmp_path / "out"
    assert main(["design", str(target), "-o", str(out), "--no-plots"]) == 3
    said = capsys.readouterr()
    assert "small: not met" in said.out
    assert "at their bounds: input.drop" in said.err
    assert {file.name for file in out.iterdir()} == {"spec.yaml", "result.json", "history.csv"}


def test_reach_writes_its_files_and_a_point_out_of_reach_exits_with_3(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    task(tmp_path, PULSE, small())
    spec, out = str(tmp_path / "spec.yaml"), tmp_path / "out"
    words = ["reach", spec, "-o", str(out), "--limits", "0, 20 kPa"]
    assert main([*words, "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["area_two_inlets_m2"] > document["area_m2"] > 0
    assert {file.name for file in out.iterdir()} == {"reach.csv", "reach.json", "reach.png"}
    assert main([*words, "--at", "0 mm, 40 mm", "--time", "6 s", "--no-plots"]) == 3
    said = capsys.readouterr()
    assert "out of reach by" in said.err
    assert (out / "input.csv").read_text().startswith("time_s,pressure_pa\n0.0,0.0\n")
    assert main(["reach", spec, "--limits", "-25, 30"]) == 2
    assert "such as [-25 kPa, 30 kPa]" in capsys.readouterr().err
    assert main([*words, "--at", "40 mm"]) == 2
    assert "--at: expected two values" in capsys.readouterr().err
