"""A check of a scene, and of what it says of its numbers, which needs their derivatives' keys."""

from __future__ import annotations

from viscodesign.checks.check import Check
from viscodesign.checks.check import check as check_scene
from viscodesign.scene.scene import Scene
from viscodesign.studies.stated_uncertainty import stated_deviations


def check(scene: Scene) -> Check:
    """Weigh every effect and test every assumption that needs no solution.

    Raises `SpecError` where the scene has no bounded solution, or where its `uncertainty` says of
    numbers what cannot be said of them.
    """
    found = check_scene(scene)
    stated_deviations(scene)
    return found
