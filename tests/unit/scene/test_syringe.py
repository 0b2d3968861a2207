"""`kind: syringe`: plungers by rows, by speeds and from files."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from tests.scenes import CONFIGS, leg
from tests.unit.scene.round_trip import comes_back
from viscodesign import load
from viscodesign.errors import SpecError
from viscodesign.scene.inputs.syringe import SyringeInput

GOOD = (CONFIGS / "leg_16_straight_air.yaml").read_text()
BARREL = "kind: syringe, diameter: 20 mm, start: 40 mm"
AREA = math.pi * 0.01**2
ROWS = "rows: [[0.5, 1 mm], [1, 3 mm], [2, -1 mm]]"
SPEEDS = "speeds: [[0.5, 2 mm/s], [1, 0 mm/s], [1.5, -4 mm/s]]"


def made(words: str, *overrides: str) -> SyringeInput:
    source = leg(f"input={{{BARREL}, {words}}}", *overrides).inputs["inlet"]
    assert isinstance(source, SyringeInput)
    return source


def with_input(tmp_path: Path, words: str) -> Path:
    file = tmp_path / "leg.yaml"
    start, end = GOOD.index("input:"), GOOD.index("loads:")
    file.write_text(f"{GOOD[:start]}input: {{{words}}}\n{GOOD[end:]}")
    return file


def faults(words: str, *overrides: str) -> list[str]:
    with pytest.raises(SpecError) as caught:
        leg(f"input={{{words}}}", *overrides)
    return [f"{fault.key}: {fault.message}" for fault in caught.value.faults]


# -- what it pushes ---------------------------------------------------------


def test_positions_are_constant_before_the_first_and_after_the_last_row() -> None:
    times = np.array([0.0, 0.5, 0.75, 1.0, 1.5, 2.0, 7.0])
    expected = AREA * np.array([1.0, 1.0, 2.0, 3.0, 1.0, -1.0, -1.0]) * 1e-3
    assert made(ROWS).values(times) == pytest.approx(expected, rel=1e-12)


def test_speeds_hold_until_the_next_and_the_last_one_continues() -> None:
    times = np.array([0.0, 0.5, 0.75, 1.0, 1.25, 1.5, 2.0, 3.0])
    expected = AREA * np.array([0.0, 0.0, 0.5, 1.0, 1.0, 1.0, -1.0, -5.0]) * 1e-3
    assert made(SPEEDS).values(times) == pytest.approx(expected, rel=1e-12, abs=1e-18)


def test_speeds_and_equivalent_positions_give_the_same_input() -> None:
    speeds = made("speeds: [[0, 2 mm/s], [1, -1 mm/s], [3, 0 mm/s]]")
    rows = made("rows: [[0, 0], [1, 2 mm], [3, 0]]")
    times = np.linspace(0.0, 8.0, 81)
    assert speeds.values(times) == pytest.approx(rows.values(times), abs=1e-18)
    assert speeds.swing_time() == pytest.approx(rows.swing_time())
    assert speeds.corners(8.0) == rows.corners(8.0) == [1.0, 3.0]


def test_a_single_speed_starts_at_its_time() -> None:
    """Also where it begins at once, and where it begins after a rest."""
    assert made("speeds: [[0, 1 mm/s]]").values(np.array([2.0]))[0] == pytest.approx(AREA * 2e-3)


def test_a_single_speed_that_starts_late_rests_before() -> None:
    late = made("speeds: [[1, 0 mm/s], [2, 1 mm/s]]")
    assert late.values(np.array([0.5, 1.5, 2.0, 4.0])) == pytest.approx(
        AREA * np.array([0.0, 0.0, 0.0, 2e-3]), abs=1e-18
    )


def test_the_start_is_that_of_the_first_row() -> None:
    assert made(ROWS).initial() == pytest.approx(AREA * 1e-3)
    assert made(SPEEDS).initial() == 0.0


def test_a_jump_is_two_rows_at_one_time() -> None:
    jump = made("rows: [[0, 0], [1, 0], [1, 2 mm], [2, 2 mm]]")
    assert jump.values(np.array([0.999, 1.0])) == pytest.approx([0.0, AREA * 2e-3], abs=1e-18)
    assert jump.transient() == 0.0


def test_closed_volume() -> None:
    source = made(f"dead_volume: 1 mL, {ROWS}")
    assert source.area == pytest.approx(AREA)
    assert source.full_volume == pytest.approx(AREA * 0.04 + 1e-6)
    assert not source.gives_pressure
    assert source.period is None


def test_a_file_gives_the_same_as_its_rows(tmp_path: Path) -> None:
    (tmp_path / "push.csv").write_text("time_s,position_m\n0.5,1e-3\n1,3e-3\n2,-1e-3\n")
    scene = load(with_input(tmp_path, f"{BARREL}, file: push.csv"))
    assert scene.inputs["inlet"] == made(ROWS)
    assert "push.csv" not in comes_back(scene)


# -- faults -----------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        ("rows: [[0, 0], [1, 40 mm]]", "input.rows: position 40 mm at 1 s exceeds the filled length of 40 mm"),
        ("rows: [[0, 50 mm], [1, 0]]", "input.rows: position 50 mm at 0 s"),
        ("speeds: [[0, 50 mm/s], [1, 0 m/s]]", "input.speeds: position 50 mm at 1 s exceeds the filled length"),
        ("speeds: [[0, 1], [0, 2]]", "input.speeds: times must increase, starting at 0 s or later"),
        ("speeds: [[2, 0], [1, 0]]", "input.speeds: times must increase, starting at 0 s or later"),
        ("speeds: [[-2, 0], [1, 0]]", "input.speeds: times must increase, starting at 0 s or later"),
        ("rows: [[1, 0], [0.5, 0]]", "row 2: time decreases from 1 s to 0.5 s"),
        ("rows: [[-1, 0], [0.5, 0]]", "before the start at 0"),
        ("rows: [[0, 0], [1, 0], [1, 0], [1, 0]]", "third row at 1 s"),
        ("rows: [[0, 0]]", "input.rows: must have from 2 to 50000 rows; got 1"),
        ("rows: [[0, 1 s], [1, 0]]", "expected a length"),
        ("speeds: [[0, 1 mm], [1, 0]]", "expected a speed"),
        (f"{ROWS}, {SPEEDS}", "a syringe needs exactly one of 'file', 'rows' and 'speeds'"),
        (f"{ROWS}, file: a.csv", "a syringe needs exactly one of 'file', 'rows' and 'speeds'"),
        ("dead_volume: 1 mL", "a syringe needs exactly one of 'file', 'rows' and 'speeds'"),
        ("file: 3", "input.file: expected the name of a CSV file"),
        (f"dead_volume: -1 mL, {ROWS}", "input.dead_volume: must be at least 0 m^3; got '-1 mL'"),
        (f"{ROWS}, value: 3", "input.value: no such key"),
    ],
)  # fmt: skip
def test_faults(words: str, expected: str) -> None:
    found = faults(f"{BARREL}, {words}")
    assert len(found) == 1
    assert expected in found[0]


@pytest.mark.parametrize(
    ("barrel", "expected"),
    [
        (
            "kind: syringe, diameter: 0 mm, start: 40 mm",
            "input.diameter: must be above 0 m; got '0 mm'",
        ),
        ("kind: syringe, diameter: 20 mm, start: 0", "input.start: must be above 0 m; got 0"),
        ("kind: syringe, start: 40 mm", "input.diameter: missing"),
    ],
)
def test_a_barrel_needs_a_size(barrel: str, expected: str) -> None:
    assert expected in " ".join(faults(f"{barrel}, rows: [[0, 0], [1, 0]]"))


@pytest.mark.parametrize(
    ("table", "words"),
    [
        (
            "time_s,position_m\n0,0\n2,1e-3\n1,0\n",
            "push.csv, line 4: time decreases from 2 s to 1 s",
        ),
        ("time_s,position\n0,0\n1,0\n", "did you mean 'position_m'"),
        (
            "time_s,pressure_pa\n0,0\n1,0\n",
            "expected 'time_s,position_m', got 'time_s,pressure_pa'",
        ),
        ("time_s,position_m\n0,0\n1,1 mm\n", "line 3: position_m is '1 mm', not a number"),
        ("time_s,position_m\n0,0\n1,0.04\n", "position 40 mm at 1 s"),
    ],
)
def test_broken_files_name_the_line(tmp_path: Path, table: str, words: str) -> None:
    (tmp_path / "push.csv").write_text(table)
    with pytest.raises(SpecError) as caught:
        load(with_input(tmp_path, f"{BARREL}, file: push.csv"))
    assert words in str(caught.value)
    assert "leg.yaml:" in str(caught.value)


# -- the fluid that makes the pressure --------------------------------------


@pytest.mark.parametrize(
    ("fluid", "words"),
    [
        ("{name: oil, viscosity: 0.1, density: 900}", "a syringe needs the stiffness of oil, which is unknown"),
        ("{name: water, viscosity: 1e-3, density: 998}", "a syringe needs the stiffness of water"),
    ],
)  # fmt: skip
def test_a_fluid_without_stiffness_is_refused(fluid: str, words: str) -> None:
    found = faults(f"{BARREL}, {ROWS}", f"fluid={fluid}")
    assert len(found) == 1
    assert found[0].startswith(f"input: {words}")


def test_faults_name_the_inlet_of_several() -> None:
    with pytest.raises(SpecError) as caught:
        leg("input=null", f"inputs={{left: {{{BARREL}, {ROWS}}}}}",
            "fluid={name: oil, viscosity: 0.1, density: 900}")  # fmt: skip
    assert [fault.key for fault in caught.value.faults] == ["inputs.left"]


@pytest.mark.parametrize(
    "fluid",
    [
        "air",
        "water",
        "{name: oil, viscosity: 0.1, density: 900, bulk_modulus: 1 GPa}",
        "{name: helium, viscosity: 2e-5, density: 0.17, gas_constant: 2077}",
    ],
)
def test_compressible_fluids_are_accepted(fluid: str) -> None:
    assert made(ROWS, f"fluid={fluid}").full_volume > 0.0


# -- coming back ------------------------------------------------------------


@pytest.mark.parametrize(
    "words", [ROWS, SPEEDS, f"dead_volume: 0.3 mL, transient_time: 2 s, {ROWS}"]
)
def test_a_syringe_survives_a_round_trip(words: str) -> None:
    comes_back(leg(f"input={{{BARREL}, {words}}}"))


def test_a_syringe_and_another_inlet_survive_a_round_trip() -> None:
    tubes = "{from: a, to: R1}, {from: b, to: L1}"
    comes_back(
        leg("bellows.count=2", "input=null",
            f"network={{layout: custom, tube_radius: 1 mm, tube_length: 3 cm, tubes: [{tubes}]}}",
            f"inputs={{a: {{{BARREL}, {SPEEDS}}}, b: {{kind: constant, value: 1 kPa}}}}")
    )  # fmt: skip
