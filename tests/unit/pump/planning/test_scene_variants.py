"""Scenes beside the one that is planned."""

from __future__ import annotations

import re

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign.errors import SpecError
from viscodesign.pump.planning.demand_kinds import pump_of
from viscodesign.pump.planning.scene_variants import jumps, planned, ramped, scaled
from viscodesign.scene.scene import Scene

KINDS = (
    "{kind: constant, value: 8 kPa}",
    "{kind: step, value: 8 kPa, time: 1 s}",
    "{kind: sine, amplitude: 8 kPa, frequency: 0.5 Hz, mean: 2 kPa, phase: 30 deg}",
    "{kind: square, high: 8 kPa, low: -3 kPa, frequency: 0.5 Hz, duty: 30 %}",
    "{kind: trapezoid, high: 8 kPa, low: 1 kPa, rise: 0.2 s, hold: 0.5 s, fall: 0.4 s, rest: 0.3 s}",
    "{kind: double_sigmoid, start: 8 kPa, drop: 12 kPa, fall_time: 0.5 s, rise_time: 2 s, "
    "transition: 0.8 s}",
    "{kind: table, rows: [[0, 0], [1, 8000], [1, 2000], [3, 0]]}",
)


@pytest.mark.parametrize("kind", KINDS)
def test_any_kind_of_input_is_scaled_and_slowed(kind: str) -> None:
    scene = leg(f"input={kind}", "run={duration: 4 s}")
    other = scaled(scene, pressure=0.6, time=2.5)
    time = np.linspace(0.0, 4.0, 333)
    (own,), (slow,) = scene.inputs.values(), other.inputs.values()
    assert slow.values(2.5 * time) == pytest.approx(0.6 * own.values(time), abs=1e-6)
    assert other.run.duration == 10.0


def with_jumps() -> Scene:
    return leg(
        "input={kind: table, rows: [[0, 1000], [1, 3000], [1, 9000], [3, 0]]}",
        "run={duration: 4 s}",
        "gauge_pressure=500 Pa",
    )


def test_jumps_are_found_and_become_ramps() -> None:
    scene = with_jumps()
    assert jumps(scene) == [1.0]
    gentle = ramped(scene, 0.2)
    assert jumps(gentle) == []
    (own,), (new,) = scene.inputs.values(), gentle.inputs.values()
    time = np.array([0.0, 0.5, 0.999, 1.2, 2.0, 4.0])
    assert new.values(time) == pytest.approx(own.values(time), abs=20)
    assert new.values(np.array([1.1]))[0] == pytest.approx((3000 + 8700) / 2, rel=0.03)


def test_a_plan_includes_effects_that_the_plunger_feels() -> None:
    scene = planned(leg("pump={syringe_diameter: 34.9 mm}", config="leg_16_straight_air_auto"))
    assert scene.effects.mode("gas_compressibility") == "on"
    published = planned(leg("pump={syringe_diameter: 34.9 mm}"))
    assert published.effects.mode("gas_compressibility") == "off"


@pytest.mark.parametrize(
    ("config", "words", "message"),
    [
        ("leg_4_air", (), "pump: missing; .*syringe_diameter: 34.9 mm"),
        ("syringe_water", ("pump={syringe_diameter: 34.9 mm}",), "already has a syringe"),
        (
            "antagonistic_two_inlets",
            ("pump={syringe_diameter: 34.9 mm}",),
            "one servo for 2 inlets; give each its own, like {left: 1, right: 2}",
        ),
        (
            "leg_4_water",
            (
                "pump={syringe_diameter: 34.9 mm}",
                "fluid={name: oil, viscosity: 0.01, density: 900}",
            ),
            "the stiffness of .* is unknown",
        ),
    ],
)
def test_scenes_that_cannot_be_planned_are_refused(
    config: str, words: tuple[str, ...], message: str
) -> None:
    with pytest.raises(SpecError) as refused:
        pump_of(leg(*words, config=config))
    assert re.search(message, str(refused.value), re.DOTALL)


@pytest.mark.parametrize("part", ["syringe_stroke: 30 mm", "pinion_diameter: 120 mm"])
def test_a_travel_that_empties_the_barrel_is_refused_with_a_remedy(part: str) -> None:
    with pytest.raises(SpecError, match=r"pump.syringe_stroke: .* draws the plunger out by"):
        pump_of(leg(f"pump={{syringe_diameter: 34.9 mm, home: 500, {part}}}"))


@pytest.mark.parametrize("part", ["filled_length: 200 mm", "filled_length: 110 mm"])
def test_a_filling_longer_than_the_barrel_is_refused_with_both_keys(part: str) -> None:
    with pytest.raises(SpecError, match=r"pump.filled_length: .* longer than pump.syringe_stroke"):
        pump_of(leg(f"pump={{syringe_diameter: 34.9 mm, {part}}}"))


def test_a_filling_of_the_whole_barrel_is_planned() -> None:
    pump_of(leg("pump={syringe_diameter: 34.9 mm, filled_length: 104.5 mm}"))
