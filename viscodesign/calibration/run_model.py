"""One recorded run as a function of unknown numbers: what its channels should have shown."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np

from viscodesign.calibration.driving import RecordedDrive
from viscodesign.calibration.recorded_columns import Measured
from viscodesign.calibration.recording import Recording
from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.compiled.function import CompiledFunction
from viscodesign.errors import SpecError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.scene import Scene
from viscodesign.storage.lru_cache import LruCache
from viscodesign.studies.all_effects import (
    felt_effects,
    with_all_effects,
    with_felt_effects,
)

TIMES_PER_ROW = 4
"""Output times between two rows where a clock is unknown, and channels lie between them."""
MAX_MODEL_TIMES = 4000
KEPT_SLOPES = 2
"""Latest derivatives that a model keeps."""
SAME_ROW_TIME_REL = 1e-9
"""Difference of two times, relative to the run, that is none."""


@dataclass(frozen=True)
class Solving:
    """How finely recorded runs are solved; None: as the scene's accuracy has it."""

    edges_per_section: int | None = None
    tolerance: float | None = None


class RunModel:
    """What the channels of a recording should have shown (T, C), by free and own numbers.

    Own numbers are those of its inputs; the last one is how late its clock is [s], that of the
    markers where the pressure was measured, else that of all channels. ``clock_is_free``: solved
    at other times than the rows', so that the clock may run late. Unless ``all_effects``, those
    that the tip does not feel at the spec's numbers are left out, if no free number needs them.
    """

    def __init__(
        self,
        recording: Recording,
        drive: RecordedDrive,
        free: Sequence[str],
        solving: Solving,
        *,
        clock_is_free: bool,
        all_effects: bool = False,
    ) -> None:
        self.recording, self.drive = recording, drive
        self.channels = (*drive.compared, *recording.of(Measured.PLACE, Measured.VOLUME))
        self.clock_is_free = clock_is_free
        self._times = recording.time - drive.late_s
        self._outputs = [own.output for own in self.channels]
        scene = _with_times(drive.scene, self._output_times())
        found = None if all_effects else _felt(scene, free, drive.free, self._outputs, solving)
        self.has_all_effects = found is None
        self.function, self.unmoved = found or _function(
            with_all_effects(scene), free, drive.free, self._outputs, solving
        )
        """By the free numbers that matter in this run, then those of its inputs."""
        self.free_names = tuple(name for name in free if name not in self.unmoved)
        self.free_count = len(self.free_names)
        self._slopes: LruCache[np.ndarray] = LruCache(KEPT_SLOPES)
        is_volume = [own.measured is Measured.VOLUME for own in self.channels]
        self._is_volume = np.array(is_volume)
        measured = bool(recording.of(Measured.PRESSURE))
        self.is_late = np.array(
            [not measured or own.measured is Measured.PLACE for own in self.channels]
        )
        """(C,) Channels that the clock's lateness shifts."""

    @property
    def own_values(self) -> np.ndarray:
        """(o,) The own numbers to start from, the clock's lateness included."""
        return np.append(self.function.values[self.free_count :], 0.0)

    @property
    def measured(self) -> np.ndarray:
        """(T, C) What was measured; NaN where nothing was."""
        return np.stack([own.values for own in self.channels], axis=1)

    def __call__(self, free: np.ndarray, own: np.ndarray) -> np.ndarray:
        """(T, C) What the channels should have shown."""
        found = self.function(np.concatenate([free, own[:-1]]))
        every = np.stack([found[name] for name in self._outputs], axis=1)
        return self._since_start(self._at_rows(every, float(own[-1])))

    def at_shifts(
        self, free: np.ndarray, own: np.ndarray, shifts: np.ndarray
    ) -> Iterator[np.ndarray]:
        """The same (T, C) for each lateness of the clock, all by one solution."""
        found = self.function(np.concatenate([free, own[:-1]]))
        every = np.stack([found[name] for name in self._outputs], axis=1)
        spline = _spline(self.function.times, every)
        for late in shifts:
            yield self._since_start(spline(self._clipped(float(late))))

    def jacobian(self, free: np.ndarray, own: np.ndarray) -> np.ndarray:
        """(T, C, f + o) Derivatives with respect to the free and the own numbers."""
        key = np.concatenate([free, own]).tobytes()
        known = self._slopes.found(key)
        return self._slopes.keep(key, self._jacobian(free, own)) if known is None else known

    def _jacobian(self, free: np.ndarray, own: np.ndarray) -> np.ndarray:
        values, late = np.concatenate([free, own[:-1]]), float(own[-1])
        found = self.function.jacobian(values)
        every = np.stack([found[name] for name in self._outputs], axis=1)
        slopes = self._since_start(self._at_rows(every, late))
        return np.concatenate([slopes, self._by_clock(values, late)[:, :, None]], axis=2)

    def lacks_effects(self, free: np.ndarray) -> bool:
        """Whether effects that were left out are felt at these free numbers (f,)."""
        if self.has_all_effects:
            return False
        scene = FreeKeys(self.drive.scene, self.free_names).validated(free.tolist())
        return not felt_effects(scene) <= self.function.effects

    # -- times ----------------------------------------------------------------------

    def _output_times(self) -> np.ndarray:
        """Those of the rows, or evenly spaced ones that are close together."""
        rows = np.maximum(self._times, 0.0)
        if not self.clock_is_free:
            apart = np.diff(rows, prepend=-1.0) > SAME_ROW_TIME_REL * rows[-1]
            return np.asarray(rows[apart])
        count = min(TIMES_PER_ROW * len(rows), MAX_MODEL_TIMES)
        return np.linspace(0.0, rows[-1], count + 1)

    def _at_rows(self, every: np.ndarray, late: float) -> np.ndarray:
        """Columns at the rows (T, C, ...), from those at the output times (N, C, ...)."""
        times = self.function.times
        if not self.clock_is_free:
            places = (
                np.searchsorted(times, self._times + SAME_ROW_TIME_REL * times[-1], "right") - 1
            )
            return np.asarray(every[np.maximum(places, 0)])
        spline = _spline(times, every)
        on_time, delayed = spline(self._clipped(0.0)), spline(self._clipped(late))
        is_late = self.is_late.reshape(1, -1, *[1] * (every.ndim - 2))
        return np.asarray(np.where(is_late, delayed, on_time))

    def _by_clock(self, values: np.ndarray, late: float) -> np.ndarray:
        """(T, C) Derivatives with respect to the clock's lateness."""
        shape = len(self._times), len(self.channels)
        if not self.clock_is_free:
            return np.zeros(shape)
        found = self.function(values)
        every = np.stack([found[name] for name in self._outputs], axis=1)
        rates = _spline(self.function.times, every)(self._clipped(late), 1)
        shifted = self._times - late
        inside = (shifted > 0.0) & (shifted <= self.function.times[-1])
        return np.asarray(np.where(self.is_late & inside[:, None], -rates, 0.0))

    def _clipped(self, late: float) -> np.ndarray:
        return np.clip(self._times - late, 0.0, self.function.times[-1])

    def _since_start(self, rows: np.ndarray) -> np.ndarray:
        """Volumes count from the first row, as a syringe's do."""
        is_volume = self._is_volume.reshape(1, -1, *[1] * (rows.ndim - 2))
        return np.asarray(np.where(is_volume, rows - rows[:1], rows))


def _function(
    scene: Scene,
    free: Sequence[str],
    own: Sequence[str],
    outputs: Sequence[str],
    solving: Solving,
) -> tuple[CompiledFunction, dict[str, str]]:
    """A function of the free numbers, without those that it cannot have, and why it cannot."""
    unmoved: dict[str, str] = {}
    while True:
        keys = [name for name in free if name not in unmoved]
        try:
            found = CompiledFunction(
                scene, [*keys, *own], outputs, solving.tolerance, solving.edges_per_section
            )
        except SpecError as error:
            reasons = {fault.key: fault.message for fault in error.faults if fault.key in keys}
            if not reasons or len(reasons) < len(error.faults) or len(reasons) == len(keys):
                raise
            unmoved |= reasons
        else:
            return found, unmoved


def _felt(
    scene: Scene,
    free: Sequence[str],
    own: Sequence[str],
    outputs: Sequence[str],
    solving: Solving,
) -> tuple[CompiledFunction, dict[str, str]] | None:
    """The same with the effects that the tip feels; None where a free number needs others."""
    try:
        found, unmoved = _function(with_felt_effects(scene), free, own, outputs, solving)
    except SpecError:
        return None
    return None if unmoved else (found, unmoved)


def _spline(times: np.ndarray, every: np.ndarray) -> Callable[..., np.ndarray]:
    from scipy.interpolate import CubicSpline

    found: Callable[..., np.ndarray] = CubicSpline(times, every, axis=0)
    return found


def _with_times(scene: Scene, times: np.ndarray) -> Scene:
    """The scene over other output times."""
    run = {
        "duration": max(float(times[-1]), scene.run.duration)
        if scene.run.start == "periodic"
        else float(times[-1]),
        "output_times": times.tolist(),
        "max_steps": scene.run.max_steps,
        "start": scene.run.start,
    }
    return scene.replace({"run": run})
