"""What a plunger can do against what is required of it: one function per limit, and their table."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from viscodesign.pump.planning.limits import MARGINS, Assessment, Limits, cap, within
from viscodesign.pump.plunger import servo_limits as servo

if TYPE_CHECKING:
    from viscodesign.pump.plunger.plunger_demand import PlungerDemand


def travel(demand: PlungerDemand) -> Assessment:
    """Counts against the ends of travel."""
    (low, high), place = demand.pump.travel, 1e3 * demand.position
    volume = 1e6 * (high - low) * demand.drive.volume_per_count
    message = (
        f"needs counts {demand.count.min():.1f} to {demand.count.max():.1f}, a plunger from "
        f"{place.min():.3g} to {place.max():.3g} mm from home; travel is {low} to {high}, "
        f"{volume:.3g} mL"
    )
    return within(demand.count, low, high, "counts", message)


def barrel(demand: PlungerDemand) -> Assessment:
    """Plunger against the ends of the barrel, independent of the stated travel."""
    filled, stroke = demand.drive.filled_at_home, demand.pump.syringe_stroke
    left = 1e3 * (filled - demand.position)
    message = (
        f"{1e3 * filled:.4g} mm of the barrel of {1e3 * stroke:.4g} mm are filled at home; needs "
        f"{left.min():.4g} to {left.max():.4g} mm"
    )
    return within(demand.position, filled - stroke, filled, "m", message)


def suction(demand: PlungerDemand) -> Assessment:
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


def resolution(demand: PlungerDemand) -> Assessment:
    """Counts of the motion against the servo's own steps and the gear's play."""
    swing, play = float(np.ptp(demand.count)), demand.pump.gear_play
    allowed = MARGINS.fewest_steps + play
    message = (
        f"the motion spans {swing:.3g} counts of {1e6 * demand.drive.volume_per_count:.3g} mL; "
        f"at least {MARGINS.fewest_steps:g} are needed, and the gear loses {play:g}"
    )
    flat = float(np.ptp(demand.pressure)) < MARGINS.flat
    ratio = 0.0 if flat else allowed / max(swing, 1e-9)
    when = int(np.argmax(demand.count))
    return Assessment("infeasible", swing, allowed, "counts", ratio, when, message)


def pressure_step(demand: PlungerDemand) -> Assessment:
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


def sensor(demand: PlungerDemand) -> Assessment:
    """Swing of pressure against the sensor's error, and its step with 8 bit."""
    swing, allowed = float(np.ptp(demand.pressure)), MARGINS.sensor_accuracy
    message = f"the pressure swings by {swing / 1e3:.3g} kPa; the sensor is accurate to 5.7 kPa"
    if swing < MARGINS.sensor_step:
        message += f", and its 8 bit reading steps by {MARGINS.sensor_step / 1e3:g} kPa"
    ratio = 0.0 if swing < MARGINS.flat else allowed / swing
    return Assessment(
        "advice", swing, allowed, "Pa", ratio, int(np.argmax(demand.pressure)), message
    )


LIMITS: Limits = {
    limit.__name__: limit
    for limit in (
        servo.stall, servo.one_fifth, servo.speed, travel, barrel, suction, cap,
        servo.cap_torque, resolution, pressure_step, sensor, servo.speed_register,
        servo.battery, servo.voltage,
    )
}  # fmt: skip
