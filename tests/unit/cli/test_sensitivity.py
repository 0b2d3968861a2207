"""`viscodesign sensitivity`: its files and its words."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.unit.cli.test_sweep import LEG
from viscodesign import load
from viscodesign.cli.main import main
from viscodesign.cli.run_folders import own_folder


def test_its_files_and_its_document(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("viscodesign.studies.sampled_variance.SAMPLE_SIZE", 32)
    tolerance = ["--tolerance", "network.tube_radius=5%", "--sobol"]
    assert main(["sensitivity", *LEG, *tolerance, "-o", str(tmp_path), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert {Path(file).name for file in document["files"]} == {
        "sensitivity.csv", "sensitivity.json", "sensitivity.png",
    }  # fmt: skip
    assert document["keys"][0]["share_of_variance"] == 1.0
    assert document["sobol"]["tip_x"]["keys"][0]["first_order"] == pytest.approx(1.0, abs=0.2)


def test_its_words_and_a_folder_that_a_run_of_the_same_spec_shares(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["sensitivity", *LEG, "--no-plots"]) == 0
    said = capsys.readouterr().out
    scene = load(LEG[0], LEG[2::2])
    folder, remark = own_folder(scene)
    assert (folder / "sensitivity.json").is_file()
    assert remark == ""
    other, remark = own_folder(scene.replace({"accuracy": 0.02}))
    assert other.name == f"{folder.name}-2"
    assert str(other) in remark
    assert "network.tube_radius" in said
    assert "mm per percent at" in said
    assert "left out" in said


@pytest.mark.parametrize(
    ("place", "missing"), [("_variances", "the band"), ("_checked", "the sample")]
)
def test_an_interrupt_behind_the_slopes_keeps_them_and_says_so(
    place: str,
    missing: str,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def pressed(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(f"viscodesign.studies.sensitivity.{place}", pressed)
    words = ["--tolerance", "network.tube_radius=5%", "--sobol", "--no-plots"]
    assert main(["sensitivity", *LEG, *words, "-o", str(tmp_path)]) == 130
    said = capsys.readouterr()
    assert f"the run and its slopes are complete, without {missing}" in said.err
    assert str(tmp_path) in said.err
    assert "mm per percent at" in said.out
    assert (tmp_path / "sensitivity.csv").is_file()
    assert ("band" in json.loads((tmp_path / "sensitivity.json").read_text())) == (
        place == "_checked"
    )
