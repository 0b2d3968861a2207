"""`simulate`: files, summary and exit code, whatever becomes of the run."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from tests.trajectories import ABLATIONS, ablated_run, made_run
from viscodesign import load
from viscodesign.cli.run_folders import folder_name
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.reading.write import resolved_yaml

from .conftest import CONFIGS, Call

SHORT = ("--set", "run.duration=0.1 s", "--no-plots")
TABLES = {"trajectory.csv", "shape.csv", "summary.json", "spec.yaml", "report.html"}


def _names(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()}


@pytest.fixture
def solved(monkeypatch: pytest.MonkeyPatch) -> Callable[[Trajectory], None]:
    """Let the solver return a given run at once."""

    def fix(trajectory: Trajectory) -> None:
        monkeypatch.setattr("viscodesign.simulate", lambda scene, **_: trajectory)

    return fix


def test_a_real_run(call: Call, tmp_path: Path) -> None:
    spec = CONFIGS / "leg_4_air.yaml"
    outcome = call("simulate", spec, "-o", tmp_path / "run", *SHORT)
    assert (outcome.status, outcome.err) == (0, "")
    assert _names(tmp_path / "run") == TABLES
    for words in ("leg_4_air: quadrant", "complete: 0.1 s", "tip error", "effects", "summary.json"):
        assert words in outcome.out


def test_json_is_the_summary_and_nothing_else(call: Call, tmp_path: Path) -> None:
    spec = CONFIGS / "leg_4_air.yaml"
    outcome = call("simulate", spec, "-o", tmp_path / "run", "--json", "--no-verify", *SHORT)
    document = json.loads(outcome.out)
    stored = json.loads((tmp_path / "run" / "summary.json").read_text())
    assert {key: document[key] for key in stored} == stored
    assert document["accuracy"]["estimated_tip_error_m"] is None
    assert document["metrics"]["path_length_m"] > 0
    assert {Path(file).name for file in document["files"]} == TABLES


def test_the_cost_is_all_the_time_but_that_of_the_summary(call: Call, tmp_path: Path) -> None:
    spec = CONFIGS / "leg_4_air.yaml"
    began = time.perf_counter()
    call("simulate", spec, "-o", tmp_path / "run", "--no-verify", *SHORT)
    spent = time.perf_counter() - began
    cost = json.loads((tmp_path / "run" / "summary.json").read_text())["cost"]
    parts = ("load_s", "choose_s", "build_s", "solve_s", "verify_s", "read_s", "write_s")
    assert cost["total_s"] == pytest.approx(sum(cost[part] for part in parts), rel=1e-12)
    assert all(cost[part] > 0 for part in parts if part != "verify_s")
    assert 0.7 * spent < cost["total_s"] < spent


def test_the_folder_is_named_by_the_scene(
    call: Call,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    leg: Path,
    trajectory: Trajectory,
    solved: Callable[[Trajectory], None],
) -> None:
    solved(replace(trajectory, spec_text=resolved_yaml(load(leg))))
    monkeypatch.chdir(tmp_path)
    assert call("simulate", leg, "--no-plots", "-q") == call("simulate", leg, "--no-plots", "-q")
    assert _names(tmp_path / "runs" / "leg_16_straight_air") == TABLES
    assert _names(tmp_path / "runs") == {"leg_16_straight_air"}


@pytest.mark.parametrize(("status", "code"), [("failed", 3), ("interrupted", 130)])
@pytest.mark.parametrize("json_wanted", [False, True])
def test_a_run_that_ends_early_is_kept_and_told(
    call: Call,
    tmp_path: Path,
    leg: Path,
    trajectory: Trajectory,
    solved: Callable[[Trajectory], None],
    status: str,
    code: int,
    json_wanted: bool,
) -> None:
    solved(replace(trajectory, status=status, failure="stretch below 0.2 at t = 1 s"))
    words = ("--json",) if json_wanted else ()
    outcome = call("simulate", leg, "-o", tmp_path / "run", "--no-plots", *words)
    assert outcome.status == code
    assert "stretch below 0.2 at t = 1 s" in outcome.err
    assert str(tmp_path / "run") in outcome.err
    assert json.loads((tmp_path / "run" / "summary.json").read_text())["status"] == status
    if json_wanted:
        assert json.loads(outcome.out)["status"] == status


def test_warnings_go_to_stderr_beside_json(
    call: Call,
    tmp_path: Path,
    leg: Path,
    trajectory: Trajectory,
    solved: Callable[[Trajectory], None],
) -> None:
    solved(trajectory)
    outcome = call("simulate", leg, "-o", tmp_path / "run", "--no-plots", "--json")
    assert outcome.err.count("negative_volume") == 1
    quiet = call("simulate", leg, "-o", tmp_path / "run", "--no-plots", "--json", "-q")
    assert quiet.err == ""
    assert json.loads(quiet.out)["name"] == "leg"


def test_prove_measures_effects_and_prints_them(
    call: Call, tmp_path: Path, leg: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[object] = []

    def solve(scene: object, *, prove: bool, **_: object) -> Trajectory:
        asked.append(prove)
        return ablated_run() if prove else made_run()

    monkeypatch.setattr("viscodesign.simulate", solve)
    plain = call("simulate", leg, "-o", tmp_path, "--no-plots")
    proven = call("simulate", leg, "-o", tmp_path, "--no-plots", "--prove")
    assert asked == [False, True]
    assert "measured effects:" not in plain.out
    for words in (
        "measured effects: each switched",
        "NEGLECTED BUT SIGNIFICANT",
        "--set effects.gravity=on",
    ):
        assert words in proven.out
    assert len(json.loads((tmp_path / "summary.json").read_text())["proof"]) == len(ABLATIONS)


def test_measured_effects_are_in_the_document_and_warnings_beside_it(
    call: Call, tmp_path: Path, leg: Path, solved: Callable[[Trajectory], None]
) -> None:
    solved(ablated_run())
    outcome = call("simulate", leg, "-o", tmp_path, "--no-plots", "--prove", "--json")
    assert [p["name"] for p in json.loads(outcome.out)["proof"]] == [p.name for p in ABLATIONS]
    assert outcome.err.count("WARNING: gravity was neglected") == 1
    quiet = call("simulate", leg, "-o", tmp_path, "--no-plots", "--prove", "-q")
    assert (quiet.out, quiet.err) == ("", "")


def test_measured_effects_of_a_real_run(call: Call, tmp_path: Path) -> None:
    spec = CONFIGS / "leg_4_air.yaml"
    outcome = call("simulate", spec, "-o", tmp_path, "--set", "run.duration=0.1 s", "--prove")
    assert outcome.status == 0
    assert "pressure_distribution  included" in outcome.out
    assert (tmp_path / "effects.png").exists()


def test_a_foreign_folder_is_refused_before_the_work(
    call: Call, tmp_path: Path, leg: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def never(scene: object, **_: object) -> None:
        raise AssertionError("solved before the folder was looked at")

    monkeypatch.setattr("viscodesign.simulate", never)
    (tmp_path / "thesis.tex").write_text("mine")
    outcome = call("simulate", leg, "-o", tmp_path)
    assert outcome.status == 2
    assert "--force" in outcome.err
    assert _names(tmp_path) == {"thesis.tex"}


def test_a_file_is_no_folder(call: Call, tmp_path: Path, leg: Path) -> None:
    (tmp_path / "run").write_text("")
    outcome = call("simulate", leg, "-o", tmp_path / "run", *SHORT)
    assert outcome.status == 2
    assert str(tmp_path / "run") in outcome.err


@pytest.mark.parametrize(
    ("name", "folder"),
    [
        ("leg_16", "leg_16"),
        ("my leg: no. 3", "my_leg_no._3"),
        ("../../etc", "etc"),
        ("/", "run"),
        ("..", "run"),
    ],
)
def test_folder_name(name: str, folder: str) -> None:
    assert folder_name(name) == folder
