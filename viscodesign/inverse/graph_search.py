"""Designs over graphs: the one of the spec, all chains, or trees."""

from __future__ import annotations

from viscodesign.inverse.number_search import NumberDesign, search_numbers
from viscodesign.inverse.search_task import SearchTask
from viscodesign.scene.scene import Scene


def search_designs(task: SearchTask, scene: Scene) -> list[NumberDesign]:
    """Designs of a posed scene, the best first."""
    return search_numbers(task, scene)
