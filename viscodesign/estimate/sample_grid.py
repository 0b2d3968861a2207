"""The times at which a motion is estimated."""

from __future__ import annotations

import itertools
import math

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.scene import Scene
from viscodesign.storage.cached_property import cached_property
from viscodesign.storage.distinct import distinct


@dataclass(frozen=True)
class GridDensity:
    """How many samples an estimate has, and how long it lasts."""

    between_corners: int = 80
    """Samples of a run between its corners; also the most outputs that are compared."""
    per_period: int = 12
    most_swings: int = 60
    """Swings of the input after which an estimate ends: a longer train repeats itself."""
    fewest_outputs: int = 24
    """Output times that an estimate must reach, where it ends before the run does."""
    behind_corner: int = 10
    """Graded samples behind every corner."""
    least_move: float = 0.01
    """Change of an input, relative to its range, that makes a swing where it has so many corners
    that an estimate must end before them: rows of a recording that rests are not swings."""
    first_step: float = 1e-3
    """Smallest graded step behind a corner, relative to the time to the next one."""


DENSITY = GridDensity()


@dataclass(frozen=True, eq=False)
class SampleGrid:
    """Samples of a scene's run, the start and each corner twice: just before it and after."""

    scene: Scene

    @cached_property
    def _grid(self) -> tuple[np.ndarray, np.ndarray]:
        """Samples (T,), and a shift of those that stand just before a corner (T,) [s]."""
        scene = self.scene
        sources = scene.inputs.values()
        duration = self._window()
        corners = sorted({c for s in sources for c in swings_of(s, duration)})
        periods = max((duration / s.period for s in sources if s.period is not None), default=1)
        plain = max(DENSITY.between_corners, int(DENSITY.per_period * periods))
        outputs = scene.run.output_times_array()
        outputs = outputs[outputs <= duration * (1 + 1e-12)]
        few = outputs[:: max(1, len(outputs) // DENSITY.between_corners)]
        parts = [np.linspace(0.0, duration, plain), few, np.array(corners)]
        stops = [0.0, *corners, duration]
        grades = np.geomspace(DENSITY.first_step, 1.0, DENSITY.behind_corner)
        parts += [a + (b - a) * grades for a, b in itertools.pairwise(stops)]
        time = distinct(np.clip(np.concatenate(parts), 0.0, duration))
        before = np.array(corners)
        everything = np.concatenate([[0.0], time, before])
        sides = (np.array([-1.0]), np.zeros(len(time)), np.full(len(before), -1.0))
        shift = 1e-9 * duration * np.concatenate(sides)
        order = np.argsort(everything + shift, kind="stable")
        # A sample that lies closer before a corner than the shift would follow it.
        return np.maximum.accumulate(everything[order]), shift[order]

    def _window(self) -> float:
        """Time up to which the motion is estimated [s]; whole periods of a run on its cycle."""
        scene = self.scene
        ends = [scene.run.duration]
        for source in scene.inputs.values():
            if source.period is not None:
                ends.append(DENSITY.most_swings / 2 * source.period)
            swings = swings_of(source, scene.run.duration)
            if len(swings) > DENSITY.most_swings:
                ends.append(swings[DENSITY.most_swings])
        period = scene.period if scene.run.start == "periodic" else None
        return min(ends) if period is None else period * math.ceil(min(ends) / period - 1e-9)

    @property
    def is_cut(self) -> bool:
        """Whether it ends before an input that does not repeat itself does."""
        inputs = self.scene.inputs.values()
        is_short = self.time[-1] < self.scene.run.duration * (1 - 1e-9)
        return bool(is_short and any(source.period is None for source in inputs))

    @property
    def time(self) -> np.ndarray:
        """Samples (T,); the start and each corner twice: before it and after [s]."""
        return self._grid[0]

    @cached_property
    def output_mask(self) -> np.ndarray:
        """Indices of the samples that are output times (n,).

        All samples where the estimate of a long train ends before it has reached enough
        outputs: those that follow may fall on any part of a cycle.
        """
        outputs = self.scene.run.output_times_array()
        nearest = np.searchsorted(outputs, self.time)
        near = np.minimum(
            np.abs(outputs[np.clip(nearest, 0, len(outputs) - 1)] - self.time),
            np.abs(outputs[np.clip(nearest - 1, 0, len(outputs) - 1)] - self.time),
        )
        # An output at a corner is the motion just before it, but just after the start.
        after = np.concatenate([[False], np.diff(self.time) == 0.0])
        after[:2] = [True, False]
        found = np.flatnonzero((near <= 1e-9 * self.time[-1]) & ~after)
        is_cut = self.time[-1] < self.scene.run.duration
        return np.flatnonzero(~after) if is_cut and len(found) < DENSITY.fewest_outputs else found

    def values(self, name: str) -> np.ndarray:
        """An input's values at the samples (T,), on the right side of every corner."""
        time, shift = self._grid
        source = self.scene.inputs[name]
        found = np.array(source.values(np.maximum(time + shift, 0.0)), dtype=float)
        found[0] = source.expression(0.0, source.initial_piece(), np)
        return found


def swings_of(source: Input, duration: float) -> list[float]:
    """Corners of an input up to a time [s]; of very many, those up to which it has moved."""
    corners = list(source.corners(duration))
    if len(corners) <= DENSITY.most_swings:
        return corners
    time = np.array(corners)
    after = np.asarray(source.values(time), dtype=float)
    before = np.asarray(source.values(np.nextafter(time, 0.0)), dtype=float)
    last = float(source.values(np.zeros(1))[0])
    low, high = source.extremes(duration)
    least, moved = DENSITY.least_move * (high - low), []
    for corner, one, other in zip(corners, before.tolist(), after.tolist(), strict=True):
        if max(abs(one - last), abs(other - last)) >= least:
            moved.append(corner)
            last = other
    return moved
