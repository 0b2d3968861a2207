"""What a plunger can do against what is required of it, limit by limit, and what may help."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from viscodesign.pump.planning.limits import (
    CAP,
    HIGHER,
    LOWER,
    MARGINS,
    PRESSURE_LIMITS,
    SLOWER,
    Assessment,
    Fix,
    Limits,
    PumpLimit,
    Steps,
    jump_words,
    within,
)

if TYPE_CHECKING:
    from viscodesign.pump.plunger.plunger_demand import PlungerDemand

STALL_SHARE = 0.8
"""Share of the load at stall that may be asked: near it a drive creeps, heats, and gives up. No
data sheet draws this limit."""


def stall(demand: PlungerDemand) -> Assessment:
    """Load against the drive's stall."""
    drive, (load, when) = demand.drive, demand.worst_load
    allowed = STALL_SHARE * drive.stall_load
    message = (
        f"{demand.pressure[when] / 1e3:.4g} kPa gauge takes {load:.3g} {drive.load.unit}, "
        f"{100 * load / drive.stall_load:.0f} % of the {drive.stall_words} (stall at "
        f"{drive.stall_pressure / 1e3:.4g} kPa gauge without friction); "
        f"at most {100 * STALL_SHARE:.0f} % is allowed"
    )
    ratio = load / allowed
    return Assessment("infeasible", load, allowed, drive.load.unit, ratio, when, message)


def speed(demand: PlungerDemand) -> Assessment:
    """Speed of the plunger against what the load at its own pressure leaves."""
    when = int(np.argmax(demand.speed_share))
    ratio, wanted = float(demand.speed_share[when]), abs(float(demand.velocity[when]))
    allowed = float(demand.speed_left[when])
    message = (
        f"the plunger has to move at {1e3 * wanted:.3g} mm/s "
        f"({1e6 * demand.drive.area * wanted:.3g} mL/s), where "
        f"{demand.pressure[when] / 1e3:.3g} kPa gauge leaves the {demand.axis.noun} "
        f"{1e3 * allowed:.3g} mm/s"
    )
    message += jump_words(demand, when) if ratio > 1.0 else ""
    return Assessment("infeasible", wanted, allowed, "m/s", ratio, when, message)


def travel(demand: PlungerDemand) -> Assessment:
    """Steps against the ends of travel."""
    (low, high), place, unit = demand.pump.travel, 1e3 * demand.position, demand.axis.unit
    volume = 1e6 * (high - low) * demand.drive.volume_per_step
    message = (
        f"needs {unit} {demand.steps.min():.1f} to {demand.steps.max():.1f}, a plunger from "
        f"{place.min():.3g} to {place.max():.3g} mm from home; travel is {low} to {high}, "
        f"{volume:.3g} mL"
    )
    return within(demand.steps, low, high, unit, message)


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


def cap_stall(demand: PlungerDemand) -> Assessment:
    """The software's cap itself against the drive's stall: whether it ever acts."""
    drive, pressure = demand.drive, demand.pump.max_pressure
    load, allowed = demand.load_of(drive.force(pressure, 1.0)), STALL_SHARE * drive.stall_load
    message = (
        f"pushing at the cap of {pressure / 1e3:.4g} kPa gauge takes "
        f"{100 * load / drive.stall_load:.0f} % of the {drive.stall_words}"
    )
    if load > drive.stall_load:
        friction = demand.pump.plunger_friction / drive.area
        stalls = (drive.stall_pressure - friction) / 1e3
        message += f": the {demand.axis.noun} stalls earlier, at {stalls:.4g} kPa gauge"
    gauge = pressure - demand.scene.ambient_pressure
    if load > allowed and gauge > 0.0:
        share = demand.load_of(drive.force(gauge, 1.0)) / drive.stall_load
        message += (
            f"; {pressure / 1e3:.4g} kPa abs would be {gauge / 1e3:.4g} kPa gauge, "
            f"{100 * share:.0f} %"
        )
    return Assessment("advice", load, allowed, drive.load.unit, load / allowed, 0, message)


def resolution(demand: PlungerDemand) -> Assessment:
    """Steps of the motion against the drive's own and its play."""
    swing, play, unit = float(np.ptp(demand.steps)), demand.drive.play, demand.axis.unit
    allowed = MARGINS.min_steps + play
    message = (
        f"the motion spans {swing:.3g} {unit} of {1e6 * demand.drive.volume_per_step:.3g} mL; "
        f"at least {MARGINS.min_steps:g} are needed, and the gear loses {play:g}"
    )
    flat = float(np.ptp(demand.pressure)) < MARGINS.flat
    ratio = 0.0 if flat else allowed / max(swing, 1e-9)
    when = int(np.argmax(demand.steps))
    return Assessment("infeasible", swing, allowed, unit, ratio, when, message)


def pressure_step(demand: PlungerDemand) -> Assessment:
    """What one step does to the pressure before the actuator yields, against the swing."""
    drive = demand.drive
    step = drive.volume_per_step / demand.least_compliance
    swing = float(np.ptp(demand.pressure))
    message = (
        f"one {drive.step_name} changes the pressure by {step / 1e3:.3g} kPa at once "
        f"({1e3 / step:.3g} {demand.axis.unit} per kPa) where the barrel is stiffest; "
        f"the pressure swings by {swing / 1e3:.3g} kPa"
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


THINNER = Fix("pump.syringe_diameter", 5e-3, "a syringe of {:.4g} mm inner diameter", "mm", 1e-3)
WIDER = replace(THINNER, far=0.1)
CURED_BY_HOME = ("travel", "barrel")
HOME = Fix(
    "pump.home",
    0.0,
    "home at {:.0f}",
    whole=lambda pump: range(pump.travel[0], pump.travel[1] + 1),
    cures=CURED_BY_HOME,
)
PLUNGER_LIMITS: Limits = {
    "stall": PumpLimit(stall, (LOWER, THINNER)),
    "speed": PumpLimit(speed, (SLOWER, LOWER)),
    "travel": PumpLimit(travel, (HOME, LOWER, WIDER)),
    "barrel": PumpLimit(barrel, (HOME, LOWER, WIDER)),
    "suction": PumpLimit(suction, (LOWER,)),
    "cap": PRESSURE_LIMITS["cap"],
    "cap_stall": PumpLimit(cap_stall),
    "resolution": PumpLimit(resolution, (THINNER, HIGHER)),
    "pressure_step": PumpLimit(pressure_step, (THINNER,)),
    "sensor": PumpLimit(sensor),
}
PLUNGER_STEPWISE: Steps = (
    (LOWER, ("stall", "speed", "suction")),  # what another drive cures only at a price
    (HOME, CURED_BY_HOME),
    (LOWER, CURED_BY_HOME),
    (CAP, ("cap",)),
)
