"""Which tubes and which input make the tip go round a circle, and what brings it to a point?

A leg of four bellows filled with oil: one inlet, no valve. The tube lengths and three harmonics of
the pressure are free; the design is simulated again with the effects that it calls for.
Run it from anywhere: python examples/design_a_loop.py
"""

from pathlib import Path

import numpy as np

from viscodesign import design, load, reach

SPEC = Path(__file__).parent.parent / "configs" / "leg_4_air.yaml"
OIL = {"name": "oil", "viscosity": "0.06 Pa*s", "density": "950 kg/m^3", "bulk_modulus": "1.6 GPa"}
CHANGES = {"name": "oil_leg", "fluid": OIL, "network.tube_radius": "0.9 mm", "effects": "auto"}
LIMITS = (-20e3, 25e3)

# With column R fed first, the tip goes clockwise when z points upwards.
turn = np.linspace(0, 2 * np.pi, 49)
circle = np.column_stack([0.5e-3 * np.cos(turn), 27.4e-3 - 0.5e-3 * np.sin(turn)])
found = design(
    {
        "spec": str(SPEC),
        "free": {
            "network.tubes[*].length": ["5 mm", "300 mm"],
            "input": {"harmonics": 3, "period": ["2 s", "60 s"], "limits": ["-20 kPa", "25 kPa"]},
        },
        "target": {"rows": circle.tolist()},
        "tolerance": "0.03 mm",
    },
    CHANGES,
)
print(f"circle: {found.status} {found.reason}")
print(f"distance {1e3 * (found.confirmed_rms_m or 0):.2g} mm rms by {found.evaluations} solutions")
for key, value in found.parameters.items():
    print(f"{key:32} {value:10.4g} {found.units[key]}")

study = reach(load(SPEC, CHANGES), limits=LIMITS, at=(2e-3, 27.5e-3), time=6.0)
point = study.point
if point is not None:
    words = "reached" if point.is_reached else "out of reach"
    print(f"(2, 27.5) mm at {point.time_s:g} s: {words}, {1e3 * point.miss_m:.2g} mm off")
    print("pressure [kPa]:", np.round(1e-3 * point.pressures, 1))
