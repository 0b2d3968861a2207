"""A quantity is one row: its columns, frames, labels and its line on the page follow."""

from __future__ import annotations

import base64
import csv
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.scenes import CONFIGS, ROOT, leg
from tests.trajectories import made_run, with_two_inlets
from viscodesign import load_several, simulate, simulate_several
from viscodesign.postprocess import motion
from viscodesign.postprocess.outputs import Outputs
from viscodesign.report.page.page_data import page_data
from viscodesign.report.run_folder import write_run
from viscodesign.results import channels
from viscodesign.results.channels import (
    CHANNELS,
    SHAPE,
    TRAJECTORY,
    Channel,
    Per,
    Rows,
    channel,
    channel_table,
    shape_columns,
    trajectory_columns,
)
from viscodesign.results.trajectory import Trajectory


def test_columns_of_a_run() -> None:
    run = made_run()
    names, values = trajectory_columns(run)
    assert names[:5] == ["time_s", "tip_x_m", "tip_z_m", "tip_angle_rad", "inlet_pressure_pa"]
    assert names[5] == "pressure_R1_pa"
    assert names[13] == "pressure_L1_pa"
    assert names[21] == "flow_inlet-R1_m3_s"
    assert len(names) == 5 + 2 * 16
    assert values.shape == (401, len(names))
    assert np.array_equal(values[:, 13], run.pressure[:, 8])


def test_several_inlets_are_named() -> None:
    names, _ = trajectory_columns(with_two_inlets(made_run(), -1.0))
    assert names[4:6] == ["inlet_pressure_left_pa", "inlet_pressure_right_pa"]


def test_shape_is_one_row_for_each_time_and_point() -> None:
    run = made_run()
    names, values = shape_columns(run)
    assert names == ["time_s", "arc_m", "x_m", "z_m"]
    points = len(run.arc)
    assert values.shape == (401 * points, 4)
    assert np.array_equal(values[points : 2 * points, 1], run.arc)
    assert np.array_equal(values[-1, 2:], run.shape[-1, -1])


def test_frames_are_the_tables() -> None:
    run = made_run()
    assert list(run.frame().columns) == trajectory_columns(run)[0]
    assert len(run.shape_frame()) == 401 * len(run.arc)


def add(monkeypatch: pytest.MonkeyPatch, *rows: Channel) -> None:
    """Rows at the end of the table, as somebody would write them there."""
    monkeypatch.setattr(channels, "CHANNELS", (*CHANNELS, *rows))


def header(file: Path) -> list[str]:
    with file.open(newline="") as opened:
        return next(csv.reader(opened))


def speed(trajectory: Trajectory, rows: Rows) -> np.ndarray:
    """Speed of the tip (n,) [m/s]."""
    rates = np.gradient(trajectory.tip[:, :2], trajectory.time, axis=0)
    return np.hypot(*rates.T)[rows]


def test_what_follows_from_other_quantities_is_one_row(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    row = Channel("tip_speed", "m/s", "speed of the tip", "speed", tables=(TRAJECTORY,), read=speed)
    add(monkeypatch, row)
    run = made_run()
    assert run.frame()["tip_speed_m_s"].to_numpy() == pytest.approx(speed(run, slice(None)))
    assert run.frame("time", "tip_speed").shape == (401, 2)
    write_run(run, tmp_path, plots=False)
    assert header(tmp_path / TRAJECTORY)[-1] == "tip_speed_m_s"
    assert ("`tip_speed_m_s`", "speed", "m/s", TRAJECTORY) in channel_table()


def test_a_plotted_quantity_has_its_panel_on_the_page(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Of the run or of several members, in the unit of pictures; also of a run that is read."""
    mean = Channel("tip_speed", "m/s", "speed of the tip", "speed", tables=(TRAJECTORY,),
                   read=speed, plotted=True)  # fmt: skip
    add(monkeypatch, mean, replace(channel("pressure"), plotted=True))
    run = made_run(spec_text=(CONFIGS / "leg_16_straight_air.yaml").read_text(encoding="utf-8"))
    found = {own["title"]: own for own in page_data(run)["quantities"]}
    assert list(found) == ["speed of the tip", "pressure"]
    assert found["speed of the tip"]["names"] == ["speed of the tip"]
    assert found["speed of the tip"]["unit"] == "m/s"
    assert found["pressure"]["names"] == list(run.bellows)
    assert found["pressure"]["unit"] == "kPa gauge"
    packed = found["pressure"]["values"]
    values = np.frombuffer(base64.b64decode(packed["bytes"]), "<f4").reshape(packed["shape"])
    assert values == pytest.approx(run.pressure / 1e3, rel=1e-6, abs=1e-6)
    write_run(run, tmp_path, plots=False)
    again = Trajectory.read(tmp_path)
    assert [own["title"] for own in page_data(again)["quantities"]] == list(found)


def test_what_the_page_plots_is_in_the_table_that_it_is_made_of() -> None:
    assert all(TRAJECTORY in row.tables for row in CHANNELS if row.plotted)
    assert page_data(made_run())["quantities"] == []  # nothing touches


def test_a_quantity_of_the_solution_is_a_row_and_where_it_is_computed(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Two files: results/channels.py and postprocess/motion.py."""
    row = Channel("density", "kg/m^3", "density", "rho", Per.BELLOW, tables=(TRAJECTORY,))
    add(monkeypatch, row)
    quantities = motion._quantities

    def more(outputs: Outputs) -> dict[str, np.ndarray]:
        return {**quantities(outputs), "density": 1.2 + 1e-5 * outputs["pressure"]}

    monkeypatch.setattr(motion, "_quantities", more)
    run = simulate(leg("run.duration=0.1 s", "bellows.count=4"), verify=False)
    names = [f"density_{bellow}_kg_m3" for bellow in ("R1", "R2", "L1", "L2")]
    assert list(run.frame("density").columns) == names
    assert run.frame()[names[0]].to_numpy() == pytest.approx(1.2 + 1e-5 * run.pressure[:, 0])
    write_run(run, tmp_path, plots=False)
    assert header(tmp_path / TRAJECTORY)[-4:] == names
    assert np.array_equal(Trajectory.read(tmp_path)["density"], run["density"])
    assert ("`density_<bellow>_kg_m3`", "rho", "kg/m^3", TRAJECTORY) in channel_table()


def test_each_of_actuators_that_share_fluid_has_its_part_of_a_new_quantity(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    add(monkeypatch, Channel("section_moment", "N*m", "moment", "moment", Per.SECTION))
    quantities = motion._quantities

    def more(outputs: Outputs) -> dict[str, np.ndarray]:
        return {**quantities(outputs), "section_moment": outputs["moment"]}

    monkeypatch.setattr(motion, "_quantities", more)
    spec = load_several(CONFIGS / "two_legs.yaml", ["run.duration=0.1 s", "effects={others: off}"])
    runs = simulate_several(spec, verify=False).runs
    assert [runs[name]["section_moment"].shape[1] for name in ("long", "short")] == [8, 6]
    assert list(runs["short"].frame("section_moment").columns)[-1] == "section_moment_6_n_m"


def test_a_quantity_along_the_axis_is_a_row_of_the_shapes(monkeypatch: pytest.MonkeyPatch) -> None:
    add(monkeypatch, Channel("strain", "1", "strain", "strain", Per.ARC, tables=(SHAPE,)))
    run = made_run()
    found = run.with_arrays(strain=np.zeros(run.shape.shape[:2]))
    assert list(found.shape_frame().columns) == ["time_s", "arc_m", "x_m", "z_m", "strain"]


def test_every_quantity_of_a_solved_run_has_its_frame() -> None:
    run = simulate(leg("run.duration=0.1 s", "bellows.count=4"), verify=False)
    assert set(run.arrays) == {"tip", "shape"} | {
        row.quantity for row in CHANNELS if row.read is None
    }
    for row in CHANNELS:
        if row.per is not Per.ARC:
            assert len(run.frame(row.quantity)) == len(run.time), row.quantity
    assert list(run.frame("inflow").columns) == ["inflow_m3"]


def test_quantities_are_unique_and_pressures_say_what_they_are_relative_to() -> None:
    assert len({row.quantity for row in CHANNELS}) == len(CHANNELS)
    assert all((row.unit == "Pa") == (row.reference is not None) for row in CHANNELS)
    assert channel("pressure").label == "gauge pressure [kPa]"
    assert channel("x").label == "x [mm]"


def test_the_page_lists_every_quantity() -> None:
    page = (ROOT / "docs" / "quantities.md").read_text(encoding="utf-8")
    for line in channel_table():
        assert f"| {' | '.join(line)} |" in page
