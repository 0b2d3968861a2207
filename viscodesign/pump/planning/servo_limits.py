"""What the servo can do: torque, speed at its torque, supply."""

from __future__ import annotations

import numpy as np

from viscodesign.pump import syringe
from viscodesign.pump.planning.assessment import MARGINS, Assessment
from viscodesign.pump.planning.demand import PumpDemand
from viscodesign.pump.planning.result import Severity
from viscodesign.pump.planning.scene_variants import jumps
from viscodesign.pump.servo_motor import STEADY_SHARE


def stall(demand: PumpDemand) -> Assessment:
    """Torque against the servo's stall at the supply voltage."""
    allowed = MARGINS.stall_share * demand.stall_torque
    torque, when = _worst_torque(demand)
    message = (
        f"{demand.pressure[when] / 1e3:.4g} kPa gauge takes {torque:.3g} N m, "
        f"{100 * torque / demand.stall_torque:.0f} % of the stall torque at "
        f"{demand.pump.supply_voltage:g} V (stall at {demand.stall_pressure / 1e3:.4g} kPa gauge); "
        f"at most {100 * MARGINS.stall_share:.0f} % is allowed"
    )
    return Assessment("infeasible", torque, allowed, "N m", torque / allowed, when, message)


def one_fifth(demand: PumpDemand) -> Assessment:
    """Torque against the maker's advice."""
    allowed = STEADY_SHARE * demand.stall_torque
    torque, when = _worst_torque(demand)
    message = (
        f"{torque:.3g} N m; the maker promises steady motion up to a fifth of the stall torque, "
        f"{allowed:.3g} N m or {STEADY_SHARE * demand.stall_pressure / 1e3:.3g} kPa gauge"
    )
    return Assessment("advice", torque, allowed, "N m", torque / allowed, when, message)


def _worst_torque(demand: PumpDemand) -> tuple[float, int]:
    """The largest torque in size, moving or holding, and the index of its time."""
    size = np.abs(demand.end_torques)
    when = int(np.argmax(np.max(size, axis=0)))
    end = int(np.argmax(size[:, when]))
    return float(size[end, when]), when + end


def speed(demand: PumpDemand) -> Assessment:
    """Speed of the plunger against what the torque at its own pressure leaves."""
    when = int(np.argmax(demand.speed_share))
    ratio, wanted = float(demand.speed_share[when]), abs(float(demand.velocity[when]))
    allowed = float(demand.speed_left[when])
    message = (
        f"the plunger has to move at {1e3 * wanted:.3g} mm/s "
        f"({1e6 * demand.drive.area * wanted:.3g} mL/s), where "
        f"{demand.pressure[when] / 1e3:.3g} kPa gauge leaves the servo {1e3 * allowed:.3g} mm/s"
    )
    if ratio > 1.0 and _jumps(demand, when):
        lasting = 1e3 * float(np.diff(demand.time)[when])
        message += f"; the wanted pressure jumps there, here taken to last {lasting:.3g} ms"
    return Assessment("infeasible", wanted, allowed, "m/s", ratio, when, message)


def _jumps(demand: PumpDemand, when: int) -> bool:
    begin, end = demand.time[when : when + 2] - demand.lead_s
    return any(begin <= t + 1e-9 and t <= end + 1e-9 for t in jumps(demand.scene))


def cap_torque(demand: PumpDemand) -> Assessment:
    """The software's cap itself against the servo's stall: whether it ever acts."""
    pressure, allowed = demand.pump.max_pressure, MARGINS.stall_share * demand.stall_pressure
    message = (
        f"the cap of {pressure / 1e3:.4g} kPa gauge takes "
        f"{100 * pressure / demand.stall_pressure:.0f} % of the stall torque at "
        f"{demand.pump.supply_voltage:g} V"
    )
    if pressure > demand.stall_pressure:
        message += f": the servo stalls before, at {demand.stall_pressure / 1e3:.4g} kPa gauge"
    gauge = pressure - demand.scene.ambient_pressure
    if pressure > allowed and gauge > 0.0:
        message += (
            f"; {pressure / 1e3:.4g} kPa abs would be {gauge / 1e3:.4g} kPa gauge, "
            f"{100 * gauge / demand.stall_pressure:.0f} %"
        )
    return Assessment("advice", pressure, allowed, "Pa gauge", pressure / allowed, 0, message)


def battery(demand: PumpDemand) -> Assessment:
    """Mean current against the battery, for this pump alone."""
    current = syringe.servo_current(demand.servo, demand.torque)
    life = syringe.battery_life(demand.pump.battery_capacity, demand.mean_current)
    duration = float(np.ptp(demand.time))
    lasts = "without limit" if np.isinf(life) else f"{life / 60:.3g} min"
    message = (
        f"{1e3 * demand.mean_current:.3g} mA on average, {float(np.max(current)):.3g} A at most; "
        f"the battery of {demand.pump.battery_capacity / 3.6:.3g} mAh lasts {lasts} for this pump "
        "alone, electronics not counted"
    )
    shortest, when = max(MARGINS.short_life, duration), int(np.argmax(current))
    severity: Severity = "infeasible" if life < duration else "advice"
    return Assessment(severity, life, shortest, "s", shortest / life, when, message)


def voltage(demand: PumpDemand) -> Assessment:
    """The supply against what the servo is made for."""
    servo, given = demand.servo, demand.pump.supply_voltage
    low = given < servo.lowest_voltage
    allowed = servo.lowest_voltage if low else servo.rated_voltage
    ratio = allowed / given if low else given / allowed
    message = (
        f"{given:g} V; the {servo.title} is made for {servo.lowest_voltage:g} to "
        f"{servo.rated_voltage:g} V"
    )
    return Assessment("infeasible", given, allowed, "V", ratio, 0, message)
