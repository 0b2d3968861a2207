"""Scenes drawn at random that ring, reproducible by seed.

======================  ==========================================================
length                  30 to 150 mm (logarithmic), height 0.12 to 0.3 of it
Young's modulus         0.2 to 3 MPa (logarithmic), raised where a weight would buckle
bellows                 4 to 32, even (logarithmic)
damping                 0.2 to 3 % of the elastic time: hardly any
fluid                   air, water, thin liquids of 3e-4 to 1e-2 Pa s, gases like air
tubes                   radius 0.03 to 0.15 of the height, length 1 to 10 sections
tube walls              soft in every other scene: 1 to 10 MPa
network                 straight, or random trees with junctions
input                   square waves and sines of 1/3 to 1.3 times the first natural
                        frequency of the rod with what hangs on it; sometimes a step
pressure                1 to 30 kPa high (logarithmic), a square wave down to zero or below
compliance              a bellow takes 0.02 to 0.6 of its rest volume at the high pressure
bending                 0.03 to 0.5 rad of the whole actuator at the high pressure
feedback                0.1 to 1 of the reciprocal coupling, blocked compliance above half
loads                   horizontal in two of three, else hanging or weightless; payloads of
                        up to a third of the mass in every other scene
accuracy                0.3 to 2 % of the length
======================  ==========================================================

Estimates made before there is a solution are worst in such scenes.
"""

from __future__ import annotations

import math

import numpy as np
from scene_draw import (
    AMBIENT,
    GRAVITY,
    LARGEST_LOAD,
    ROOM,
    Spec,
    bellows_of,
    bending_stiffness,
    elastic_time,
    feed_back,
    keep_coefficients,
    log_uniform,
    mass,
    tree,
)

FIRST_ROOT = 3.516
"""First natural frequency of a clamped-free beam, times its elastic time."""
FREE_MASS = 0.2427
"""Of its mass, what moves like one at the tip in that mode."""


def draw(seed: int, index: int) -> Spec:
    """A complete spec in SI units as a plain mapping."""
    random = np.random.default_rng((seed, index, 1))
    high = log_uniform(random, 1e3, 30e3)
    count = 2 * round(log_uniform(random, 2, 16))
    body = _body(random)
    bellows = bellows_of(
        random, body, count, high, volume=(0.02, 0.6), angle=(0.03, 0.5), stretch=(0.002, 0.03)
    )
    fluid = _fluid(random)
    loads, lift = _loads(random, body, bellows, fluid)
    body["youngs_modulus"] *= lift
    keep_coefficients(bellows, lift)
    feed_back(random, body, bellows)
    moved = FREE_MASS * _mass_on_axis(body, bellows, fluid) + loads["payload"]
    slower = math.sqrt(moved / (FREE_MASS * mass(body)))
    first = FIRST_ROOT / (2 * math.pi * elastic_time(body) * slower)
    source, duration = _input(random, high, first)
    return {
        "name": f"ringing_{index}",
        "actuator": body,
        "bellows": bellows,
        "network": _network(random, body, count),
        "fluid": fluid,
        "temperature": ROOM,
        "input": source,
        "loads": loads,
        "effects": "auto",
        "accuracy": log_uniform(random, 3e-3, 2e-2),
        "run": {"duration": duration, "output_interval": duration / 240},
    }


def _body(random: np.random.Generator) -> Spec:
    length = log_uniform(random, 0.03, 0.15)
    height = length * random.uniform(0.12, 0.3)
    body = {
        "length": length,
        "height": height,
        "width": height * random.uniform(0.5, 1.2),
        "youngs_modulus": log_uniform(random, 2e5, 3e6),
        "density": random.uniform(950, 1200),
        "solid_fraction": random.uniform(0.4, 0.9),
        "extension_factor": random.uniform(0.4, 0.9),
        "bending_factor": random.uniform(0.4, 0.9),
    }
    return {**body, "damping_time": elastic_time(body) * log_uniform(random, 2e-3, 3e-2)}


def _density(fluid: str | Spec) -> float:
    if isinstance(fluid, str):
        return {"air": 1.2, "water": 998.0}[fluid]
    return float(fluid["density"])


def _mass_on_axis(body: Spec, bellows: Spec, fluid: str | Spec) -> float:
    volume = bellows["count"] * bellows["height"] * bellows["width"] * bellows["length"]
    return mass(body) + float(_density(fluid) * volume)


def _fluid(random: np.random.Generator) -> str | Spec:
    kind = str(random.choice(["air", "air", "water", "water", "liquid", "gas"]))
    if kind == "liquid":
        viscosity = log_uniform(random, 3e-4, 1e-2)
        density = random.uniform(700.0, 1300.0)
        return {
            "name": "liquid", "viscosity": viscosity, "density": density, "bulk_modulus": 1.5e9,
        }  # fmt: skip
    if kind == "gas":
        constant = random.uniform(180.0, 520.0)
        return {
            "name": "gas",
            "viscosity": log_uniform(random, 8e-6, 4e-5),
            "density": AMBIENT / (constant * ROOM),
            "gas_constant": constant,
        }
    return kind


def _loads(
    random: np.random.Generator, body: Spec, bellows: Spec, fluid: str | Spec
) -> tuple[Spec, float]:
    """Loads, and the factor by which the modulus must rise to bear them."""
    kind = str(random.choice(["horizontal", "horizontal", "hanging", "weightless"], p=WEIGHTS))
    payload = mass(body) * random.uniform(0.02, 0.33) if random.random() < 0.5 else 0.0
    weight = (_mass_on_axis(body, bellows, fluid) + payload) * GRAVITY
    stiffness = bending_stiffness(body) / body["length"] ** 2
    lift = max(1.0, weight / stiffness / LARGEST_LOAD) if kind != "weightless" else 1.0
    tilt = {"horizontal": math.pi / 2, "hanging": 0.0}
    gravity = "off" if kind == "weightless" else {"tilt": tilt[kind]}
    return {"payload": payload, "gravity": gravity}, lift


WEIGHTS = (0.33, 0.33, 0.17, 0.17)


def _network(random: np.random.Generator, body: Spec, count: int) -> Spec:
    section = body["length"] / (count / 2)
    radius = body["height"] * log_uniform(random, 0.03, 0.15)
    network: Spec = {
        "tube_radius": radius,
        "tube_length": max(section * random.uniform(1.0, 10.0), 12 * radius),
        "layout": str(random.choice(["straight", "custom"])),
    }
    if network["layout"] == "custom":
        network["tubes"] = tree(random, count)
    if random.random() < 0.5:
        network["tube_wall"] = {
            "youngs_modulus": log_uniform(random, 1e6, 1e7),
            "thickness": radius * random.uniform(0.3, 1.0),
        }
    return network


def _input(random: np.random.Generator, high: float, first: float) -> tuple[Spec, float]:
    """A profile near the first natural frequency [Hz], and the duration of the run."""
    kind = str(random.choice(["square", "square", "sine", "sine", "step"]))
    frequency = first * log_uniform(random, 1 / 3, 1.3)
    if kind == "step":
        return {"kind": kind, "value": high, "time": 0.5 / first}, random.uniform(8, 20) / first
    duration = random.uniform(6, 12) / frequency
    low = -high * random.uniform(0.0, 1.0) if random.random() < 0.5 else 0.0
    if kind == "square":
        return {"kind": kind, "high": high, "low": low, "frequency": frequency}, duration
    shape = {"amplitude": (high - low) / 2, "mean": (high + low) / 2}
    return {"kind": kind, "frequency": frequency, **shape}, duration
