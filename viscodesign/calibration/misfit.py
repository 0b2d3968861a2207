"""Recorded runs against their models: weighted residuals of all unknown numbers at once."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from viscodesign.calibration.noise_level import shared_level
from viscodesign.calibration.recorded_columns import Measured
from viscodesign.calibration.run_model import RunModel
from viscodesign.lazy_dataclass import dataclass

PULL = 1.0
"""Standard deviation of the logarithm of a free number about the spec's value, which keeps numbers
that the data hardly determine where they are. One known to 1 % is moved by 1e-4 of its distance."""
LARGEST_LOG_STEP = 2.0


@dataclass(frozen=True)
class Unknown:
    """One unknown number of a fit."""

    name: str
    start: float
    unit: str
    is_log: bool
    """Whether equal ratios count as equal steps."""
    run: int | None = None
    """The recording that it belongs to; None for the scene's own."""
    is_clock: bool = False

    @property
    def size(self) -> float:
        """By which a number that is not logarithmic is scaled."""
        return abs(self.start) or 1.0


class Misfit:
    """Residuals, in standard deviations, of all channels and of the pull to the spec's values.

    ``levels``: standard deviation of the noise of every channel, a list a run; ``kept``: which
    samples count, (T, C) a run. Values (u,) are those of ``unknowns``, in order. ``slopes_by``:
    models that give the derivatives, on a mesh that may be coarser. Derivatives a percent off make
    no difference to where a fit ends, and take most of its time.
    """

    def __init__(
        self,
        models: Sequence[RunModel],
        unknowns: Sequence[Unknown],
        levels: Sequence[np.ndarray],
        kept: Sequence[np.ndarray],
        *,
        slopes_by: Sequence[RunModel] | None = None,
    ) -> None:
        self.slopes_by = tuple(slopes_by or models)
        self.models, self.unknowns = tuple(models), tuple(unknowns)
        self.levels, self.kept = list(levels), list(kept)
        self.pulled = [k for k, own in enumerate(unknowns) if own.run is None]

    def with_(
        self,
        *,
        models: Sequence[RunModel] | None = None,
        levels: Sequence[np.ndarray] | None = None,
        kept: Sequence[np.ndarray] | None = None,
    ) -> Misfit:
        """The same with other models, noise or samples."""
        return Misfit(
            models or self.models,
            self.unknowns,
            levels or self.levels,
            kept or self.kept,
            slopes_by=self.slopes_by,
        )

    def sizes(self, values: np.ndarray) -> np.ndarray:
        """(u,) By which a unit step of each number changes it: itself, where it is logarithmic."""
        own = zip(self.unknowns, values, strict=True)
        return np.array([value if unknown.is_log else unknown.size for unknown, value in own])

    def stepped(self, values: np.ndarray, steps: np.ndarray) -> np.ndarray:
        """(u,) Values after steps of each number, none of which is longer than a factor of e^2."""
        own = np.clip(steps, -LARGEST_LOG_STEP, LARGEST_LOG_STEP)
        is_log = np.array([unknown.is_log for unknown in self.unknowns])
        return np.asarray(np.where(is_log, values * np.exp(own), values + own * self.sizes(values)))

    @property
    def samples(self) -> int:
        """Numbers that are compared."""
        return int(sum(own.sum() for own in self.kept))

    def deviations(self, values: np.ndarray) -> list[np.ndarray]:
        """Measured minus expected (T, C) of every run, NaN where nothing was measured."""
        return [
            model.measured - model(*self._parts(values, k)) for k, model in enumerate(self.models)
        ]

    def data_residuals(self, values: np.ndarray) -> np.ndarray:
        """(n,) Of the samples that count, in standard deviations of their noise."""
        found = zip(self.deviations(values), self.levels, self.kept, strict=True)
        return np.concatenate([(apart / level)[kept] for apart, level, kept in found])

    def data_jacobian(self, values: np.ndarray) -> np.ndarray:
        """(n, u) Derivatives of `data_residuals`."""
        blocks = []
        for k, (model, level, kept) in enumerate(
            zip(self.slopes_by, self.levels, self.kept, strict=True)
        ):
            slopes = model.jacobian(*self._parts(values, k)) / level[None, :, None]
            block = np.zeros((int(kept.sum()), len(self.unknowns)))
            block[:, self._places(k)] = -slopes[kept][:, : len(self._places(k))]
            blocks.append(block)
        return np.concatenate(blocks)

    def __call__(self, values: np.ndarray) -> np.ndarray:
        """(n + f,) Residuals of the samples, and of the pull."""
        return np.concatenate([self.data_residuals(values), self._pulls(values)])

    def jacobian(self, values: np.ndarray) -> np.ndarray:
        """(n + f, u)"""
        pulls = np.zeros((len(self.pulled), len(self.unknowns)))
        for row, k in enumerate(self.pulled):
            own = self.unknowns[k]
            pulls[row, k] = 1 / (PULL * (values[k] if own.is_log else own.size))
        return np.concatenate([self.data_jacobian(values), pulls])

    def _pulls(self, values: np.ndarray) -> np.ndarray:
        found = []
        for k in self.pulled:
            own = self.unknowns[k]
            step = np.log(values[k] / own.start) if own.is_log else values[k] - own.start
            found.append(step / (PULL * (1.0 if own.is_log else own.size)))
        return np.array(found)

    def free_values(self, values: np.ndarray, run: int) -> np.ndarray:
        """(f,) Those of the scene's numbers that matter in a run."""
        return self._parts(values, run)[0]

    def _places(self, run: int) -> list[int]:
        """Unknowns of a run: those of the scene that matter in it, then its own."""
        moving = self.models[run].free_names
        return [
            k
            for k, own in enumerate(self.unknowns)
            if own.run == run or (own.run is None and own.name in moving)
        ]

    def _parts(self, values: np.ndarray, run: int) -> tuple[np.ndarray, np.ndarray]:
        own = values[self._places(run)]
        if not self.models[run].clock_is_free:
            own = np.append(own, 0.0)
        free = self.models[run].free_count
        return own[:free], own[free:]


def first_levels(model: RunModel) -> np.ndarray:
    """(C,) Noise of a run's channels before anything is fitted; that of all markers is one."""
    found = np.zeros(len(model.channels))
    for measured in Measured:
        places = [k for k, own in enumerate(model.channels) if own.measured is measured]
        for group in [[k] for k in places] if measured is not Measured.PLACE else [places]:
            if group:
                values = [model.channels[k].values for k in group]
                found[group] = shared_level(model.recording.time, values)
    return found


def noise_groups(model: RunModel) -> list[list[int]]:
    """Channels of a run that share their noise: all markers, and every other alone."""
    markers = [k for k, own in enumerate(model.channels) if own.measured is Measured.PLACE]
    others = [[k] for k in range(len(model.channels)) if k not in markers]
    return [*([markers] if markers else []), *others]
