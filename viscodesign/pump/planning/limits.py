"""What a pump can do, held against what is asked of it at each pressure of its own.

A limit is one function from a demand to an assessment; this list is all that anything else
needs to know.
"""

from __future__ import annotations

from collections.abc import Callable

from viscodesign.pump.planning.assessment import Assessment
from viscodesign.pump.planning.demand import PumpDemand
from viscodesign.pump.planning.plunger_limits import (
    barrel,
    pressure_step,
    resolution,
    speed_register,
    travel,
)
from viscodesign.pump.planning.pressure_limits import cap, sensor, suction
from viscodesign.pump.planning.result import PumpVerdict
from viscodesign.pump.planning.servo_limits import (
    battery,
    cap_torque,
    one_fifth,
    speed,
    stall,
    voltage,
)

LIMITS: dict[str, Callable[[PumpDemand], Assessment]] = {
    limit.__name__: limit
    for limit in (
        stall, one_fifth, speed, travel, barrel, suction, cap, cap_torque, resolution,
        pressure_step, sensor, speed_register, battery, voltage,
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
