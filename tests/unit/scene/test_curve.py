"""`bellows.curve`: measured laws, from rows and from files."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.scenes import CONFIGS, leg
from tests.unit.scene.round_trip import comes_back
from viscodesign import load
from viscodesign.errors import SpecError
from viscodesign.scene.bellow_curve import CURVE_COLUMNS, MAX_CURVE_ROWS

GOOD = (CONFIGS / "leg_16_straight_air.yaml").read_text()
ROWS = "[[-20 kPa, -50 mm^2, -0.1, -0.3 mm], [0, 0, 0, 0], [30 kPa, 200 mm^2, 0.3, 2 mm]]"
IN_SI = ((-2e4, -5e-5, -0.1, -3e-4), (0.0, 0.0, 0.0, 0.0), (3e4, 2e-4, 0.3, 2e-3))
HEADER = ",".join(column.header for column in CURVE_COLUMNS)


def from_file(tmp_path: Path, table: str) -> Path:
    (tmp_path / "curve.csv").write_text(table)
    file = tmp_path / "leg.yaml"
    place = "  count: 16 "
    assert GOOD.count(place) == 1
    file.write_text(GOOD.replace(place, f"  curve: {{file: curve.csv}}\n{place}"))
    return file


def message(rows: str) -> str:
    with pytest.raises(SpecError) as caught:
        leg(f"bellows.curve={rows}")
    return str(caught.value)


def test_rows_are_read_in_their_units() -> None:
    curve = leg(f"bellows.curve={{rows: {ROWS}}}").bellows.curve
    assert curve is not None
    assert [pytest.approx(row) for row in IN_SI] == list(curve.rows or ())


def test_a_file_gives_the_same_as_its_rows(tmp_path: Path) -> None:
    lines = "\n".join(",".join(map(repr, row)) for row in IN_SI)
    scene = load(from_file(tmp_path, f"{HEADER}\n{lines}\n"))
    assert scene.bellows.curve is not None
    assert scene.bellows.curve.rows == IN_SI
    assert "curve.csv" not in comes_back(scene)


def test_a_curve_survives_a_round_trip() -> None:
    assert "curve:" in comes_back(leg(f"bellows.curve={{rows: {ROWS}}}"))
    assert "curve:" not in comes_back(leg())


def many(count: int) -> str:
    rows = ", ".join(f"[{k - 1}, {k * 1e-6}, 0, 0]" for k in range(count))
    return f"{{rows: [{rows}]}}"


@pytest.mark.parametrize(
    ("curve", "words"),
    [
        ("{rows: [[0, 0, 0, 0], [0, 1e-4, 0, 0]]}", "bellows.curve.rows.1: row 2: the pressure 0 Pa is that of the row before"),
        ("{rows: [[-1, 0, 0, 0], [3, 1e-4, 0, 0], [2, 2e-4, 0, 0]]}", "the pressure must increase with the area at both ends"),
        ("{rows: [[-1, 0, 0, 0], [0, 1e-4, 0, 0], [1, 1e-4, 0, 0]]}", "row 3: the area must increase from row to row"),
        ("{rows: [[-1, 0, 0, 0], [1, -1e-4, 0, 0]]}", "row 2: the area must increase from row to row"),
        ("{rows: [[-1, 0, 0, 0], [-2, 1e-4, 0, 0], [3, 2e-4, 0, 0]]}", "the pressure must increase with the area at both ends"),
        ("{rows: [[-2, 0, 0, 0], [-1, 1e-4, 0, 0], [-2, 2e-4, 0, 0], [5, 3e-4, 0, 0]]}", "the first rising part must include zero gauge pressure"),
        ("{rows: [[-2, 0, 0, 0], [2, 1e-4, 0, 0], [1, 1.00001e-4, 0, 0], [5, 3e-4, 0, 0]]}", "rows 2 and 3 are closer than 3e-08 m2"),
        ("{rows: [[1, 0, 0, 0], [2, 1e-4, 0, 0]]}", "bellows.curve.rows: the first rising part must include zero gauge pressure"),
        ("{rows: [[-2, 0, 0, 0], [-1, 1e-4, 0, 0]]}", "the first rising part must include zero gauge pressure"),
        ("{rows: [[0, 0, 0, 0]]}", "must have from 2 to 50000 rows; got 1"),
        ("{rows: []}", "must have from 2 to 50000 rows; got 0"),
        (many(MAX_CURVE_ROWS + 1), f"{MAX_CURVE_ROWS + 1} rows; at most {MAX_CURVE_ROWS} are allowed"),
        ("{rows: [[0, 0, 0], [1, 1, 0]]}", "bellows.curve.rows.0"),
        ("{rows: [[0, 0, 0, 1 kPa], [1, 1e-4, 0, 0]]}", "expected a length"),
        ("{}", "a curve needs exactly one of 'file' and 'rows'"),
        ("{file: a.csv, rows: [[0, 0, 0, 0], [1, 1, 0, 0]]}", "a curve needs exactly one of 'file' and 'rows'"),
        ("{file: nowhere.csv}", "nowhere.csv cannot be read"),
        ("3", "bellows.curve"),
    ],
)  # fmt: skip
def test_faults_of_rows(curve: str, words: str) -> None:
    assert words in message(curve)


@pytest.mark.parametrize("count", [2, MAX_CURVE_ROWS])
def test_the_maximum_number_of_rows_is_accepted(count: int) -> None:
    found = leg(f"bellows.curve={many(count)}").bellows.curve
    assert found is not None
    assert len(found.rows or ()) == count


def test_zero_may_be_the_first_or_the_last_row() -> None:
    assert leg("bellows.curve={rows: [[0, 0, 0, 0], [1, 1e-4, 0, 0]]}").bellows.curve
    assert leg("bellows.curve={rows: [[-1, 0, 0, 0], [0, 1e-4, 0, 0]]}").bellows.curve


@pytest.mark.parametrize(
    ("table", "words"),
    [
        (f"{HEADER}\n-1,0,0,0\n\n0,1e-4,0,0\n0,2e-4,0,0\n", "curve.csv, line 5: the pressure 0 Pa is that of the row before"),
        (f"{HEADER}\n-1,0,0,0\n0,1e-4,0\n", "curve.csv, line 3: expected 4 values, got 3"),
        (f"{HEADER}\n-1,0,0,0\n0,x,0,0\n", "line 3: area_m2 is 'x', not a number"),
        (f"{HEADER}\n-1,0,0,0\n0,1e-4,,0\n", "line 3: angle_rad is empty"),
        (f"{HEADER}\n-1,0,0,0\n0,inf,0,0\n", "line 3: area_m2 is inf, not finite"),
        ("pressure_pa,area_m2,angle,extension_m\n0,0,0,0\n", "did you mean 'angle_rad'"),
        ("time_s,pressure_pa\n0,0\n1,1\n", f"expected '{HEADER}', got 'time_s,pressure_pa'"),
        (f"{HEADER}\n0,0,0,0\n", "must have from 2 to 50000 rows; got 1"),
        (f"{HEADER}\n-1,1e-4,0,0\n1,0,0,0\n", "row 2: the area must increase from row to row"),
        (f"{HEADER}\n1,1e-4,0,0\n2,2e-4,0,0\n", "the first rising part must include zero gauge pressure"),
    ],
)  # fmt: skip
def test_faults_of_files_name_the_line(tmp_path: Path, table: str, words: str) -> None:
    with pytest.raises(SpecError) as caught:
        load(from_file(tmp_path, table))
    assert words in str(caught.value)
    assert "leg.yaml:" in str(caught.value)
