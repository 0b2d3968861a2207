"""The verdict on every effect, in words for the user."""

from __future__ import annotations

from viscodesign.effects.allowed_sets import AllowedSets, Names
from viscodesign.results.findings import Verdict


def verdict(
    sets: AllowedSets, name: str, active: Names, moved: float, *, by_weight: bool = False
) -> Verdict:
    """Why one effect is active or not; ``moved``: how far it moves the tip [m].

    ``by_weight``: whether that is its weight, at most 1, in actuator lengths.
    """
    effect, quantities, present = sets.effects[name], sets.quantities, name in sets.present
    share = moved / quantities.requested_m
    return Verdict(
        name=name,
        mode=sets.mode(name),  # type: ignore[arg-type]
        taken=name in active,
        weight=effect.weight(quantities) if present else 0.0,
        formula=effect.formula,
        reason=_sentence(sets, name, active, _displacement(moved, share, by_weight)),
        contribution_m=moved,
        budget_share=share,
        present=present,
        traits=tuple(sorted(trait.name.lower() for trait in effect.traits)),
    )


def _displacement(moved: float, share: float, by_weight: bool) -> str:
    """What an effect does to the tip; of a mere weight, only that it is small."""
    if by_weight and share >= 1.0:
        return "may move the tip by more than the accuracy, as its weight says"
    return f"moves the tip by about {1e3 * moved:.3g} mm, {_of_accuracy(share)}"


def _sentence(sets: AllowedSets, name: str, active: Names, moves: str) -> str:
    effect, mode = sets.effects[name], sets.mode(name)
    reason = effect.reason(sets.quantities)
    if name not in sets.present:
        if effect.replaced_by in sets.present and effect.present(sets.quantities):
            return f"not applicable: replaced by {effect.replaced_by}"
        return f"not applicable: {reason}"
    if not sets.acts_in(name, active):
        missing = " and ".join(n for n in effect.needs if n not in active)
        return f"neglected with {missing}, without which it has nothing to act on; {reason}"
    if mode != "auto":
        return f"{'included' if mode == 'on' else 'neglected'}: set in the spec; {reason}"
    if name not in active:
        return f"neglected: {moves}; {reason}"
    if effect.indispensable(sets.quantities):
        return f"included: this scene requires it; {reason}"
    if sets.costs_nothing(name, active):
        return f"included: no extra cost beside {effect.free_with}; {moves}; {reason}"
    return f"included: {moves}; {reason}"


def _of_accuracy(share: float) -> str:
    """A part of the requested accuracy, or a multiple of it."""
    if share < 1.0:
        return f"{100 * share:.2g} % of the accuracy"
    return f"{share:.3g} times the accuracy"
