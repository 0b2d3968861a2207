"""The models that a spec allows: sets of effects under a name."""

from __future__ import annotations

from viscodesign.effects.base import Trait
from viscodesign.effects.catalogue import names_with, traits_of
from viscodesign.effects.select import Selection
from viscodesign.results.accuracy_points import Model

PRESSURE, INERTIA = Trait.DISTRIBUTED_PRESSURE, Trait.ROD_INERTIA
FORMS: dict[str, frozenset[Trait]] = {
    "IV": frozenset(),
    "III": frozenset({PRESSURE}),
    "I": frozenset({INERTIA}),
    "II": frozenset({PRESSURE, INERTIA}),
}
"""The quadrants' models, the cheapest first, by which of the two traits they have."""


def allowed_models(selection: Selection) -> tuple[tuple[Model, ...], tuple[str, ...]]:
    """The different sets of effects, cheapest first, and notes on quadrants that are not allowed.

    A set with several names is listed once: `auto` before `everything` before a quadrant.
    """
    sets = {
        "auto": selection.active,
        "everything": selection.everything,
        **{name: selection.switched(_modes(form)) for name, form in FORMS.items()},
    }
    names: dict[frozenset[str], list[str]] = {}
    for name, found in sets.items():
        if found is not None:
            names.setdefault(found, []).append(name)
    models = [
        _model(own, tuple(e.name for e in selection.members(found)), tuple(others))
        for found, (own, *others) in names.items()
    ]
    refused = tuple(name for name, found in sets.items() if found is None)
    return tuple(sorted(models, key=_cost)), _refused_notes(refused)


def _cost(model: Model) -> tuple[bool, bool, int]:
    return model.is_distributed, model.is_inertial, len(model.effects)


def _refused_notes(refused: tuple[str, ...]) -> tuple[str, ...]:
    if not refused:
        return ()
    models = [_model(name, _with_traits(FORMS[name])) for name in refused]
    words = ", ".join(f"{model.name} ({model.words})" for model in models)
    return (
        f"models left out, as the spec or the scene does not allow them: {words}; use "
        "--set effects=auto to let the study choose",
    )


def _model(name: str, effects: tuple[str, ...], also: tuple[str, ...] = ()) -> Model:
    traits = traits_of(effects)
    return Model(name, effects, also, PRESSURE in traits, INERTIA in traits)


def _modes(form: frozenset[Trait]) -> dict[str, bool]:
    """Which effects a form switches on, and which off."""
    return {name: trait in form for trait in (PRESSURE, INERTIA) for name in names_with(trait)}


def _with_traits(form: frozenset[Trait]) -> tuple[str, ...]:
    return tuple(name for name, on in _modes(form).items() if on)
