"""Which effects a scene calls for, and why."""

from __future__ import annotations

from functools import cache

from viscodesign import effects
from viscodesign.catalog import members
from viscodesign.effects.base import Effect
from viscodesign.effects.conditions import Conditions
from viscodesign.trajectory import Verdict

RESERVED_EFFECTS = (
    "rotary_inertia",
    "gas_compressibility",
    "fluid_inertance",
    "flow_regime",
    "tube_compliance",
    "collapse",
    "material_curve",
    "fluid_mass",
)
"""Names of the public spec that this version does not compute: legal only when off."""


@cache
def catalogue() -> dict[str, type[Effect]]:
    """Every effect of this version by name, in the order of judgement."""
    return members(effects.__name__, Effect)  # type: ignore[type-abstract]


def effect_names() -> tuple[str, ...]:
    """Names that a spec may switch."""
    return tuple(name for name, kind in catalogue().items() if kind.switchable)


def select_effects(conditions: Conditions) -> tuple[list[Effect], list[Verdict]]:
    """The effects to join, and a verdict for every one of the catalogue.

    ``conditions.taken`` is filled on the way: a later effect may ask for it.
    """
    chosen: list[Effect] = []
    verdicts: list[Verdict] = []
    for kind in catalogue().values():
        effect = kind.of(conditions)
        verdict = judge(effect, conditions)
        verdicts.append(verdict)
        if verdict.taken:
            chosen.append(effect)
            conditions.taken.add(effect.name)
    return chosen, verdicts


def judge(effect: Effect, conditions: Conditions) -> Verdict:
    """Weigh one effect against its threshold and the spec's own word."""
    mode = conditions.scene.effects.mode(effect.name) if effect.switchable else "on"
    present = effect.present(conditions)
    weight = effect.weight(conditions) if present else 0.0
    threshold = effect.threshold(conditions)
    wanted = weight > threshold if mode == "auto" else mode == "on"
    return Verdict(
        name=effect.name,
        mode=mode,
        taken=wanted and present,
        weight=weight,
        formula=effect.formula,
        reason=_sentence(effect.reason(conditions), mode, present, weight, threshold),
    )


def _sentence(reason: str, mode: str, present: bool, weight: float, threshold: float) -> str:
    if not present:
        return f"absent: {reason}"
    if mode != "auto":
        return f"{'taken' if mode == 'on' else 'left out'} as the spec says; {reason}"
    above = weight > threshold
    return (
        f"{'taken' if above else 'left out'}: weight {weight:.3g} "
        f"{'above' if above else 'not above'} {threshold:.3g}; {reason}"
    )
