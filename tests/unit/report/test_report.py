"""Files of a run: whole or absent, with the columns of the public interface; pictures drawn."""

from __future__ import annotations

import errno
import json
import os
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

from tests.scenes import ACTUATOR_SPECS, CONFIGS, leg
from viscodesign import Trajectory, classify, load, simulate
from viscodesign.errors import OutputError, UsageError
from viscodesign.report.charts.quadrants import draw_plane
from viscodesign.report.folder import PAGE, RUN_PICTURES, RUN_TABLES, SUMMARY
from viscodesign.report.layout.snapshots import normals, outline, spread_instants
from viscodesign.report.run_folder import write_run
from viscodesign.results.findings import Classification, Notice
from viscodesign.storage import atomic_files as atomic

PNG = b"\x89PNG"
ALL = {*RUN_TABLES, *RUN_PICTURES, PAGE, SUMMARY}


@cache
def trajectory(*overrides: str) -> Trajectory:
    return simulate(leg("effects={pressure_distribution: on, others: off}", *overrides))


def test_a_run_has_its_files_and_columns(tmp_path: Path) -> None:
    found = trajectory()
    written = write_run(found, tmp_path / "run")
    assert {p.name for p in written} == ALL == {p.name for p in (tmp_path / "run").iterdir()}
    table = pd.read_csv(tmp_path / "run" / "trajectory.csv")
    pressures = [f"pressure_{side}{j}_pa" for side in "RL" for j in range(1, 9)]
    assert list(table.columns[:21]) == [
        "time_s", "tip_x_m", "tip_z_m", "tip_angle_rad", "inlet_pressure_pa", *pressures
    ]  # fmt: skip
    assert table.columns[21] == "flow_inlet-R1_m3_s"
    assert np.array_equal(table["tip_x_m"], found.tip[:, 0])  # every digit survives
    shape = pd.read_csv(tmp_path / "run" / "shape.csv")
    assert list(shape.columns) == ["time_s", "arc_m", "x_m", "z_m"]
    assert len(shape) == len(found.time) * len(found.arc)
    summary = json.loads((tmp_path / "run" / "summary.json").read_text())
    assert summary["status"] == "complete"
    assert set(summary["scales"]) == {"t_s", "t_f", "t_i", "t_net"}
    assert set(summary["ratios"]) == {"ts_over_tf", "ts_over_ti", "tnet_over_ti"}
    assert {"requested_m", "estimated_tip_error_m", "method"} <= set(summary["accuracy"])
    assert {"build_s", "solve_s", "verify_s", "steps", "residual_calls"} <= set(summary["cost"])
    assert set(summary["effects"][0]) == {
        "name", "mode", "taken", "weight", "formula", "reason", "contribution_m", "budget_share", "present",
        "traits",
    }  # fmt: skip
    assert summary["metrics"]["tip_x_max_m"] == table["tip_x_m"].max()
    assert summary["metrics"]["tip_z_min_time_s"] == table["time_s"][table["tip_z_m"].idxmin()]
    assert {"loop_width_m", "path_length_m", "loop_area_m2", "column_lag_s"} <= set(
        summary["metrics"]
    )
    assert "proof" not in summary
    assert summary["spec_sha256"]


def test_the_resolved_spec_of_a_run_runs_again_to_the_same_numbers(tmp_path: Path) -> None:
    found = trajectory()
    write_run(found, tmp_path / "run", plots=False)
    again = simulate(load(tmp_path / "run" / "spec.yaml"))
    assert np.array_equal(again.tip, found.tip)


def test_frames_have_the_columns_of_the_files() -> None:
    found = trajectory()
    assert found.frame().columns[0] == "time_s"
    assert len(found.shape_frame()) == len(found.time) * len(found.arc)
    assert json.dumps(found.summary(), allow_nan=False)


def test_several_inlets_have_a_column_each() -> None:
    found = simulate(load(CONFIGS / "antagonistic_two_inlets.yaml"), verify=False)
    columns = list(found.frame().columns)
    assert "inlet_pressure_left_pa" in columns
    assert "inlet_pressure_right_pa" in columns


def test_pictures_are_left_out_and_old_ones_removed(tmp_path: Path) -> None:
    write_run(trajectory(), tmp_path)
    assert (tmp_path / "tip.png").read_bytes().startswith(PNG)
    write_run(trajectory(), tmp_path, plots=False)
    assert not list(tmp_path.glob("*.png"))


def test_folders_with_other_files_need_force(tmp_path: Path) -> None:
    (tmp_path / "thesis.txt").write_text("precious")
    with pytest.raises(UsageError, match=r"other files \(thesis\.txt\)"):
        write_run(trajectory(), tmp_path, plots=False)
    assert os.listdir(tmp_path) == ["thesis.txt"]
    write_run(trajectory(), tmp_path, plots=False, force=True)
    assert (tmp_path / "thesis.txt").read_text() == "precious"


def test_a_file_in_the_place_of_the_folder_is_refused(tmp_path: Path) -> None:
    (tmp_path / "run").write_text("")
    with pytest.raises(UsageError, match="is a file"):
        write_run(trajectory(), tmp_path / "run")
    with pytest.raises(UsageError, match="run"):
        write_run(trajectory(), tmp_path / "run" / "below")


def test_a_full_disk_leaves_no_half_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    real = os.replace

    def full(source: Any, target: Any) -> None:
        if str(target).endswith("shape.csv"):
            raise OSError(errno.ENOSPC, "No space left on device")
        real(source, target)

    monkeypatch.setattr(atomic.os, "replace", full)
    with pytest.raises(OutputError, match="No space left on device"):
        write_run(trajectory(), tmp_path, plots=False)
    assert os.listdir(tmp_path) == ["trajectory.csv"]  # whole, and no summary that calls it a run


def test_an_interrupted_write_vanishes(tmp_path: Path) -> None:
    def interrupted() -> None:
        with atomic.replaced(tmp_path / "x.csv") as file:
            file.write(b"half")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    assert not os.listdir(tmp_path)


def cut(found: Trajectory, count: int, **changes: Any) -> Trajectory:
    """The first times of a run."""
    arrays = {name: values[:count] for name, values in found.arrays.items()}
    return replace(found, arrays=arrays, **changes)


@pytest.mark.parametrize("count", [1, 2, 401])
def test_short_and_failed_runs_are_drawn(tmp_path: Path, count: int) -> None:
    notice = Notice("test", "a warning", "here", 1.0)
    found = cut(trajectory(), count, status="failed", failure="it broke", warnings=(notice,))
    write_run(found, tmp_path)
    assert json.loads((tmp_path / "summary.json").read_text())["failure"] == "it broke"


@pytest.mark.parametrize("bellows", [2, 128])
def test_few_and_many_bellows_are_drawn(tmp_path: Path, bellows: int) -> None:
    found = trajectory(
        f"bellows.count={bellows}",
        "input={kind: sine, amplitude: 5 kPa, frequency: 1 Hz}",
        "run={duration: 1 s}",
        "actuator.length=0.3 m",
    )
    assert len(write_run(found, tmp_path)) == len(ALL)


def test_a_still_actuator_is_drawn(tmp_path: Path) -> None:
    found = trajectory("input={kind: constant, value: 0}", "run={duration: 1 s}")
    assert len(write_run(found, tmp_path)) == len(ALL)


def test_instants_are_few_where_little_moves_and_spread_where_much_does() -> None:
    still = trajectory("input={kind: constant, value: 0}", "run={duration: 1 s}")
    assert list(spread_instants(still, 8)) == [0]
    chosen = spread_instants(trajectory(), 8)
    assert len(chosen) == 8
    assert list(chosen) == sorted(set(chosen))


def test_right_is_x_where_the_axis_hangs() -> None:
    axis = np.column_stack((np.zeros(5), np.linspace(0, 1, 5)))
    assert normals(axis) == pytest.approx(np.tile([1.0, 0.0], (5, 1)))
    assert outline(axis, 0.2)[:, 0] == pytest.approx([0.1] * 5 + [-0.1] * 5)


@pytest.fixture(scope="module")
def plane() -> list[Classification]:
    """Every config, and a scene far outside of them all."""
    found = [classify(load(p)) for p in ACTUATOR_SPECS]
    found.append(
        classify(
            leg("input={kind: step, value: 1}", "fluid={name: x, viscosity: 1e-15, density: 1}")
        )
    )
    return found


@pytest.mark.parametrize("ending", ["png", "pdf", "svg"])
def test_the_plane_is_drawn(plane: list[Classification], tmp_path: Path, ending: str) -> None:
    draw_plane(plane, tmp_path / f"plane.{ending}")
    assert (tmp_path / f"plane.{ending}").stat().st_size > 1000
