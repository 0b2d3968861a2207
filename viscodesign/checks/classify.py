"""Timescales, the quadrant of Figure 1, and what they mean for the motion."""

from __future__ import annotations

import math
from typing import Literal

from viscodesign.checks.refusals import refuse_beyond_numbers
from viscodesign.checks.scene_warnings import scene_notices
from viscodesign.effects.select import select_effects
from viscodesign.estimate.joined_quantities import quantities_of
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.physics.timescales import cutoff_frequency
from viscodesign.results.findings import Classification, Scales
from viscodesign.scene.scene import Scene

QUADRANTS: dict[str, str] = {
    "I": "uniform pressure, dominated by the solid's inertia",
    "II": "pressure distribution with a steep input",
    "III": "pressure distribution, input on the fluid's timescale",
    "IV": "uniform pressure, quasi-static motion",
}
NEARLY_UNIFORM = 0.1
FAR_TOO_SLOW = 10.0


def classify(scene: Scene) -> Classification:
    """Timescales, ratios and quadrant of a scene; solves nothing.

    Raises `SpecError` where sizes lie beyond the range of numbers.
    """
    quantities = quantities_of(scene)
    refuse_beyond_numbers(quantities)
    return classification(quantities, select_effects(quantities).active)


def classification(quantities: SceneQuantities, active: frozenset[str]) -> Classification:
    """The same from the quantities of a scene and the names of its active effects."""
    scales = quantities.scales
    quadrant = find_quadrant(scales)
    return Classification(
        name=quantities.scene.name,
        scales=scales,
        quadrant=quadrant,
        meaning=_meaning(quadrant, scales),
        cutoff_frequency_hz=cutoff_frequency(scales.t_f) if scales.t_f else math.inf,
        warnings=tuple(scene_notices(quantities, active)),
    )


def find_quadrant(scales: Scales) -> Literal["I", "II", "III", "IV"]:
    """The quadrant of Figure 1: x = t_s/t_f against 1, y = t_s/t_i against 1."""
    ratios = scales.ratios
    uniform, steep = ratios["ts_over_tf"] > 1, ratios["ts_over_ti"] > 1
    if uniform:
        return "I" if steep else "IV"
    return "II" if steep else "III"


def _meaning(quadrant: str, scales: Scales) -> str:
    text = QUADRANTS[quadrant]
    if quadrant in ("I", "IV"):
        return text
    ratio = scales.ratios["tnet_over_ti"]
    if math.isinf(scales.t_i):
        return f"{text}; the input never changes"
    if scales.t_i == 0.0:
        return f"{text}; the input jumps, and the network takes {scales.t_net:.3g} s to settle"
    if scales.t_net == 0.0:
        return f"{text}; no tube separates the bellows from their inlet"
    if ratio < NEARLY_UNIFORM:
        return (
            f"{text}; but the whole network settles {1 / ratio:.3g} times faster than the input "
            f"changes (t_net/t_i = {ratio:.2g}), so the pressure is nearly uniform"
        )
    if ratio > FAR_TOO_SLOW:
        return (
            f"{text}; but the whole network settles {ratio:.3g} times slower than the input "
            f"changes (t_net/t_i), so the far bellows hardly move within one swing"
        )
    return f"{text}; t_net/t_i = {ratio:.2g}, the pressure lags and varies along the network"
