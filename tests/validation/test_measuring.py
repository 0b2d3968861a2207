"""The bench of `docs/measuring.md`, simulated: its formulas give back the coefficients."""

from __future__ import annotations

import pytest

from tests.scenes import STATIC, STILL, leg
from viscodesign import Trajectory, simulate

GRAVITY = 9.80665
LENGTH, HEIGHT, WIDTH, MODULUS, SECTIONS = 0.109, 0.03, 0.02, 1.8e6, 8
ONCE = "run={duration: 1 s, output_interval: 1 s}"
ARCS = "effects={pressure_distribution: off, others: off}"


def reading(*changes: str, config: str = "leg_16_straight_air") -> Trajectory:
    return simulate(leg(*changes, ONCE, config=config), verify=False)


def test_a_weight_on_the_hanging_body_gives_the_extension_factor() -> None:
    force = 0.05 * GRAVITY
    longer = reading(STILL, STATIC, f"loads.tip_force.z={force}").tip[-1, 1] - LENGTH
    factor = force * LENGTH / (MODULUS * HEIGHT * WIDTH * longer)
    assert factor == pytest.approx(0.53, rel=1e-3)


def test_a_weight_on_the_level_body_gives_the_bending_factor() -> None:
    def drop(payload: str) -> float:
        loads = f"loads={{gravity: {{tilt: 90 deg}}, payload: {payload}}}"
        return float(reading(STILL, STATIC, loads).tip[-1, 0])

    lower = drop("20 g") - drop("0 g")
    factor = 4 * 0.02 * GRAVITY * LENGTH**3 / (MODULUS * WIDTH * HEIGHT**3 * lower)
    assert factor == pytest.approx(0.55, rel=1e-2)


def test_pressure_in_all_bellows_gives_extension_and_area() -> None:
    pressure = 5e3
    run = reading(f"input={{kind: constant, value: {pressure}}}", ARCS)
    longer = run.tip[-1, 1] - LENGTH
    assert MODULUS * longer / (2 * SECTIONS * pressure) == pytest.approx(0.047, rel=1e-9)
    volume = run.inflow["inlet"][-1]
    assert volume / (16 * 0.018 * pressure) == pytest.approx(3.413e-9, rel=1e-9)


def test_pressure_in_one_column_gives_the_angle() -> None:
    pressure = 5e3
    apart = (
        f"inputs.left={{kind: constant, value: {pressure}}}",
        "inputs.right={kind: constant, value: 0}",
    )
    run = reading(*apart, ARCS, config="antagonistic_two_inlets")
    assert MODULUS * run.tip[-1, 2] / (SECTIONS * pressure) == pytest.approx(10.266, rel=1e-9)
