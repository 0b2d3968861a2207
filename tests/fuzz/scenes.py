"""Random specs that are valid by every rule of the schema, whatever they lead to.

Everything is drawn from one `random.Random`, so that a scene is told by the seed of it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from random import Random
from typing import Any

from tests.fuzz.inputs import source
from tests.fuzz.networks import network
from tests.fuzz.random_numbers import around, chance_of, share, size
from viscodesign.effects.catalogue import effect_names

Spec = dict[str, Any]
MOST_STEPS = 1_500
"""Work that a scene may cost, its verification included."""
SECTIONS = (1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 3, 3, 3, 4, 4, 5, 6, 8, 12)
"""Few of many: their cost grows faster than what they show."""


@dataclass(frozen=True)
class Draft:
    """A spec as a mapping, and the tables that lie beside it by their names."""

    spec: Spec
    files: dict[str, str] = field(default_factory=dict)


def draft(rng: Random) -> Draft:
    """A whole spec; sizes around the paper's, over some orders of magnitude."""
    sections = rng.choice(SECTIONS)
    several = sections > 1 and chance_of(rng, 0.25)
    names = [f"in{k}" for k in range(rng.choice([2, 3]))] if several else ["inlet"]
    fluid, yields = _fluid(rng)
    duration = around(rng, 1.0, -6, 6) if chance_of(rng, 0.25) else around(rng, 1.0, -3, 1)
    inputs = {name: source(rng, duration, syringe=yields) for name in names}
    spec: Spec = {
        "name": "fuzz",
        "actuator": _actuator(rng),
        "bellows": _bellows(rng, sections),
        "network": network(rng, sections, names),
        "fluid": fluid,
        **_surroundings(rng),
        "loads": _loads(rng),
        "effects": _effects(rng, len(names)),
        "accuracy": around(rng, 0.005, -0.7, 1) if chance_of(rng, 0.9) else 5e-4,
        "run": _run(rng, duration),
        **({"inputs": inputs} if several else {"input": inputs["inlet"]}),
    }
    return _with_files(rng, spec)


def _actuator(rng: Random) -> Spec:
    return {
        "length": size(rng, 0.109, -0.5, 0.5),
        "height": size(rng, 0.03, -0.3, 0.3),
        "width": size(rng, 0.02, -0.3, 0.3),
        "youngs_modulus": size(rng, 1.8e6, -0.5, 1.0),
        "density": size(rng, 950.0, -2, 2),
        "solid_fraction": share(rng, 0.01, 1.0),
        "extension_factor": size(rng, 0.53, -1, 2),
        "bending_factor": size(rng, 0.55, -0.5, 0.5),
        "damping_time": rng.choice([0.0, 1e-4, 1e-3, 1e-2]),
    }


def _bellows(rng: Random, sections: int) -> Spec:
    found: Spec = {
        "count": 2 * sections,
        "height": size(rng, 0.01, -0.3, 0.3),
        "width": size(rng, 0.012, -0.3, 0.3),
        "length": size(rng, 0.018, -0.3, 0.3),
        "area_per_pressure": size(rng, 3.413e-9, -1, 1),
        "angle_per_pressure": rng.choice([1, 1, 1, -1]) * size(rng, 10.266, -1, 0.5),
        "extension_per_pressure": size(rng, 0.047, -1, 0.5),
        "collapse_fraction": share(rng, 0.0, 0.99) if chance_of(rng, 0.3) else 0.1,
    }
    if chance_of(rng, 0.6):
        found["area_per_force"] = size(rng, 3e-7, -1, 0.8)
    if chance_of(rng, 0.6):
        found["area_per_moment"] = size(rng, 1.2e-6, -1, 1.9)
    if chance_of(rng, 0.15):
        found["curve"] = {"rows": _curve(rng)}
    return found


def _curve(rng: Random) -> list[list[float]]:
    """Measured rows: the area rises, angle and extension may go up and down."""
    pressures = [-6e4, -2e4, 0.0, 1e4, 5e4, 1.2e5]
    monotone = chance_of(rng, 0.6)
    area, rows = -2e-4, []
    for k, pressure in enumerate(pressures):
        area += 1e-4 * rng.choice([0.05, 0.5, 1.0])
        lean = k if monotone else rng.uniform(0, 6)
        rows.append([pressure, area, 0.08 * lean, 1e-3 * lean])
    return rows


def _fluid(rng: Random) -> tuple[Any, bool]:
    """A known one, or one of any viscosity; and whether it yields."""
    if chance_of(rng, 0.45):
        return rng.choice(["air", "water"]), True
    if chance_of(rng, 0.05):
        return {"name": "glycerol-water", "fraction": share(rng, 0.0, 0.6)}, False
    own: Spec = {
        "name": "own",
        "viscosity": around(rng, 1e-3, -6, 6),
        "density": around(rng, 30, -1.5, 1.5),
    }
    if chance_of(rng, 0.4):
        own["gas_constant"] = around(rng, 287.0, -0.5, 1)
        if chance_of(rng, 0.3):
            own["polytropic_exponent"] = share(rng, 1.0, 1.6666)
    elif chance_of(rng, 0.5):
        own["bulk_modulus"] = around(rng, 2e9, -3, 0.5)
        if chance_of(rng, 0.5):
            own["vapour_pressure"] = share(rng, 0.0, 1e5)
    return own, "gas_constant" in own or "bulk_modulus" in own


def _surroundings(rng: Random) -> Spec:
    found: Spec = {"gauge_pressure": rng.choice([0.0, 0.0, 0.0, 2e4, -1e4])}
    if chance_of(rng, 0.2):
        found["temperature"] = share(rng, 275.0, 312.0)
    if chance_of(rng, 0.1):
        found["ambient_pressure"] = around(rng, 101325.0, -0.5, 1)
    return found


def _loads(rng: Random) -> Spec:
    found: Spec = {"gravity": "off"}
    if chance_of(rng, 0.5):
        found["gravity"] = {"tilt": share(rng, 0.0, 2 * math.pi)}
        if chance_of(rng, 0.1):
            found["gravity"]["acceleration"] = rng.choice([0.0, 1.62, 98.0])
    if chance_of(rng, 0.3):
        found["tip_force"] = {"x": share(rng, -3.0, 3.0), "z": share(rng, -12.0, 3.0)}
    if chance_of(rng, 0.25):
        found["payload"] = size(rng, 0.02, -1, 1)
    return found


def _effects(rng: Random, inlets: int) -> Any:
    """Left to the scene, or some of them forced, or all."""
    if chance_of(rng, 0.5):
        return "auto"
    if chance_of(rng, 0.1):
        return rng.choice(["on", "off"])
    names = rng.sample(effect_names(), rng.randint(0, 5))
    forced = {name: rng.choice(["on", "off", "auto"]) for name in names}
    if inlets > 1 and chance_of(rng, 0.9):
        forced["pressure_distribution"] = "on"
    return {**forced, "others": rng.choice(["auto", "auto", "off", "on"])}


def _run(rng: Random, duration: float) -> Spec:
    found: Spec = {
        "duration": duration,
        "start": rng.choice(["equilibrium", "equilibrium", "rest"]),
        "max_steps": MOST_STEPS,
    }
    if chance_of(rng, 0.2):
        times = sorted({duration * rng.random() for _ in range(rng.choice([1, 2, 10]))})
        found["output_times"] = [*times, duration] if chance_of(rng, 0.5) else times
    else:
        found["output_interval"] = duration / rng.choice([1, 2, 5, 10, 25, 25, 60])
    return found


def _with_files(rng: Random, spec: Spec) -> Draft:
    """Half of the tables lie in files of their own."""
    files: dict[str, str] = {}
    tables = {"table": ("time_s,pressure_pa", "t"), "syringe": ("time_s,position_m", "s")}
    for name, given in {"": spec.get("input"), **spec.get("inputs", {})}.items():
        if given and given["kind"] in tables and "rows" in given and chance_of(rng, 0.5):
            header, letter = tables[given["kind"]]
            files[f"{letter}{name}.csv"] = _csv(header, given.pop("rows"))
            given["file"] = f"{letter}{name}.csv"
    curve = spec["bellows"].get("curve")
    if curve and chance_of(rng, 0.5):
        header = "pressure_pa,area_m2,angle_rad,extension_m"
        files["curve.csv"] = _csv(header, curve.pop("rows"))
        curve["file"] = "curve.csv"
    return Draft(spec, files)


def _csv(header: str, rows: list[list[float]]) -> str:
    return "\n".join([header, *(",".join(map(repr, row)) for row in rows)]) + "\n"
