"""A compiled function for many designs, with every effect that the spec allows.

Which effects a design needs would have to be asked of each. The estimates that choose them take 1.6
(16 bellows) to 3.3 times (4) as long as a compiled solution, the effects that need not be there 0.4
to 1.7 times. With all of them, no design lacks one.
"""

from __future__ import annotations

from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.compiled.function import CompiledFunction
from viscodesign.effects.select import select_effects
from viscodesign.errors import ViscodesignError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.results.metrics import METRIC_NAMES
from viscodesign.scene.effects_choice import EffectsChoice
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import copied


def with_all_effects(scene: Scene) -> Scene:
    """The scene with all effects on that its spec does not turn off and that act on something."""
    selection = select_effects(SceneQuantities(scene))
    if selection.active == selection.everything:
        return scene
    modes = dict.fromkeys(sorted(selection.everything), "on")
    choice = EffectsChoice.model_validate({**modes, "others": "off"})
    found: Scene = copied(scene, {"effects": choice})
    return found


def compiled_metrics(keys: FreeKeys) -> CompiledFunction | None:
    """All metrics as a function of free numbers; None for a scene that cannot be compiled."""
    try:
        return CompiledFunction(with_all_effects(keys.scene), keys.names, METRIC_NAMES)
    except ViscodesignError:
        return None
