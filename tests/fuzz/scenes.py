"""Random specs that are valid by every rule of the schema, whatever they lead to.

Everything is drawn from one `random.Random`, so that a scene is told by the seed of it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from random import Random
from typing import Any

from tests.fuzz.dice import around, happens, share, size
from tests.fuzz.inputs import source
from tests.fuzz.networks import network
from viscodesign.effects.select import effect_names

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


def draft(dice: Random) -> Draft:
    """A whole spec; sizes around the paper's, over some orders of magnitude."""
    sections = dice.choice(SECTIONS)
    several = sections > 1 and happens(dice, 0.25)
    names = [f"in{k}" for k in range(dice.choice([2, 3]))] if several else ["inlet"]
    fluid, yields = _fluid(dice)
    duration = around(dice, 1.0, -6, 6) if happens(dice, 0.25) else around(dice, 1.0, -3, 1)
    inputs = {name: source(dice, duration, syringe=yields) for name in names}
    spec: Spec = {
        "name": "fuzz",
        "actuator": _actuator(dice),
        "bellows": _bellows(dice, sections),
        "network": network(dice, sections, names),
        "fluid": fluid,
        **_surroundings(dice),
        "loads": _loads(dice),
        "effects": _effects(dice, len(names)),
        "accuracy": around(dice, 0.005, -0.7, 1) if happens(dice, 0.9) else 5e-4,
        "run": _run(dice, duration),
        **({"inputs": inputs} if several else {"input": inputs["inlet"]}),
    }
    return _with_files(dice, spec)


def _actuator(dice: Random) -> Spec:
    return {
        "length": size(dice, 0.109, -0.5, 0.5),
        "height": size(dice, 0.03, -0.3, 0.3),
        "width": size(dice, 0.02, -0.3, 0.3),
        "youngs_modulus": size(dice, 1.8e6, -0.5, 1.0),
        "density": size(dice, 950.0, -2, 2),
        "solid_fraction": share(dice, 0.01, 1.0),
        "extension_factor": size(dice, 0.53, -1, 2),
        "bending_factor": size(dice, 0.55, -0.5, 0.5),
        "damping_time": dice.choice([0.0, 1e-4, 1e-3, 1e-2]),
    }


def _bellows(dice: Random, sections: int) -> Spec:
    found: Spec = {
        "count": 2 * sections,
        "height": size(dice, 0.01, -0.3, 0.3),
        "width": size(dice, 0.012, -0.3, 0.3),
        "length": size(dice, 0.018, -0.3, 0.3),
        "area_per_pressure": size(dice, 3.413e-9, -1, 1),
        "angle_per_pressure": dice.choice([1, 1, 1, -1]) * size(dice, 10.266, -1, 0.5),
        "extension_per_pressure": size(dice, 0.047, -1, 0.5),
        "collapse_fraction": share(dice, 0.0, 0.99) if happens(dice, 0.3) else 0.1,
    }
    if happens(dice, 0.6):
        found["area_per_force"] = size(dice, 3e-7, -1, 0.8)
    if happens(dice, 0.6):
        found["area_per_moment"] = size(dice, 1.2e-6, -1, 1.9)
    if happens(dice, 0.15):
        found["curve"] = {"rows": _curve(dice)}
    return found


def _curve(dice: Random) -> list[list[float]]:
    """Measured rows: the area rises, angle and extension may go up and down."""
    pressures = [-6e4, -2e4, 0.0, 1e4, 5e4, 1.2e5]
    monotone = happens(dice, 0.6)
    area, rows = -2e-4, []
    for k, pressure in enumerate(pressures):
        area += 1e-4 * dice.choice([0.05, 0.5, 1.0])
        lean = k if monotone else dice.uniform(0, 6)
        rows.append([pressure, area, 0.08 * lean, 1e-3 * lean])
    return rows


def _fluid(dice: Random) -> tuple[Any, bool]:
    """A known one, or one of any viscosity; and whether it yields."""
    if happens(dice, 0.45):
        return dice.choice(["air", "water"]), True
    if happens(dice, 0.05):
        return {"name": "glycerol-water", "fraction": share(dice, 0.0, 0.6)}, False
    own: Spec = {
        "name": "own",
        "viscosity": around(dice, 1e-3, -6, 6),
        "density": around(dice, 30, -1.5, 1.5),
    }
    if happens(dice, 0.4):
        own["gas_constant"] = around(dice, 287.0, -0.5, 1)
        if happens(dice, 0.3):
            own["polytropic_exponent"] = share(dice, 1.0, 1.6666)
    elif happens(dice, 0.5):
        own["bulk_modulus"] = around(dice, 2e9, -3, 0.5)
        if happens(dice, 0.5):
            own["vapour_pressure"] = share(dice, 0.0, 1e5)
    return own, "gas_constant" in own or "bulk_modulus" in own


def _surroundings(dice: Random) -> Spec:
    found: Spec = {"gauge_pressure": dice.choice([0.0, 0.0, 0.0, 2e4, -1e4])}
    if happens(dice, 0.2):
        found["temperature"] = share(dice, 275.0, 312.0)
    if happens(dice, 0.1):
        found["ambient_pressure"] = around(dice, 101325.0, -0.5, 1)
    return found


def _loads(dice: Random) -> Spec:
    found: Spec = {}
    if happens(dice, 0.5):
        found["gravity"] = {"tilt": share(dice, 0.0, 2 * math.pi)}
        if happens(dice, 0.1):
            found["gravity"]["acceleration"] = dice.choice([0.0, 1.62, 98.0])
    if happens(dice, 0.3):
        found["tip_force"] = {"x": share(dice, -3.0, 3.0), "z": share(dice, -12.0, 3.0)}
    if happens(dice, 0.25):
        found["payload"] = size(dice, 0.02, -1, 1)
    return found


def _effects(dice: Random, inlets: int) -> Any:
    """Left to the scene, or some of them forced, or all."""
    if happens(dice, 0.5):
        return "auto"
    if happens(dice, 0.1):
        return dice.choice(["on", "off"])
    names = dice.sample(effect_names(), dice.randint(0, 5))
    forced = {name: dice.choice(["on", "off", "auto"]) for name in names}
    if inlets > 1 and happens(dice, 0.9):
        forced["pressure_distribution"] = "on"
    return {**forced, "others": dice.choice(["auto", "auto", "off", "on"])}


def _run(dice: Random, duration: float) -> Spec:
    found: Spec = {
        "duration": duration,
        "start": dice.choice(["equilibrium", "equilibrium", "rest"]),
        "max_steps": MOST_STEPS,
    }
    if happens(dice, 0.2):
        times = sorted({duration * dice.random() for _ in range(dice.choice([1, 2, 10]))})
        found["output_times"] = [*times, duration] if happens(dice, 0.5) else times
    else:
        found["output_interval"] = duration / dice.choice([1, 2, 5, 10, 25, 25, 60])
    return found


def _with_files(dice: Random, spec: Spec) -> Draft:
    """Half of the tables lie in files of their own."""
    files: dict[str, str] = {}
    tables = {"table": ("time_s,pressure_pa", "t"), "syringe": ("time_s,position_m", "s")}
    for name, given in {"": spec.get("input"), **spec.get("inputs", {})}.items():
        if given and given["kind"] in tables and "rows" in given and happens(dice, 0.5):
            header, letter = tables[given["kind"]]
            files[f"{letter}{name}.csv"] = _csv(header, given.pop("rows"))
            given["file"] = f"{letter}{name}.csv"
    curve = spec["bellows"].get("curve")
    if curve and happens(dice, 0.5):
        header = "pressure_pa,area_m2,angle_rad,extension_m"
        files["curve.csv"] = _csv(header, curve.pop("rows"))
        curve["file"] = "curve.csv"
    return Draft(spec, files)


def _csv(header: str, rows: list[list[float]]) -> str:
    return "\n".join([header, *(",".join(map(repr, row)) for row in rows)]) + "\n"
