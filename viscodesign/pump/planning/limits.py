"""What a pump can do, held against what is asked of it at each pressure of its own.

Each limit is one small function from a demand to a verdict; the list of them is all that
anything else needs to know.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from viscodesign.pump import syringe as syringe_pump
from viscodesign.pump.planning.demand import Demand
from viscodesign.pump.planning.result import PumpVerdict, Severity
from viscodesign.pump.planning.scene_variants import jumps
from viscodesign.pump.servo_motor import SPEED_UNIT, STEADY_SHARE

STALL_SHARE = 0.8
"""Part of the stall torque above which a plan is refused: our margin, since near its stall a
servo creeps, heats and switches off."""
SENSOR_FLOOR = 20e3
"""Absolute [Pa]; the Phidgets 1140 reads no lower."""
SENSOR_ACCURACY = 6e3
"""Amplitude below which the sensor's 1.5 % of full scale, 5.7 kPa, hides a course [Pa]."""
SENSOR_STEP = 1.61e3
"""One count of the sensor where it is read with 8 bit, as the ROS firmware does [Pa]."""
FEWEST_COUNTS = 5.0
"""Amplitude in counts below which a course is none, beside the servo's own margin of one."""
FINE_STEPS = 20.0
"""Counts that a swing of pressure should have, taken at once: below, it comes in steps."""
SHORT_LIFE = 360.0
"""Battery life that is worth a word [s]."""
STEPPING = 5.0
"""Units of the speed register below which the fastest move is told to go in steps."""

Judge = Callable[[Demand], PumpVerdict]


def verdicts(demand: Demand) -> tuple[PumpVerdict, ...]:
    """All verdicts of one inlet."""
    return tuple(judge(demand) for judge in JUDGES)


def is_passed(demand: Demand, name: str) -> bool:
    """Whether a demand passes the limit of a name."""
    return JUDGE_OF[name](demand).severity == "ok"


def infeasible(demand: Demand) -> tuple[str, ...]:
    """Names of the limits that forbid it."""
    return tuple(v.name for v in verdicts(demand) if v.severity == "infeasible")


def _verdict(
    demand: Demand,
    name: str,
    severity: Severity,
    wanted: float,
    allowed: float,
    unit: str,
    ratio: float,
    when: int,
    message: str,
) -> PumpVerdict:
    """A verdict that is `severity` where the ratio is above 1."""
    told: Severity = severity if ratio > 1.0 else "ok"
    time = float(demand.time[when])
    return PumpVerdict(name, demand.inlet, told, wanted, allowed, unit, float(ratio), time, message)


def stall(demand: Demand) -> PumpVerdict:
    """Torque against the servo's stall at the battery's voltage."""
    allowed = STALL_SHARE * demand.stall_torque
    torque, when = _worst_torque(demand)
    share = torque / demand.stall_torque
    message = (
        f"{demand.pressure[when] / 1e3:.4g} kPa gauge takes {torque:.3g} N m, {100 * share:.0f} % "
        f"of the stall torque at {demand.pump.supply_voltage:g} V (stall at "
        f"{demand.stall_pressure / 1e3:.4g} kPa gauge); up to {100 * STALL_SHARE:.0f} % is let pass"
    )
    return _verdict(
        demand, "stall", "infeasible", torque, allowed, "N m", torque / allowed, when, message
    )


def one_fifth(demand: Demand) -> PumpVerdict:
    """Torque against the maker's advice."""
    allowed = STEADY_SHARE * demand.stall_torque
    torque, when = _worst_torque(demand)
    message = (
        f"{torque:.3g} N m; the maker promises steady motion up to a fifth of the stall torque, "
        f"{allowed:.3g} N m or {STEADY_SHARE * demand.stall_pressure / 1e3:.3g} kPa gauge"
    )
    return _verdict(
        demand, "one_fifth", "advice", torque, allowed, "N m", torque / allowed, when, message
    )


def _worst_torque(demand: Demand) -> tuple[float, int]:
    """The largest torque in size, while moving or holding, and where."""
    moving = np.max(np.abs(demand.end_torques), axis=0)
    when = int(np.argmax(moving))
    end = int(np.argmax(np.abs(demand.end_torques[:, when])))
    return float(moving[when]), when + end


def speed(demand: Demand) -> PumpVerdict:
    """Speed of the plunger against what the torque at its own pressure leaves."""
    when = int(np.argmax(demand.speed_share))
    ratio, wanted = float(demand.speed_share[when]), abs(float(demand.velocity[when]))
    allowed, step = float(demand.speed_left[when]), float(np.diff(demand.time)[when])
    message = (
        f"the plunger is to move at {1e3 * wanted:.3g} mm/s "
        f"({1e6 * demand.drive.area * wanted:.3g} mL/s) where "
        f"{demand.pressure[when] / 1e3:.3g} kPa gauge leaves the servo {1e3 * allowed:.3g} mm/s"
    )
    if ratio > 1.0 and _jumps(demand, when):
        message += f"; the wanted pressure jumps there, here taken to last {1e3 * step:.3g} ms"
    return _verdict(demand, "speed", "infeasible", wanted, allowed, "m/s", ratio, when, message)


def _jumps(demand: Demand, when: int) -> bool:
    begin, end = demand.time[when : when + 2] - demand.lead_s
    return any(begin <= t + 1e-9 and t <= end + 1e-9 for t in jumps(demand.scene))


def travel(demand: Demand) -> PumpVerdict:
    """Counts against the ends of travel."""
    low, high = demand.pump.travel
    counts = demand.count
    beyond = np.maximum(counts - high, low - counts)
    when = int(np.argmax(beyond))
    width = float(high - low)
    ratio = 1.0 + float(beyond[when]) / width
    message = (
        f"counts {counts.min():.1f} to {counts.max():.1f} are wanted, a plunger from "
        f"{1e3 * demand.position.min():.3g} to {1e3 * demand.position.max():.3g} mm from home; "
        f"travel is {low} to {high}, {1e6 * width * demand.drive.volume_per_count:.3g} mL"
    )
    near = float(high if counts[when] > (low + high) / 2 else low)
    return _verdict(
        demand, "travel", "infeasible", float(counts[when]), near, "counts", ratio, when, message
    )


def barrel(demand: Demand) -> PumpVerdict:
    """Plunger against the ends of the barrel, whatever travel says."""
    filled, stroke = demand.drive.filled_at_home, demand.pump.syringe_stroke
    place = demand.position
    beyond = np.maximum(place - filled, filled - stroke - place)
    when = int(np.argmax(beyond))
    message = (
        f"{1e3 * filled:.4g} mm of the barrel of {1e3 * stroke:.4g} mm are filled at home; between "
        f"{1e3 * (filled - place.max()):.4g} and {1e3 * (filled - place.min()):.4g} mm are wanted"
    )
    ratio = 1.0 + float(beyond[when]) / stroke
    nearest = filled if place[when] > filled - stroke / 2 else filled - stroke
    return _verdict(
        demand, "barrel", "infeasible", float(place[when]), nearest, "m", ratio, when, message
    )


def suction(demand: Demand) -> PumpVerdict:
    """Lowest pressure against what the sensor reads, and a liquid boils at."""
    ambient, vapour = demand.scene.ambient_pressure, demand.scene.fluid.vapour_pressure or 0.0
    floor = max(SENSOR_FLOOR, vapour)
    when = int(np.argmin(demand.pressure))
    lowest = float(demand.pressure[when]) + ambient
    message = (
        f"down to {demand.pressure[when] / 1e3:.4g} kPa gauge, {lowest / 1e3:.3g} kPa abs; the "
        f"sensor reads no lower than {SENSOR_FLOOR / 1e3:g} kPa abs"
    )
    if vapour and lowest < 2 * vapour:
        message += f", and the liquid boils at {vapour / 1e3:.3g} kPa abs"
    # Depth below the ambient, over the depth that is allowed.
    ratio = max(ambient - lowest, 0.0) / (ambient - floor)
    return _verdict(
        demand,
        "suction",
        "infeasible",
        lowest - ambient,
        floor - ambient,
        "Pa gauge",
        ratio,
        when,
        message,
    )


def cap(demand: Demand) -> PumpVerdict:
    """Highest pressure against the software's cap."""
    allowed, when = demand.pump.max_pressure, int(np.argmax(demand.pressure))
    highest = float(demand.pressure[when])
    message = (
        f"up to {highest / 1e3:.4g} kPa gauge; pump.max_pressure allows {allowed / 1e3:.4g} kPa"
    )
    ratio = max(highest, 0.0) / allowed
    return _verdict(demand, "cap", "infeasible", highest, allowed, "Pa gauge", ratio, when, message)


def cap_torque(demand: Demand) -> PumpVerdict:
    """The software's cap itself against the servo's stall: whether it ever acts."""
    pressure, allowed = demand.pump.max_pressure, STALL_SHARE * demand.stall_pressure
    message = (
        f"the cap of {pressure / 1e3:.4g} kPa gauge takes "
        f"{100 * pressure / demand.stall_pressure:.0f} % of the stall torque at "
        f"{demand.pump.supply_voltage:g} V"
    )
    if pressure > demand.stall_pressure:
        message += f": the servo stalls before, at {demand.stall_pressure / 1e3:.4g} kPa gauge"
    above = pressure - demand.scene.ambient_pressure
    if pressure > allowed and above > 0.0:
        message += (
            f"; {pressure / 1e3:.4g} kPa abs would be {above / 1e3:.4g} kPa gauge, "
            f"{100 * above / demand.stall_pressure:.0f} %"
        )
    ratio = pressure / allowed
    return _verdict(
        demand, "cap_torque", "advice", pressure, allowed, "Pa gauge", ratio, 0, message
    )


def resolution(demand: Demand) -> PumpVerdict:
    """Counts of the course against the servo's own steps and the gear's play."""
    swing, needed = float(np.ptp(demand.count)), FEWEST_COUNTS + demand.pump.gear_play
    message = (
        f"the course spans {swing:.3g} counts of {1e6 * demand.drive.volume_per_count:.3g} mL; "
        f"below {FEWEST_COUNTS:g}, and {demand.pump.gear_play:g} lost in the gear, it is none"
    )
    still = float(np.ptp(demand.pressure)) < 1.0
    ratio = 0.0 if still else needed / max(swing, 1e-9)
    when = int(np.argmax(demand.count))
    return _verdict(
        demand, "resolution", "infeasible", swing, needed, "counts", ratio, when, message
    )


def pressure_step(demand: Demand) -> PumpVerdict:
    """What one count does to the pressure before the actuator takes any, against the swing."""
    barrel, volume = demand.barrel, demand.drive.volume_per_count
    stiff = np.array([barrel.compliance(p, x) for p, x in demand.extremes])
    step = volume / float(np.min(stiff))
    swing = float(np.ptp(demand.pressure))
    message = (
        f"one count makes {step / 1e3:.3g} kPa at once, {1e3 / step:.3g} counts for a kPa, where "
        f"the barrel is stiffest; the pressure swings by {swing / 1e3:.3g} kPa"
    )
    ratio = 0.0 if swing < 1.0 else FINE_STEPS * step / swing
    when = int(np.argmax(demand.pressure))
    return _verdict(
        demand, "pressure_step", "advice", step, swing / FINE_STEPS, "Pa", ratio, when, message
    )


def sensor(demand: Demand) -> PumpVerdict:
    """Swing of pressure against the sensor's error, and its step with 8 bit."""
    swing = float(np.ptp(demand.pressure))
    message = f"the pressure swings by {swing / 1e3:.3g} kPa; the sensor is sure to 5.7 kPa"
    if swing < SENSOR_STEP:
        message += f", and one count of the 8 bit reading is {SENSOR_STEP / 1e3:g} kPa"
    ratio = 0.0 if swing < 1.0 else SENSOR_ACCURACY / swing
    when = int(np.argmax(demand.pressure))
    return _verdict(demand, "sensor", "advice", swing, SENSOR_ACCURACY, "Pa", ratio, when, message)


def speed_register(demand: Demand) -> PumpVerdict:
    """Fastest move against the unit of the speed register."""
    unit = SPEED_UNIT * demand.pump.pinion_diameter / 2
    when = int(np.argmax(np.abs(demand.velocity)))
    fastest = abs(float(demand.velocity[when]))
    register = syringe_pump.speed_register(fastest / (demand.pump.pinion_diameter / 2))
    message = (
        f"the fastest move, {1e3 * fastest:.3g} mm/s, is {register} in the speed register, whose "
        f"unit is {1e3 * unit:.3g} mm/s ({1e6 * unit * demand.drive.area:.3g} mL/s)"
    )
    ratio = 0.0 if not np.any(demand.direction) else STEPPING * unit / fastest
    return _verdict(
        demand, "speed_register", "advice", fastest, STEPPING * unit, "m/s", ratio, when, message
    )


def battery(demand: Demand) -> PumpVerdict:
    """Mean current against the battery, this pump alone."""
    current = syringe_pump.servo_current(demand.servo, demand.torque)
    mean = float(np.trapezoid(current, demand.time)) / float(np.ptp(demand.time))
    life = syringe_pump.battery_life(demand.pump.battery_capacity, mean)
    message = (
        f"{1e3 * mean:.3g} mA in the mean, {float(np.max(current)):.3g} A at most; the battery "
        f"of {demand.pump.battery_capacity / 3.6:.3g} mAh lasts "
        + ("for ever" if np.isinf(life) else f"{life / 60:.3g} min")
        + " for this pump alone, its electronics left out"
    )
    shortest = max(SHORT_LIFE, float(np.ptp(demand.time)))
    when = int(np.argmax(current))
    return _verdict(
        demand, "battery", "advice", life, shortest, "s", shortest / life, when, message
    )


def voltage(demand: Demand) -> PumpVerdict:
    """The battery against what the servo is made for."""
    servo, given = demand.servo, demand.pump.supply_voltage
    message = (
        f"{given:g} V; {servo.title} is made for {servo.lowest_voltage:g} to "
        f"{servo.rated_voltage:g} V"
    )
    low = given < servo.lowest_voltage
    ratio = servo.lowest_voltage / given if low else given / servo.rated_voltage
    allowed = servo.lowest_voltage if low else servo.rated_voltage
    return _verdict(demand, "voltage", "advice", given, allowed, "V", ratio, 0, message)


JUDGES: tuple[Judge, ...] = (
    stall,
    one_fifth,
    speed,
    travel,
    barrel,
    suction,
    cap,
    cap_torque,
    resolution,
    pressure_step,
    sensor,
    speed_register,
    battery,
    voltage,
)
JUDGE_OF = {judge.__name__: judge for judge in JUDGES}
