"""All effects of this version, found by their files."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from functools import cache
from typing import TYPE_CHECKING, TypeVar

from viscodesign import effects
from viscodesign.effects.base import Effect, Trait
from viscodesign.plugins import members
from viscodesign.scene.robot_scene import RobotScene
from viscodesign.scene.scene import Scene
from viscodesign.scene.several_scene import SeveralScene
from viscodesign.scene.spec_part import SpecPart, copied

if TYPE_CHECKING:
    from viscodesign.estimate.scene_quantities import SceneQuantities


SpecT = TypeVar("SpecT", bound=Scene | SeveralScene | RobotScene)


def catalogue() -> dict[str, type[Effect]]:
    """Every effect by its name, in the order of listing and joining."""
    if not all(map(_is_current, _catalogue().values())):
        _catalogue.cache_clear()
    return _catalogue()


@cache
def _catalogue() -> dict[str, type[Effect]]:
    return members(effects.__name__, Effect)  # type: ignore[type-abstract]


def _is_current(kind: type[Effect]) -> bool:
    """Whether a class is still what its module has by its name: one that was reloaded has not."""
    return getattr(sys.modules.get(kind.__module__), kind.__name__, None) is kind


def effect_names() -> tuple[str, ...]:
    """Names that a spec may switch."""
    return tuple(catalogue())


def option_kinds() -> dict[str, type[SpecPart]]:
    """The classes of the options of effects that have some, by name."""
    kinds = catalogue().items()
    return {name: kind.options for name, kind in kinds if kind.options is not None}


def every_effect(quantities: SceneQuantities) -> dict[str, Effect]:
    """All effects of a scene by name, whether they act on something or not."""
    kinds = catalogue()

    def made() -> dict[str, Effect]:
        return {name: kind.of(quantities) for name, kind in kinds.items()}

    return dict(quantities.remembered(("effects", *kinds.values()), made))


def with_default_options(scene: SpecT, names: Iterable[str]) -> SpecT:
    """The spec with the options of these effects spelt out, which means the same."""
    choice, kinds = scene.effects, option_kinds()
    unsaid = {n: kinds[n]() for n in names if n in kinds and n not in choice.options}
    return copied(scene, {"effects": choice.with_options(unsaid)}) if unsaid else scene


def traits_of(names: Iterable[str]) -> frozenset[Trait]:
    """What these effects make of the model."""
    known = catalogue()
    return frozenset(trait for name in names for trait in known[name].traits)


def names_with(trait: Trait) -> tuple[str, ...]:
    """Names of the effects that have a trait."""
    return tuple(name for name, kind in catalogue().items() if trait in kind.traits)
