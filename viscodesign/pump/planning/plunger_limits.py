"""What rack and barrel can do: travel, stroke, and the finest step."""

from __future__ import annotations

import numpy as np

from viscodesign.pump import syringe
from viscodesign.pump.planning.assessment import EPS_COUNTS, FLAT_PA, MARGINS, Assessment
from viscodesign.pump.planning.demand import PumpDemand
from viscodesign.pump.servo_motor import SPEED_UNIT


def travel(demand: PumpDemand) -> Assessment:
    """Counts against the ends of travel."""
    low, high = demand.pump.travel
    counts, width = demand.count, float(high - low)
    beyond = np.maximum(counts - high, low - counts)
    when = int(np.argmax(beyond))
    message = (
        f"needs counts {counts.min():.1f} to {counts.max():.1f}, a plunger from "
        f"{1e3 * demand.position.min():.3g} to {1e3 * demand.position.max():.3g} mm from home; "
        f"travel is {low} to {high}, {1e6 * width * demand.drive.volume_per_count:.3g} mL"
    )
    nearest = float(high if counts[when] > (low + high) / 2 else low)
    ratio = 1.0 + float(beyond[when]) / width
    return Assessment("infeasible", float(counts[when]), nearest, "counts", ratio, when, message)


def barrel(demand: PumpDemand) -> Assessment:
    """Plunger against the ends of the barrel, independent of the stated travel."""
    filled, stroke = demand.drive.filled_at_home, demand.pump.syringe_stroke
    place = demand.position
    beyond = np.maximum(place - filled, filled - stroke - place)
    when = int(np.argmax(beyond))
    message = (
        f"{1e3 * filled:.4g} mm of the barrel of {1e3 * stroke:.4g} mm are filled at home; needs "
        f"{1e3 * (filled - place.max()):.4g} to {1e3 * (filled - place.min()):.4g} mm"
    )
    nearest = filled if place[when] > filled - stroke / 2 else filled - stroke
    ratio = 1.0 + float(beyond[when]) / stroke
    return Assessment("infeasible", float(place[when]), nearest, "m", ratio, when, message)


def resolution(demand: PumpDemand) -> Assessment:
    """Counts of the motion against the servo's own steps and the gear's play."""
    swing, needed = float(np.ptp(demand.count)), MARGINS.fewest_counts + demand.pump.gear_play
    message = (
        f"the motion spans {swing:.3g} counts of {1e6 * demand.drive.volume_per_count:.3g} mL; "
        f"at least {MARGINS.fewest_counts:g} are needed, and the gear loses "
        f"{demand.pump.gear_play:g}"
    )
    flat = float(np.ptp(demand.pressure)) < FLAT_PA
    ratio = 0.0 if flat else needed / max(swing, EPS_COUNTS)
    when = int(np.argmax(demand.count))
    return Assessment("infeasible", swing, needed, "counts", ratio, when, message)


def pressure_step(demand: PumpDemand) -> Assessment:
    """What one count does to the pressure before the actuator yields, against the swing."""
    step = demand.drive.volume_per_count / demand.least_compliance
    swing = float(np.ptp(demand.pressure))
    message = (
        f"one count changes the pressure by {step / 1e3:.3g} kPa at once ({1e3 / step:.3g} counts "
        f"per kPa) where the barrel is stiffest; the pressure swings by {swing / 1e3:.3g} kPa"
    )
    ratio = 0.0 if swing < FLAT_PA else MARGINS.fine_steps * step / swing
    when, allowed = int(np.argmax(demand.pressure)), swing / MARGINS.fine_steps
    return Assessment("advice", step, allowed, "Pa", ratio, when, message)


def speed_register(demand: PumpDemand) -> Assessment:
    """Fastest move against the unit of the speed register."""
    unit = SPEED_UNIT * demand.pump.pinion_diameter / 2
    when = int(np.argmax(np.abs(demand.velocity)))
    fastest = abs(float(demand.velocity[when]))
    register = syringe.speed_register(fastest / (demand.pump.pinion_diameter / 2))
    message = (
        f"the fastest move, {1e3 * fastest:.3g} mm/s, is {register} in the speed register, whose "
        f"unit is {1e3 * unit:.3g} mm/s ({1e6 * unit * demand.drive.area:.3g} mL/s)"
    )
    allowed = MARGINS.coarse_speed * unit
    ratio = allowed / fastest if np.any(demand.direction) else 0.0
    return Assessment("advice", fastest, allowed, "m/s", ratio, when, message)
