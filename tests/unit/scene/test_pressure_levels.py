"""Levels of an input may say gauge or abs; with a pump a bare one above ambient is asked about."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg
from tests.unit.scene.round_trip import comes_back
from viscodesign.errors import SpecError

AMBIENT = 101325.0
KINDS = [
    ("kind: constant, value: {}", "value"),
    ("kind: step, value: {}, time: 1 s", "value"),
    ("kind: sine, mean: {}, amplitude: 3 kPa, frequency: 1 Hz", "mean"),
    ("kind: square, high: {}, low: -60 kPa, frequency: 1 Hz", "high"),
    ("kind: square, high: 90 kPa, low: {}, frequency: 1 Hz", "low"),
    ("kind: trapezoid, high: {}, rise: 1 s, fall: 1 s", "high"),
    ("kind: double_sigmoid, start: {}, drop: 3 kPa, fall_time: 1 s, rise_time: 3 s, transition: 1 s", "start"),
]  # fmt: skip


@pytest.mark.parametrize(("kind", "key"), KINDS)
@pytest.mark.parametrize("baseline", [0.0, 2000.0])
@pytest.mark.parametrize(
    ("text", "gauge"),
    [("110 kPa abs", 110e3 - AMBIENT), ("110kPa absolute", 110e3 - AMBIENT), ("1.1 bar abs", 110e3 - AMBIENT)],
)  # fmt: skip
def test_an_absolute_level_is_that_at_the_inlet(
    kind: str, key: str, baseline: float, text: str, gauge: float
) -> None:
    scene = leg(f"gauge_pressure={baseline}", f"input={{{kind.format(text)}}}")
    level = getattr(scene.inputs["inlet"], key)
    assert level + baseline == pytest.approx(gauge, abs=1e-9)
    comes_back(scene)


@pytest.mark.parametrize(("kind", "key"), KINDS)
def test_gauge_reads_as_a_bare_level(kind: str, key: str) -> None:
    bare, said = (leg(f"input={{{kind.format(text)}}}") for text in ("9 kPa", "9 kPa gauge"))
    assert getattr(bare.inputs["inlet"], key) == getattr(said.inputs["inlet"], key) == 9e3
    comes_back(said)


def test_rows_and_several_inlets_may_be_absolute() -> None:
    scene = leg(
        "input={kind: table, rows: [[0, 90 kPa abs], [1 s, 5 kPa], [2 s, 101.325 kPa abs]]}"
    )
    expected = [90e3 - AMBIENT, 5e3, 0.0]
    assert scene.inputs["inlet"].values(np.array([0.0, 1.0, 2.0])) == pytest.approx(expected)
    level = "{kind: constant, value: 100 kPa abs}"
    several = leg(f"inputs={{left: {level}, right: {level}}}", config="antagonistic_two_inlets")
    for source in several.inputs.values():
        assert source.values(np.array([1.0])) == pytest.approx(100e3 - AMBIENT)


def test_another_ambient_pressure_counts() -> None:
    scene = leg("ambient_pressure=80 kPa", "input={kind: constant, value: 90 kPa abs}")
    assert scene.inputs["inlet"].value == 10e3  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ("override", "words"),
    [
        ("input={kind: sine, amplitude: 3 kPa abs, frequency: 1 Hz}", "input.amplitude"),
        ("input={kind: constant, value: 3 kPaa abs}", "unknown unit 'kPaa'"),
        ("input={kind: constant, value: 3 m abs}", "input.value: '3 m' is a length"),
        ("input={kind: table, rows: [[0, 1 kPa], [1, 1 800 kPa abs]]}", "input.rows.1.1"),
        ("gauge_pressure=40 kPa abs", "this key is gauge, so subtract the ambient pressure"),
        ("ambient_pressure=0 kPa gauge", "this key is abs, so add the ambient pressure"),
        ("actuator.youngs_modulus=1.8 MPa abs", "no choice between gauge and absolute"),
        ("input={kind: constant, value: 40 kPa (abs)}", "did you mean '40 kPa abs'?"),
        ("input={kind: constant, value: 40 kPa ABS}", "did you mean '40 kPa abs'?"),
        ("input={kind: constant, value: 40 kPa rel}", "did you mean '40 kPa gauge'?"),
        ("input={kind: constant, value: 40 kPa gauge abs}", "'40 kPa gauge abs': unknown unit"),
        ("input={kind: constant, value: 40 kPa gauge abs}", "either gauge or absolute"),
        ("gauge_pressure=2 kPa (gauge)", "did you mean '2 kPa gauge'?"),
        ("input={kind: constant, value: -5 kPa abs}", "no absolute pressure is negative"),
    ],
)
def test_a_reference_that_makes_no_sense_is_refused(override: str, words: str) -> None:
    with pytest.raises(SpecError) as caught:
        leg(override)
    assert words in str(caught.value)


def test_a_reference_that_the_key_has_anyway_may_be_said() -> None:
    assert leg("gauge_pressure=2 kPa gauge").gauge_pressure == 2e3
    assert leg("ambient_pressure=101 kPa abs").ambient_pressure == 101e3


@pytest.mark.parametrize(
    "level",
    ["kind: constant, value: {}", "kind: step, value: {}, time: 1 s", "kind: sine, mean: {}, amplitude: 1, frequency: 1",
     "kind: square, high: {}, low: 0, frequency: 1 Hz", "kind: trapezoid, high: {}, rise: 1 s, fall: 1 s"],
)  # fmt: skip
def test_a_bare_level_above_ambient_is_asked_about_for_a_pump(level: str) -> None:
    with pytest.raises(SpecError) as caught:
        leg(f"input={{{level.format('140 kPa')}}}", config="leg_16_pump")
    assert "write '140 kPa gauge', or '140 kPa abs' (38.67 kPa gauge)" in str(caught.value)
    for said in ("140 kPa gauge", "140 kPa abs", "40 kPa"):
        comes_back(leg(f"input={{{level.format(said)}}}", config="leg_16_pump"))
    leg(f"input={{{level.format('140 kPa')}}}")  # without a pump it is gauge, with a warning
