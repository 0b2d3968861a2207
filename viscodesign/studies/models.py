"""The models that a spec allows: sets of effects under a name."""

from __future__ import annotations

from viscodesign.effects.select import Selection
from viscodesign.results.accuracy_study import Model

FORMS = {
    "IV": {"pressure_distribution": False, "inertia": False},
    "III": {"pressure_distribution": True, "inertia": False},
    "I": {"pressure_distribution": False, "inertia": True},
    "II": {"pressure_distribution": True, "inertia": True},
}
"""Effects that are on or off in each quadrant of the paper, cheapest first."""


def allowed_models(selection: Selection) -> tuple[tuple[Model, ...], tuple[str, ...]]:
    """The different sets of effects, cheapest first, and notes on quadrants that are not allowed.

    A set with several names is listed once: `auto` before `everything` before a quadrant.
    """
    sets = {
        "auto": selection.taken,
        "everything": selection.everything,
        **{name: selection.turned(form) for name, form in FORMS.items()},
    }
    names: dict[frozenset[str], list[str]] = {}
    for name, found in sets.items():
        if found is not None:
            names.setdefault(found, []).append(name)
    models = [
        Model(own, tuple(e.name for e in selection.members(found)), tuple(others))
        for found, (own, *others) in names.items()
    ]
    refused = tuple(name for name, found in sets.items() if found is None)
    return tuple(sorted(models, key=_cost)), _refused_notes(refused)


def _cost(model: Model) -> tuple[bool, bool, int]:
    return model.is_distributed, model.is_inertial, len(model.effects)


def _refused_notes(refused: tuple[str, ...]) -> tuple[str, ...]:
    if not refused:
        return ()
    words = ", ".join(f"{name} ({Model(name, _effects(name)).words})" for name in refused)
    return (
        f"models left out, as the spec or the scene does not allow them: {words}; use "
        "--set effects=auto to let the study choose",
    )


def _effects(name: str) -> tuple[str, ...]:
    return tuple(effect for effect, on in FORMS[name].items() if on)
