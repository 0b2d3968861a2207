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
    "actuator.youngs_modulus=1e300": "bending stiffness",
    "actuator.youngs_modulus=1e3": "angle_per_pressure",
    "actuator.length=1e-200": "fourth power",
    "actuator.density=1e200": "effects.inertia: off",
    "actuator.damping_time=1e300": "actuator.damping_time",
    "loads.tip_force.x=1e300": "loads.tip_force",
    "input={kind: constant, value: 1e300}": "angle_per_pressure",
    "bellows.area_per_pressure=1e300": "compliance",
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
