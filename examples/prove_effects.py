"""How far each effect moves the tip: estimated before the run, measured by a second solution.

Run it from anywhere: python examples/prove_effects.py
"""

from pathlib import Path

from viscodesign import load, simulate

CONFIGS = Path(__file__).parent.parent / "configs"

motion = simulate(load(CONFIGS / "leg_4_air_auto.yaml"), prove=True)
print(f"{motion.name}: {1e3 * motion.accuracy.requested_m:.3g} mm requested at the tip")
for found in motion.proof:
    measured = "no solution" if found.measured_m is None else f"{1e3 * found.measured_m:.2g} mm"
    estimated = f"{1e3 * found.estimated_m:.2g} mm"
    print(f"{found.name}: {found.decision}, {estimated} estimated, {measured} measured")
