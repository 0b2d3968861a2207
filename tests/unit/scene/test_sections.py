"""`sections` and `bellows.changes`: what single sections and bellows have otherwise."""

from __future__ import annotations

import json
import re

import numpy as np
import pytest

from tests.scenes import leg
from tests.trajectories import made_run
from tests.unit.scene.round_trip import comes_back
from viscodesign import check
from viscodesign.checks.plausibility import plausibility_notices
from viscodesign.errors import SpecError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.report.page.sketch_numbers import sketch_numbers


def test_numbers_are_one_for_all_or_one_for_each() -> None:
    scene = leg("sections={1-2: {youngs_modulus: 3 MPa}, 8: {youngs_modulus: 1 MPa}}")
    modulus = scene.sections.each("youngs_modulus")
    assert modulus.tolist() == [3e6, 3e6, *[1.8e6] * 5, 1e6]
    assert scene.sections.each("height") == 0.03
    own = leg("bellows.changes={R2-R3: {height: 12 mm}, 8: {height: 9 mm}}").bellows.each("height")
    expected = [0.01, 0.012, 0.012, *[0.01] * 4, 0.009, *[0.01] * 7, 0.009]
    assert own.tolist() == expected


def test_a_scene_without_changes_has_no_number_more() -> None:
    quantities = SceneQuantities(leg())
    assert quantities.body.varied is None
    laws = vars(quantities.bellows)
    assert not any(isinstance(value, np.ndarray) for value in laws.values())


def test_changed_specs_come_back() -> None:
    scene = leg(
        "sections={1-2: {blocked: on, density: 1200}, 5: {height: 2 cm}}",
        "bellows.changes={R3: {area_per_pressure: 5e-9}, 7-8: {width: 10 mm}}",
    )
    comes_back(scene)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ("sections={9: {height: 2 cm}}", "sections.9: no such section; the actuator has sections "
         "1 to 8"),
        ("sections={0-2: {height: 2 cm}}", "no such section"),
        ("sections={3-1: {height: 2 cm}}", "no such section"),
        ("sections={1-3: {height: 2 cm}, 3-4: {height: 3 cm}}", "sections.3-4.height: '1-3' gives "
         "section 3 another value"),
        ("sections={1: {youngs_modulos: 1 MPa}}", "did you mean 'youngs_modulus'"),
        ("sections={1: {length: 1 cm}}", "sections.1.length: no section has its own; all sections "
         "of an actuator have the same length"),
        ("sections={1: {blocked: maybe}}", "must be one of on, off"),
        ("sections={1-8: {blocked: on}}", "all sections are blocked"),
        ("bellows.changes={R9: {height: 1 cm}}", "no such bellow; the actuator has R1 to R8"),
        ("bellows.changes={r3: {height: 1 cm}}", "did you mean 'R3'"),
        ("bellows.changes={R1-L3: {height: 1 cm}}", "no such bellow"),
        ("bellows.changes={R1: {height: 1 cm}, 1: {height: 8 mm}}", "'R1' gives R1 another value"),
        ("bellows.changes={R1: {curve: {rows: [[0, 0, 0, 0], [1e3, 1e-5, 0.1, 1e-4]]}}}",
         "bellows.curve: missing"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_said_at_its_key(change: str, message: str) -> None:
    with pytest.raises(SpecError, match=re.escape(message)):
        leg(change)


def test_two_keys_may_say_the_same_of_a_section() -> None:
    scene = leg("sections={1-3: {height: 2 cm}, 3-4: {height: 20 mm, width: 1 cm}}")
    assert scene.sections.each("height").tolist() == [0.02] * 4 + [0.03] * 4


def test_a_slip_in_a_single_section_is_seen() -> None:
    with pytest.raises(SpecError, match=r"sections\.1\.youngs_modulus.*did you mean 1\.8 MPa"):
        check(leg("sections={1: {youngs_modulus: 1.8 mPa}}"))
    notices = plausibility_notices(leg("bellows.changes={R2: {height: 40 mm}}"))
    assert [n.where for n in notices if n.code == "does_not_fit"] == ["bellows.height"]


def test_a_stiff_layer_makes_the_actuator_quicker_and_its_turns_fewer() -> None:
    plain, layered = (
        SceneQuantities(leg(*own)) for own in ((), ("sections={1-4: {blocked: on}}",))
    )
    # What half of a cantilever adds to its tip's deflection at the clamp's end: seven eighths.
    assert layered.scales.t_s == pytest.approx(plain.scales.t_s / 8**0.5, rel=1e-12)
    assert layered.largest_turn == plain.largest_turn


@pytest.mark.parametrize(
    "keys", ["density: 1200", "height: 29 mm", "damping_time: 2 ms", "shear_factor: 0.4"]
)
def test_each_kind_of_number_may_differ_alone(keys: str) -> None:
    every = "effects={feedback: on, shear: on, rotary_inertia: on, inertia: on, damping: on}"
    found = check(leg(f"sections={{1: {{{keys}}}}}", every))
    assert {v.name for v in found.effects if v.taken} >= {"feedback", "shear", "damping"}


def test_the_estimate_knows_what_each_bellow_does() -> None:
    still = "bellows.changes={1-8: {angle_per_pressure: 0, extension_per_pressure: 0}}"
    one = still.replace("1-8", "L1-L8")
    tips = [SceneQuantities(leg(own)).bare_estimate.tip for own in (still, one)]
    assert np.ptp(tips[0][:, 0]) == 0.0
    assert np.ptp(tips[1][:, 0]) > 1e-3


def test_the_live_sketch_has_a_number_for_each_bellow() -> None:
    scene = leg("sections={2: {blocked: on}}", "bellows.changes={L8: {length: 9 mm}}")
    found = json.loads(json.dumps(sketch_numbers(made_run(), scene, from_start=True)))
    assert found["curvature_per_pressure"][1] == found["curvature_per_pressure"][9] == 0.0
    assert found["compliance"][-1] == pytest.approx(found["compliance"][0] / 2)
    assert len(found["stretch_per_pressure"]) == 16
