"""What drives a recorded run: the spec's input where it fits the measured pressure, else that."""

from __future__ import annotations

from typing import Any

import numpy as np

from viscodesign.calibration.noise_level import noise_level, white_level
from viscodesign.calibration.recorded_columns import Measured
from viscodesign.calibration.recording import RecordedChannel, Recording
from viscodesign.compiled.free_keys import FreeKeys, candidates
from viscodesign.errors import SpecError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.cross_checks import SINGLE_INLET
from viscodesign.scene.scene import Scene
from viscodesign.scene.tables.smoothing import without_noise
from viscodesign.scene.tables.straight_pieces import straight_pieces


@dataclass(frozen=True)
class DriveRules:
    """When recordings share a clock, and how a drive is followed."""

    most_squares: float = 2.0
    """Mean square of what an input leaves of a measured pressure, over that of its noise, up to
    which it counts as what drove the run."""
    most_correlation: float = 4.0
    """Correlation of neighbours in what it leaves, times the root of their number, likewise."""
    gross_drive_deviations: float = 6.0
    most_gross_drive: float = 0.06
    """Standard deviations from which a sample is gross, and the part of them that may be."""
    other_clock_share: float = 0.8
    """The clocks count as different if a shift leaves less than this part of the squares."""
    most_shifts: int = 801
    """Shifts that are tried."""
    longest_shift: float = 0.5
    """Longest clock offset, as a part of the recording."""
    bound_noise: float = 0.1
    """Distance of straight pieces from the smoothed rows, in standard deviations of the noise."""
    bound_rel: float = 2e-4
    """The least such distance, relative to the range."""
    most_free_rows: int = 60
    """Most rows of a measured input whose pressures are unknown: of more, noise is taken out, and
    what is left counts as exact. Each takes as long to differentiate by as a number of the
    scene."""
    rows_between: int = 4
    """Into which the time between two rows is divided, where a pressure is followed."""


RULES = DriveRules()


@dataclass(frozen=True)
class RecordedDrive:
    """The inputs of a recorded run."""

    scene: Scene
    """With the inputs that drove it."""
    free: tuple[str, ...]
    """Numbers of the inputs that the measured pressures tell, and so are unknown like others."""
    late_s: float
    """Time of the recording at which the run begins [s]."""
    shift_s: float
    """By how much its clock is later than that of the spec's input [s]; 0 where that is unknown."""
    compared: tuple[RecordedChannel, ...]
    """Pressures that tell these numbers."""
    words: tuple[str, ...]
    """What was done, inlet by inlet."""
    is_exact: bool = False
    """Whether a measured pressure counts as exact, once its noise is taken out."""


def driven(scene: Scene, recording: Recording) -> RecordedDrive:
    """The drive of a recording, whose pressures some or no channels have measured."""
    late, shift, found = 0.0, 0.0, RecordedDrive(scene, (), 0.0, 0.0, (), ())
    channels = recording.of(Measured.PRESSURE)
    for own in channels:
        inlet = _inlet_of(own, scene)
        fitted = _fitted(found.scene, inlet, recording.time - late, own)
        if fitted is None and own is channels[0]:
            late = shift = _shift(scene, inlet, recording.time, own.values)
            fitted = _fitted(found.scene, inlet, recording.time - late, own) if late else None
        if fitted is None:
            if not found.words:
                late, shift = float(recording.time[0]), 0.0
            fitted = _followed(found.scene, inlet, recording.time - late, own)
        found = RecordedDrive(
            fitted.scene,
            (*found.free, *fitted.free),
            late,
            shift,
            (*found.compared, *fitted.compared),
            (*found.words, *fitted.words),
            found.is_exact or fitted.is_exact,
        )
    return found


def _inlet_of(channel: RecordedChannel, scene: Scene) -> str:
    tail = channel.output.removeprefix("inlet_pressure").removesuffix("_pa").strip("_")
    return tail if tail in scene.inputs else SINGLE_INLET


def _key(inlet: str) -> str:
    return "input" if inlet == SINGLE_INLET else f"inputs.{inlet}"


# -- by the spec's own input ------------------------------------------------------


def _fitted(
    scene: Scene, inlet: str, time: np.ndarray, channel: RecordedChannel
) -> RecordedDrive | None:
    """The spec's input with numbers that fit a pressure; None where none do, to its noise."""
    from scipy.optimize import least_squares

    keys = _input_keys(scene, inlet)
    if not keys or not scene.inputs[inlet].gives_pressure:
        return None
    known = ~np.isnan(channel.values)
    t, pressure = time[known], channel.values[known] - scene.gauge_pressure
    noise, free = noise_level(t, pressure), FreeKeys(scene, keys)
    sizes = np.where(free.values, np.abs(free.values), 1.0)

    def left(shares: np.ndarray) -> np.ndarray:
        try:
            source: Any = free.placed((shares * sizes).tolist()).inputs[inlet]
            values = source.values(np.maximum(t, 0.0))
        except (SpecError, ValueError, ZeroDivisionError):
            return np.full(len(t), 1e6)
        found = (values - pressure) / noise
        return np.where(np.isfinite(found), found, 1e6)

    with np.errstate(all="ignore"):
        found = least_squares(left, free.values / sizes, loss="soft_l1", f_scale=3.0, x_scale="jac")
    residual = left(found.x)
    if not _is_noise(t, residual, len(keys)):
        return None
    try:
        own = free.validated(found.x * sizes)
    except SpecError:
        return None
    kind = scene.inputs[inlet].name
    words = f"{channel.header}: the spec's {kind} fits it to its noise of {noise:.3g} Pa"
    return RecordedDrive(own, tuple(keys), 0.0, 0.0, (channel,), (words,))


def _is_noise(time: np.ndarray, residual: np.ndarray, fitted: int) -> bool:
    """Whether what is left (T,) of a pressure is noise, but for a few gross samples.

    Its level is that by which neighbours differ in what is left: the pressure itself moves.
    """
    level = white_level(time, residual[:, None])
    plain = residual[np.abs(residual) < RULES.gross_drive_deviations * level]
    gross = len(residual) - len(plain)
    if gross > 1 + RULES.most_gross_drive * len(residual) or len(plain) < fitted + 3:
        return False
    squares = float(plain @ plain)
    correlation = abs(float(plain[1:] @ plain[:-1])) / squares * np.sqrt(len(plain))
    is_small = squares / (len(plain) - fitted) < RULES.most_squares * level**2
    return is_small and correlation < RULES.most_correlation


def _input_keys(scene: Scene, inlet: str) -> list[str]:
    """Keys of the numbers of an input, unless it is a table."""
    start = f"{_key(inlet)}."
    every = [key for key in candidates(scene) if key.startswith(start)]
    if any("[" in key for key in every):
        return []
    return [key for key in every if not key.endswith(".transient_time")]


def _shift(scene: Scene, inlet: str, time: np.ndarray, pressure: np.ndarray) -> float:
    """By how much a measured pressure is later than the spec's input [s]; 0 where that is unclear.

    By the least squares of a level and an amplitude for each of many shifts.
    """
    known = ~np.isnan(pressure)
    t, p = time[known], pressure[known]
    longest = RULES.longest_shift * float(t[-1] - t[0])
    step = max(float(np.median(np.diff(t))) / 4, 2 * longest / RULES.most_shifts)
    count = int(longest / step)
    shifts = step * np.arange(-count, count + 1)
    squares = [_unlike(p, scene.inputs[inlet].values(np.maximum(t - own, 0.0))) for own in shifts]
    best = int(np.argmin(squares))
    own = _unlike(p, scene.inputs[inlet].values(np.maximum(t, 0.0)))
    return float(shifts[best]) if squares[best] < RULES.other_clock_share * own else 0.0


def _unlike(measured: np.ndarray, values: np.ndarray) -> float:
    """Squares that remain of a measurement without a level and a multiple of values (T,)."""
    basis = np.column_stack([np.ones(len(values)), values])
    _, left, rank, _ = np.linalg.lstsq(basis, measured, rcond=None)
    return float(left[0]) if rank == 2 and len(left) else float(np.var(measured) * len(measured))


# -- by the measured pressure -----------------------------------------------------


def _followed(
    scene: Scene, inlet: str, time: np.ndarray, channel: RecordedChannel
) -> RecordedDrive:
    """A table of the measured pressure without its noise, in straight pieces."""
    known = ~np.isnan(channel.values)
    t, pressure = time[known], channel.values[known] - scene.gauge_pressure
    t, first = np.unique(np.maximum(t, 0.0), return_index=True)
    pressure = pressure[first]
    noise, span = noise_level(t, pressure), float(np.ptp(pressure))
    smooth = without_noise(t, pressure, noise, 0.0) if span > 4 * noise else pressure
    bound = max(RULES.bound_noise * noise, RULES.bound_rel * span)
    is_exact = len(knots := straight_pieces(t, smooth, bound)) > RULES.most_free_rows
    if is_exact:
        t, smooth = _between(t, smooth)
        knots = straight_pieces(t, smooth, bound)
    rows = list(zip(t[knots].tolist(), smooth[knots].tolist(), strict=True))
    table = {"kind": "table", "rows": rows, "smooth": "off"}
    own = scene.replace({_key(inlet): table})
    words = (
        f"{channel.header}: noise of {noise:.3g} Pa taken out, followed by {len(rows) - 1} "
        "straight pieces"
    )
    if is_exact:
        return RecordedDrive(own, (), 0.0, 0.0, (), (f"{words}, taken as exact",), True)
    free = (f"{_key(inlet)}.rows[*].pressure",)
    return RecordedDrive(own, free, 0.0, 0.0, (channel,), (words,))


def _between(time: np.ndarray, value: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Times and values with more rows on a curve through the given ones that never overshoots."""
    from scipy.interpolate import PchipInterpolator

    shares = np.arange(RULES.rows_between) / RULES.rows_between
    fine = (time[:-1, None] + np.diff(time)[:, None] * shares).ravel()
    fine = np.append(fine, time[-1])
    return fine, np.asarray(PchipInterpolator(time, value)(fine))
