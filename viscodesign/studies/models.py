"""The forms of a model that a spec lets one choose between."""

from __future__ import annotations

from viscodesign.effects.select import Selection
from viscodesign.results.accuracy_study import Model

FORMS = {
    "IV": {"pressure_distribution": False, "inertia": False},
    "III": {"pressure_distribution": True, "inertia": False},
    "I": {"pressure_distribution": False, "inertia": True},
    "II": {"pressure_distribution": True, "inertia": True},
}
"""The quadrants' forms, the cheapest first, as what is on and what is off."""


def models_of(selection: Selection) -> tuple[tuple[Model, ...], tuple[str, ...]]:
    """Different sets of effects, the cheapest first; and notes on forms that are not allowed.

    A set that has several names is there once, `auto` before `everything` before a
    quadrant's number.
    """
    wanted = {
        "auto": selection.taken,
        "everything": selection.everything,
        **{name: selection.turned(form) for name, form in FORMS.items()},
    }
    names: dict[frozenset[str], list[str]] = {}
    for name, found in wanted.items():
        if found is not None:
            names.setdefault(found, []).append(name)
    models = [
        Model(own, tuple(e.name for e in selection.members(found)), tuple(others))
        for found, (own, *others) in names.items()
    ]
    refused = tuple(name for name, found in wanted.items() if found is None)
    return tuple(sorted(models, key=_cost)), _told(refused)


def _cost(model: Model) -> tuple[bool, bool, int]:
    return model.is_distributed, model.is_inertial, len(model.effects)


def _told(refused: tuple[str, ...]) -> tuple[str, ...]:
    if not refused:
        return ()
    words = ", ".join(f"{name} ({Model(name, _effects(name)).words})" for name in refused)
    return (
        f"forms left out because the spec or the scene does not allow them: {words}; "
        "--set effects=auto lets the study choose",
    )


def _effects(name: str) -> tuple[str, ...]:
    return tuple(effect for effect, on in FORMS[name].items() if on)
