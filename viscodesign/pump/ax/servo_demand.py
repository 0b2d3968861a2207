"""What a plan asks of an AX servo and its plunger, and what it is limited by.

Besides what limits any plunger: the maker's advice, speed steps and supply.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.ax.servo_drive import ServoDrive
from viscodesign.pump.ax.servo_pump import axis_limits
from viscodesign.pump.planning.limits import LOWER, Assessment, Fix, Limits, PumpLimit
from viscodesign.pump.planning.result import Severity
from viscodesign.pump.play.axis import AxisLimits
from viscodesign.pump.plunger.plunger_demand import PlungerDemand
from viscodesign.pump.plunger.plunger_limits import PLUNGER_LIMITS, THINNER
from viscodesign.scene.pumps.servo import ServoPumpSpec
from viscodesign.scene.pumps.servo_motor import SERVOS, STEADY_SHARE
from viscodesign.scene.scene import Scene
from viscodesign.storage.cached_property import cached_property


@dataclass(frozen=True)
class ServoMargins:
    """Where limits of a servo are drawn that no data sheet draws."""

    short_life: float = 360.0  # battery life that is worth a word [s]
    coarse_speed: float = 5.0  # speed register below which even the fastest move goes in steps


SERVO_MARGINS = ServoMargins()


def one_fifth(demand: AxDemand) -> Assessment:
    """Torque against the manufacturer's advice."""
    allowed = STEADY_SHARE * demand.drive.stall_load
    torque, when = demand.worst_load
    pressure = STEADY_SHARE * demand.drive.stall_pressure
    message = (
        f"{torque:.3g} N m; the manufacturer specifies steady motion up to a fifth of the stall "
        f"torque, {allowed:.3g} N m or {pressure / 1e3:.3g} kPa gauge without friction"
    )
    return Assessment("advice", torque, allowed, "N m", torque / allowed, when, message)


def speed_register(demand: AxDemand) -> Assessment:
    """Assess the fastest move relative to the resolution of the speed register."""
    drive = demand.drive
    when = int(np.argmax(np.abs(demand.velocity)))
    fastest, unit = abs(float(demand.velocity[when])), drive.speed_step
    message = (
        f"the fastest move, {1e3 * fastest:.3g} mm/s, is {drive.speed_register(fastest)} in the "
        f"speed register, whose unit is {1e3 * unit:.3g} mm/s ({1e6 * unit * drive.area:.3g} mL/s)"
    )
    allowed = SERVO_MARGINS.coarse_speed * unit
    ratio = allowed / fastest if np.any(demand.direction) else 0.0
    return Assessment("advice", fastest, allowed, "m/s", ratio, when, message)


def battery(demand: AxDemand) -> Assessment:
    """Mean current against the battery, for this pump alone."""
    current, mean = demand.drive.current(demand.load), demand.mean_current
    life, duration = demand.drive.battery_life(mean), float(np.ptp(demand.time))
    lasts = "without limit" if np.isinf(life) else f"{life / 60:.3g} min"
    message = (
        f"{1e3 * mean:.3g} mA on average, {float(np.max(current)):.3g} A at most; the battery of "
        f"{demand.pump.battery_capacity / 3.6:.3g} mAh lasts {lasts} for this pump alone, "
        "electronics not counted"
    )
    shortest, when = max(SERVO_MARGINS.short_life, duration), int(np.argmax(current))
    severity: Severity = "infeasible" if life < duration else "advice"
    return Assessment(severity, life, shortest, "s", shortest / life, when, message)


def voltage(demand: AxDemand) -> Assessment:
    """The supply against what the servo is made for."""
    servo, given = demand.drive.servo, demand.pump.supply_voltage
    low = given < servo.lowest_voltage
    allowed = servo.lowest_voltage if low else servo.rated_voltage
    ratio = allowed / given if low else given / allowed
    message = (
        f"{given:g} V; the {servo.title} is made for {servo.lowest_voltage:g} to "
        f"{servo.rated_voltage:g} V"
    )
    return Assessment("infeasible", given, allowed, "V", ratio, 0, message)


RATED = min(servo.rated_voltage for servo in SERVOS.values())
VOLTAGE = Fix("pump.supply_voltage", RATED, "a supply of {:.4g} V", "V")
OWN_NAMES = {"cap_stall": "cap_torque"}
CURED_BY_VOLTAGE = ("stall", "speed")
_PLUNGER = {
    OWN_NAMES.get(name, name): PumpLimit(
        limit.assess, (*limit.fixes, VOLTAGE) if name in CURED_BY_VOLTAGE else limit.fixes
    )
    for name, limit in PLUNGER_LIMITS.items()
}
LIMITS: Limits = {
    "stall": _PLUNGER["stall"],
    "one_fifth": PumpLimit(one_fifth, (LOWER, THINNER, VOLTAGE)),
    **_PLUNGER,
    "speed_register": PumpLimit(speed_register, (THINNER,)),
    "battery": PumpLimit(battery),
    "voltage": PumpLimit(voltage),
}


@dataclass(frozen=True)
class AxDemand(PlungerDemand):
    """One inlet's plunger and servo over T times; a step is a count."""

    limits = LIMITS
    stall_marks = (("a fifth: advice", 20.0), *PlungerDemand.stall_marks)

    pump: ServoPumpSpec

    @classmethod
    def drive_of(cls, pump: ServoPumpSpec) -> ServoDrive:
        return ServoDrive(pump)

    @cached_property
    def drive(self) -> ServoDrive:
        return self.drive_of(self.pump)

    @cached_property
    def axis(self) -> AxisLimits:
        return axis_limits(self.pump)

    @property
    def device(self) -> str:
        return self.drive.servo.title

    @classmethod
    def faults(cls, scene: Scene) -> Iterator[tuple[str, str]]:
        pump, inlets = scene.pump, list(scene.inputs)
        assert isinstance(pump, ServoPumpSpec), "a servo's section"
        if isinstance(pump.servo_id, int) and len(inlets) > 1:
            ids = ", ".join(f"{name}: {k}" for k, name in enumerate(inlets, start=1))
            yield (
                "pump.servo_id",
                f"{pump.servo_id} is one servo for {len(inlets)} inlets; give each its own, like "
                f"{{{ids}}}",
            )
        yield from super().faults(scene)

    @property
    def mean_current(self) -> float:
        """Current of the servo, averaged over the whole motion [A]."""
        current = self.drive.current(self.load)
        return float(np.trapezoid(current, self.time)) / float(np.ptp(self.time))

    def numbers(self) -> dict[str, float]:
        n, drive = super().numbers(), self.drive
        return {
            **n,
            "steady_pressure_pa_gauge": STEADY_SHARE * drive.stall_pressure,
            "largest_current_a": float(drive.current(n["largest_torque_nm"])),
            "mean_current_a": self.mean_current,
            "fastest_speed_register": float(
                drive.speed_register(float(np.max(np.abs(self.velocity))))
            ),
        }

    def words(self) -> dict[str, str]:
        words, n = super().words(), self.numbers()
        words["stall"] += f"; a fifth of it is {n['steady_pressure_pa_gauge'] / 1e3:.3g} kPa"
        words["needs"] += f", {n['largest_current_a']:.3g} A"
        return words

    @classmethod
    def limit_numbers(cls, demands: Sequence[Any]) -> dict[str, float]:
        drive = demands[0].drive
        return {
            "fifth_nm": STEADY_SHARE * drive.stall_load,
            **super().limit_numbers(demands),
            "battery_life_s": drive.battery_life(sum(d.mean_current for d in demands)),
        }
