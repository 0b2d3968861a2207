"""`viscodesign sensitivity`: its files and its words."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.unit.cli.test_sweep import LEG
from viscodesign.cli.main import main


def test_its_files_and_its_document(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("viscodesign.exploration.sampled_variance.SAMPLE_SIZE", 32)
    tolerance = ["--tolerance", "network.tube_radius=5%", "--sobol"]
    assert main(["sensitivity", *LEG, *tolerance, "-o", str(tmp_path), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert {Path(file).name for file in document["files"]} == {
        "sensitivity.csv", "sensitivity.json", "sensitivity.png",
    }  # fmt: skip
    assert document["keys"][0]["share_of_variance"] == 1.0
    assert document["sobol"]["tip_x"]["keys"][0]["first_order"] == pytest.approx(1.0, abs=0.2)


def test_its_words(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["sensitivity", *LEG, "-o", str(tmp_path), "--no-plots"]) == 0
    said = capsys.readouterr().out
    assert "network.tube_radius" in said
    assert "mm per percent at" in said
    assert "left out" in said
