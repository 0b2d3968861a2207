"""Actuators whose sections and bellows differ, against closed forms and against uniform ones."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import LEG_EI, LEG_LENGTH, LEG_MASS_PER_LENGTH, STILL, leg
from viscodesign import Scene, compile, simulate

ONCE = "run={duration: 1 s, output_interval: 1 s}"
SWING = "input={kind: sine, amplitude: 8 kPa, frequency: 1 Hz}"
SHORT = "run={duration: 0.5 s, output_interval: 0.05 s}"
WRITTEN_OUT = (
    "sections={1-8: {youngs_modulus: 1.8 MPa, height: 30 mm, width: 20 mm, density: 950, "
    "solid_fraction: 0.47, extension_factor: 0.53, bending_factor: 0.55, damping_time: 1 ms}}",
    "bellows.changes={1-8: {height: 10 mm, width: 12 mm, length: 18 mm, "
    "area_per_pressure: 3.413e-9, angle_per_pressure: 10.266, extension_per_pressure: 47 mm, "
    "area_per_force: 3.0e-7, area_per_moment: 1.2e-6, collapse_fraction: 0.1}}",
)
EVERYTHING = (
    "effects={pressure_distribution: on, gas_compressibility: on, collapse: on, fluid_mass: on, "
    "inertia: on, rotary_inertia: on, damping: on, feedback: on, gravity: on, shear: on}"
)


def _tips(scene: Scene) -> np.ndarray:
    found = simulate(scene, verify=False)
    assert found.status == "complete"
    return np.asarray(found.tip)


def test_sections_written_out_equal_the_uniform_actuator() -> None:
    same = (SWING, SHORT, EVERYTHING, "loads.gravity={tilt: 40 deg}")
    uniform, written = _tips(leg(*same)), _tips(leg(*same, *WRITTEN_OUT))
    assert np.ptp(uniform[:, 0]) > 0.01
    assert written == pytest.approx(uniform, abs=1e-9)


def _ends() -> np.ndarray:
    """Distances of the sections' ends from the tip [m]."""
    return LEG_LENGTH * (1 - np.arange(9) / 8)


def test_a_stepped_cantilever_bends_as_its_closed_form_says() -> None:
    force = 1e-4 * 3 * LEG_EI / LEG_LENGTH**2
    scene = leg(
        "sections={1-2: {youngs_modulus: 5.4 MPa}, 4: {height: 15 mm}, 7-8: {width: 5 mm}}",
        f"loads={{gravity: off, tip_force: {{x: {force}, z: 0}}}}",
        *(STILL, ONCE, "effects={others: off}"),
    )
    softer = np.array([1 / 3, 1 / 3, 1, 8, 1, 1, 4, 4])
    closed = force / (3 * LEG_EI) * np.sum(softer * -np.diff(_ends() ** 3))
    assert _tips(scene)[-1, 0] == pytest.approx(closed, rel=1e-6)


@pytest.mark.parametrize(("accuracy", "error"), [("1e-3", 5e-5), ("1e-6", 1e-6)])
def test_sections_of_different_mass_weigh_down_a_level_actuator(
    accuracy: str, error: float
) -> None:
    scene = leg(
        "sections={1-4: {density: 95}, 8: {density: 3800}}",
        "loads.gravity={acceleration: 0.05, tilt: 90 deg}",
        *(STILL, ONCE, "effects={gravity: on, others: off}", f"accuracy={accuracy}"),
    )
    load = 0.05 * LEG_MASS_PER_LENGTH * np.array([0.1] * 4 + [1] * 3 + [4])
    ends = _ends()
    # Of the weight from s1 to s2 along a cantilever: its tip moves by w s^2 (3 l - s) / 6 EI ds.
    s = LEG_LENGTH - ends
    closed = np.sum(load * np.diff(LEG_LENGTH * s**3 - s**4 / 4)) / (6 * LEG_EI)
    assert _tips(scene)[-1, 0] == pytest.approx(closed, rel=error)


def test_blocked_sections_are_a_straight_stub_on_which_the_others_hang() -> None:
    loads = "loads={gravity: off, tip_force: {x: 2 N, z: 0.1 N}}"
    steady = "input={kind: constant, value: 15 kPa}"
    same = (steady, loads, ONCE, "accuracy=1e-4", "effects={others: off}")
    scene = leg("sections={1-2: {blocked: on}}", *same)
    length = 0.75 * LEG_LENGTH
    network = ("bellows.count=12", f"actuator.length={length}", "accuracy=1.3333e-4")
    shorter = _tips(leg(*same, *network))[-1]
    found = simulate(scene, verify=False)
    stub = [0.0, LEG_LENGTH / 4, 0.0]
    assert found.tip[-1] == pytest.approx(shorter + stub, abs=1e-4 * LEG_LENGTH)
    assert abs(found.shape[-1][found.arc < LEG_LENGTH / 4, 0]).max() < 1e-4 * LEG_LENGTH
    assert shorter[0] > 0.005


def test_a_blocked_section_stays_straight_where_it_swings() -> None:
    found = simulate(leg("sections={3-4: {blocked: on}}", SWING, SHORT, EVERYTHING), verify=False)
    inside = (found.arc >= LEG_LENGTH / 4) & (found.arc <= LEG_LENGTH / 2)
    part = found.shape[:, inside]
    chord = part[:, -1] - part[:, 0]
    away = part - part[:, :1]
    across = away[..., 0] * chord[:, None, 1] - away[..., 1] * chord[:, None, 0]
    assert np.abs(across).max() / np.hypot(*chord.T).min() < 1e-5
    assert np.ptp(found.tip[:, 0]) > 0.005


def _chain(first: str, other: str) -> str:
    order = [*(f"{first}{j}" for j in range(1, 9)), *(f"{other}{j}" for j in range(8, 0, -1))]
    ends = zip(["inlet", *order], order, strict=False)
    tubes = ", ".join(f"{{from: {a}, to: {b}}}" for a, b in ends)
    sizes = "tube_length: 37.5 mm, tube_radius: 0.325 mm"
    return f"network={{layout: custom, {sizes}, tubes: [{tubes}]}}"


def test_mirrored_changes_mirror_the_motion() -> None:
    changes = "{area_per_pressure: 5e-9, angle_per_pressure: 14 rad, height: 12 mm}"
    paths = [
        _tips(
            leg(
                *(SWING, SHORT, EVERYTHING, _chain(side, other)),
                f"bellows.changes={{{side}3: {changes}, {other}6-{other}7: {{length: 12 mm}}}}",
                "sections={2: {youngs_modulus: 3 MPa}}",
            )
        )
        for side, other in ("RL", "LR")
    ]
    assert paths[1] == pytest.approx(paths[0] * [-1, 1, -1], abs=1e-12)
    assert np.ptp(paths[0][:, 0]) > 0.005


def test_balances_hold_where_sections_and_bellows_differ() -> None:
    found = simulate(
        leg(
            "bellows.changes={R1-R4: {area_per_pressure: 6e-9}, L5: {height: 14 mm}}",
            "sections={1: {blocked: on}, 5-8: {height: 22 mm}}",
            *(SWING, SHORT, EVERYTHING),
        ),
        verify=False,
    )
    assert found.status == "complete"
    assert found.invariants.volume_imbalance_rel < 1e-8
    assert abs(found.invariants.energy_imbalance_rel) < 1e-4


CURVE = "{rows: [[-40e3, -1.3652e-4, -0.22813333, -1.0444e-3], [40e3, 1.3652e-4, 0.22813333, 1.0444e-3]]}"
"""The linear laws of the leg as a curve."""


def test_a_curve_for_each_bellow_that_is_its_linear_law_changes_nothing() -> None:
    same = (SWING, SHORT, "effects={gravity: on, material_curve: on, others: off}")
    slope = 6e-9 * 40e3
    own = f"{{rows: [[-40e3, -{slope}, 0, 0], [40e3, {slope}, 0, 0]]}}"
    linear = "bellows.changes={R3: {area_per_pressure: 6e-9, angle_per_pressure: 0, "
    linear += "extension_per_pressure: 0}}"
    straight = _tips(leg(*same, linear, "effects={gravity: on, others: off}"))
    curved = _tips(
        leg(*same, f"bellows.curve={CURVE}", f"bellows.changes={{R3: {{curve: {own}}}}}")
    )
    assert curved == pytest.approx(straight, abs=2e-7)


def test_one_bellow_that_snaps_among_others_that_do_not() -> None:
    snap = "{rows: [[-20e3, -5e-5, -0.1, -5e-4], [0, 0, 0, 0], [6e3, 4e-5, 0.1, 4e-4], "
    snap += "[4e3, 8e-5, 0.2, 8e-4], [30e3, 2.0e-4, 0.4, 2e-3]]}"
    found = simulate(
        leg(
            *(f"bellows.curve={CURVE}", f"bellows.changes={{R2: {{curve: {snap}}}}}"),
            "input={kind: step, value: 12 kPa, time: 0.1 s}",
            "run={duration: 4 s, output_interval: 0.05 s}",
            "effects={material_curve: on, pressure_distribution: on, others: off}",
        ),
        verify=False,
    )
    assert found.status == "complete"
    volume = found["volume"][:, [found.bellows.index(b) for b in ("R2", "R3")]]
    grown = np.ptp(volume, axis=0)
    # Beyond its peak the bellow that snaps swells more than twice as much as its neighbour.
    assert grown[0] > 2 * grown[1] > 0.0


@pytest.mark.parametrize(
    ("key", "step"),
    [("sections.1-2.youngs_modulus", 3e4), ("bellows.changes.R3.area_per_pressure", 5e-11)],
)
def test_numbers_of_sections_and_bellows_may_be_free(key: str, step: float) -> None:
    scene = leg(
        "sections={1-2: {youngs_modulus: 3 MPa}, 5: {blocked: on}}",
        "bellows.changes={R3: {area_per_pressure: 5e-9}}",
        *(SWING, SHORT, "accuracy=1e-4"),
    )
    function = compile(scene, free=[key], outputs=["tip_x_m"])
    slope = function.jacobian(function.values)["tip_x_m"][..., 0]
    ends = [function(function.values + side * step)["tip_x_m"] for side in (1, -1)]
    difference = (ends[0] - ends[1]) / (2 * step)
    assert slope == pytest.approx(difference, abs=1e-3 * np.abs(difference).max())
    assert np.abs(difference).max() > 0.0
