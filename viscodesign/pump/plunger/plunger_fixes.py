"""What may be changed about a syringe to make a limit pass."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from viscodesign.pump.planning.fix import CAP, HIGHER, LOWER, SLOWER, Fix, Steps

THINNER = Fix("pump.syringe_diameter", 5e-3, "a syringe of {:.4g} mm inner diameter", "mm", 1e-3)
WIDER = replace(THINNER, far=0.1)
CURED_BY_HOME = ("travel", "barrel")


def home_fix(step_name: str) -> Fix:
    """Another `home`, in whole steps of a drive."""
    return Fix(
        "pump.home",
        0.0,
        f"home at {step_name} {{:.0f}}",
        whole=lambda pump: range(pump.travel[0], pump.travel[1] + 1),
        cures=CURED_BY_HOME,
    )


def plunger_fixes(home: Fix) -> Mapping[str, Sequence[Fix]]:
    """What may help against a limit, simplest first."""
    return {
        "stall": (LOWER, THINNER),
        "speed": (SLOWER, LOWER),
        "travel": (home, LOWER, WIDER),
        "barrel": (home, LOWER, WIDER),
        "suction": (LOWER,),
        "cap": (CAP, LOWER),
        "resolution": (THINNER, HIGHER),
        "pressure_step": (THINNER,),
    }


def plunger_stepwise(home: Fix) -> Steps:
    """Changes that are tried one upon the other, each against its limits."""
    return (
        (LOWER, ("stall", "speed", "suction")),  # what another drive cures only at a price
        (home, CURED_BY_HOME),
        (LOWER, CURED_BY_HOME),
        (CAP, ("cap",)),
    )
