"""How long should the tubes be, and which fluid fills them? The tip's loop in one table.

Run it from anywhere: python examples/sweep_tube_length.py
"""

from pathlib import Path

from viscodesign import load, sweep

SPEC = Path(__file__).parent.parent / "configs" / "leg_4_air.yaml"

scene = load(SPEC, ["run.output_interval=50 ms"])
table = sweep(scene, {"network.tube_length": "10 mm..160 mm:5:log", "fluid": ["air", "water"]})

for own in table.verified:
    error = 1e3 * (own.estimated_tip_error_m or 0.0)
    print(f"row {own.row} verified: {own.validity} of the model, stated error {error:.3f} mm")
print("tube length [mm]   fluid   loop [mm x mm]   left column late by [s]")
for row in table.frame().itertuples():
    length, fluid = row[2] * 1e3, row[3]
    size = f"{row.loop_width_m * 1e3:.1f} x {row.loop_height_m * 1e3:.1f}"
    print(f"{length:16.0f}   {fluid:5}   {size:>14}   {row.column_lag_s:10.3f}")
