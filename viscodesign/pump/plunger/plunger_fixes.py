"""What may be changed about a syringe and its servo to make a limit pass."""

from __future__ import annotations

from dataclasses import replace

from viscodesign.pump.planning.fix import CAP, HIGHER, LOWER, SLOWER, Fix
from viscodesign.scene.pumps.servo_motor import SERVOS

THINNER = Fix("pump.syringe_diameter", 5e-3, "a syringe of {:.4g} mm inner diameter", "mm", 1e-3)
WIDER = replace(THINNER, far=0.1)
RATED = min(servo.rated_voltage for servo in SERVOS.values())
VOLTAGE = Fix("pump.supply_voltage", RATED, "a supply of {:.4g} V", "V")
CURED_BY_HOME = ("travel", "barrel")
HOME = Fix(
    "pump.home",
    0.0,
    "home at count {:.0f}",
    whole=lambda pump: range(pump.travel[0], pump.travel[1] + 1),
    cures=CURED_BY_HOME,
)
FIXES = {
    "stall": (LOWER, THINNER, VOLTAGE),
    "one_fifth": (LOWER, THINNER, VOLTAGE),
    "speed": (SLOWER, LOWER, VOLTAGE),
    "travel": (HOME, LOWER, WIDER),
    "barrel": (HOME, LOWER, WIDER),
    "suction": (LOWER,),
    "cap": (CAP, LOWER),
    "resolution": (THINNER, HIGHER),
    "pressure_step": (THINNER,),
    "speed_register": (THINNER,),
}
"""What may help against a limit, simplest first."""
STEPWISE = (
    (LOWER, ("stall", "speed", "suction")),  # what another drive cures only at a price
    (HOME, CURED_BY_HOME),
    (LOWER, CURED_BY_HOME),
    (CAP, ("cap",)),
)
"""Changes that are tried one upon the other, each against its limits."""
