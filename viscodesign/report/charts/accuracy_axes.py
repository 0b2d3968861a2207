"""The plane of `accuracy.png`: tip error against solve time, log-log."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.layout.look import look
from viscodesign.results.accuracy_points import Point
from viscodesign.results.accuracy_study import AccuracyStudy

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MARGIN_DECADES = 0.12
"""Space around the outermost points, in decades."""
MIN_DECADES = 1.0


@dataclass(frozen=True)
class Window:
    """The decades that are shown; places are fractions of the sides of the plane."""

    left: float
    right: float
    bottom: float
    top: float

    def place(self, point: Point) -> tuple[float, float]:
        """Place of a point."""
        return self.across(point.solve_s), self.up(point.tip_error_rel)

    def across(self, solve_s: float) -> float:
        """Place of a time [s] along the plane."""
        return (math.log10(solve_s) - self.left) / (self.right - self.left)

    def up(self, error: float) -> float:
        """Place of an error [actuator lengths] up the plane."""
        return (math.log10(error) - self.bottom) / (self.top - self.bottom)


def window_of(study: AccuracyStudy) -> Window:
    """The decades that hold all points and the requested error."""
    times = [math.log10(point.solve_s) for point in study.points]
    errors = [math.log10(point.tip_error_rel) for point in study.points]
    errors.append(math.log10(study.requested_rel))
    return Window(*_ends(times), *_ends(errors))


def _ends(logarithms: Sequence[float]) -> tuple[float, float]:
    low, high = min(logarithms) - MARGIN_DECADES, max(logarithms) + MARGIN_DECADES
    wider = max(MIN_DECADES - (high - low), 0.0) / 2
    return low - wider, high + wider


def draw_axes(axes: Axes, window: Window) -> None:
    """Scales, limits, ticks, grid and labels."""
    axes.set(xscale="log", yscale="log")
    axes.set_xlim(10**window.left, 10**window.right)
    axes.set_ylim(10**window.bottom, 10**window.top)
    sides: tuple[tuple[Any, float, float, Any], ...] = (
        (axes.xaxis, window.left, window.right, time_words),
        (axes.yaxis, window.bottom, window.top, percent_words),
    )
    for side, low, high, words in sides:
        steps = (1,) if high - low > 3.2 else (1, 3) if high - low > 1.5 else (1, 2, 5)
        side.set_major_locator(FixedLocator(_marks(low, high, steps)))
        side.set_major_formatter(FuncFormatter(lambda value, _, words=words: words(value)))
        side.set_minor_locator(FixedLocator(_marks(low, high, range(1, 10))))
        side.set_minor_formatter(NullFormatter())
    axes.grid(color=look().grid, lw=0.6)
    axes.set_axisbelow(True)
    axes.set_xlabel("solve time")
    axes.set_ylabel("largest tip error, relative to the actuator length")


def _marks(low: float, high: float, steps: Iterable[int]) -> list[float]:
    decades = range(math.floor(low), math.ceil(high) + 1)
    marks = [float(f"{m}e{k}") for k in decades for m in steps]
    return [mark for mark in marks if low <= math.log10(mark) <= high]


def time_words(time: float) -> str:
    """A time [s] with its unit."""
    if time < 0.999e-3:
        return f"{1e6 * time:.3g} µs"
    return f"{1e3 * time:.3g} ms" if time < 0.999 else f"{time:.6g} s"


def percent_words(fraction: float) -> str:
    """A fraction in percent."""
    return f"{100 * fraction:.10f}".rstrip("0").rstrip(".") + " %"
