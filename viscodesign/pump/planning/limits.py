"""What a pump can do, held against what is asked of it: one function a limit, and their table."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from viscodesign.pump.planning.demand import PumpDemand
from viscodesign.pump.planning.result import PumpVerdict, Severity
from viscodesign.pump.planning.scene_variants import jumps
from viscodesign.pump.servo_motor import SPEED_UNIT, STEADY_SHARE


@dataclass(frozen=True)
class LimitMargins:
    """Where limits are drawn that no data sheet draws."""

    stall_share: float = 0.8  # of the stall torque: near it a servo creeps, heats, switches off
    sensor_floor: float = 20e3  # the Phidgets 1140 reads no lower [Pa abs]
    sensor_accuracy: float = 6e3  # swing that its 1.5 % of full scale, 5.7 kPa, would hide [Pa]
    sensor_step: float = 1.61e3  # its reading at 8 bit, as the firmware for ROS takes it [Pa]
    fewest_counts: float = 5.0  # smallest motion, beside what the gear loses
    fine_steps: float = 20.0  # counts per swing of pressure, below which it is coarse
    short_life: float = 360.0  # battery life that is worth a word [s]
    coarse_speed: float = 5.0  # speed register below which even the fastest move goes in steps
    flat: float = 1.0  # swing of pressure below which nothing is asked [Pa]


MARGINS = LimitMargins()


class Assessment(NamedTuple):
    """What a limit says of a demand."""

    severity: Severity  # where the ratio is above 1
    wanted: float  # at the worst time, in the unit
    allowed: float
    unit: str
    ratio: float  # how much of what is allowed is asked
    when: int  # index of the worst time
    message: str


def stall(demand: PumpDemand) -> Assessment:
    """Torque against the servo's stall at the supply voltage."""
    drive, (torque, when) = demand.drive, _worst_torque(demand)
    allowed = MARGINS.stall_share * drive.stall_torque
    message = (
        f"{demand.pressure[when] / 1e3:.4g} kPa gauge takes {torque:.3g} N m, "
        f"{100 * torque / drive.stall_torque:.0f} % of the stall torque at "
        f"{demand.pump.supply_voltage:g} V (stall at {drive.stall_pressure / 1e3:.4g} kPa gauge); "
        f"at most {100 * MARGINS.stall_share:.0f} % is allowed"
    )
    return Assessment("infeasible", torque, allowed, "N m", torque / allowed, when, message)


def one_fifth(demand: PumpDemand) -> Assessment:
    """Torque against the maker's advice."""
    allowed = STEADY_SHARE * demand.drive.stall_torque
    torque, when = _worst_torque(demand)
    message = (
        f"{torque:.3g} N m; the maker promises steady motion up to a fifth of the stall torque, "
        f"{allowed:.3g} N m or {STEADY_SHARE * demand.drive.stall_pressure / 1e3:.3g} kPa gauge"
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
    begin, end = demand.time[when : when + 2] - demand.lead_s
    if ratio > 1.0 and any(begin - 1e-9 <= t <= end + 1e-9 for t in jumps(demand.scene)):
        lasting = 1e3 * float(end - begin)
        message += f"; the wanted pressure jumps there, here taken to last {lasting:.3g} ms"
    return Assessment("infeasible", wanted, allowed, "m/s", ratio, when, message)


def travel(demand: PumpDemand) -> Assessment:
    """Counts against the ends of travel."""
    (low, high), place = demand.pump.travel, 1e3 * demand.position
    volume = 1e6 * (high - low) * demand.drive.volume_per_count
    message = (
        f"needs counts {demand.count.min():.1f} to {demand.count.max():.1f}, a plunger from "
        f"{place.min():.3g} to {place.max():.3g} mm from home; travel is {low} to {high}, "
        f"{volume:.3g} mL"
    )
    return _within(demand.count, low, high, "counts", message)


def barrel(demand: PumpDemand) -> Assessment:
    """Plunger against the ends of the barrel, independent of the stated travel."""
    filled, stroke = demand.drive.filled_at_home, demand.pump.syringe_stroke
    left = 1e3 * (filled - demand.position)
    message = (
        f"{1e3 * filled:.4g} mm of the barrel of {1e3 * stroke:.4g} mm are filled at home; needs "
        f"{left.min():.4g} to {left.max():.4g} mm"
    )
    return _within(demand.position, filled - stroke, filled, "m", message)


def _within(values: np.ndarray, low: float, high: float, unit: str, message: str) -> Assessment:
    """Values against both ends of a range; by how much of its width they leave it."""
    beyond = np.maximum(values - high, low - values)
    when = int(np.argmax(beyond))
    worst, nearest = float(values[when]), high if values[when] > (low + high) / 2 else low
    ratio = 1.0 + float(beyond[when]) / (high - low)
    return Assessment("infeasible", worst, float(nearest), unit, ratio, when, message)


def suction(demand: PumpDemand) -> Assessment:
    """Lowest pressure against what the sensor reads, and a liquid boils at."""
    ambient, vapour = demand.scene.ambient_pressure, demand.scene.fluid.vapour_pressure or 0.0
    allowed = max(MARGINS.sensor_floor, vapour) - ambient
    when = int(np.argmin(demand.pressure))
    lowest = float(demand.pressure[when])
    message = (
        f"down to {lowest / 1e3:.4g} kPa gauge, {(lowest + ambient) / 1e3:.3g} kPa abs; the "
        f"sensor reads no lower than {MARGINS.sensor_floor / 1e3:g} kPa abs"
    )
    if vapour and lowest + ambient < 2 * vapour:
        message += f", and the liquid boils at {vapour / 1e3:.3g} kPa abs"
    ratio = max(0.0, lowest / allowed)
    return Assessment("infeasible", lowest, allowed, "Pa gauge", ratio, when, message)


def cap(demand: PumpDemand) -> Assessment:
    """Highest pressure against the software's cap."""
    allowed, when = demand.pump.max_pressure, int(np.argmax(demand.pressure))
    highest = float(demand.pressure[when])
    message = (
        f"up to {highest / 1e3:.4g} kPa gauge; pump.max_pressure allows {allowed / 1e3:.4g} kPa"
    )
    ratio = max(highest, 0.0) / allowed
    return Assessment("infeasible", highest, allowed, "Pa gauge", ratio, when, message)


def cap_torque(demand: PumpDemand) -> Assessment:
    """The software's cap itself against the servo's stall: whether it ever acts."""
    pressure, stalls = demand.pump.max_pressure, demand.drive.stall_pressure
    allowed = MARGINS.stall_share * stalls
    message = (
        f"the cap of {pressure / 1e3:.4g} kPa gauge takes {100 * pressure / stalls:.0f} % of the "
        f"stall torque at {demand.pump.supply_voltage:g} V"
    )
    if pressure > stalls:
        message += f": the servo stalls before, at {stalls / 1e3:.4g} kPa gauge"
    gauge = pressure - demand.scene.ambient_pressure
    if pressure > allowed and gauge > 0.0:
        message += (
            f"; {pressure / 1e3:.4g} kPa abs would be {gauge / 1e3:.4g} kPa gauge, "
            f"{100 * gauge / stalls:.0f} %"
        )
    return Assessment("advice", pressure, allowed, "Pa gauge", pressure / allowed, 0, message)


def resolution(demand: PumpDemand) -> Assessment:
    """Counts of the motion against the servo's own steps and the gear's play."""
    swing, play = float(np.ptp(demand.count)), demand.pump.gear_play
    allowed = MARGINS.fewest_counts + play
    message = (
        f"the motion spans {swing:.3g} counts of {1e6 * demand.drive.volume_per_count:.3g} mL; "
        f"at least {MARGINS.fewest_counts:g} are needed, and the gear loses {play:g}"
    )
    flat = float(np.ptp(demand.pressure)) < MARGINS.flat
    ratio = 0.0 if flat else allowed / max(swing, 1e-9)
    when = int(np.argmax(demand.count))
    return Assessment("infeasible", swing, allowed, "counts", ratio, when, message)


def pressure_step(demand: PumpDemand) -> Assessment:
    """What one count does to the pressure before the actuator yields, against the swing."""
    step = demand.drive.volume_per_count / demand.least_compliance
    swing = float(np.ptp(demand.pressure))
    message = (
        f"one count changes the pressure by {step / 1e3:.3g} kPa at once ({1e3 / step:.3g} counts "
        f"per kPa) where the barrel is stiffest; the pressure swings by {swing / 1e3:.3g} kPa"
    )
    ratio = 0.0 if swing < MARGINS.flat else MARGINS.fine_steps * step / swing
    when, allowed = int(np.argmax(demand.pressure)), swing / MARGINS.fine_steps
    return Assessment("advice", step, allowed, "Pa", ratio, when, message)


def sensor(demand: PumpDemand) -> Assessment:
    """Swing of pressure against the sensor's error, and its step with 8 bit."""
    swing, allowed = float(np.ptp(demand.pressure)), MARGINS.sensor_accuracy
    message = f"the pressure swings by {swing / 1e3:.3g} kPa; the sensor is accurate to 5.7 kPa"
    if swing < MARGINS.sensor_step:
        message += f", and its 8 bit reading steps by {MARGINS.sensor_step / 1e3:g} kPa"
    ratio = 0.0 if swing < MARGINS.flat else allowed / swing
    return Assessment(
        "advice", swing, allowed, "Pa", ratio, int(np.argmax(demand.pressure)), message
    )


def speed_register(demand: PumpDemand) -> Assessment:
    """Fastest move against the unit of the speed register."""
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


def battery(demand: PumpDemand) -> Assessment:
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


def voltage(demand: PumpDemand) -> Assessment:
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


LIMITS: dict[str, Callable[[PumpDemand], Assessment]] = {
    limit.__name__: limit
    for limit in (
        stall, one_fifth, speed, travel, barrel, suction, cap, cap_torque, resolution,
        pressure_step, sensor, speed_register, battery, voltage,
    )
}  # fmt: skip


def verdict(demand: PumpDemand, name: str) -> PumpVerdict:
    """One limit held against a demand."""
    severity, wanted, allowed, unit, ratio, when, message = LIMITS[name](demand)
    return PumpVerdict(
        name, demand.inlet, severity if ratio > 1.0 else "ok", wanted, allowed, unit,
        float(ratio), float(demand.time[when]), message,
    )  # fmt: skip


def verdicts(demand: PumpDemand) -> tuple[PumpVerdict, ...]:
    """All limits held against a demand."""
    return tuple(verdict(demand, name) for name in LIMITS)


def infeasible(demand: PumpDemand) -> tuple[str, ...]:
    """Names of the limits that forbid it."""
    return tuple(v.name for v in verdicts(demand) if v.severity == "infeasible")
