"""Scenes drawn at random over the whole plane of timescales, reproducible by seed.

======================  ==========================================================
length                  5 mm to 1 m (logarithmic), height 0.1 to 0.35 of it
Young's modulus         20 kPa to 100 MPa (logarithmic), raised where a weight would buckle
bellows                 2 to 64, even (logarithmic)
fluid                   air, water, a glycerol-like liquid, own liquids of 1e-6 to
                        1e2 Pa s and own gases of 1e-6 to 1e-3 Pa s (logarithmic)
tubes                   radius 0.005 to 0.1 of the height, length 0.5 to 2 sections
network                 straight, crossed, random trees with junctions
input                   step, ramp, sine, pulse or square wave within 1 ms to 100 s
pressure                1 to 80 kPa high (logarithmic), down to -80 kPa
compliance              a bellow takes 0.1 to 1.5 of its rest volume at the high pressure
bending                 0.1 to 2.5 rad of the whole actuator at the high pressure
extension               2 to 15 % at the high pressure
feedback                0.1 to 1 of the reciprocal coupling, blocked compliance above half
loads                   weightless, hanging or horizontal; sometimes a force or payload
tube walls              soft in one scene of five
accuracy                0.2 to 2 % of the length
======================  ==========================================================

Coefficients follow from what they do at the high pressure, so that every scene is one
that could be built, and has one stable solution.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from viscodesign.model.graph import bellow_names

GRAVITY = 9.80665
ROOM = 293.15
AMBIENT = 101325.0
LARGEST_LOAD = 0.5
"""Largest load times length squared over bending stiffness."""

Spec = dict[str, Any]
Range = tuple[float, float]


def draw(seed: int, index: int) -> Spec:
    """A complete spec in SI units as a plain mapping."""
    random = np.random.default_rng((seed, index))
    high = log_uniform(random, 1e3, 80e3)
    count = 2 * round(log_uniform(random, 1, 32))
    body = _body(random)
    bellows = bellows_of(random, body, count, high)
    loads, lift = _loads(random, body, bellows)
    body["youngs_modulus"] *= lift
    keep_coefficients(bellows, lift)
    feed_back(random, body, bellows)
    swing = log_uniform(random, 1e-3, 100.0)
    source, duration = _input(random, high, swing)
    return {
        "name": f"scene_{index}",
        "actuator": body,
        "bellows": bellows,
        "network": _network(random, body, count),
        "fluid": _fluid(random),
        "temperature": ROOM,
        "input": source,
        "loads": loads,
        "effects": "auto",
        "accuracy": log_uniform(random, 2e-3, 2e-2),
        "run": {
            "duration": duration,
            "output_interval": duration / 200,
            "start": "rest" if random.random() < 0.15 else "equilibrium",
        },
    }


def log_uniform(random: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(random.uniform(math.log(low), math.log(high))))


def _body(random: np.random.Generator) -> Spec:
    length = log_uniform(random, 5e-3, 1.0)
    height = length * random.uniform(0.1, 0.35)
    body = {
        "length": length,
        "height": height,
        "width": height * random.uniform(0.5, 1.0),
        "youngs_modulus": log_uniform(random, 20e3, 100e6),
        "density": random.uniform(900, 1300),
        "solid_fraction": random.uniform(0.4, 1.0),
        "extension_factor": random.uniform(0.4, 1.0),
        "bending_factor": random.uniform(0.4, 1.0),
    }
    return {**body, "damping_time": elastic_time(body) * log_uniform(random, 0.01, 0.1)}


def mass(body: Spec) -> float:
    section = body["height"] * body["width"] * body["solid_fraction"]
    return float(body["density"] * section * body["length"])


def bending_stiffness(body: Spec) -> float:
    second_moment = body["width"] * body["height"] ** 3 / 12
    return float(body["youngs_modulus"] * second_moment * body["bending_factor"])


def _extension_stiffness(body: Spec) -> float:
    area = body["width"] * body["height"]
    return float(body["youngs_modulus"] * area * body["extension_factor"])


def elastic_time(body: Spec) -> float:
    return math.sqrt(mass(body) * body["length"] ** 3 / bending_stiffness(body))


def bellows_of(
    random: np.random.Generator,
    body: Spec,
    count: int,
    high: float,
    *,
    volume: Range = (0.1, 1.5),
    angle: Range = (0.1, 2.5),
    stretch: Range = (0.02, 0.14),
) -> Spec:
    """Coefficients from their effect at the high pressure.

    ``volume``: of the rest volume; ``angle``: of the whole actuator [rad]; ``stretch``: of it.
    """
    section = body["length"] / (count / 2)
    size = min(0.6 * section, 0.5 * body["height"])
    height, stream = 0.3 * body["height"], 0.9 * body["width"]
    rest = height * size * stream
    modulus = body["youngs_modulus"]
    return {
        "count": count,
        "height": height,
        "width": size,
        "length": stream,
        "area_per_pressure": random.uniform(*volume) * rest / high / stream,
        "angle_per_pressure": random.uniform(*angle) / (count / 2) * modulus / high,
        "extension_per_pressure": random.uniform(*stretch) / 2 * section * modulus / high,
    }


def keep_coefficients(bellows: Spec, lift: float) -> None:
    """Keep the strains per pressure in a body that is made stiffer."""
    for key in ("angle_per_pressure", "extension_per_pressure"):
        bellows[key] *= lift


def feed_back(random: np.random.Generator, body: Spec, bellows: Spec) -> None:
    """Reciprocal coupling, scaled to leave half of the compliance when blocked."""
    modulus, stream = body["youngs_modulus"], bellows["length"]
    section = body["length"] / (bellows["count"] / 2)
    compliance = stream * bellows["area_per_pressure"]
    for key, per_pressure, stiffness in (
        ("area_per_force", bellows["extension_per_pressure"], _extension_stiffness(body)),
        ("area_per_moment", bellows["angle_per_pressure"], bending_stiffness(body)),
    ):
        strain = per_pressure / modulus
        limit = 0.25 * compliance / (strain / section * stiffness)
        bellows[key] = random.uniform(0.1, 1.0) * min(strain, limit) / stream


def _loads(random: np.random.Generator, body: Spec, bellows: Spec) -> tuple[Spec, float]:
    """Loads, and the factor by which the modulus must rise to bear them."""
    kind = random.choice(["weightless", "hanging", "horizontal", "tilted"])
    payload = mass(body) * random.uniform(0.05, 0.3) if random.random() < 0.25 else 0.0
    held = 1000 * bellows["count"] * bellows["height"] * bellows["width"] * bellows["length"]
    weight = (mass(body) + payload + 2 * held) * GRAVITY
    if kind == "weightless":
        weight = 0.0
    stiffness = bending_stiffness(body) / body["length"] ** 2
    lift = max(1.0, weight / stiffness / LARGEST_LOAD)
    force = random.uniform(-0.3, 0.3) * stiffness * lift if random.random() < 0.25 else 0.0
    tilt = {"hanging": 0.0, "horizontal": math.pi / 2, "tilted": 0.6}
    loads: Spec = {"payload": payload, "tip_force": {"x": force, "z": 0.0}}
    loads["gravity"] = "off" if kind == "weightless" else {"tilt": tilt[str(kind)]}
    return loads, lift


def _network(random: np.random.Generator, body: Spec, count: int) -> Spec:
    section = body["length"] / (count / 2)
    radius = body["height"] * log_uniform(random, 0.005, 0.1)
    network: Spec = {
        "tube_radius": radius,
        "tube_length": max(section * random.uniform(0.5, 2.0), 12 * radius),
    }
    layouts = ["straight", "custom"] + (["crossed"] if count % 4 == 0 else [])
    network["layout"] = str(random.choice(layouts))
    if network["layout"] == "custom":
        network["tubes"] = tree(random, count)
    if random.random() < 0.2:
        network["tube_wall"] = {
            "youngs_modulus": log_uniform(random, 1e6, 1e9),
            "thickness": radius * random.uniform(0.3, 1.0),
        }
    return network


def tree(random: np.random.Generator, count: int) -> list[Spec]:
    """Connect every bellow to one that is already connected, sometimes by a junction."""
    names = [str(n) for n in random.permutation(bellow_names(count // 2))]
    joined, tubes = [names[0]], [{"from": "inlet", "to": names[0]}]
    for k, name in enumerate(names[1:]):
        start = str(random.choice(joined[-4:]))
        if random.random() < 0.15:
            tubes.append({"from": start, "to": f"T{k}"})
            start = f"T{k}"
            joined.append(start)
        tubes.append({"from": start, "to": name})
        joined.append(name)
    return tubes


def _fluid(random: np.random.Generator) -> str | Spec:
    kind = random.choice(["air", "water", "glycerol", "liquid", "liquid", "gas"])
    if kind in ("air", "water"):
        return str(kind)
    if kind == "glycerol":
        viscosity = log_uniform(random, 0.1, 1.4)
        return {"name": "syrup", "viscosity": viscosity, "density": 1230.0, "bulk_modulus": 4e9}
    if kind == "liquid":
        viscosity = log_uniform(random, 1e-6, 1e2)
        return {"name": "liquid", "viscosity": viscosity, "density": 1000.0, "bulk_modulus": 2.2e9}
    constant = random.uniform(180.0, 520.0)
    return {
        "name": "gas",
        "viscosity": log_uniform(random, 1e-6, 1e-3),
        "density": AMBIENT / (constant * ROOM),
        "gas_constant": constant,
    }


def _input(random: np.random.Generator, high: float, swing: float) -> tuple[Spec, float]:
    """A profile with a swing time of ``swing`` [s], and the duration of the run."""
    low = -min(high, 80e3) * random.uniform(0.0, 1.0)
    kind = str(random.choice(["step", "ramp", "sine", "double_sigmoid", "square"]))
    if kind == "step":
        return {"kind": "step", "value": high, "time": swing}, swing * random.uniform(5, 20)
    if kind == "ramp":
        shape = [(0.0, low), (0.5, low), (1.5, high), (4.5, high), (5.5, low)]
        rows = [[part * swing, pressure] for part, pressure in shape]
        return {"kind": "table", "rows": rows}, 7 * swing
    if kind == "sine":
        source = {"amplitude": (high - low) / 2, "mean": (high + low) / 2}
        return {"kind": kind, "frequency": 0.4 / swing, **source}, 6 * swing
    if kind == "square":
        return {"kind": kind, "high": high, "low": low, "frequency": 0.2 / swing}, 12 * swing
    source = {"start": high, "drop": high - low, "transition": swing}
    return {"kind": kind, "fall_time": swing, "rise_time": 4 * swing, **source}, 7 * swing
