"""What the numbers of a scene violate before anything is solved; nothing here changes a result."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from viscodesign.checks.plausibility import plausibility_notices
from viscodesign.checks.resting_inputs import resting_notices
from viscodesign.checks.table_cover import table_notices
from viscodesign.effects.base import Effect
from viscodesign.effects.catalogue import every_effect
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.results.findings import Notice, Verdict

NEAR_VACUUM = 0.05
"""Absolute pressure, relative to the ambient, below which pumps rarely go."""


def scene_notices(quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Notice]:
    """Every warning about a scene that is simulated with these effects."""
    yield from plausibility_notices(quantities.scene)
    yield from table_notices(quantities.scene)
    yield from resting_notices(quantities.scene)
    yield from _pressure_notices(quantities)
    for effect in every_effect(quantities).values():
        yield from effect.warnings(quantities, active)
    yield from _network_notices(quantities)


def verdict_notices(quantities: SceneQuantities, verdicts: Iterable[Verdict]) -> Iterator[Notice]:
    """Effects that a spec switches off although its scene or others need them; changed defaults."""
    effects = every_effect(quantities)
    for verdict in verdicts:
        yield from _unmet_needs(quantities, effects[verdict.name], verdict)
        changed = effects[verdict.name].changed_default(quantities)
        if verdict.mode == "off" and not verdict.taken and verdict.budget_share > 1.0:
            yield Notice(
                "needed_effect_off",
                f"effects.{verdict.name} is off, but it would move the tip by about "
                f"{1e3 * verdict.contribution_m:.3g} mm, {verdict.budget_share:.3g} times the "
                "requested accuracy; use auto" + (f". {changed}" if changed else ""),
                f"effects.{verdict.name}",
            )
        elif verdict.taken and changed and not _says_its_version(quantities):
            yield Notice(
                "changed_default",
                f"{verdict.name} moves the tip by about {1e3 * verdict.contribution_m:.3g} mm: "
                f"{changed}, or accept the default with `spec: 1`",
                effects[verdict.name].keys[0],
            )


def _unmet_needs(quantities: SceneQuantities, effect: Effect, verdict: Verdict) -> Iterator[Notice]:
    """An effect that the spec switches on, and one off without which it acts on nothing."""
    modes = quantities.scene.effects.modes
    forbidden = [name for name in effect.needs if modes.get(name) == "off"]
    if modes.get(effect.name) == "on" and verdict.present and forbidden and not verdict.taken:
        needed = " and ".join(forbidden)
        yield Notice(
            "unmet_need",
            f"effects.{effect.name} is on, but not {needed}, without which it has nothing to act "
            f"on: it is left out; use `{needed}: auto`",
            f"effects.{effect.name}",
        )


def _says_its_version(quantities: SceneQuantities) -> bool:
    """Whether the spec was written for the keys of today."""
    return "spec" in quantities.scene.model_fields_set


def inlet_violations(quantities: SceneQuantities) -> Iterator[Notice]:
    """Pressures of the inlets at which the fluid is none."""
    scene, absolute = quantities.scene, _lowest_absolute(quantities)
    vapour, lowest = scene.fluid.vapour_pressure, _lowest_words(quantities)
    if absolute <= 0.0:
        yield Notice(
            "below_vacuum",
            f"{lowest} {absolute / 1e3:.4g} kPa absolute: below vacuum, which no pump reaches",
            "input",
        )
    elif vapour is not None and absolute < vapour:
        yield Notice(
            "cavitation",
            f"{lowest} {absolute / 1e3:.4g} kPa absolute, below the vapour pressure of "
            f"{scene.fluid.name} ({vapour / 1e3:.3g} kPa)",
            "input",
        )


def _pressure_notices(quantities: SceneQuantities) -> Iterator[Notice]:
    violations = list(inlet_violations(quantities))
    yield from violations
    absolute = _lowest_absolute(quantities)
    if not violations and absolute < NEAR_VACUUM * quantities.scene.ambient_pressure:
        yield Notice(
            "near_vacuum",
            f"{_lowest_words(quantities)} {absolute / 1e3:.3g} kPa absolute: near vacuum",
            "input",
        )


def _lowest_absolute(quantities: SceneQuantities) -> float:
    return quantities.scene.ambient_pressure + quantities.lowest_inlet_pressure


def _lowest_words(quantities: SceneQuantities) -> str:
    return f"the lowest inlet pressure, {quantities.lowest_inlet_pressure / 1e3:.4g} kPa gauge, is"


def _network_notices(quantities: SceneQuantities) -> Iterator[Notice]:
    for component in quantities.graph.components():
        if not component.fed and component.bellows:
            yield Notice(
                "sealed_island",
                f"no inlet feeds {', '.join(component.bellows)}: the fluid in them is sealed in",
                "network",
            )
