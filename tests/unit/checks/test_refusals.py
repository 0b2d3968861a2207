"""Specs whose numbers lie too far apart are refused with their key, before anything is solved."""

from __future__ import annotations

import pytest

from tests.scenes import leg
from viscodesign import check, classify, simulate
from viscodesign.errors import SpecError

SECOND = "run={duration: 1 s, output_interval: 0.1 s}"
BEYOND = {
    "network.changes={R3-R4: {length: 375 km, radius: 4 um}}": "4.4e+14 times the resistance of tube inlet-R1",
    "network.changes={R3-R4: {radius: 100 m}}": "the resistance of tube R3-R4",
    "fluid={name: own, viscosity: 1e-30, density: 1}": "effects.pressure_distribution: off",
    "fluid={name: own, viscosity: 1e30, density: 1}": "lower fluid.viscosity",
    "actuator.youngs_modulus=1e300": "actuator.youngs_modulus: is 1e+300",
    "actuator.youngs_modulus=1e3": "angle_per_pressure",
    "actuator.length=1e-200": "actuator.length: is 1e-200",
    "actuator.length=1e300 m": "actuator.length: is 1e+300",
    "network.tube_radius=1e-90 m": "network.tube_radius: is 1e-90",
    "network.changes={R3-R4: {radius: 1e-90 m}}": "network.changes.R3-R4.radius: is 1e-90",
    "input.transition=1e-300 s": "input.transition: is 1e-300",
    "input={kind: table, rows: [[0, 0], [1, 1e300]]}": "input.rows: is 1e+300",
    "fluid.viscosity=1e-320": "fluid.viscosity: is 1e-320",
    "fluid.density=1e-320": "fluid.density: is 1e-320",
    "ambient_pressure=1e-300 Pa": "ambient_pressure: is 1e-300",
    "actuator.density=1e40": "effects.inertia: off",
    "actuator.damping_time=1e40": "actuator.damping_time",
    "loads.tip_force.x=1e40": "loads.tip_force",
    "input={kind: constant, value: 1e40}": "angle_per_pressure",
    "bellows.area_per_pressure=1e300": "bellows.area_per_pressure: is 1e+300",
}


@pytest.mark.parametrize("change", BEYOND)
@pytest.mark.parametrize("command", [check, simulate], ids=["check", "simulate"])
def test_a_number_beyond_the_rest_is_refused_with_its_key(change: str, command: object) -> None:
    with pytest.raises(SpecError) as refusal:
        command(leg(change, SECOND, "effects=auto"))  # type: ignore[operator]
    assert BEYOND[change] in str(refusal.value)


@pytest.mark.parametrize(
    ("turn", "message"),
    [
        (29.0, ""),
        (31.0, "turns by 31 rad: more than the 30 rad"),
        (60.0, "turns by 60 rad: more than the 30 rad"),
    ],
)
def test_a_section_that_winds_around_itself(turn: float, message: str) -> None:
    # Of a pressure p, angle/E of it for a bellow.
    change = f"bellows.angle_per_pressure={turn * 1.8e6 / 5e3!r}"
    still = "input={kind: constant, value: 5 kPa}"
    if message:
        with pytest.raises(SpecError, match=message):
            check(leg("bellows.count=4", change, still, SECOND, "effects.feedback=off"))
    else:
        check(leg("bellows.count=4", change, still, SECOND, "effects.feedback=off"))


def test_many_sections_that_turn_a_hundred_times_together() -> None:
    change = f"bellows.angle_per_pressure={20 * 1.8e6 / 5e3!r}"
    still = "input={kind: constant, value: 5 kPa}"
    with pytest.raises(SpecError, match="by 20 rad, and there are 24: more than the 400 rad"):
        check(leg("bellows.count=48", change, still, SECOND))


def test_what_double_precision_carries_is_let_through() -> None:
    for change in ("network.changes={inlet-R1: {radius: 0.325 um}}", "actuator.density=1e15"):
        check(leg(change, SECOND))


@pytest.mark.parametrize(
    "change", [c for c in BEYOND if not c.startswith(("loads", "actuator.damping"))]
)
def test_a_scene_without_finite_numbers_is_not_placed_on_the_plane(change: str) -> None:
    with pytest.raises(SpecError) as refusal:
        classify(leg(change, SECOND, "effects=auto"))
    assert BEYOND[change] in str(refusal.value)


def test_a_network_too_slow_for_double_precision_is_refused_before_any_division() -> None:
    with pytest.raises(SpecError, match="the resistance of tube"):
        classify(
            leg("network.changes={inlet-R1: {radius: 100 m}, R1-R2: {radius: 1e-9 m}}", SECOND)
        )


@pytest.mark.parametrize("command", [check, simulate], ids=["check", "simulate"])
def test_inlets_of_one_network_have_no_one_pressure(command: object) -> None:
    joined = "network={layout: custom, tube_length: 4 cm, tube_radius: 0.3 mm, tubes: [{from: left, to: R1}, {from: right, to: R1}]}"
    scene = leg(
        "effects={pressure_distribution: off, others: auto}",
        joined,
        config="antagonistic_two_inlets",
    )
    with pytest.raises(SpecError, match="inlets left, right feed the same network"):
        command(scene)  # type: ignore[operator]


def test_a_product_of_numbers_none_of_which_is_extreme() -> None:
    tubes = "network={layout: straight, tube_radius: 1e-50, tube_length: 1e6}"
    with pytest.raises(SpecError, match=r"tube inlet-R1 \(its resistance\): is 2.55e\+256"):
        check(leg("fluid={name: own, viscosity: 1e50, density: 1}", tubes, SECOND))


@pytest.mark.parametrize("given", ["-102 kPa", "-101.326 kPa", "-101.325 kPa", "-150 kPa"])
@pytest.mark.parametrize("fluid", ["standard air", "water"])
@pytest.mark.parametrize("command", [check, classify, simulate])
def test_a_baseline_without_absolute_pressure_is_refused(
    command: object, given: str, fluid: str
) -> None:
    own = "fluid=water" if fluid == "water" else f"fluid.name={fluid}"
    with pytest.raises(SpecError) as refusal:
        command(leg(f"gauge_pressure={given}", "ambient_pressure=101.325 kPa", own, SECOND))  # type: ignore[operator]
    told = str(refusal.value)
    assert f"gauge_pressure: {given} gauge at an ambient_pressure of 101.325 kPa" in told
    assert "an absolute pressure written as gauge" in told


def test_a_baseline_just_above_vacuum_is_weighed() -> None:
    check(leg("gauge_pressure=-100 kPa", "ambient_pressure=101.325 kPa", SECOND))


@pytest.mark.parametrize(
    "change",
    ["input={kind: table, rows: [[0, 0], [1e-300, 1], [1, 5e3]]}", "loads.payload=1e-300 kg"],
)
def test_what_may_be_zero_may_be_tiny(change: str) -> None:
    check(leg(change, SECOND, "effects=auto"))


@pytest.mark.parametrize(("mode", "told"), [("auto", True), ("off", False), ("on", None)])
def test_feedback_that_no_run_can_judge_is_told_where_it_is_left_out(
    mode: str, told: bool | None
) -> None:
    """A section that fills by itself with its strain held: with the effect, pressures diverge."""
    changes = ("bellows.area_per_moment=1e-3", f"effects={{feedback: {mode}, others: auto}}")
    scene = leg("bellows.count=4", "loads.gravity=off", *changes, config="leg_4_air_auto")
    if told is None:
        with pytest.raises(SpecError, match="negative compliance in bending"):
            check(scene)
        return
    assert ("not_passive" in {notice.code for notice in check(scene).warnings}) is told
