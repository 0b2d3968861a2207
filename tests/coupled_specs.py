"""Specs of two small actuators that share fluid, for tests."""

from __future__ import annotations

from typing import Any

BODY = {
    "length": "40 mm", "height": "30 mm", "width": "20 mm", "youngs_modulus": "1.8 MPa",
    "density": 950, "solid_fraction": 0.47, "extension_factor": 0.53, "bending_factor": 0.55,
    "damping_time": "1 ms",
}  # fmt: skip
BELLOWS = {
    "count": 4, "height": "10 mm", "width": "12 mm", "length": "18 mm",
    "area_per_pressure": 3.413e-9, "angle_per_pressure": "10.266 rad",
    "extension_per_pressure": "47 mm",
}  # fmt: skip
NETWORK = {"layout": "straight", "tube_radius": "0.15 mm", "tube_length": "37.5 mm"}
LEFT = {"actuator": BODY, "bellows": BELLOWS, "network": NETWORK}
RIGHT = {
    "actuator": {**BODY, "length": "22 mm", "youngs_modulus": "1.5 MPa"},
    "bellows": {**BELLOWS, "count": 2, "length": "15 mm"},
    "network": {**NETWORK, "tube_radius": "0.18 mm"},
}
SINE = {"kind": "sine", "amplitude": "10 kPa", "frequency": "0.5 Hz"}
SYRINGE = {
    "kind": "syringe", "diameter": "15 mm", "start": "40 mm",
    "rows": [[0, 0], [0.6, 8e-3], [1.2, 2e-3]],
}  # fmt: skip
TREE = [
    {"from": "A", "to": "T", "length": "200 mm", "radius": "0.6 mm"},
    {"from": "T", "to": "left.inlet", "length": "30 mm", "radius": "0.5 mm"},
    {"from": "T", "to": "right.inlet", "length": "60 mm", "radius": "0.5 mm"},
]
FLOW_ALONE = {"pressure_distribution": "on", "gas_compressibility": "on", "others": "off"}


def coupled_spec(**changes: Any) -> dict[str, Any]:
    """Two unequal actuators behind a tee on one sine, with some keys replaced."""
    return {
        "name": "coupled",
        "actuators": {"left": LEFT, "right": RIGHT},
        "tubes": TREE,
        "fluid": "air",
        "gauge_pressure": "20 kPa",
        "inputs": {"A": SINE},
        "loads": {"gravity": "on"},
        "run": {"duration": 1.2, "output_interval": 0.05},
        **changes,
    }


def on_one_syringe(**changes: Any) -> dict[str, Any]:
    """The same without a tee: one syringe is the source of both."""
    actuators = {name: {**own, "source": "A"} for name, own in (("left", LEFT), ("right", RIGHT))}
    found = coupled_spec(actuators=actuators, inputs={"A": SYRINGE}, **changes)
    del found["tubes"]
    return found
