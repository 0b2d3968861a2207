"""What numbers of such actuators are beside others of the same scene.

As in `plausible_ranges`, the bounds are our choice: some thousand times wider than the paper's leg
to either side, so that they catch slips of prefix, unit and exponent and judge no design.
"""

from __future__ import annotations

from collections.abc import Iterator

from viscodesign.checks.plausible_ranges import PlausibleRange
from viscodesign.scene.scene import Scene

PREFIXES = (1e-6, 1e-3, 1e-9, 1e6, 1e3, 1e9)
"""Likely factors of a slip in a coefficient."""
GRAMS = (1e-3, 1e-6)
ANY = (-float("inf"), float("inf"))
"""No value is impossible: a large one is solved like any other."""


def relative_ranges(scene: Scene) -> Iterator[PlausibleRange]:
    """Ranges that follow from the modulus, the sizes and the mass of a scene."""
    body, bellows = scene.actuator, scene.bellows
    modulus, face = body.youngs_modulus, bellows.height * bellows.width
    section = body.length / (bellows.count // 2)
    yield _both(
        "bellows.area_per_pressure",
        "m^2/Pa",
        (0.01 * face / modulus, 1e5 * face / modulus),
        "a wall of the actuator's modulus, from massive to thin as a film",
    )
    yield _up_to(
        "bellows.angle_per_pressure", "rad", 1e4, "a section that turns by a few rad at E/1000"
    )
    yield _up_to(
        "bellows.extension_per_pressure",
        "m",
        1e4 * section,
        "a section that doubles its length at E/10 000",
    )
    yield _up_to(
        "bellows.area_per_force", "m^2/N", 1e3 / modulus, "a section that grows as the rod's strain"
    )
    yield _up_to(
        "bellows.area_per_moment",
        "m^2/(N*m)",
        1e4 / (modulus * section),
        "a section that grows as the rod's curvature",
    )
    area = body.height * body.width
    strength = modulus * area
    heaviest = max(1e3 * body.density * area * body.length, strength / 9.81)
    yield PlausibleRange(
        "loads.payload", "kg", 0.0, heaviest, "a thousand times the actuator itself", GRAMS, ANY
    )
    for axis in "xz":
        key = f"loads.tip_force.{axis}"
        words = "what stretches the actuator to twice its length"
        yield PlausibleRange(key, "N", -strength, strength, words, GRAMS, ANY)


def _both(key: str, unit: str, bounds: tuple[float, float], source: str) -> PlausibleRange:
    return PlausibleRange(key, unit, *bounds, source, PREFIXES, ANY)


def _up_to(key: str, unit: str, most: float, source: str) -> PlausibleRange:
    """Give the range of a coefficient of either sign."""
    return PlausibleRange(key, unit, -most, most, source, PREFIXES, ANY)
