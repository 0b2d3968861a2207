"""Bellows and tubes that are larger than the space that they lie in."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from viscodesign.checks.written_numbers import written
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Notice
from viscodesign.scene.scene import Scene

LARGEST_SHARE = 1.001
"""Share of the space at hand that parts may take, with a margin for rounding."""


@dataclass(frozen=True)
class _Space:
    """Parts and the spaces that they must lie in, each of both for every section."""

    key: str
    sizes: np.ndarray
    """Mean size of the parts of a space [m]."""
    count: int
    words: str
    outer: str
    spaces: np.ndarray
    """[m]"""


def misfits(scene: Scene) -> Iterator[Notice]:
    """Parts that are larger than the space that they lie in."""
    for own in _spaces(scene):
        tightest = int(np.argmax(own.sizes / own.spaces))
        size, space = float(own.sizes[tightest]), float(own.spaces[tightest])
        if own.count * size > LARGEST_SHARE * space:
            needed, free = written(own.count * size, "m"), written(space, "m")
            message = f"{own.words} needs {needed} and cannot lie within {own.outer}, {free}"
            yield Notice("does_not_fit", f"{written(size, 'm')}: {message}", own.key)
    opening = float(min(np.min(scene.bellows.each(name)) for name in ("height", "width")))
    widest = max(scene.graph.tubes, key=lambda tube: tube.radius)
    if 2 * widest.radius > LARGEST_SHARE * opening:
        yield Notice(
            "does_not_fit",
            f"tube {widest.name} is {written(2 * widest.radius, 'm')} wide, more than the "
            f"bellows' smaller side of {written(opening, 'm')}; is it a diameter, or in another "
            "unit?",
            "network.tube_radius",
        )


def _spaces(scene: Scene) -> Iterator[_Space]:
    """What must fit: pairs of bellows, single ones, and all of a column in a row."""
    pairs = scene.bellows.count // 2
    high, wide, long = (
        np.broadcast_to(scene.bellows.each(name), 2 * pairs).reshape(2, pairs)
        for name in ("height", "width", "length")
    )
    height, width = (
        np.broadcast_to(scene.sections.each(name), pairs) for name in ("height", "width")
    )
    mean, whole = np.max(wide, axis=0).mean(), np.array([scene.actuator.length])
    yield _Space("bellows.height", high.mean(axis=0), 2, "a pair", "actuator.height", height)
    yield _Space("bellows.length", long.max(axis=0), 1, "a bellow", "actuator.width", width)
    row = f"a row of {pairs}"
    yield _Space("bellows.width", np.array([mean]), pairs, row, "actuator.length", whole)
