"""`viscodesign fit`: its files, its document, its words."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.recordings import columns_of, small_scene, written
from viscodesign import load
from viscodesign.cli.main import main
from viscodesign.cli.texts.fit_text import _number_row
from viscodesign.results.fit_result import FittedNumber
from viscodesign.scene.reading.write import resolved_yaml

TRUTH = {"bellows.area_per_pressure": 4.0e-9, "fluid.viscosity": 8.5e-5}
FREE = [word for key in TRUTH for word in ("--free", key)]


@pytest.fixture
def given(tmp_path: Path) -> list[str]:
    """Spec and recording on a command line."""
    scene = small_scene()
    spec = tmp_path / "leg.yaml"
    spec.write_text(resolved_yaml(scene))
    data = written(columns_of(scene, TRUTH, seed=1), tmp_path / "data.csv")
    return [str(spec), str(data)]


def test_its_files_and_its_document(
    given: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "out"
    assert main(["fit", *given, *FREE, "-o", str(folder), "--json"]) == 0
    document = json.loads(capsys.readouterr().out)
    assert {Path(file).name for file in document["files"]} == {"spec.yaml", "fit.json", "fit.png"}
    by_key = {own["key"]: own for own in document["parameters"]}
    assert set(by_key) == set(TRUTH)
    for key, truth in TRUTH.items():
        own = by_key[key]
        assert own["identified"]
        assert own["low_95"] < own["value"] < own["high_95"]
        assert own["value"] == pytest.approx(truth, rel=0.01)
    assert document["clock_offset_s"] == 0.0
    assert document["cannot_be_told_apart"] == document["products"] == []
    on_disk = json.loads((folder / "fit.json").read_text())
    assert on_disk["parameters"] == document["parameters"]
    fitted = load(folder / "spec.yaml")
    assert fitted.fluid.viscosity == by_key["fluid.viscosity"]["value"]


def test_its_words(given: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["fit", *given, *FREE, "-o", str(tmp_path / "out"), "--no-plots"]) == 0
    said = capsys.readouterr().out
    assert "2 of 2 numbers identified" in said
    assert "the spec's double_sigmoid fits it" in said
    assert not (tmp_path / "out" / "fit.png").exists()


def test_a_model_that_does_not_describe_the_recording_is_told_first(
    given: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """An actuator a tenth longer than the spec's: the numbers are kept, and none is believed."""
    length = f"actuator.length={small_scene().actuator.length / 1.1} m"
    folder = tmp_path / "out"
    words = [*FREE, "--set", length, "-o", str(folder), "--no-plots"]
    assert main(["fit", *given, *words]) == 3
    told = capsys.readouterr()
    lines = told.out.splitlines()
    assert lines[0].endswith("0 of 2 numbers identified")
    assert lines[1].strip().startswith("THE MODEL DOES NOT DESCRIBE THE RECORDING")
    assert "Worst: m2_" in told.out
    assert "Effects included: pressure_distribution" in told.out
    assert "none of its numbers counts" in told.err
    document = json.loads((folder / "fit.json").read_text())
    assert document["status"] == "mismatch"
    assert document["next_experiment"] is None
    assert document["mismatch"]["worst"]["column"].startswith("m2_")
    assert "inertia" in document["mismatch"]["effects_left_out"]
    assert {own["reason"] for own in document["parameters"]} == {"mismatch"}
    assert "the model does not describe the data" in (folder / "spec.yaml").read_text()


def test_a_bad_recording_is_one_message(
    given: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    Path(given[1]).write_text("time_s,m1_x\n0,1\n")
    assert main(["fit", *given, "-o", str(tmp_path / "out")]) == 2
    assert capsys.readouterr().err.strip().endswith("such as 'm1_x_m'")


def test_an_empty_key_is_one_message(
    given: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["fit", *given, "--free", "", "-o", str(tmp_path / "out")]) == 2
    assert capsys.readouterr().err.strip().startswith("a free key is empty; name a number")


def test_a_number_at_a_search_bound_is_marked_in_its_row() -> None:
    own = FittedNumber(
        "fluid.viscosity", 3e-4, "Pa*s", 1e-5, 2.9e-4, 3.1e-4, "edge_of_range", "high"
    )
    assert _number_row(own)[-1].endswith("; NOT IDENTIFIED, at its high search bound")
