"""Tables as labs have them: delimiters, decimal commas, comments, units, columns."""

from __future__ import annotations

import re
import time as clock
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.unit.scene.tables.written import refusal, scene_of, table
from viscodesign import load
from viscodesign.scene.inputs.table import PRESSURE, TIME
from viscodesign.scene.reading.write import resolved_yaml
from viscodesign.scene.scene import Scene
from viscodesign.scene.table_file import table_of_file, time_faults

ROWS = ((0.0, 0.0), (1.5, 2500.0), (4.0, -1250.0))
ANY = settings(
    max_examples=80, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
TIME_UNITS = {"s": 1.0, "ms": 1e-3, "min": 60.0}
PRESSURE_UNITS = {"Pa": 1.0, "kPa": 1e3, "mbar": 100.0, "bar": 1e5, "hPa": 100.0, "MPa": 1e6}
FORMS: dict[str, Callable[[str, str], str]] = {
    "brackets": lambda name, unit: f"{name} [{unit}]",
    "parentheses": lambda name, unit: f"{name}({unit})",
    "slash": lambda name, unit: f"{name} / {unit}",
    "underscore": lambda name, unit: f"{name}_{unit}",
}


@given(data=st.data())
@ANY
def test_every_spelling_of_a_table_gives_the_same_rows(tmp_path: Path, data: st.DataObject) -> None:
    delimiter = data.draw(st.sampled_from([",", ";", "\t", "|", " "]))
    forms = ["underscore"] if delimiter == " " else list(FORMS)
    head = FORMS[data.draw(st.sampled_from(forms))]
    comma = delimiter != "," and data.draw(st.booleans())
    own_time = data.draw(st.sampled_from(sorted(TIME_UNITS)))
    own_pressure = data.draw(st.sampled_from(sorted(PRESSURE_UNITS)))
    names = data.draw(st.permutations(["time", "pressure", "valve", "p2"]))
    name = {
        "time": head(data.draw(st.sampled_from(["time", "Time", "t"])), own_time),
        "pressure": head(data.draw(st.sampled_from(["pressure", "P", "Druck"])), own_pressure),
        "valve": "valve",
        "p2": head("temperature", "degC"),
    }
    lines = [delimiter.join(name[key] for key in names)]
    for t, p in ROWS:
        cells = {
            "time": f"{t / TIME_UNITS[own_time]:.8f}",
            "pressure": f"{p / PRESSURE_UNITS[own_pressure]:.8f}",
            "valve": "1",
            "p2": "21.25",
        }
        line = delimiter.join(cells[key] for key in names)
        lines.append(line.replace(".", ",") if comma else line)
    sign = data.draw(st.sampled_from(["", "# made by a logger", "% 12.5, 3"]))
    end = data.draw(st.sampled_from(["\n", "\r\n", "\r"]))
    text = end.join([sign, *lines[:2], *([sign] if sign else []), "", *lines[2:], ""])
    mark = data.draw(st.sampled_from([b"", b"\xef\xbb\xbf"]))
    rows = np.array(table(tmp_path, mark + text.encode()).rows)
    assert rows == pytest.approx(np.array(ROWS), rel=1e-6, abs=1e-6)


PREAMBLES = {
    "a spreadsheet": "sep=;\ntime_s;pressure_kPa\n",
    "units below": "Time;Pressure;Valve\ns;kPa;-\n",
    "bracketed units below": "Time;Pressure;Valve\n[s];[kPa];\n",
    "an oscilloscope": "Model;TDS2024\nFirmware;1.2\nInterval;0.1;s\n\nTIME;CH1;CH2\ns;kPa;-\n",
    "LabVIEW": "LabVIEW Measurement\nWriter_Version;2\n***End***\n\nX (s);P (kPa);Comment\n",
}


@pytest.mark.parametrize("above", PREAMBLES)
def test_what_instruments_write_above_a_table_is_passed_over(tmp_path: Path, above: str) -> None:
    rows = "".join(f"{t};{p / 1e3};1\n" for t, p in ROWS)
    if above == "a spreadsheet":
        rows = rows.replace(";1\n", "\n")
    found = table(tmp_path, (PREAMBLES[above] + rows).encode())
    assert np.array(found.rows) == pytest.approx(np.array(ROWS))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("time_s,pressure_pa\nfoo,1\n1,2\n2,3\n", "line 2: time_s is 'foo', not a number"),
        ("time,pressure\nfoo,1\n1,2\n2,3\n", "line 1.*'time' has no unit"),
        ("log of today\nby me\ntime,pressure\n1,2\n2,3\n", "line 3.*'time' has no unit"),
    ],
)
def test_a_header_that_is_one_is_not_passed_over(tmp_path: Path, text: str, words: str) -> None:
    assert re.search(words, refusal(tmp_path, text.encode()))


@pytest.mark.parametrize(
    ("text", "keys"),
    [
        ("time_s pressure_pa\n0   0\n1\t5e3\n", {}),
        ("# time_s pressure_pa\n0 0\n1 5000\n", {}),  # as numpy.savetxt writes it
        ("\nTime [ms]  p (kPa)\n0 0\n1000 5\n", {}),
        ('"time, s";"p, kPa"\n"0";"0"\n"1";"5,0"\n', {}),
        ("time_s;pressure_kPa;\n0;0;\n1;5,00;\n", {}),
        ("Zeit;Druck;Ventil\n0;0;zu\n1,0;5;auf\n",
         {"columns": "{time: {column: Zeit, unit: s}, pressure: {column: Druck, unit: kPa}}"}),
        ("t\tp1 [kPa]\tp2 [kPa]\n0\t9\t0\n1\t9\t5\n", {"columns": "{time: t, pressure: p2}"}),
        ("0,0\n1,5000\n", {"columns": "{time: 1, pressure: 2}"}),
        ("0,5;0\n1,5;5\n", {"columns": "{time: 1, pressure: {column: 2, unit: kPa}}"}),
        ("0 0\n1 0,5e1\n", {"columns": "{time: 1, pressure: {column: 2, unit: kPa}}"}),
        ("time_s;p [Pa]\n0;0\n1;5,000e3\n", {"decimal": "comma"}),
        ("time_s;p [kPa]\n0;0\n1;5,000\n", {"decimal": "comma"}),
        ("datum;time_s;p [kPa]\n1.2.24;0;0\n1.2.24;1;5,00\n", {}),
        ("time_s,dt_ms,flow_m3_s,p [kPa]\n0,1,0,0\n1,1,0,5\n", {}),
        ("Time (µs),p [kPa]\n0,0\n1e6,5\n", {}),
        ("time_s,p,p_set\n0,0,1\n1,5,1\n", {"columns": "{pressure: {column: p, unit: kPa}}"}),
        ("time_s,p\n0,0\n1,5\n", {"columns": "{pressure: 'p [kPa]'}"}),
        ("TIME [MS],P [KPA]\n0,0\n1000,5\n", {}),
        ("time_s,p_in\n0,0\n1,5\n", {"columns": "{pressure: {column: p_in, unit: kPa}}"}),
        ("time_s,p (min)\n0,0\n1,5\n", {"columns": "{pressure: {column: 2, unit: kPa}}"}),
        ("time_s,p_kPa\n0,0\n1,5\n", {"columns": "{pressure: {column: p_kPa, unit: kPa}}"}),
    ],
)  # fmt: skip
def test_single_spellings(tmp_path: Path, text: str, keys: dict[str, str]) -> None:
    (start, low), (end, high) = table(tmp_path, text, **keys).rows or ()
    assert end == start + 1.0
    assert (low, high) == (0.0, pytest.approx(5e3, rel=1e-12))


def test_other_encodings(tmp_path: Path) -> None:
    for encoding in ("utf-16", "cp1252"):
        text = "Zeit [µs];Druck [kPa]\n0;0\n1000000;5\n".encode(encoding)
        assert table(tmp_path, text).rows == ((0.0, 0.0), (1.0, 5e3))


@pytest.mark.parametrize(
    ("text", "keys", "words"),
    [
        ("time_s,p1 [kPa],p2 [kPa]\n0,1,2\n1,2,3\n", {}, "2 columns that may be the pressure: 'p1 [kPa]', 'p2 [kPa]'. Choose one, as in columns: {pressure: \"p1 [kPa]\"}"),
        ("t [s],t2 [s],p [kPa]\n0,1,2\n1,2,3\n", {"columns": "{pressure: q}"}, "no column 'q'"),
        ("t1 [s],t2 [s],p [kPa]\n0,1,2\n1,2,3\n", {}, "2 columns that may be the time"),
        ("time_s;p [kPa]\n0;1,234\n1;2,345\n", {}, "line 2: '1,234' may be 1.234 or 1234; write 'decimal: comma'"),
        ("time_s;p [kPa]\n0;1.5\n1;2,5\n", {}, "'2,5' has a comma, '1.5' a point"),
        ("time_s;p [Pa]\n0;1.234,5\n1;2,5\n", {}, "line 2: p [Pa] is '1.234,5', not a number"),
        ("time_s;p [Pa]\n0;1\n1;1,234\n", {"decimal": "point"}, "line 3: p [Pa] is '1,234', not a number"),
        ("time_s,p [kPa]\n0,0,0,5\n1,0,1,5\n", {}, "line 2: expected 2 values, got 4; a table with decimal commas needs semicolons"),
        ("time_s,p\n0,0\n1,1\n", {}, "'p' has no unit; did you mean 'p_pa'?"),
        ("time_s,pressure_mpa\n0,0\n1,1\n", {}, "'pressure_mpa' may be in MPa or in mPa"),
        ("0,0\n1,1\n", {}, "no header; name the columns in its first line, or write columns: {time: {column: 1, unit: s}"),
        ("time_s,p [kPa]\n0,0\n1,1_000\n", {}, "line 3: p [kPa] is '1_000', not a number"),
        ("time_s,p [kPa]\n0,0\n# note\n\n1,x\n", {}, "in.csv, line 5: p [kPa] is 'x'"),
        ("time_s,p [kPa]\n0,0\n12:03:05,1\n", {}, "time_s is '12:03:05', not a number"),
        ("time_s,p [kPa]\n0,0\n1,1\n", {"columns": "{pressure: 3}"}, "columns 1 to 2; got 3"),
        ("time_s,p [kPa]\n0,0\n1,1\n", {"columns": "{presure: 2}"}, "did you mean 'pressure'"),
        ("time_s,p [kPa]\n0,0\n1,1\n", {"columns": "{pressure: {column: p, unit: mm}}"}, "'1 mm' is a length"),
        ("time_s,p [kPa]\n0,0\n1,1\n", {"columns": "{pressure: {name: p}}"}, "{column: ..., unit: ...}"),
        ("time_s,p_kPa\n0,0\n1,1\n", {"columns": "{pressure: {column: p_kPa, unit: Pa}}"}, "its header 'p_kPa' has another unit than the stated 'Pa'"),
        ("time_s,p_kPa_abs\n0,0\n1,1\n", {"columns": "{pressure: {column: 2, unit: kPa gauge}}"}, "'p_kPa_abs' has another unit than the stated 'kPa gauge'"),
        ("time_s,p [kPa]\n0,0\n1,1\n", {"columns": "{time: 1, pressure: 1}"}, "pressure: its header 'time_s' says time, not pressure"),
        ("time_s,p [kPa]\n0,0\n1,1\n", {"columns": "{pressure: {column: time_s, unit: kPa}}"}, "'time_s' says time, not pressure"),
        ("time_s,x [mm]\n0,0\n1,1\n", {"columns": "{pressure: {column: 2, unit: kPa}}"}, "'x [mm]' says length, not pressure"),
        ("t,p\n0,0\n1,1\n", {"columns": "{time: 2, pressure: 2}"}, "time and pressure are both column 2, 'p'"),
        ("Time [Ms],p [kPa]\n0,0\n1,1\n", {}, "'Time [Ms]' is not in 'ms' as it is written; did you mean 'ms'?"),
        ("Time [mS],p [kPa]\n0,0\n1,1\n", {"columns": "{time: 1}"}, "did you mean 'ms'?"),
        ("time_s,p [Mbar]\n0,0\n1,1\n", {}, "did you mean 'mbar'?"),
        ("time_s,p [mpa]\n0,0\n1,1\n", {"columns": "{pressure: 2}"}, "may be in MPa or in mPa"),
        ("time_s,p [kPa]\n0,0\n1,1\n", {"decimal": "dot"}, "must be one of point, comma"),
        ("time_s,p [kPa]\n0,0\n1,1\n", {"smooth": "5"}, "a cut-off as a time or a frequency"),
    ],
)  # fmt: skip
def test_what_is_ambiguous_or_wrong_is_refused_with_what_to_write(
    tmp_path: Path, text: str, keys: dict[str, str], words: str
) -> None:
    message = refusal(tmp_path, text, **keys)
    assert words in message
    assert "leg.yaml" in message or "--set" in message


def test_keys_of_a_file_without_one_are_refused(tmp_path: Path) -> None:
    with pytest.raises(Exception, match="decimal: describes a file"):
        load_rows("decimal: comma")


def load_rows(keys: str) -> Scene:
    from tests.scenes import leg

    return leg(f"input={{kind: table, rows: [[0, 0], [1, 1]], {keys}}}")


def test_the_tables_of_a_run_hold_the_baseline_already(tmp_path: Path) -> None:
    text = "time_s,tip_x_m,inlet_pressure_pa,pressure_R1_pa,flow_inlet-R1_m3_s\n0,0,2e3,2e3,0\n1,0,7e3,3e3,0\n"
    assert table(tmp_path, text).rows == ((0.0, 2e3), (1.0, 7e3))
    raised = scene_of(tmp_path, text, "gauge_pressure=2 kPa")
    assert raised.input is not None
    assert raised.input.values(np.array([0.0, 1.0])).tolist() == [0.0, 5e3]
    record = "time_s,inlet_pressure_pa,wanted_pressure_pa,position_counts\n0,2e3,0,1\n1,7e3,0,1\n"
    assert table(tmp_path, record).rows == ((0.0, 2e3), (1.0, 7e3))


@pytest.mark.parametrize("header", ["p [kPa abs]", "p_abs (kPa)", "p [kPa(a)]", "p_kPa_abs"])
def test_absolute_columns_lose_ambient_and_baseline(tmp_path: Path, header: str) -> None:
    text = f"time_s,{header}\n0,101.325\n1,111.325\n"
    found = scene_of(tmp_path, text, "gauge_pressure=4 kPa").input
    assert found is not None
    assert found.values(np.array([0.0, 1.0])) == pytest.approx([-4e3, 6e3])


def test_an_absolute_column_stays_so_with_its_unit_stated(tmp_path: Path) -> None:
    text, stated = "time_s,p_kPa_abs\n0,101.325\n1,106.325\n", "{pressure: {column: 2, unit: kPa}}"
    assert (table(tmp_path, text, columns=stated).rows or ())[1][1] == pytest.approx(5e3)


def test_a_plunger_and_a_curve_are_read_likewise(tmp_path: Path) -> None:
    (tmp_path / "push.txt").write_text("Weg [mm];Zeit [ms]\n0,0;0\n1,5;500\n")
    (tmp_path / "curve.csv").write_text(
        "extension_mm,angle [deg],area (mm^2),p / kPa\n-0.1,-1,-3,-1\n0,0,0,0\n0.5,5,15,5\n"
    )
    file = tmp_path / "leg.yaml"
    from tests.unit.scene.tables.written import LEG

    file.write_text(LEG)
    scene = load(
        file,
        [
            "input={kind: syringe, diameter: 20 mm, start: 40 mm, file: push.txt}",
            "bellows.curve={file: curve.csv}",
        ],
    )
    assert scene.input is not None
    assert scene.input.rows == ((0.0, 0.0), (0.5, 0.0015))
    curve = scene.bellows.curve
    assert curve is not None
    assert np.array(curve.rows)[2] == pytest.approx([5e3, 15e-6, np.radians(5), 5e-4])


def test_a_clean_table_is_followed_to_the_last_bit(tmp_path: Path) -> None:
    time = np.arange(0, 3, 0.01)
    pressure = 1e4 * np.sin(time) ** 2 + 12.34567
    rows = tuple(zip(time.tolist(), pressure.tolist(), strict=True))
    text = "time_s,pressure_pa\n" + "".join(f"{t!r},{p!r}\n" for t, p in rows)
    scene = scene_of(tmp_path, text)
    assert scene.input is not None
    assert scene.input.rows == rows
    other = tmp_path / "again.yaml"
    other.write_text(resolved_yaml(scene))
    assert load(other).model_dump() == scene.model_dump()


def test_a_million_rows_are_read_in_less_than_two_seconds(tmp_path: Path) -> None:
    time = np.arange(1_000_000)
    lines = [f"{t};{t % 977},5" for t in time.tolist()]
    file = tmp_path / "long.csv"
    file.write_text("Zeit [ms];Druck [mbar]\n" + "\n".join(lines) + "\n")
    start = clock.process_time()
    found = table_of_file(
        {"file": str(file)}, Path(), (TIME, PRESSURE), time_faults, most_rows=10**7
    )
    assert clock.process_time() - start < 2.0
    assert found.values[-1] == pytest.approx([999.999, 100 * (999_999 % 977 + 0.5)])
