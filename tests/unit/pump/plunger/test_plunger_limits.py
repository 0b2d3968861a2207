"""Each limit against a course whose numbers are known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign.pump.kinds.servo import ServoDemand
from viscodesign.pump.planning.demand import FeedLine
from viscodesign.pump.planning.limits import infeasible, verdicts
from viscodesign.pump.planning.limits import verdict as held_against
from viscodesign.pump.planning.result import PumpVerdict

AMBIENT = 101325.0


def demand(pressure: list[float], *words: str, seconds: float = 1.0) -> ServoDemand:
    """A pump on nothing but its own barrel: what it asks is in closed form."""
    own = ", ".join(
        (
            "syringe_diameter: 34.9 mm",
            *(() if "supply_voltage" in str(words) else ("supply_voltage: 12 V",)),
            *words,
            *(() if "home" in str(words) else ("home: 500",)),
        )
    )
    scene = leg(f"pump={{{own}}}", config="leg_16_straight_air_auto")
    assert scene.pump is not None
    values = np.array(pressure)
    time = seconds * np.arange(len(values))
    return ServoDemand(scene, scene.pump, "inlet", FeedLine(), time, 0.0, values, 0 * values)


def verdict(name: str, *given: object, **more: float) -> PumpVerdict:
    return held_against(demand(*given, **more), name)  # type: ignore[arg-type]


def test_140_kpa_gauge_takes_more_than_the_stall() -> None:
    found = verdict("stall", [0, 140e3, 140e3], "plunger_friction: 0 N")
    assert found.severity == "infeasible"
    assert found.wanted / 1.8 == pytest.approx(1.10, abs=0.005)
    assert found.ratio == pytest.approx(1.10 / 0.8, abs=0.01)


def test_38_7_kpa_gauge_fits_but_is_above_the_makers_fifth() -> None:
    course = [0, 38675.0, 38675.0]
    assert verdict("stall", course).severity == "ok"
    advice = verdict("one_fifth", course, "plunger_friction: 0 N")
    assert advice.severity == "advice"
    assert advice.wanted / 1.8 == pytest.approx(0.304, abs=0.003)


def test_suction_pulls_as_hard_as_pressure_pushes() -> None:
    assert verdict("stall", [0, -100e3, 0], "plunger_friction: 0 N").wanted == pytest.approx(
        verdict("stall", [0, 100e3, 0], "plunger_friction: 0 N").wanted
    )


def test_speed_is_limited_by_the_torque_of_its_own_pressure() -> None:
    """Same way and time, twice: at rest pressure and under load less is left."""
    found = verdict("speed", [20e3, 22e3], "plunger_friction: 0 N")
    torque = 22e3 * np.pi * 0.0349**2 / 4 * 14.8e-3
    left = 97 * 2 * np.pi / 60 * (1 - torque / 1.8) * 14.8e-3
    assert found.allowed == pytest.approx(left)
    assert found.severity == "ok"
    fast = verdict("speed", [0, 30e3, 0], seconds=0.01)
    assert fast.severity == "infeasible"
    assert fast.ratio == pytest.approx(fast.wanted / fast.allowed)


def test_suction_is_limited_by_the_sensor() -> None:
    assert verdict("suction", [0, 20e3 - AMBIENT + 1]).severity == "ok"
    found = verdict("suction", [0, -100.9e3])
    assert found.severity == "infeasible"
    assert found.allowed == pytest.approx(20e3 - AMBIENT)


def test_a_cap_above_stall_never_acts() -> None:
    assert verdict("cap", [0, 26e3]).severity == "infeasible"
    assert verdict("cap", [0, 24e3]).severity == "ok"
    found = verdict("cap_torque", [0, 1e3], "max_pressure: 140 kPa gauge")
    assert found.severity == "advice"
    assert "38.67 kPa gauge" in found.message
    assert verdict("cap_torque", [0, 1e3], "max_pressure: 140 kPa abs").severity == "ok"


def test_a_cap_counts_the_friction_of_the_plunger() -> None:
    area = np.pi * 0.0349**2 / 4
    found = verdict("cap_torque", [0, 1e3], "plunger_friction: 80 N")
    assert found.wanted == pytest.approx((25e3 * area + 80.0) * 14.8e-3)
    assert found.severity == "advice"
    assert verdict("cap_torque", [0, 1e3], "plunger_friction: 0 N").severity == "ok"


def test_travel_and_barrel() -> None:
    assert verdict("travel", [0, 60e3], "home: 900").severity == "infeasible"
    assert verdict("barrel", [0, -40e3], "filled_length: 100 mm").severity == "infeasible"
    assert verdict("barrel", [0, 10e3]).severity == "ok"


def test_a_motion_of_few_counts_is_infeasible() -> None:
    small = verdict("resolution", [0, 300.0])
    assert small.severity == "infeasible"
    assert small.wanted < 7.0
    assert verdict("resolution", [0, 5e3]).severity == "ok"
    assert verdict("resolution", [0, 0, 0]).severity == "ok"  # nothing is asked


def test_a_plunger_beyond_its_barrel_makes_the_largest_steps() -> None:
    found = demand([0, 24e3], "filled_length: 5 mm", "home: 990")
    beyond = held_against(replace(found, stated_position=np.array([0.0, 0.02])), "pressure_step")
    inside = held_against(replace(found, stated_position=np.array([0.0, 0.004])), "pressure_step")
    assert beyond.wanted > inside.wanted > 0.0


def test_the_sensors_accuracy_and_its_step() -> None:
    assert verdict("sensor", [0, 6.1e3]).severity == "ok"
    assert "8 bit" not in verdict("sensor", [0, 5e3]).message
    assert "8 bit" in verdict("sensor", [0, 1.5e3]).message


def test_battery_life_follows_from_mean_current() -> None:
    found = verdict("battery", [100e3] * 5, "plunger_friction: 0 N")
    current = 2.2 * 100e3 * np.pi * 0.0349**2 / 4 * 14.8e-3 / 1.8
    assert found.wanted == pytest.approx(1620.0 / current)


def test_counts_may_decrease_as_the_plunger_goes_in() -> None:
    up = demand([0, 20e3], "travel: [100, 900]")
    down = demand([0, 20e3], "travel: [100, 900]", "push: down")
    assert down.steps - 500 == pytest.approx(500 - up.steps)


def test_every_limit_has_a_name_and_a_sentence() -> None:
    found = verdicts(demand([0, 10e3, 0]))
    assert [v.name for v in found] == list(ServoDemand.limits)
    assert all(v.message and np.isfinite(v.ratio) for v in found)
    assert not infeasible(demand([0, 10e3, 0]))


@pytest.mark.parametrize("volts", ["8.9 V", "12.1 V", "25.6 V", "230 V"])
def test_a_supply_outside_the_servos_range_is_infeasible(volts: str) -> None:
    found = held_against(demand([0, 10e3], f"supply_voltage: {volts}"), "voltage")
    assert found.severity == "infeasible"
    assert "AX-18A is made for 9 to 12 V" in found.message


def test_a_battery_that_does_not_last_to_the_end_is_infeasible() -> None:
    found = held_against(demand([0, 10e3, 10e3], "battery_capacity: 1e-6 A*h"), "battery")
    assert found.severity == "infeasible"
