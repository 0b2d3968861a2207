"""Whether a pump can play a leg's pressures, and how much higher they may become.

Run it from anywhere: python examples/plan_a_pump.py
"""

from pathlib import Path

from viscodesign import load, plan

TEMPLATE = Path(__file__).parent.parent / "configs" / "leg_16_pump.yaml"
SHORT = ("run.duration=1 s", "input.rise_time=0.9 s", "input.transition=0.3 s")

for amplitude in ("5 kPa", "15 kPa"):
    changes = (f"input.start={amplitude}", f"input.drop={2 * float(amplitude[:-4]):g} kPa", *SHORT)
    found = plan(load(TEMPLATE, changes))
    print(f"±{amplitude}: {'feasible' if found.is_feasible else 'INFEASIBLE'}")
    for verdict in found.verdicts:
        if verdict.severity == "infeasible":
            print(f"  {verdict.name}: {verdict.message}")
    print(f"  tip up to {1e3 * found.deviation.max():.2f} mm from where it is wanted")
