"""What numbers of such actuators are beside others of the same scene.

As in `plausible_ranges`, the bounds are our choice, some hundred times wider than the paper's leg
to either side: they catch slips of prefix, unit and exponent and judge no design.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from viscodesign.checks.plausible_ranges import ANY, PlausibleRange
from viscodesign.scene.scene import Scene

PREFIXES = (1e-6, 1e-3, 1e-9, 1e6, 1e3, 1e9)
"""Likely factors of a slip in a coefficient."""
LEVELS = (1e-3, 1e3, 1e-6, 1e6)
GRAMS = (1e-3, 1e-6)
SOLID = "a massive wall (0.2 A/E) to one as thin as a film (2e4 A/E, A the bellow's section)"
PUSHED = "times what the pressure does that pushes on a bellow's section alone"
GROWN = "what lets a bellow's section grow by 0.0001 to 10 of itself"
RECIPROCAL = (
    "times what the work of the pressure gives (an elastic bellow pushes as it is stretched)"
)
HUNG = "a hundred times the actuator itself, or what stretches it by a tenth"
PULLED = "what stretches the actuator by a fifth"
LIQUIDS_FLOW = "light hydrocarbons (some 1e-4 Pa*s) to syrups and honey (10 Pa*s)"
LIQUIDS_WEIGH = "light hydrocarbons (500) to mercury (13 600 kg/m^3)"
GASES_FLOW = "hydrogen (9e-6 Pa*s) to hot neon (1e-4 Pa*s)"
BOILING = "less than the ambient pressure, at which it would boil"


def relative_ranges(scene: Scene) -> Iterator[PlausibleRange]:
    """Ranges that follow from modulus, sizes and mass of a scene, and from its fluid."""
    yield from _fluid(scene)
    yield from _coefficients(scene)
    yield from _loads(scene)


def reciprocal_ranges(scene: Scene) -> Iterator[PlausibleRange]:
    """Ranges of what tension and moment do to the bellows, from what the bellows do to the rod.

    Of an elastic body the work of both is the same: l dA/dN = dzeta/dp, l dA/dM = dpsi/dp. The
    leg of the paper has 0.2 and 0.004 of that.
    """
    body, bellows = scene.actuator, scene.bellows
    per_work = 1.0 / (body.youngs_modulus * bellows.length)
    for key, unit, coefficient in (
        ("bellows.area_per_force", "m^2/N", bellows.extension_per_pressure),
        ("bellows.area_per_moment", "m^2/(N*m)", bellows.angle_per_pressure),
    ):
        size = abs(coefficient) * per_work
        if size:
            yield _sized(key, unit, (5e-5 * size, 100 * size), f"5e-5 to 100 {RECIPROCAL}")


def _coefficients(scene: Scene) -> Iterator[PlausibleRange]:
    body, bellows = scene.actuator, scene.bellows
    face = bellows.height * bellows.width / body.youngs_modulus
    yield PlausibleRange(
        "bellows.area_per_pressure", "m^2/Pa", 0.2 * face, 2e4 * face, SOLID, PREFIXES, ANY
    )
    growth = bellows.height * bellows.width / bellows.area_per_pressure
    baseline = (1e-4 * growth, 10 * growth)
    yield replace(_sized("gauge_pressure", "Pa", baseline, GROWN), slips=LEVELS)
    section, area = body.length / (bellows.count // 2), body.height * body.width
    pushed = section * bellows.height * bellows.length
    extension = pushed / (area * body.extension_factor)
    yield _sized(
        "bellows.extension_per_pressure",
        "m",
        (0.01 * extension, 1e3 * extension),
        f"0.01 to 1000 {PUSHED}",
    )
    lever, bending = body.height / 4, area * body.height**2 / 12 * body.bending_factor
    angle = pushed * lever / bending
    yield _sized(
        "bellows.angle_per_pressure", "rad", (0.02 * angle, 700 * angle), f"0.02 to 700 {PUSHED}"
    )


def _loads(scene: Scene) -> Iterator[PlausibleRange]:
    body = scene.actuator
    area = body.height * body.width
    tension = body.youngs_modulus * area * body.extension_factor
    heaviest = max(100 * body.density * area * body.length, 0.1 * tension / 9.81)
    yield PlausibleRange("loads.payload", "kg", 0.0, heaviest, HUNG, GRAMS, ANY)
    for axis in "xz":
        key = f"loads.tip_force.{axis}"
        yield PlausibleRange(key, "N", -tension / 5, tension / 5, PULLED, GRAMS, ANY)


def _fluid(scene: Scene) -> Iterator[PlausibleRange]:
    """Narrower than of any fluid, where the keys say whether it is a gas."""
    if scene.fluid.is_gas:
        yield _of_fluid("viscosity", "Pa*s", (5e-6, 1e-4), GASES_FLOW)
        return  # its density follows from its pressure and temperature
    yield _of_fluid("viscosity", "Pa*s", (1e-4, 100.0), LIQUIDS_FLOW)
    yield _of_fluid("density", "kg/m^3", (400.0, 2e4), LIQUIDS_WEIGH)
    yield _of_fluid("vapour_pressure", "Pa", (0.0, scene.ambient_pressure), BOILING)


def _of_fluid(name: str, unit: str, bounds: tuple[float, float], source: str) -> PlausibleRange:
    return PlausibleRange(f"fluid.{name}", unit, *bounds, source, (1e-3, 1e3, 1e-6, 1e6))


def _sized(key: str, unit: str, bounds: tuple[float, float], source: str) -> PlausibleRange:
    """The range of a coefficient of either sign, or of none."""
    return PlausibleRange(key, unit, *bounds, source, PREFIXES, ANY, either_sign=True, or_none=True)
