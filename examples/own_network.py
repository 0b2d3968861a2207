"""A custom network, generated in Python.

Run it from anywhere: python examples/own_network.py
"""

import tempfile
from pathlib import Path

import yaml

from viscodesign import check, load, simulate

TEMPLATE = Path(__file__).parent.parent / "configs" / "leg_16_straight_air.yaml"

spec = yaml.safe_load(TEMPLATE.read_text())
spec["name"] = "ladder"
spec["network"] = {
    "layout": "custom",
    "tube_radius": "0.325 mm",
    "tubes": [{"from": "inlet", "to": "R1", "length": "37.5 mm"}]
    + [{"from": f"R{j}", "to": f"R{j + 1}", "length": "37.5 mm"} for j in range(1, 8)]
    + [{"from": f"R{j}", "to": f"L{j}", "length": "300 mm"} for j in range(1, 9)],
}

with tempfile.TemporaryDirectory() as folder:
    file = Path(folder) / "ladder.yaml"
    file.write_text(yaml.safe_dump(spec))
    scene = load(file)

for fact in check(scene).facts:
    print(fact)
tip = simulate(scene).tip * 1e3
print(f"tip from x = {tip[:, 0].min():.1f} to {tip[:, 0].max():.1f} mm")
