"""What a pump can do, held against what is asked of it at each pressure of its own.

A limit is one function from a demand to an assessment; this list is all that anything else
needs to know.
"""

from __future__ import annotations

from collections.abc import Callable

from viscodesign.pump.planning import plunger_limits as plunger
from viscodesign.pump.planning import pressure_limits as pressure
from viscodesign.pump.planning import servo_limits as servo
from viscodesign.pump.planning.assessment import Assessment
from viscodesign.pump.planning.demand import PumpDemand
from viscodesign.pump.planning.result import PumpVerdict

LIMITS: dict[str, Callable[[PumpDemand], Assessment]] = {
    limit.__name__: limit
    for limit in (
        servo.stall, servo.one_fifth, servo.speed, plunger.travel, plunger.barrel,
        pressure.suction, pressure.cap, servo.cap_torque, plunger.resolution,
        plunger.pressure_step, pressure.sensor, plunger.speed_register, servo.battery,
        servo.voltage,
    )
}  # fmt: skip


def verdict(demand: PumpDemand, name: str) -> PumpVerdict:
    """One limit held against a demand."""
    found = LIMITS[name](demand)
    return PumpVerdict(
        name=name,
        inlet=demand.inlet,
        severity=found.severity if found.ratio > 1.0 else "ok",
        wanted=found.wanted,
        allowed=found.allowed,
        unit=found.unit,
        ratio=float(found.ratio),
        time_s=float(demand.time[found.when]),
        message=found.message,
    )


def verdicts(demand: PumpDemand) -> tuple[PumpVerdict, ...]:
    """All limits held against a demand."""
    return tuple(verdict(demand, name) for name in LIMITS)


def infeasible(demand: PumpDemand) -> tuple[str, ...]:
    """Names of the limits that forbid it."""
    return tuple(v.name for v in verdicts(demand) if v.severity == "infeasible")
