"""How long should the tubes be? The width of the tip's sweep against their length.

Run it from anywhere: python examples/sweep_tube_length.py
"""

from pathlib import Path

import numpy as np

from viscodesign import load, simulate

SPEC = Path(__file__).parent.parent / "configs" / "leg_16_straight_air.yaml"

print("tube length [mm]   t_f [s]   sweep in x [mm]   stated error [mm]")
for length in (10, 20, 37.5, 75, 150):
    scene = load(SPEC, [f"network.tube_length={length} mm", "run.output_interval=50 ms"])
    found = simulate(scene)
    sweep = np.ptp(found.tip[:, 0]) * 1e3
    error = (found.accuracy.estimated_tip_error_m or 0.0) * 1e3
    t_f = found.classification.scales.t_f
    print(f"{length:16.1f}   {t_f:7.3f}   {sweep:15.1f}   {error:17.3f}")
