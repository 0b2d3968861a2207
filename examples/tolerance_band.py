"""What do five percent of tube radius and three of viscosity do to the tip?

Run it from anywhere: python examples/tolerance_band.py
"""

from pathlib import Path

from viscodesign import load, sensitivity

SPEC = Path(__file__).parent.parent / "configs" / "leg_4_air.yaml"

scene = load(SPEC, ["run.output_interval=100 ms"])
study = sensitivity(scene, {"network.tube_radius": "5 %", "fluid.viscosity": "3 %"})

row = study.worst_row
x, z = 1e3 * study.band[row]
print(f"widest band at {study.time[row]:.1f} s: sd {x:.3f} mm in x, {z:.3f} mm in z")
for number, share in zip(study.numbers, study.shares, strict=True):
    print(f"{number.key:20} {100 * share:5.1f} % of the variance")
