"""What the servo can do: torque, speed at its torque, supply."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.planning.limits import Assessment, jump_words
from viscodesign.pump.planning.result import Severity
from viscodesign.scene.pumps.servo_motor import SPEED_UNIT, STEADY_SHARE

if TYPE_CHECKING:
    from viscodesign.pump.plunger.plunger_demand import PlungerDemand


@dataclass(frozen=True)
class ServoMargins:
    """Where limits of a servo are drawn that no data sheet draws."""

    stall_share: float = 0.8  # of the stall torque: near it a servo creeps, heats, switches off
    short_life: float = 360.0  # battery life that is worth a word [s]
    coarse_speed: float = 5.0  # speed register below which even the fastest move goes in steps


MARGINS = ServoMargins()


def stall(demand: PlungerDemand) -> Assessment:
    """Torque against the servo's stall at the supply voltage."""
    drive, (torque, when) = demand.drive, _worst_torque(demand)
    allowed = MARGINS.stall_share * drive.stall_torque
    message = (
        f"{demand.pressure[when] / 1e3:.4g} kPa gauge takes {torque:.3g} N m, "
        f"{100 * torque / drive.stall_torque:.0f} % of the stall torque at "
        f"{demand.pump.supply_voltage:g} V (stall at "
        f"{drive.stall_pressure / 1e3:.4g} kPa gauge without friction); "
        f"at most {100 * MARGINS.stall_share:.0f} % is allowed"
    )
    return Assessment("infeasible", torque, allowed, "N m", torque / allowed, when, message)


def one_fifth(demand: PlungerDemand) -> Assessment:
    """Torque against the manufacturer's advice."""
    allowed = STEADY_SHARE * demand.drive.stall_torque
    torque, when = _worst_torque(demand)
    pressure = STEADY_SHARE * demand.drive.stall_pressure
    message = (
        f"{torque:.3g} N m; the manufacturer specifies steady motion up to a fifth of the stall "
        f"torque, {allowed:.3g} N m or {pressure / 1e3:.3g} kPa gauge without friction"
    )
    return Assessment("advice", torque, allowed, "N m", torque / allowed, when, message)


def _worst_torque(demand: PlungerDemand) -> tuple[float, int]:
    """The largest torque in size, moving or holding, and the index of its time."""
    size = np.abs(demand.end_torques)
    when = int(np.argmax(np.max(size, axis=0)))
    end = int(np.argmax(size[:, when]))
    return float(size[end, when]), when + end


def speed(demand: PlungerDemand) -> Assessment:
    """Speed of the plunger against what the torque at its own pressure leaves."""
    when = int(np.argmax(demand.speed_share))
    ratio, wanted = float(demand.speed_share[when]), abs(float(demand.velocity[when]))
    allowed = float(demand.speed_left[when])
    message = (
        f"the plunger has to move at {1e3 * wanted:.3g} mm/s "
        f"({1e6 * demand.drive.area * wanted:.3g} mL/s), where "
        f"{demand.pressure[when] / 1e3:.3g} kPa gauge leaves the servo {1e3 * allowed:.3g} mm/s"
    )
    message += jump_words(demand, when) if ratio > 1.0 else ""
    return Assessment("infeasible", wanted, allowed, "m/s", ratio, when, message)


def cap_torque(demand: PlungerDemand) -> Assessment:
    """The software's cap itself against the servo's stall: whether it ever acts."""
    drive, pressure = demand.drive, demand.pump.max_pressure
    torque, allowed = drive.torque(pressure, 1.0), MARGINS.stall_share * drive.stall_torque
    message = (
        f"pushing at the cap of {pressure / 1e3:.4g} kPa gauge takes "
        f"{100 * torque / drive.stall_torque:.0f} % of the stall torque at "
        f"{demand.pump.supply_voltage:g} V"
    )
    if torque > drive.stall_torque:
        friction = demand.pump.plunger_friction / drive.area
        stalls = (drive.stall_pressure - friction) / 1e3
        message += f": the servo stalls earlier, at {stalls:.4g} kPa gauge"
    gauge = pressure - demand.scene.ambient_pressure
    if torque > allowed and gauge > 0.0:
        share = drive.torque(gauge, 1.0) / drive.stall_torque
        message += (
            f"; {pressure / 1e3:.4g} kPa abs would be {gauge / 1e3:.4g} kPa gauge, "
            f"{100 * share:.0f} %"
        )
    return Assessment("advice", torque, allowed, "N m", torque / allowed, 0, message)


def speed_register(demand: PlungerDemand) -> Assessment:
    """Assess the fastest move relative to the resolution of the speed register."""
    drive, unit = demand.drive, SPEED_UNIT * demand.drive.radius
    when = int(np.argmax(np.abs(demand.velocity)))
    fastest = abs(float(demand.velocity[when]))
    message = (
        f"the fastest move, {1e3 * fastest:.3g} mm/s, is {drive.speed_register(fastest)} in the "
        f"speed register, whose unit is {1e3 * unit:.3g} mm/s ({1e6 * unit * drive.area:.3g} mL/s)"
    )
    allowed = MARGINS.coarse_speed * unit
    ratio = allowed / fastest if np.any(demand.direction) else 0.0
    return Assessment("advice", fastest, allowed, "m/s", ratio, when, message)


def battery(demand: PlungerDemand) -> Assessment:
    """Mean current against the battery, for this pump alone."""
    current, mean = demand.drive.current(demand.torque), demand.mean_current
    life, duration = demand.drive.battery_life(mean), float(np.ptp(demand.time))
    lasts = "without limit" if np.isinf(life) else f"{life / 60:.3g} min"
    message = (
        f"{1e3 * mean:.3g} mA on average, {float(np.max(current)):.3g} A at most; the battery of "
        f"{demand.pump.battery_capacity / 3.6:.3g} mAh lasts {lasts} for this pump alone, "
        "electronics not counted"
    )
    shortest, when = max(MARGINS.short_life, duration), int(np.argmax(current))
    severity: Severity = "infeasible" if life < duration else "advice"
    return Assessment(severity, life, shortest, "s", shortest / life, when, message)


def voltage(demand: PlungerDemand) -> Assessment:
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
