"""Bounds on a motion, and where a run leaves them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.graph import Graph
from viscodesign.postprocess.sustained import Sustained
from viscodesign.postprocess.tube_ends import end_pressures
from viscodesign.results.findings import Notice
from viscodesign.results.motion_arrays import MotionArrays, QuantityArrays
from viscodesign.storage.cached_property import cached_property


@dataclass(frozen=True, eq=False)
class MotionBlock(QuantityArrays):
    """Consecutive times of a run, each quantity read or computed when it is first asked for.

    T times, B bellows, Q tubes, S sections. Any array of a motion is an item, such as
    ``block["contact_gap"]`` (T, c); those that limits ask for most are attributes.
    """

    motion: MotionArrays
    """The whole run, of one rod."""
    rows: slice
    """Which of its times are those of the block."""
    graph: Graph
    inlets: tuple[str, ...]
    """Names of the inlets, in the order of their pressures."""

    def __getitem__(self, quantity: str) -> np.ndarray:
        return np.asarray(self.motion[quantity][self.rows])

    @cached_property
    def tip_velocity(self) -> np.ndarray:
        """(T, 3): rates of the same [m/s, m/s, rad/s].

        Means over the two intervals beside an output, so that none is above the largest rate in
        them; 0 of a single output.
        """
        first, stop, _ = self.rows.indices(len(self.motion.time))
        known = slice(max(first - 1, 0), stop + 1)
        time, tip = self.motion.time[known], self.motion.tip[known]
        rates = np.gradient(tip, time, axis=0) if len(time) > 1 else np.zeros(tip.shape)
        return np.asarray(rates[first - known.start :][: stop - first])

    @property
    def tip_speed(self) -> np.ndarray:
        """(T,) [m/s]."""
        return np.asarray(np.hypot(*self.tip_velocity[:, :2].T))

    @cached_property
    def tube_pressure(self) -> np.ndarray:
        """(T, Q) lower gauge pressure of each tube's ends [Pa]."""
        ends = end_pressures(self.graph, self.motion, self.inlets, self.rows)
        return np.asarray(np.minimum(*ends))

    @property
    def section_stretch(self) -> np.ndarray:
        """(T, S) smallest total stretch of each section [1]."""
        return self["section_stretch"]

    @property
    def section_turn(self) -> np.ndarray:
        """(T, S) angle that each section turns [rad]."""
        return self["section_turn"]


class Peak:
    """The largest of values that come block by block, with its time and its column."""

    def __init__(self) -> None:
        self.value = -np.inf
        self.time_s = 0.0
        self.column = 0
        self.columns = np.zeros(0)
        """The largest of every column (n,)."""

    def update(self, time: np.ndarray, values: np.ndarray) -> None:
        """Add rows (T, n) at times (T,)."""
        if not values.size:
            return
        row, column = np.unravel_index(int(np.argmax(values)), values.shape)
        if values[row, column] > self.value:
            self.value = float(values[row, column])
            self.time_s, self.column = float(time[row]), int(column)
        highest = values.max(axis=0)
        self.columns = np.maximum(self.columns, highest) if self.columns.size else highest


@dataclass(frozen=True)
class Limit:
    """A bound of the model's validity, and the warning of a run that exceeds it."""

    values: Callable[[MotionBlock], np.ndarray]
    """Quantity of the motion that the bound is for (T,) or (T, n)."""
    bound: float
    notice: Callable[[Peak], Notice]
    """The warning, for the worst place and time of the run."""
    inclusive: bool = False
    """Whether the bound itself is too much."""
    lag_s: float = 0.0
    """Time that it takes to matter [s]: between outputs a burst counts by how long it lasts."""

    def is_exceeded(self, peak: Peak) -> bool:
        """Whether a run with this peak is beyond the bound."""
        return peak.value >= self.bound if self.inclusive else peak.value > self.bound


def limit_notices(
    limits: Iterable[Limit],
    outputs: Iterable[MotionBlock],
    solved: Iterable[MotionBlock] = (),
) -> Iterator[Notice]:
    """A warning for every limit that a run exceeds, once, at its worst place and time.

    ``outputs``: the run at its outputs, in order; ``solved``: at all times that were solved for,
    so that what lasts is found wherever the outputs are.
    """
    peaks = [(limit, Peak(), Sustained(limit.lag_s)) for limit in limits]
    for block in outputs:
        for limit, peak, _ in peaks if block.time.size else ():
            peak.update(block.time, _rows(limit, block))
    for block in solved:
        for limit, peak, sustained in peaks if block.time.size else ():
            values = _rows(limit, block)
            felt = sustained.update(block.time, values) if limit.lag_s else values
            peak.update(block.time, felt)
    for limit, peak, _ in peaks:
        if limit.is_exceeded(peak):
            yield limit.notice(peak)


def _rows(limit: Limit, block: MotionBlock) -> np.ndarray:
    """Values (T, n) of a limit's quantity."""
    values = limit.values(block)
    return values.reshape(len(values), -1)
