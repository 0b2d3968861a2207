"""The pump's closed forms against numbers worked out by hand, and the paper's statements."""

from __future__ import annotations

import math

import numpy as np
import pytest

from viscodesign.pump import syringe as pump
from viscodesign.pump.drive import Drive
from viscodesign.pump.servo_motor import SERVOS, SPEED_UNIT, STEADY_SHARE
from viscodesign.scene.pump import PumpSpec

AX18A, AX12A = SERVOS["ax18a"], SERVOS["ax12a"]
PINION = 29.6e-3
GLASS = {"BD": 34.90e-3, "Micro-Mate": 35.70e-3}
"""Inner diameters of glass syringes of 100 mL [m]."""


def test_the_makers_numbers() -> None:
    assert (AX18A.stall_torque, AX18A.stall_current) == (1.8, 2.2)
    assert pytest.approx(97.0) == AX18A.no_load_speed * 60 / (2 * math.pi)
    assert (AX12A.stall_torque, AX12A.stall_current) == (1.5, 1.5)
    assert pytest.approx(59.0) == AX12A.no_load_speed * 60 / (2 * math.pi)
    assert STEADY_SHARE == 0.2


@pytest.mark.parametrize(
    ("make", "stall", "steady"), [("BD", 127.0, 25.4), ("Micro-Mate", 122.0, 24.3)]
)
def test_stall_pressure_of_glass_syringes(make: str, stall: float, steady: float) -> None:
    found = pump.stall_pressure(AX18A, 12.0, GLASS[make], PINION) / 1e3
    assert found == pytest.approx(stall, abs=0.6)
    assert STEADY_SHARE * found == pytest.approx(steady, abs=0.1)
    force = 1.8 / 14.8e-3
    assert found * 1e3 == pytest.approx(force / (math.pi * GLASS[make] ** 2 / 4))


@pytest.mark.parametrize("make", GLASS)
def test_the_papers_140_kpa(make: str) -> None:
    """As gauge it is beyond the stall; as absolute, 38.7 kPa gauge, it takes a third."""
    stall = pump.stall_pressure(AX18A, 12.0, GLASS[make], PINION)
    assert 1.10 <= 140e3 / stall <= 1.155
    assert (140e3 - 101325.0) / stall == pytest.approx(0.31, abs=0.015)


def test_torque_balances_pressure_and_friction_in_both_directions() -> None:
    area = math.pi * GLASS["BD"] ** 2 / 4
    torque = pump.shaft_torque(np.array([1e4, -1e4]), GLASS["BD"], PINION, np.array([5.0, -5.0]))
    assert torque == pytest.approx(np.array([1, -1]) * (1e4 * area + 5.0) * 14.8e-3)


def test_speed_falls_along_a_straight_line_to_the_stall_and_not_below() -> None:
    stall = pump.stall_torque(AX18A, 11.1)
    assert stall == pytest.approx(1.8 * 11.1 / 12)
    free = float(pump.speed_left(AX18A, 11.1, 0.0))
    assert free == pytest.approx(AX18A.no_load_speed * 11.1 / 12)
    assert float(pump.speed_left(AX18A, 11.1, stall / 2)) == pytest.approx(free / 2)
    assert float(pump.speed_left(AX18A, 11.1, stall)) == pytest.approx(0.0, abs=1e-12)
    assert float(pump.speed_left(AX18A, 11.1, 2 * stall)) == 0.0
    assert float(pump.speed_left(AX18A, 11.1, -1.0)) == free  # what helps makes it no faster


def test_largest_flow_and_finest_step() -> None:
    flow = float(pump.flow_rate(AX18A.no_load_speed, GLASS["BD"], PINION))
    assert flow * 1e6 == pytest.approx(144, abs=1)
    assert 1e3 * pump.advance_per_count(PINION) == pytest.approx(0.07575, abs=1e-4)
    assert 1e6 / pump.counts_per_volume(GLASS["BD"], PINION) == pytest.approx(0.0725, abs=2e-4)


def test_counts_are_those_of_the_drive() -> None:
    drive = Drive(PumpSpec(syringe_diameter=GLASS["BD"]))
    assert drive.advance_per_count == pytest.approx(pump.advance_per_count(PINION))
    assert 1 / drive.volume_per_count == pytest.approx(pump.counts_per_volume(GLASS["BD"], PINION))


def test_counts_for_a_pressure_of_a_closed_volume_of_gas() -> None:
    """100 mL at 140 kPa absolute: a tenth of a kPa for a count."""
    compliance = 100e-6 / 140e3
    counts = pump.counts_per_pressure(compliance, GLASS["BD"], PINION)
    assert 1e-3 / counts == pytest.approx(0.10, abs=0.005)


def test_current_and_battery() -> None:
    assert float(pump.servo_current(AX18A, -1.8)) == pytest.approx(2.2)
    minutes = pump.battery_life(0.45 * 3600, 2 * 2.2) / 60
    assert minutes == pytest.approx(6.1, abs=0.1)  # two servos at stall
    assert pump.battery_life(1.0, 0.0) == math.inf


def test_the_speed_register_is_never_zero() -> None:
    assert pump.speed_register(0.0) == 1
    assert pump.speed_register(-0.4 * SPEED_UNIT) == 1
    assert pump.speed_register(300 * SPEED_UNIT) == 300
    assert pump.speed_register(1e6) == 1023
