"""`viscodesign compare`: its files, its words and its exit codes."""

from __future__ import annotations

import csv
import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.trajectories import made_run
from viscodesign.comparison import simulated_operands
from viscodesign.results.trajectory import RunInterruptedError
from viscodesign.scene.reading.write import resolved_yaml

from .conftest import CONFIGS, Call

FILES = {"compare.csv", "compare.json", "compare.png", "compare.html"}


@pytest.fixture(scope="module")
def camera(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A table: the made-up run, 1 mm to the right."""
    run, file = made_run(), tmp_path_factory.mktemp("camera") / "camera.csv"
    rows = np.column_stack((run.time, run.tip[:, 0] + 1e-3, run.tip[:, 1]))
    np.savetxt(file, rows, delimiter=",", header="time_s,tip_x_m,tip_z_m", comments="")
    return file


@pytest.fixture
def solved(monkeypatch: pytest.MonkeyPatch) -> None:
    """Specs are solved at once, by the made-up run."""

    def solve(scene: object, **_: object) -> object:
        return replace(made_run(), name="leg", spec_text=resolved_yaml(scene))  # type: ignore[arg-type]

    monkeypatch.setattr(simulated_operands, "simulate", solve)


@pytest.mark.usefixtures("solved")
def test_files_words_and_document(call: Call, camera: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    done = call("compare", CONFIGS / "leg.yaml", camera, "-o", out, "--no-verify")
    assert done.status == 0
    assert "camera differs from leg by 1 mm at most" in done.out
    assert {file.name for file in out.iterdir()} == {*FILES, "runs"}
    found = call("compare", CONFIGS / "leg.yaml", camera, "-o", out, "--json", "--no-plots")
    document = json.loads(found.out)
    assert document["differences"][0]["rms_m"] == pytest.approx(1e-3)
    assert not (out / "compare.png").exists()
    with (out / "compare.csv").open() as lines:
        rows = list(csv.DictReader(lines))
    assert [row["label"] for row in rows] == ["leg", "camera"]
    assert rows[0]["rms_m"] == ""
    assert float(rows[1]["max_m"]) == document["differences"][0]["max_m"]
    assert float(rows[1]["tip_x_max_m"]) == pytest.approx(float(rows[0]["tip_x_max_m"]) + 1e-3)


def test_bad_input_leaves_no_folder(call: Call, camera: Path, tmp_path: Path) -> None:
    done = call("compare", camera, "-o", tmp_path / "out")
    assert done.status == 2
    assert done.err.startswith("expected two or more motions to compare, got only")
    assert not (tmp_path / "out").exists()
    assert call("compare", camera, tmp_path / "no.csv", "--period", "0 s").status == 2


def test_an_interrupt_before_there_are_two_motions(
    call: Call, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    def stopped(scene: object, **_: object) -> None:
        raise RunInterruptedError(None)

    monkeypatch.setattr(simulated_operands, "simulate", stopped)
    words = ("compare", CONFIGS / "leg.yaml", CONFIGS / "leg_4_air.yaml", "-o", tmp_path / "out")
    done = call(*words)
    assert done.status == 130
    assert "the same command reads them and does the others" in done.err


def test_a_spec_that_fails_is_compared_and_exits_with_3(
    call: Call, camera: Path, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    failed = replace(made_run(time=np.linspace(0, 1, 51)), status="failed", failure="no step")
    monkeypatch.setattr(simulated_operands, "simulate", lambda scene, **_: failed)
    done = call("compare", camera, CONFIGS / "leg.yaml", "-o", tmp_path / "out", "--no-plots")
    assert done.status == 3
    assert "leg_made_up (failed at 1 s) differs from camera by 1 mm" in done.out
    assert "no step" in done.err


def test_figure_1_of_the_paper(call: Call, tmp_path: Path) -> None:
    done = call("compare", "--figure", "1", "-o", tmp_path / "out", "--json")
    assert done.status == 0
    document = json.loads(done.out)
    found = {row["words"]: (row["verdict"], row["found"]) for row in document["statements"]}
    assert found["t_f = 0.157 s"] == ("agrees", "0.157 s")
    assert found["t_i = 0.74 s"][0] == "DIFFERS"
    assert {file.name for file in (tmp_path / "out").iterdir()} == {
        "figure_1.csv", "figure_1.json", "figure_1.png",
    }  # fmt: skip


def test_figures_take_no_motions_and_are_1_3_and_4(call: Call, tmp_path: Path) -> None:
    done = call("compare", "--figure", "2", "-o", tmp_path / "out")
    assert (done.status, done.err) == (2, "--figure: must be one of 1, 3, 4; got 2\n")
    assert not (tmp_path / "out").exists()
    done = call("compare", "leg.yaml", "--figure", "3", "-o", tmp_path / "out")
    assert (done.status, done.err) == (2, "--figure 3 takes no motions; got leg.yaml\n")
