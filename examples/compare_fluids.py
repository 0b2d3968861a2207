"""The same leg with air and with water: what the fluid's viscosity does to the motion.

Run it from anywhere: python examples/compare_fluids.py
"""

from pathlib import Path

from viscodesign import classify, load, simulate

CONFIGS = Path(__file__).parent.parent / "configs"

for name in ("leg_16_straight_air", "leg_16_straight_water"):
    scene = load(CONFIGS / f"{name}.yaml")
    result = classify(scene)
    motion = simulate(scene).frame()
    x = motion["tip_x_m"] * 1e3
    print(
        f"{name}: quadrant {result.quadrant}, t_f = {result.scales.t_f:.3g} s, "
        f"tip from x = {x.min():.1f} to {x.max():.1f} mm"
    )
