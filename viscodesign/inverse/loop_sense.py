"""Which way round the tip of a graph goes, and the refusal of a loop in the other sense.

The signed area of a small loop is a sum over the harmonics of the input, each with the sign that
the graph gives it at that frequency: the column that is fed first leads the other one. So the
sign of one harmonic at all frequencies, with many lengths, is that of every input, as long as the
rod follows its pressures: near its own frequency it swings, and nothing is said.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.effects.allowed_sets import AllowedSets
from viscodesign.effects.base import Trait
from viscodesign.effects.catalogue import traits_of
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.swinging_rods import EFFECTIVE_MASS, FIRST_BENDING
from viscodesign.inverse.free_choice import FreeChoice
from viscodesign.inverse.quick_motion import QuickMotion
from viscodesign.inverse.tree_graph import TreeGraph, mirrored, sizes_of, tree_of, with_tree
from viscodesign.inverse.wanted_path import WantedPath
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.scene import Scene


@dataclass(frozen=True)
class LoopSenseRules:
    """When a loop has a sense, and how senses are sought."""

    draws: int = 24
    frequencies: int = 7
    period_reach: float = 300.0
    """Draws of lengths, periods of each, and how far these reach where none is free."""
    round: float = 0.2
    """Area of a loop, over that of a circle of its length, from which it has a sense."""
    linear_amplitude: float = 1e-4
    """Amplitude of the harmonic, relative to the limits: a linear motion."""
    slow: float = 2.0
    """Shortest period, over that in which the rod swings by itself, at which it follows without."""
    least_area: float = 1e-3
    """A loop below this part of the largest area of all draws has no sense."""


RULES = LoopSenseRules()


@dataclass(frozen=True)
class WrongSense:
    """A loop that a graph cannot follow, and what could."""

    reason: str
    hint: str
    mirrored: Scene


def wrong_sense(wanted: WantedPath, choice: FreeChoice, scene: Scene) -> WrongSense | None:
    """Why a free loop cannot be followed by a posed scene's graph; None where it may be."""
    own = tree_of(scene.graph)
    roundness = 4 * math.pi * abs(wanted.area) / wanted.length**2 if wanted.length else 0.0
    if (
        not wanted.is_free_loop
        or wanted.any_sense
        or choice.graph != "keep"
        or own is None
        or scene.input is None
        or roundness < RULES.round
        or _may_swing(choice, scene)
    ):
        return None
    sizes = sizes_of(scene, scene.bellows.count)
    areas = list(_areas(choice, with_tree(scene, own, sizes), own))
    sense = _common_sense(np.array(areas))
    if sense == 0 or sense == np.sign(wanted.area):
        return None
    words = {1: "counter-clockwise", -1: "clockwise"}
    sections = scene.bellows.count // 2
    first = "R" if own.parents[0][0] < sections else "L"
    other = "L" if first == "R" else "R"
    return WrongSense(
        f"wrong sense: the wanted loop goes {words[-sense]} (x to the right, z up; pictures have z "
        f"down and show the reverse), and with column {first} fed first the tip of this graph goes "
        f"{words[sense]}, whatever its lengths, period and input ({len(areas)} of {len(areas)} "
        "draws)",
        f"Feed column {other} first: spec.yaml has the mirrored graph, use it as `spec`; or set "
        "network.graph: chain free, or target.sense: any",
        with_tree(scene, mirrored(own, sections), sizes),
    )


def _may_swing(choice: FreeChoice, scene: Scene) -> bool:
    """Whether the input may be so fast that the rod swings: beyond its resonance x lags by half a
    turn, and the loop goes the other way round."""
    quantities = SceneQuantities(scene)
    if Trait.ROD_INERTIA not in traits_of(AllowedSets(quantities).everything):
        return False
    heavier = 1 + scene.loads.payload / (EFFECTIVE_MASS * quantities.solid_mass)
    own = 2 * math.pi * quantities.scales.t_s / FIRST_BENDING * math.sqrt(heavier)
    return _fastest(choice, scene) < RULES.slow * own


def _fastest(choice: FreeChoice, scene: Scene) -> float:
    """Shortest period of the input's harmonics [s]; of other inputs that of the input itself."""
    if choice.harmonics is not None:
        return choice.harmonics.period[0] / choice.harmonics.count
    for own in choice.ranges:
        if own.key == "input.period":
            return own.low
        if own.key == "input.frequency":
            return 1 / own.high
    return float(scene.period or math.inf)


def _common_sense(areas: np.ndarray) -> int:
    """The sign of all areas that are not nearly zero; 0 where both occur."""
    large = areas[np.abs(areas) > RULES.least_area * np.abs(areas).max(initial=0.0)]
    return int(np.sign(large[0])) if large.size and np.ptp(np.sign(large)) == 0.0 else 0


def _areas(choice: FreeChoice, scene: Scene, graph: TreeGraph) -> Iterator[float]:
    """Signed areas of loops by one small harmonic, with lengths and periods by chance."""
    period = float(scene.period or scene.run.duration)
    low, high = (period / RULES.period_reach, period * RULES.period_reach)
    count = 1
    if choice.harmonics is not None:
        low, high = choice.harmonics.period
        count = choice.harmonics.count
    size = RULES.linear_amplitude * (choice.harmonics.span if choice.harmonics is not None else 1e4)
    drive = {"kind": "harmonics", "period": period, "cosine": [size]}
    probe = scene.replace({"input": drive})
    lengths = [own for own in choice.ranges if own.key.startswith("network.")]
    keys = FreeKeys(probe, ["input.period", *(own.key for own in lengths)])
    motion = QuickMotion(keys, graph)
    periods = np.geomspace(low / count, high, RULES.frequencies)
    chance = np.random.default_rng(0)
    for _ in range(RULES.draws if lengths else 1):
        values = keys.values
        place = 1
        for own in lengths:
            numbers = len(FreeKeys(probe, [own.key]).numbers)
            share = chance.random(numbers)
            values[place : place + numbers] = own.low * (own.high / own.low) ** share
            place += numbers
        for each in periods:
            values[0] = each
            x, z = motion.tip(values).T
            yield float(np.sum(x * np.roll(z, -1) - np.roll(x, -1) * z) / 2)
