"""Limits of the model whatever its effects are: of pressures, volumes and strains."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.physics import beam
from viscodesign.postprocess.motion_limits import Limit, MotionBlock, Peak
from viscodesign.results.findings import Notice

SMALL_STRETCH = 0.2
LARGE_STRETCH = 2.0
"""Length of a section, of that at rest, from which no linear law can be trusted: there a
neo-Hookean elastomer, whose force goes as s - 1/s^2 with its stretch s, pulls 1.7 times less
than its slope at rest says."""


def model_limits(quantities: SceneQuantities) -> Iterator[Limit]:
    """The limits of every run of a scene."""
    yield _vacuum(quantities)
    yield from _strains()
    yield _self_contact(quantities)
    yield Limit(lambda block: np.abs(block.section_turn.sum(axis=1)), 2 * np.pi, _full_turn)


def _vacuum(quantities: SceneQuantities) -> Limit:
    scene, names = quantities.scene, quantities.graph.bellows
    vapour = scene.fluid.vapour_pressure or 0.0

    def notice(peak: Peak) -> Notice:
        name, absolute = names[peak.column], scene.ambient_pressure - peak.value
        floor = f"the vapour pressure {vapour / 1e3:.3g} kPa" if vapour else "vacuum"
        return Notice(
            "cavitation" if vapour else "below_vacuum",
            f"{name} falls to {absolute / 1e3:.4g} kPa absolute, below {floor}",
            name,
            peak.time_s,
        )

    bound = scene.ambient_pressure - vapour
    return Limit(lambda block: -block.pressure, bound, notice, inclusive=True)


def _strains() -> Iterator[Limit]:
    yield Limit(lambda block: -block.section_stretch, -SMALL_STRETCH, _compressed, inclusive=True)
    yield Limit(lambda block: block.section_stretch, LARGE_STRETCH, _stretched)


def _compressed(peak: Peak) -> Notice:
    where = f"section {peak.column + 1}"
    return Notice(
        "small_stretch",
        f"{where} is compressed to {-100 * peak.value:.3g} % of its length",
        where,
        peak.time_s,
    )


def _stretched(peak: Peak) -> Notice:
    where = f"section {peak.column + 1}"
    return Notice(
        "large_stretch",
        f"{where} is stretched to {peak.value:.3g} times its length or more: no elastomer is "
        "linear at such strains; lower the loads or the pressure, or check "
        "actuator.youngs_modulus and actuator.extension_factor",
        where,
        peak.time_s,
    )


def _self_contact(quantities: SceneQuantities) -> Limit:
    section, height = quantities.body.section_lengths, quantities.scene.sections.each("height")

    def inner_fibre(block: MotionBlock) -> np.ndarray:
        length = block.section_stretch * section
        return -beam.inner_fibre_stretch(length, height, block.section_turn)

    def notice(peak: Peak) -> Notice:
        where = f"section {peak.column + 1}"
        return Notice(
            "self_contact",
            f"{where} bends so sharply that its inner side would have a negative length: "
            "neighbouring sections touch",
            where,
            peak.time_s,
        )

    return Limit(inner_fibre, 0.0, notice, inclusive=True)


def _full_turn(peak: Peak) -> Notice:
    return Notice(
        "full_turn",
        f"the actuator turns by {peak.value:.3g} rad, more than a full turn: it would pass "
        "through itself in the plane",
        "rod",
        peak.time_s,
    )
