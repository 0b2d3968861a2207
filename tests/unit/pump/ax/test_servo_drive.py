"""The pump's closed forms against numbers worked out by hand, and the paper's statements."""

from __future__ import annotations

import math

import numpy as np
import pytest

from viscodesign.pump.ax.servo_drive import ServoDrive
from viscodesign.scene.pumps.servo import ServoPumpSpec
from viscodesign.scene.pumps.servo_motor import SERVOS, STEADY_SHARE

AX18A, AX12A = SERVOS["ax18a"], SERVOS["ax12a"]
PINION = 29.6e-3
GLASS = {"BD": 34.90e-3, "Micro-Mate": 35.70e-3}
"""Inner diameters of glass syringes of 100 mL [m]."""


def drive(make: str = "BD", **words: float) -> ServoDrive:
    """A pump of that syringe, at 12 V if nothing else is said."""
    words = {"supply_voltage": 12.0, **words}
    return ServoDrive(ServoPumpSpec(syringe_diameter=GLASS[make], **words))


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
    found = drive(make).stall_pressure / 1e3
    assert found == pytest.approx(stall, abs=0.6)
    assert STEADY_SHARE * found == pytest.approx(steady, abs=0.1)
    force = 1.8 / 14.8e-3
    assert found * 1e3 == pytest.approx(force / (math.pi * GLASS[make] ** 2 / 4))


@pytest.mark.parametrize("make", GLASS)
def test_the_papers_140_kpa(make: str) -> None:
    """As gauge it is beyond the stall; as absolute, 38.7 kPa gauge, it takes a third."""
    stall = drive(make).stall_pressure
    assert 1.10 <= 140e3 / stall <= 1.155
    assert (140e3 - 101325.0) / stall == pytest.approx(0.31, abs=0.015)


def test_torque_balances_pressure_and_friction_in_both_directions() -> None:
    area = math.pi * GLASS["BD"] ** 2 / 4
    torque = drive(plunger_friction=5.0).torque(np.array([1e4, -1e4]), np.array([1.0, -1.0]))
    assert torque == pytest.approx(np.array([1, -1]) * (1e4 * area + 5.0) * 14.8e-3)


def test_speed_falls_along_a_straight_line_to_the_stall_and_not_below() -> None:
    pump = drive(supply_voltage=11.1)
    stall = pump.stall_load
    assert stall == pytest.approx(1.8 * 11.1 / 12)
    free = float(pump.speed_left(0.0))
    assert free == pytest.approx(AX18A.no_load_speed * 11.1 / 12 * 14.8e-3)
    force = stall / 14.8e-3
    assert float(pump.speed_left(force / 2)) == pytest.approx(free / 2)
    assert float(pump.speed_left(force)) == pytest.approx(0.0, abs=1e-12)
    assert float(pump.speed_left(2 * force)) == 0.0
    assert float(pump.speed_left(-1.0)) == free  # what helps makes it no faster


def test_largest_flow_and_finest_step() -> None:
    pump = drive()
    assert float(pump.speed_left(0.0)) * pump.area * 1e6 == pytest.approx(144, abs=1)
    assert 1e3 * pump.step == pytest.approx(0.07575, abs=1e-4)
    assert 1e6 * pump.volume_per_step == pytest.approx(0.0725, abs=2e-4)


def test_the_two_statements_of_a_count_agree() -> None:
    assert drive().step == pytest.approx(PINION / 2 * math.radians(300.0) / 1024)


def test_counts_for_a_pressure_of_a_closed_volume_of_gas() -> None:
    """100 mL at 140 kPa absolute: a tenth of a kPa for a count."""
    compliance = 100e-6 / 140e3
    assert 1e-3 * drive().volume_per_step / compliance == pytest.approx(0.10, abs=0.005)


def test_current_and_battery() -> None:
    pump = drive(battery_capacity=0.45 * 3600)
    assert float(pump.current(-1.8)) == pytest.approx(2.2)
    minutes = pump.battery_life(2 * 2.2) / 60
    assert minutes == pytest.approx(6.1, abs=0.1)  # two servos at stall
    assert pump.battery_life(0.0) == math.inf


def test_the_speed_register_is_never_zero() -> None:
    pump = drive()
    unit = 0.111 * 2 * math.pi / 60 * pump.radius
    assert pump.speed_step == pytest.approx(unit)
    assert pump.speed_register(0.0) == 1
    assert pump.speed_register(-0.4 * unit) == 1
    assert pump.speed_register(300 * unit) == 300
    assert pump.speed_register(300.1 * unit) == 301  # as a stream, which must not lag behind
    assert pump.speed_register(1e6 * pump.radius) == 1023
