"""What a pump can do against what is required of it: one function per limit, and what may help."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.planning.result import PumpVerdict, Severity
from viscodesign.pump.planning.scene_variants import jumps

if TYPE_CHECKING:
    from viscodesign.pump.planning.demand import PumpDemand


@dataclass(frozen=True)
class LimitMargins:
    """Where limits are drawn that no data sheet draws."""

    sensor_floor: float = 20e3  # the Phidgets 1140 reads no lower [Pa abs]
    sensor_accuracy: float = 6e3  # swing that its 1.5 % of full scale, 5.7 kPa, would hide [Pa]
    sensor_step: float = 1.61e3  # its reading at 8 bit, as the firmware for ROS takes it [Pa]
    min_steps: float = 5.0  # smallest motion
    fine_steps: float = 20.0  # steps per swing of pressure, below which it is coarse
    flat: float = 1.0  # swing of pressure below which nothing is asked [Pa]


MARGINS = LimitMargins()


class Assessment(NamedTuple):
    """How a demand compares with one limit."""

    severity: Severity  # where the ratio is above 1
    wanted: float  # at the worst time, in the unit
    allowed: float
    unit: str
    ratio: float  # how much of what is allowed is asked
    when: int  # index of the worst time
    message: str


@dataclass(frozen=True)
class Fix:
    """A number of a scene or its pump that is changed, and as far as to where."""

    key: str  # of a `Variation`
    far: float
    words: str
    unit: str = ""  # in which a spec states it
    si: float = 1.0  # of that unit
    whole: Callable[[Any], range] | None = None
    """Values of a key that counts, of a pump's section; each is tried, the nearest first."""
    cures: tuple[str, ...] = ()
    """Limits that have to pass together where it counts."""


LOWER = Fix("pressure", 0.005, "every pressure of the input times {:.3g}")
HIGHER = replace(LOWER, far=100.0)
SLOWER = Fix("time", 1000.0, "everything slower by a factor of {:.3g}")
RAMPS = Fix("ramp", 1000.0, "every jump of the pressure as a ramp of {:.3g} s")
CAP = Fix("pump.max_pressure", 1e7, "a cap of {:.4g} kPa gauge", "kPa gauge", 1e3)
Steps = Sequence[tuple[Fix, Sequence[str]]]
"""Changes one upon the other, each with the limits that it is to satisfy."""


class PumpLimit(NamedTuple):
    """One limit of a demand."""

    assess: Callable[[Any], Assessment]
    fixes: tuple[Fix, ...] = ()
    """What may help against it, simplest first."""


Limits = Mapping[str, PumpLimit]
"""Limits by name, in the order in which a plan lists them."""


def within(values: np.ndarray, low: float, high: float, unit: str, message: str) -> Assessment:
    """Values against both ends of a range; by how much of its width they leave it."""
    beyond = np.maximum(values - high, low - values)
    when = int(np.argmax(beyond))
    worst, nearest = float(values[when]), high if values[when] > (low + high) / 2 else low
    ratio = 1.0 + float(beyond[when]) / (high - low)
    return Assessment("infeasible", worst, float(nearest), unit, ratio, when, message)


def cap(demand: PumpDemand) -> Assessment:
    """Highest pressure against the software's cap."""
    allowed, when = demand.pump.max_pressure, int(np.argmax(demand.pressure))
    highest = float(demand.pressure[when])
    message = (
        f"up to {highest / 1e3:.4g} kPa gauge; pump.max_pressure allows {allowed / 1e3:.4g} kPa"
    )
    ratio = max(highest, 0.0) / allowed
    return Assessment("infeasible", highest, allowed, "Pa gauge", ratio, when, message)


def pressure_range(demand: PumpDemand) -> Assessment:
    """Pressures against what the pump can make."""
    low, high = demand.made_pressures
    message = (
        f"needs {demand.pressure.min() / 1e3:.4g} to {demand.pressure.max() / 1e3:.4g} kPa gauge; "
        f"{demand.device} makes {low / 1e3:.4g} to {high / 1e3:.4g} kPa"
    )
    return within(demand.pressure, low, high, "Pa gauge", message)


def pressure_rate(demand: PumpDemand) -> Assessment:
    """Assess the fastest change of pressure relative to the pump's limit."""
    when, allowed = int(np.argmax(demand.rates)), demand.axis.top_speed * demand.axis.step
    wanted = float(demand.rates[when])
    message = (
        f"the pressure has to change by {wanted / 1e3:.4g} kPa/s; "
        f"at most {allowed / 1e3:.4g} kPa/s is allowed"
    )
    message += jump_words(demand, when) if wanted > allowed else ""
    return Assessment("infeasible", wanted, allowed, "Pa/s", wanted / allowed, when, message)


def pressure_lag(demand: PumpDemand) -> Assessment:
    """How far a set-point has to run ahead, against what counts as not following."""
    axis, when = demand.axis, int(np.argmax(demand.rates))
    wanted = float(demand.rates[when]) * axis.lead_distance / axis.top_speed
    allowed = axis.following_error * axis.step
    message = (
        f"the set-point has to run ahead of the pressure by {wanted / 1e3:.3g} kPa, since the "
        f"outlet lags; above {allowed / 1e3:.3g} kPa a stream may stop it as not following"
    )
    return Assessment("advice", wanted, allowed, "Pa", wanted / allowed, when, message)


def jump_words(demand: PumpDemand, when: int) -> str:
    """How long a jump is taken to last, where an interval of the times holds one."""
    begin, end = demand.time[when : when + 2] - demand.lead_s
    if not any(begin - 1e-9 <= t <= end + 1e-9 for t in jumps(demand.scene)):
        return ""
    lasting = 1e3 * float(end - begin)
    return f"; the wanted pressure jumps there, here taken to last {lasting:.3g} ms"


def pressure_resolution(demand: PumpDemand) -> Assessment:
    """Swing of pressure against the steps in which it is set."""
    swing, step = float(np.ptp(demand.pressure)), demand.axis.step
    message = f"the pressure swings by {swing / 1e3:.3g} kPa, and is set in steps of {step:.3g} Pa"
    ratio = 0.0 if swing < MARGINS.flat else MARGINS.fine_steps * step / swing
    when, allowed = int(np.argmax(demand.pressure)), swing / MARGINS.fine_steps
    return Assessment("advice", step, allowed, "Pa", ratio, when, message)


PRESSURE_LIMITS: Limits = {
    "range": PumpLimit(pressure_range, (LOWER,)),
    "cap": PumpLimit(cap, (CAP, LOWER)),
    "rate": PumpLimit(pressure_rate, (SLOWER, LOWER)),
    "lag": PumpLimit(pressure_lag, (SLOWER, LOWER)),
    "resolution": PumpLimit(pressure_resolution),
}
"""Limits of an axis that sets the pressure itself."""


def verdict(demand: PumpDemand, name: str) -> PumpVerdict:
    """One limit held against a demand."""
    severity, wanted, allowed, unit, ratio, when, message = demand.limits[name].assess(demand)
    return PumpVerdict(
        name, demand.inlet, severity if ratio > 1.0 else "ok", wanted, allowed, unit,
        float(ratio), float(demand.time[when]), message,
    )  # fmt: skip


def verdicts(demand: PumpDemand) -> tuple[PumpVerdict, ...]:
    """All limits held against a demand."""
    return tuple(verdict(demand, name) for name in demand.limits)


def infeasible(demand: PumpDemand) -> tuple[str, ...]:
    """Names of the limits that forbid it."""
    return tuple(v.name for v in verdicts(demand) if v.severity == "infeasible")
