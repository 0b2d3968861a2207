"""Specs that between them have every key that holds a number, for `test_every_key`."""

from __future__ import annotations

from typing import Any

Spec = dict[str, Any]
BODY: Spec = {
    "name": "every key",
    "actuator": {
        "length": 0.109, "height": 0.03, "width": 0.02, "youngs_modulus": 1.8e6, "density": 950.0,
        "solid_fraction": 0.47, "extension_factor": 0.53, "bending_factor": 0.55,
        "shear_factor": 0.5, "damping_time": 1e-3,
    },
    "bellows": {
        "count": 4, "height": 0.01, "width": 0.012, "length": 0.018,
        "area_per_pressure": 3.413e-9, "angle_per_pressure": 10.266,
        "extension_per_pressure": 0.047, "area_per_force": 3e-7, "area_per_moment": 1.2e-6,
        "collapse_fraction": 0.1,
        "changes": {"R1": {
            "height": 0.009, "width": 0.013, "length": 0.017, "area_per_pressure": 3.5e-9,
            "angle_per_pressure": 10.0, "extension_per_pressure": 0.045, "area_per_force": 2e-7,
            "area_per_moment": 1.1e-6, "collapse_fraction": 0.12,
        }},
    },
    "sections": {"1-2": {
        "height": 0.031, "width": 0.021, "youngs_modulus": 1.9e6, "density": 940.0,
        "solid_fraction": 0.45, "extension_factor": 0.5, "bending_factor": 0.5,
        "shear_factor": 0.5, "damping_time": 1.1e-3,
    }},
    "gauge_pressure": 1e3,
    "ambient_pressure": 101325.0,
    "temperature": 293.15,
    "accuracy": 0.005,
    "run": {"duration": 8.0, "output_interval": 0.02},
}  # fmt: skip
NAMED: Spec = {
    "layout": "straight", "tube_radius": 3.25e-4, "tube_length": 0.0375,
    "changes": {"R1-R2": {"length": 0.1125, "radius": 4e-4}},
    "feed_line": {"length": 1.0, "radius": 1e-3},
    "tube_wall": {"youngs_modulus": 5e6, "thickness": 1e-3, "poissons_ratio": 0.48},
    "entrance_loss": 0.5, "exit_loss": 1.0,
}  # fmt: skip
LISTED: Spec = {
    "layout": "custom",
    "tubes": [
        {"from": a, "to": b, "length": 0.0375, "radius": 3.25e-4}
        for a, b in (("inlet", "R1"), ("R1", "R2"), ("R2", "L2"), ("L2", "L1"))
    ],
}
GAS: Spec = {
    "name": "own gas", "viscosity": 1.8e-5, "density": 1.204, "gas_constant": 287.05,
    "polytropic_exponent": 1.2,
}  # fmt: skip
LIQUID: Spec = {
    "name": "own liquid", "viscosity": 1e-3, "density": 998.0, "bulk_modulus": 2.2e9,
    "vapour_pressure": 2.3e3,
}  # fmt: skip
LOADS: Spec = {
    "gravity": {"acceleration": 9.81, "tilt": 1.5},
    "tip_force": {"x": 0.5, "z": 0.5},
    "payload": 0.2,
}
FLOOR: Spec = {
    "kind": "line", "point": {"x": 0.05, "z": 0.15}, "normal": 3.1, "friction": 0.5,
    "foot_radius": 0.01,
}  # fmt: skip
PIN: Spec = {"kind": "circle", "centre": {"x": 0.15, "z": 0.1}, "radius": 0.02, "friction": 0.5}
PUMP: Spec = {
    "syringe_diameter": 0.0349, "syringe_stroke": 0.1045, "pinion_diameter": 0.0296,
    "supply_voltage": 11.1, "dead_volume": 5e-6, "battery_capacity": 1620.0,
    "plunger_friction": 5.0, "gear_play": 2.0, "max_pressure": 25e3, "home": 200,
    "filled_length": 0.06,
}  # fmt: skip
REGULATOR: Spec = {
    "kind": "regulator", "full_scale": 100e3, "response_time": 0.2, "error": 0.02,
    "rate_limit": 50e3, "following_error": 0.1, "max_pressure": 25e3,
}  # fmt: skip
INPUTS: tuple[Spec, ...] = (
    {"kind": "double_sigmoid", "start": 20e3, "drop": 40e3, "fall_time": 0.5, "rise_time": 4.0,
     "transition": 0.875, "transient_time": 0.7},
    {"kind": "constant", "value": 10e3},
    {"kind": "step", "value": 10e3, "time": 1.0},
    {"kind": "sine", "amplitude": 10e3, "frequency": 0.5, "phase": 1.5, "mean": 5e3},
    {"kind": "square", "high": 10e3, "low": -5e3, "frequency": 0.5, "duty": 0.4},
    {"kind": "trapezoid", "high": 10e3, "low": -5e3, "rise": 0.5, "hold": 0.5, "fall": 0.5,
     "rest": 0.5},
    {"kind": "harmonics", "period": 2.0, "mean": 1e3, "cosine": [10e3], "sine": [5e3]},
    {"kind": "table", "rows": [[0.0, 0.0], [2.0, 10e3], [8.0, 0.0]]},
    {"kind": "syringe", "diameter": 0.02, "start": 0.05, "dead_volume": 1e-6, "cushion": 1e-7,
     "rows": [[0.0, 0.0], [2.0, 5e-3], [8.0, 0.0]]},
    {"kind": "syringe", "diameter": 0.02, "start": 0.05,
     "speeds": [[0.0, 2e-3], [2.0, -2e-3], [4.0, 0.0]]},
)  # fmt: skip


def specs() -> list[Spec]:
    """Sound specs, of which no number is warned about."""
    whole = {**BODY, "network": NAMED, "fluid": GAS, "loads": LOADS, "input": INPUTS[0]}
    listed = {**BODY, "network": LISTED, "fluid": LIQUID}
    return [
        {**whole, "pump": PUMP},
        {**listed, "input": INPUTS[1], "pump": REGULATOR, "loads": {"ground": FLOOR}},
        {**listed, "input": INPUTS[1], "loads": {"ground": PIN}},
        {**listed, "input": INPUTS[1], "fluid": {"name": "glycerol-water", "fraction": 0.5}},
        *({**listed, "input": source} for source in INPUTS[2:]),
    ]
