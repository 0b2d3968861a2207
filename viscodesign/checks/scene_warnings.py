"""Where the model's assumptions end: what the numbers of a scene give away.

Nothing here changes a result: what the numbers show before anything is solved is reported.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.results.findings import Notice, Verdict
from viscodesign.scene.bellows import falls, first_peak

STEEP_RECIPROCITY = 1.05


def scene_notices(quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Notice]:
    """What can be said before anything is solved with these effects."""
    yield from _pressure_notices(quantities, active)
    yield from _reciprocity_notices(quantities)
    yield from _network_notices(quantities)
    yield from _curve_notices(quantities)


def verdict_notices(verdicts: Iterable[Verdict]) -> Iterator[Notice]:
    """Effects that a spec switches off although its scene needs them."""
    for verdict in verdicts:
        if verdict.mode == "off" and not verdict.taken and verdict.budget_share > 1.0:
            yield Notice(
                "needed_effect_off",
                f"effects.{verdict.name} is off, but it would move the tip by about "
                f"{1e3 * verdict.contribution_m:.3g} mm, {verdict.budget_share:.3g} times the "
                "accuracy asked for; use auto",
                f"effects.{verdict.name}",
            )


def _pressure_notices(quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Notice]:
    scene, law = quantities.scene, quantities.bellow
    low = quantities.lowest_pressure
    absolute = scene.ambient_pressure + low
    if absolute <= 0.0:
        yield Notice(
            "below_vacuum",
            f"the lowest inlet pressure, {low / 1e3:.4g} kPa gauge, is {absolute / 1e3:.4g} kPa "
            "absolute: below vacuum, which no pump reaches",
            "input",
        )
    elif scene.fluid.vapour_pressure is not None and absolute < scene.fluid.vapour_pressure:
        yield Notice(
            "cavitation",
            f"the lowest inlet pressure, {low / 1e3:.4g} kPa gauge, is {absolute / 1e3:.4g} kPa "
            f"absolute, below the vapour pressure of {scene.fluid.name} "
            f"({scene.fluid.vapour_pressure / 1e3:.3g} kPa)",
            "input",
        )
    elif absolute < 0.05 * scene.ambient_pressure:
        yield Notice(
            "near_vacuum",
            f"the lowest inlet pressure, {low / 1e3:.4g} kPa gauge, is {absolute / 1e3:.3g} kPa "
            "absolute: near vacuum",
            "input",
        )
    lowest_volume = law.rest_volume + law.compliance * low
    # Where the floor is weighed and left out, no bellow comes near it.
    forced = quantities.scene.effects.mode("collapse") == "off"
    follows_law = forced and not active & {"collapse", "material_curve"}
    if lowest_volume < law.floor_volume and follows_law:
        empty = -law.rest_volume / law.compliance
        yield Notice(
            "negative_volume" if lowest_volume <= 0.0 else "collapse",
            f"at {low / 1e3:.4g} kPa gauge the linear law gives a bellow of "
            f"{lowest_volume / law.rest_volume:.3g} of its rest volume (none is left below "
            f"{empty / 1e3:.4g} kPa gauge); a real bellow collapses at about "
            f"{law.floor_volume / law.rest_volume:.3g}",
            "bellows",
        )


def _reciprocity_notices(quantities: SceneQuantities) -> Iterator[Notice]:
    """Volume per resultant against strain per pressure: equal in a reciprocal coupling."""
    if quantities.scene.effects.mode("feedback") == "off":
        return
    law, b = quantities.bellow, quantities.scene.bellows
    section = quantities.body.section_length
    for strain, resultant, found in (
        (law.curvature_per_pressure * section, "moment", law.length * b.area_per_moment),
        (law.stretch_per_pressure * section, "force", law.length * b.area_per_force),
    ):
        if found * strain < 0.0:
            yield Notice(
                "not_passive",
                f"volume per {resultant} and strain per pressure have opposite signs "
                f"({found:.3g} and {strain:.3g}): the coupling creates energy",
                "bellows",
            )
        elif found and not 1 / STEEP_RECIPROCITY < strain / found < STEEP_RECIPROCITY:
            yield Notice(
                "not_reciprocal",
                f"volume per {resultant} is {found:.3g}, strain per pressure {strain:.3g}, a "
                f"factor of {strain / found:.3g}: an elastic body has them equal, so the coupling "
                "does work of its own",
                "bellows",
            )


def _curve_notices(quantities: SceneQuantities) -> Iterator[Notice]:
    curve = quantities.scene.bellows.curve
    rows = (curve.rows or ()) if curve is not None else ()
    if falls(rows) and quantities.scene.effects.mode("material_curve") != "off":
        peak = first_peak(rows)
        yield Notice(
            "snapping_curve",
            f"by bellows.curve a bellow snaps at {peak / 1e3:.4g} kPa gauge, where its pressure "
            "falls as it swells: under such a pressure equal bellows swell one after another, and "
            "small differences decide which is first",
            "bellows.curve",
        )


def _network_notices(quantities: SceneQuantities) -> Iterator[Notice]:
    for component in quantities.graph.components():
        if not component.fed and component.bellows:
            yield Notice(
                "sealed_island",
                f"no inlet reaches {', '.join(component.bellows)}: what they hold stays in them",
                "network",
            )
