"""Fixes that change the drive: barrel, supply, cap, home. They ask nothing new of the actuator."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

from viscodesign.pump.planning.factor_search import nearest, rounded
from viscodesign.pump.planning.input_fixes import Found
from viscodesign.pump.planning.result import SuggestedChange
from viscodesign.pump.planning.trials import Aim, Trials, Variation, remaining
from viscodesign.pump.servo_motor import SERVOS

THINNEST_BARREL, WIDEST_BARREL = 5e-3, 0.1
"""Diameters between which one is sought [m]."""
CAP_STEP_PA = 100.0


def thinner_barrel(trials: Trials, aim: Aim, case: Variation) -> Found | None:
    """A barrel of smaller diameter."""
    return _diameter(trials, aim, case, THINNEST_BARREL)


def wider_barrel(trials: Trials, aim: Aim, case: Variation) -> Found | None:
    """A barrel of larger diameter."""
    return _diameter(trials, aim, case, WIDEST_BARREL)


def _diameter(trials: Trials, aim: Aim, case: Variation, far: float) -> Found | None:
    value = _sought(trials, aim, case, "syringe_diameter", far)
    if value is None:
        return None
    words = f"a syringe of {1e3 * value:.4g} mm inner diameter"
    setting = f"{1e3 * value:.4g} mm"
    return _tried(trials, aim, case, "syringe_diameter", value, words, setting)


def more_voltage(trials: Trials, aim: Aim, case: Variation) -> Found | None:
    """A supply of more voltage, up to what the servo is rated for."""
    pump = trials.pump_of(case)
    rated = SERVOS[pump.servo].rated_voltage
    if pump.supply_voltage >= rated:
        return None
    value = _sought(trials, aim, case, "supply_voltage", rated)
    if value is None:
        return None
    value = min(value, rated)
    words, setting = f"a supply of {value:.4g} V", f"{value:.4g} V"
    return _tried(trials, aim, case, "supply_voltage", value, words, setting)


def higher_cap(trials: Trials, aim: Aim, case: Variation) -> Found | None:
    """A software cap that lets the pressures through."""
    demands = trials.demands(case)
    if demands is None:
        return None
    highest = max(float(d.pressure.max()) for d in demands)
    value = math.ceil(highest / CAP_STEP_PA) * CAP_STEP_PA
    words, setting = f"a cap of {value / 1e3:.4g} kPa gauge", f"{value / 1e3:.6g} kPa gauge"
    return _tried(trials, aim, case, "max_pressure", value, words, setting)


def other_home(trials: Trials, aim: Aim, case: Variation) -> Found | None:
    """Another count of home, the nearest that does; the barrel then is as full as it follows."""
    pump, demands = trials.pump_of(case), trials.demands(case)
    if demands is None:
        return None
    low, high = pump.travel
    # What leaves its travel seldom stays within its barrel: one home is to do for both.
    aims = Aim(aim.inlet, ("travel", "barrel"))
    for home in sorted(range(low, high + 1), key=lambda count: abs(count - pump.home)):
        moved = pump.model_copy(update={"home": home})
        if aims.is_met(tuple(d.with_pump(moved) for d in demands)):
            return _tried(trials, aim, case, "home", home, f"home at count {home}", str(home))
    return None


def _sought(trials: Trials, aim: Aim, case: Variation, key: str, far: float) -> float | None:
    """The value of a key of the drive nearest to its own that passes, rounded towards ``far``."""
    pump, demands = trials.pump_of(case), trials.demands(case)
    near = float(getattr(pump, key))
    if demands is None or near == far:
        return None

    def passes(value: float) -> bool:
        other = pump.model_copy(update={key: value})
        return aim.is_met(tuple(d.with_pump(other) for d in demands))

    found = nearest(passes, near, far)
    return None if found is None else rounded(found, far)


def _tried(
    trials: Trials, aim: Aim, case: Variation, key: str, value: Any, words: str, setting: str
) -> Found | None:
    """A value of one key of the drive, where it meets the aim."""
    tried = replace(case, pump=trials.pump_of(case).model_copy(update={key: value}))
    demands = trials.demands(tried)
    if not aim.is_met(demands):
        return None
    key = f"pump.{key}"
    return SuggestedChange(key, words, (f"{key}={setting}",), remaining(demands)), tried
