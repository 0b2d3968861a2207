"""A compiled function for many designs, with every effect that the spec allows.

Which effects a design needs would have to be asked of each. The estimates that choose them take 1.6
(16 bellows) to 3.3 times (4) as long as a compiled solution, the effects that need not be there 0.4
to 1.7 times. With all of them, no design lacks one.
"""

from __future__ import annotations

from collections.abc import Iterable

from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.compiled.function import CompiledFunction
from viscodesign.effects.select import select_effects
from viscodesign.errors import ViscodesignError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.results.metrics import METRIC_NAMES
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import copied

FAR_BELOW = 0.01
"""Part of the accuracy for which effects are chosen that shall lack nothing."""


def with_all_effects(scene: Scene) -> Scene:
    """The scene with all effects on that its spec does not turn off and that act on something."""
    selection = select_effects(SceneQuantities(scene))
    if selection.active == selection.everything:
        return scene
    return _with(scene, selection.everything)


def with_felt_effects(scene: Scene) -> Scene:
    """The scene with those that a hundredth of its accuracy calls for.

    Others can cost far more than they do: a gas in a short tube rings at some kHz, and steps that
    follow it are as short.
    """
    return _with(scene, felt_effects(scene))


def felt_effects(scene: Scene) -> frozenset[str]:
    """Names of these."""
    finer = scene.replace({"accuracy": FAR_BELOW * scene.accuracy})
    return frozenset(select_effects(SceneQuantities(finer)).active)


def _with(scene: Scene, names: Iterable[str]) -> Scene:
    choice = scene.effects.with_modes(dict.fromkeys(sorted(names), "on"), "off")
    return copied(scene, {"effects": choice})


def compiled_metrics(keys: FreeKeys) -> CompiledFunction | None:
    """All metrics as a function of free numbers; None for a scene that cannot be compiled."""
    try:
        return CompiledFunction(with_all_effects(keys.scene), keys.names, METRIC_NAMES)
    except ViscodesignError:
        return None
