"""Recordings: what their headers mean, gaps, and every fault with its place."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.recordings import small_scene
from viscodesign.calibration.recorded_columns import Measured
from viscodesign.calibration.recording import read_recording, split_source
from viscodesign.errors import SpecError

HEADER = "time_s,inlet_pressure_pa,m1_x_m,m1_z_m"


def rows(count: int = 12) -> list[str]:
    return [f"{k / 10},{100 * k},{0.001 * k},{0.03 + 0.0001 * k}" for k in range(count)]


def file(path: Path, header: str = HEADER, body: list[str] | None = None) -> Path:
    path.write_text("\n".join([header, *(rows() if body is None else body), ""]))
    return path


def test_units_and_words_of_headers(tmp_path: Path) -> None:
    header = "Time [ms],inlet pressure (kPa abs),tip_x_mm,syringe_volume_mL,note"
    body = [f"{100 * k},{101.325 + k},{k},{2 * k},7" for k in range(12)]
    found = read_recording(file(tmp_path / "a.csv", header, body), small_scene())
    assert found.time == pytest.approx(np.arange(12) / 10)
    pressure, tip, volume = found.channels
    assert pressure.values == pytest.approx(1e3 * np.arange(12), abs=1e-6)
    assert (tip.output, tip.values[3]) == ("tip_x_m", pytest.approx(0.003))
    assert (volume.output, volume.measured) == ("inflow_m3", Measured.VOLUME)
    assert volume.values[2] == pytest.approx(4e-6)
    assert found.notices == ("columns that mean nothing to a fit are ignored: note",)


def test_empty_cells_and_nan_are_gaps(tmp_path: Path) -> None:
    body = rows()
    body[3] = "0.3,300,,0.03"
    body[4] = "0.4,400,NaN,0.03"
    found = read_recording(file(tmp_path / "a.csv", body=body), small_scene())
    assert np.flatnonzero(np.isnan(found.channels[1].values)).tolist() == [3, 4]
    assert found.notices == ("missing samples are left out: m1_x_m 2",)


def test_keys_behind_the_name_of_a_file() -> None:
    assert split_source("a.csv@loads.payload=200 g@fluid=water") == (
        "a.csv",
        ("loads.payload=200 g", "fluid=water"),
    )
    with pytest.raises(SpecError, match=r"expected KEY=VALUE behind '@'.*got 'payload'"):
        split_source("a.csv@payload")


@pytest.mark.parametrize(
    ("header", "changes", "message"),
    [
        (
            "time_s,m1_x,m1_z_m",
            {},
            r"a\.csv:1: column 'm1_x' has no unit.*write it after the name, such as 'm1_x_m'",
        ),
        ("m1_x_m,m1_z_m", {}, "no time_s among its columns; expected time_s with m1_x_m"),
        ("time_s,m3_x_m", {}, "the actuator has 2 sections, so that its markers are m1"),
        ("time_s,inlet_pressure_pa", {}, "nothing to compare with a motion; expected"),
        ("time_s,tip_x_m,tip_x_mm", {}, "'tip_x_m', 'tip_x_mm' are the same quantity"),
        (HEADER, {5: "0.3,500,0.005,0.03"}, r"a\.csv:7: time goes from 0\.4 s to 0\.3 s"),
        (HEADER, {5: ",500,0.005,0.03"}, "line 7: time_s is empty"),
        (HEADER, {5: "nan,500,0.005,0.03"}, "line 7: time_s is nan, not finite"),
        (HEADER, {5: "0.5,500,oops,0.03"}, "line 7: m1_x_m is 'oops', not a number"),
        (HEADER, {5: "0.5,500,inf,0.03"}, "line 7: m1_x_m is inf, not finite"),
    ],
)
def test_faults(tmp_path: Path, header: str, changes: dict[int, str], message: str) -> None:
    width = header.count(",") + 1
    body = [",".join(row.split(",")[:width]) for row in rows()]
    for k, row in changes.items():
        body[k] = row
    with pytest.raises(SpecError, match=message):
        read_recording(file(tmp_path / "a.csv", header, body), small_scene())


def test_markers_that_never_move_and_columns_without_values(tmp_path: Path) -> None:
    still = [f"{k / 10},{100 * k},0.001,0.03" for k in range(12)]
    with pytest.raises(SpecError, match=r"marker m1 never moves.*Remove m1_x_m and m1_z_m"):
        read_recording(file(tmp_path / "a.csv", body=still), small_scene())
    gone = [f"{k / 10},{100 * k},,{0.03 + 0.001 * k}" for k in range(12)]
    with pytest.raises(SpecError, match="column 'm1_x_m' has 0 values, the rest is missing"):
        read_recording(file(tmp_path / "a.csv", body=gone), small_scene())


def test_files_that_are_none(tmp_path: Path) -> None:
    (tmp_path / "empty.csv").write_text("")
    with pytest.raises(SpecError, match=r"empty\.csv:1: is empty"):
        read_recording(tmp_path / "empty.csv", small_scene())
    with pytest.raises(SpecError, match="cannot be read"):
        read_recording(tmp_path / "none.csv", small_scene())
    with pytest.raises(SpecError, match="has 3 rows; a fit needs 10"):
        read_recording(file(tmp_path / "short.csv", body=rows(3)), small_scene())


def test_millimetres_that_are_called_metres_are_refused(tmp_path: Path) -> None:
    body = [f"{k / 10},{100 * k},{k},{28 + 0.1 * k}" for k in range(12)]
    with pytest.raises(
        SpecError, match=r"m1_x_m, m1_z_m: .* times the actuator's length"
    ) as caught:
        read_recording(file(tmp_path / "a.csv", body=body), small_scene())
    assert len(caught.value.faults) == 1
    header = HEADER.replace("_x_m", "_x_mm").replace("_z_m", "_z_mm")
    assert read_recording(file(tmp_path / "b.csv", header, body), small_scene()).channels
