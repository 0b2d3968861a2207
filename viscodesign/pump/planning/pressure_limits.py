"""Which pressures may be made, and which the sensor can tell apart."""

from __future__ import annotations

import numpy as np

from viscodesign.pump.planning.assessment import FLAT_PA, MARGINS, Assessment
from viscodesign.pump.planning.demand import PumpDemand


def suction(demand: PumpDemand) -> Assessment:
    """Lowest pressure against what the sensor reads, and a liquid boils at."""
    ambient, vapour = demand.scene.ambient_pressure, demand.scene.fluid.vapour_pressure or 0.0
    floor = max(MARGINS.sensor_floor, vapour)
    when = int(np.argmin(demand.pressure))
    lowest = float(demand.pressure[when]) + ambient
    message = (
        f"down to {demand.pressure[when] / 1e3:.4g} kPa gauge, {lowest / 1e3:.3g} kPa abs; the "
        f"sensor reads no lower than {MARGINS.sensor_floor / 1e3:g} kPa abs"
    )
    if vapour and lowest < 2 * vapour:
        message += f", and the liquid boils at {vapour / 1e3:.3g} kPa abs"
    # Depth below the ambient, over the depth that is allowed.
    ratio = max(ambient - lowest, 0.0) / (ambient - floor)
    wanted, allowed = lowest - ambient, floor - ambient
    return Assessment("infeasible", wanted, allowed, "Pa gauge", ratio, when, message)


def cap(demand: PumpDemand) -> Assessment:
    """Highest pressure against the software's cap."""
    allowed, when = demand.pump.max_pressure, int(np.argmax(demand.pressure))
    highest = float(demand.pressure[when])
    message = (
        f"up to {highest / 1e3:.4g} kPa gauge; pump.max_pressure allows {allowed / 1e3:.4g} kPa"
    )
    ratio = max(highest, 0.0) / allowed
    return Assessment("infeasible", highest, allowed, "Pa gauge", ratio, when, message)


def sensor(demand: PumpDemand) -> Assessment:
    """Swing of pressure against the sensor's error, and its step with 8 bit."""
    swing, allowed = float(np.ptp(demand.pressure)), MARGINS.sensor_accuracy
    message = f"the pressure swings by {swing / 1e3:.3g} kPa; the sensor is accurate to 5.7 kPa"
    if swing < MARGINS.sensor_step:
        message += f", and its 8 bit reading steps by {MARGINS.sensor_step / 1e3:g} kPa"
    ratio = 0.0 if swing < FLAT_PA else allowed / swing
    when = int(np.argmax(demand.pressure))
    return Assessment("advice", swing, allowed, "Pa", ratio, when, message)
