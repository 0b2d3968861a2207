"""A scene that says nothing of gravity hangs in Earth's, weighed like any effect."""

from __future__ import annotations

import pytest

from tests.scenes import LEG_EA, LEG_LENGTH, LEG_MASS_PER_LENGTH, leg
from viscodesign import check, simulate
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.scene.loads import STANDARD_GRAVITY
from viscodesign.scene.reading.read import parse_scene
from viscodesign.scene.reading.write import resolved_yaml

SHORT = ("run={duration: 0.1 s, output_interval: 0.05 s}", "input={kind: constant, value: 5 kPa}")
UNSAID = (*SHORT, "loads={payload: 0}")
AUTO = "effects=auto"
FINE = "accuracy=0.05 %"
PINNED = "effects={pressure_distribution: on, others: off}"


def codes(*changes: str) -> dict[str, str]:
    return {n.code: n.message for n in check(leg(*changes)).warnings}


def test_nothing_said_is_earths_gravity_along_the_leg() -> None:
    unsaid, said = leg(*UNSAID), leg(*SHORT, "loads.gravity=on")
    assert unsaid.loads.gravity == said.loads.gravity
    assert unsaid.loads.gravity is not None
    assert (unsaid.loads.gravity.acceleration, unsaid.loads.gravity.tilt) == (STANDARD_GRAVITY, 0.0)
    assert leg("loads=null").loads.gravity is not None
    assert leg("loads.gravity=off").loads.gravity is None


def test_it_is_included_where_the_tip_notices_and_told_once() -> None:
    found = simulate(leg(*UNSAID, AUTO, FINE), verify=False)
    assert "gravity" in [v.name for v in found.effects if v.taken]
    told = [n for n in found.warnings if n.code == "changed_default"]
    assert len(told) == 1
    assert told[0].where == "loads.gravity"
    # The leg hangs straight: it sags by about m g l^2/(2 EA).
    weightless = simulate(leg(*SHORT, AUTO, FINE, "loads.gravity=off"), verify=False)
    weight = LEG_MASS_PER_LENGTH * LEG_LENGTH * STANDARD_GRAVITY
    stretch = found.tip[0, 1] - weightless.tip[0, 1]
    assert stretch == pytest.approx(weight * LEG_LENGTH / (2 * LEG_EA), rel=0.01)


@pytest.mark.parametrize("said", ["spec=1", "loads.gravity=on", "loads.gravity=off"])
def test_a_spec_that_says_it_is_told_nothing(said: str) -> None:
    assert "changed_default" in codes(*UNSAID, AUTO, FINE)
    assert "changed_default" not in codes(*UNSAID, AUTO, FINE, said)


def test_a_resolved_spec_says_it() -> None:
    again = parse_scene(resolved_yaml(leg(*UNSAID, AUTO, FINE)).encode())
    assert "changed_default" not in [n.code for n in check(again).warnings]


def test_where_it_is_neglected_nothing_is_told_of_it() -> None:
    assert "changed_default" not in codes(*UNSAID, AUTO, "accuracy=5 %")


def test_pinned_off_it_is_told_what_it_would_do() -> None:
    told = codes(*UNSAID, PINNED, "accuracy=0.01 %")
    assert "gravity is off, but it would move the tip by about" in told["needed_effect_off"]
    assert "`loads.gravity` is not stated" in told["needed_effect_off"]
    assert "needed_effect_off" not in codes(*SHORT, PINNED, "accuracy=0.01 %")


def test_a_weight_that_is_switched_off_refuses_no_scene() -> None:
    soft = ("actuator.density=1e12", "actuator.youngs_modulus=1.8 MPa")
    check(leg(*UNSAID, *soft, PINNED))


@pytest.mark.parametrize(
    ("tilt", "payload", "accuracy", "needed"),
    [("0", "0", "0.5 %", False), ("0", "0", "0.05 %", True), ("90 deg", "0", "0.5 %", True),
     ("180 deg", "0", "0.5 %", True), ("0", "60 g", "0.5 %", True)],
)  # fmt: skip
def test_a_rod_that_is_released_needs_inertia_where_its_weight_swings_it(
    tilt: str, payload: str, accuracy: str, needed: bool
) -> None:
    released = (f"loads={{gravity: {{tilt: {tilt}}}, payload: {payload}}}", "run.start=rest")
    quantities = SceneQuantities(leg(*SHORT, *released, f"accuracy={accuracy}"))
    assert quantities.suddenly_loaded is needed
