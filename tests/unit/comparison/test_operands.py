"""What can be compared, what cannot, and what an interrupt leaves."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.scenes import CONFIGS
from tests.trajectories import made_run
from viscodesign import ComparisonInterruptedError, compare, load
from viscodesign.comparison import simulated_operands
from viscodesign.errors import UsageError
from viscodesign.results.trajectory import RunInterruptedError, Trajectory

SHORT = ("run.duration=0.2 s", "run.output_interval=20 ms", "accuracy=5 %")


@pytest.fixture(scope="session")
def short_runs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folder with the runs of two short scenes, `leg_4_air` and `leg_4_water`."""
    folder = tmp_path_factory.mktemp("compared")
    found = compare(*_specs(), overrides=SHORT, folder=folder)
    assert not found.notes
    return folder


def _specs() -> list[Path]:
    return [CONFIGS / f"leg_4_{fluid}.yaml" for fluid in ("air", "water")]


def test_a_run_its_spec_and_its_table_are_one_motion(short_runs: Path) -> None:
    folder = short_runs / "leg_4_air"
    run = Trajectory.read(folder)
    found = compare(run, folder, folder / "trajectory.csv", folder / "spec.yaml")
    assert [m.origin for m in found.motions] == ["run", "run", "table", "spec"]
    assert [d.max_m for d in found.differences] == [0.0] * 3
    assert found.motions[0].stated_error_m == run.accuracy.estimated_tip_error_m
    assert found.motions[2].stated_error_m is None
    known, tabled = (dict(m.metrics) for m in found.motions[1:3])
    assert np.isfinite(known.pop("column_lag_s"))
    assert np.isnan(tabled.pop("column_lag_s"))
    assert known == tabled


def test_runs_that_are_there_are_read(short_runs: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: Any, **__: Any) -> None:
        raise AssertionError("it was simulated again")

    monkeypatch.setattr(simulated_operands, "simulate", fail)
    found = compare(*_specs(), overrides=SHORT, folder=short_runs)
    assert len(found.notes) == 2
    with pytest.raises(AssertionError):  # another scene of the same name
        compare(*_specs(), overrides=[*SHORT, "run.duration=0.1 s"], folder=short_runs)


def test_an_interrupt_keeps_what_was_done(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    part = replace(made_run(time=np.linspace(0, 1, 51)), name="leg_4_water", status="interrupted")

    def stopped(scene: Any, **_: Any) -> Trajectory:
        if scene.name == "leg_4_air":
            return replace(made_run(), name="leg_4_air")
        raise RunInterruptedError(part)

    monkeypatch.setattr(simulated_operands, "simulate", stopped)
    rest = load(CONFIGS / "leg.yaml")
    with pytest.raises(ComparisonInterruptedError) as caught:
        compare(*_specs(), rest, folder=tmp_path)
    found = caught.value.comparison
    assert found is not None
    assert [m.title for m in found.motions] == ["leg_4_air", "leg_4_water (interrupted at 1 s)"]
    assert found.missing == (f"{_specs()[1]} after 1 s", rest.name)
    assert {file.parent.name for file in tmp_path.glob("*/summary.json")} == {
        "leg_4_air", "leg_4_water",
    }  # fmt: skip


def test_a_failed_run_is_labelled_and_one_without_motion_refused() -> None:
    failed = replace(made_run(time=np.linspace(0, 1, 51)), status="failed", failure="no step")
    found = compare(made_run(), failed)
    assert (
        "leg_made_up 2 (failed at 1 s) differs from leg_made_up 1" in found.differences[0].sentence
    )
    assert "the part of time that both have" in found.differences[0].sentence
    assert found.document()["motions"][1]["failure"] == "no step"
    blank = failed.with_arrays(**{name: v[:0] for name, v in failed.arrays.items()})
    with pytest.raises(UsageError, match="failed before its first output time: no step"):
        compare(made_run(), blank)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("x_m,z_m\n0,0\n1,1\n", "time_s,tip_x_m,tip_z_m"),
        ("time_s,tip_x_m\n0,0\n1,1\n", "time_s,tip_x_m,tip_z_m"),
        ("time,tip_x_m,tip_z_m\n0,0,0\n1,1,1\n", "did you mean 'time_s'"),
        ("time_s,tip_x_m,tip_z_m\n0,0,0\n1,1,1\n1,2,2\n", "line 4: times must increase"),
        ("time_s,tip_x_m,tip_z_m\n0,0,0\n", "from 2 to"),
        ("time_s,tip_x_m,tip_z_m\n0,0,0\n1,a,1\n", "line 3"),
    ],
)
def test_a_bad_table_gives_one_message(tmp_path: Path, text: str, words: str) -> None:
    table = tmp_path / "camera.csv"
    table.write_text(text)
    with pytest.raises(UsageError) as caught:
        compare(made_run(), table)
    message = str(caught.value)
    assert words in message
    assert "camera.csv" in message
    assert "columns:" not in message
    assert "\n" not in message


def test_units_of_a_table_are_read(tmp_path: Path) -> None:
    table = tmp_path / "camera.csv"
    table.write_text("Time [ms];x [mm];z [cm]\n0;1,5;10,9\n500;2,5;10,8\n")
    found = compare(made_run(), table).motions[1]
    np.testing.assert_allclose(found.time, [0, 0.5])
    np.testing.assert_allclose(found.tip, [[1.5e-3, 0.109], [2.5e-3, 0.108]])


def test_rows_without_a_position_are_left_out_and_it_is_said(tmp_path: Path) -> None:
    table, run = tmp_path / "camera.csv", made_run()
    rows = [
        f"{float(t)},{float(x)},{float(z)}"
        for t, (x, z) in zip(run.time, run.tip[:, :2], strict=True)
    ]
    rows[7], rows[8] = f"{run.time[7]},,{run.tip[7, 1]}", f"{run.time[8]},nan,nan"
    table.write_text("\n".join(["time_s,tip_x_m,tip_z_m", *rows]))
    found = compare(run, table)
    assert len(found.motions[1].time) == 399
    assert found.notes == (
        "camera: 2 of 401 rows lack x or z and are left out; it is interpolated over up to 0.06 s",
    )
    assert 0 < found.differences[0].max_m < found.differences[0].interpolation_m


def test_what_cannot_be_compared(tmp_path: Path, short_runs: Path) -> None:
    run = short_runs / "leg_4_air"
    cases: list[tuple[list[Any], str]] = [
        ([], "expected two or more motions to compare, got nothing"),
        ([run], "got only"),
        ([run, run], "is given twice"),
        ([run, tmp_path], "there is no summary.json"),
        ([run, short_runs / "leg_4_ai"], "did you mean"),
        ([run, run / "summary.json"], "is none that can be compared"),
    ]
    for operands, words in cases:
        with pytest.raises(UsageError, match=words):
            compare(*operands)
