"""`viscodesign sweep`: its files, its words, and its exit codes."""

from __future__ import annotations

import json
from pathlib import Path

import pandas as pd
import pytest

from tests.scenes import CONFIGS
from tests.unit.studies.test_sweep import QUASI_STATIC
from viscodesign.cli.main import main

LEG = [str(CONFIGS / "leg_4_air.yaml"), *(w for o in QUASI_STATIC for w in ("--set", o))]


def test_its_files_and_its_document(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    over = ["--over", "network.tube_radius=0.3 mm,0.4 mm", "--over", "fluid=air,whater"]
    assert main(["sweep", *LEG, *over, "-o", str(tmp_path), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert {Path(file).name for file in document["files"]} == {
        "sweep.csv", "sweep.json", "sweep.png",
    }  # fmt: skip
    table = pd.read_csv(tmp_path / "sweep.csv")
    assert table["status"].tolist() == ["complete", "failed"] * 2
    assert [failed["row"] for failed in document["failed"]] == [1, 3]
    assert json.loads((tmp_path / "sweep.json").read_text())["models"] == document["models"]
    assert document["keys"][0]["column"] == "network.tube_radius_m" in table


def test_its_words(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    over = ["--over", "network.tube_radius=0.3 mm..0.4 mm:2"]
    assert main(["sweep", *LEG, *over, "-o", str(tmp_path), "--format", "svg"]) == 0
    said = capsys.readouterr().out
    assert said.startswith("leg_4_air: complete sweep over network.tube_radius\n")
    assert "2: 2 complete" in said
    assert "row 0     stated error" in said
    assert (tmp_path / "sweep.svg").is_file()


@pytest.mark.parametrize(
    ("words", "status", "message"),
    [
        (["--over", "network.tube_radius=-1 mm"], 3, "no row could be solved; the first: "),
        (["--over", "network.tube_radius=1 mm", "--metric", "loop"], 2, "--metric: must be one of"),
        (["--over", ""], 2, "'' names no key"),
    ],
)
def test_exit_codes(
    words: list[str], status: int, message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["sweep", *LEG, *words, "-o", str(tmp_path / "out"), "--no-plots"]) == status
    assert message in capsys.readouterr().err
