"""`accuracy.png`: the tip's error against the time to solve, and what is worth taking."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from matplotlib.lines import Line2D
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter

from viscodesign.report.layout.label_placement import Box, place_labels, text_box
from viscodesign.report.layout.style import (
    ACCENT,
    FAINT,
    GREY,
    INK,
    TITLE_ROOM,
    axes_at,
    picture,
    shown,
)
from viscodesign.results.accuracy_study import AccuracyStudy, Model, Point, spread, tolerance_words

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LEFT, BOTTOM, SIZE, KEY_WIDTH = 0.78, 0.55, 5.0, 2.25
WIDTH = LEFT + SIZE + KEY_WIDTH
"""In inches."""
COLOURS = ("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#000000")
"""Okabe-Ito colours, one a model; vermillion is the recommendation's."""
MARKERS = ("o", "s", "^", "D", "v", "P", "X")
"""One a solver."""
STEPLESS = "*"
"""Of what has no steps through time, and hence no solver."""
MOST_LABELS = 9
LABEL, NOTE = 7.0, 7.5
"""Sizes of words [pt]."""
NOTE_ENDS = (0.985, 0.85, 0.7, 0.55, 0.4, 0.25)
"""Where notes on a line may end, in parts of the plane."""
MARGIN = 0.12
"""Room about the outermost points, of a decade."""
LEAST_DECADES = 1.0


@dataclass(frozen=True)
class Window:
    """Decades shown, and places in parts of the plane."""

    left: float
    right: float
    bottom: float
    top: float

    def place(self, point: Point) -> tuple[float, float]:
        """Where a point stands, in parts of the plane's sides."""
        return self.across(point.solve_s), self.up(point.tip_error_rel)

    def across(self, solve_s: float) -> float:
        """Of a time [s]."""
        return (math.log10(solve_s) - self.left) / (self.right - self.left)

    def up(self, error: float) -> float:
        """Of an error in actuator lengths."""
        return (math.log10(error) - self.bottom) / (self.top - self.bottom)


def draw_accuracy(study: AccuracyStudy, path: Path) -> None:
    """Log-log; every point by its model and solver, the front, and the recommendation."""
    window = _window(study)
    height = BOTTOM + SIZE + TITLE_ROOM
    with picture(path, WIDTH, height) as made:
        axes = axes_at(made, LEFT, BOTTOM, SIZE, SIZE)
        axes.set(xscale="log", yscale="log")
        axes.set_xlim(10**window.left, 10**window.right)
        axes.set_ylim(10**window.bottom, 10**window.top)
        _draw_ticks(axes, window)
        taken = [*_draw_bounds(axes, study, window), *_draw_front(axes, study, window)]
        _draw_branches(axes, study)
        _draw_points(axes, study)
        _draw_labels(axes, study, window, taken)
        _draw_key(made, study)
        words = "what accuracy costs in time"
        if study.status == "interrupted":
            words += " (interrupted: not all was measured)"
        title = f"{shown(study.name, 40)}: {words}"
        made.text(0.1 / WIDTH, (height - 0.21) / height, title, size=10, va="baseline")


def _window(study: AccuracyStudy) -> Window:
    times = [math.log10(point.solve_s) for point in study.points]
    errors = [math.log10(point.tip_error_rel) for point in study.points]
    errors.append(math.log10(study.requested_rel))
    return Window(*_ends(times), *_ends(errors))


def _ends(logarithms: Sequence[float]) -> tuple[float, float]:
    low, high = min(logarithms) - MARGIN, max(logarithms) + MARGIN
    wider = max(LEAST_DECADES - (high - low), 0.0) / 2
    return low - wider, high + wider


# -- axes --------------------------------------------------------------------------------


def _draw_ticks(axes: Axes, window: Window) -> None:
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
    axes.grid(color="#ececec", lw=0.6)
    axes.set_axisbelow(True)
    axes.set_xlabel("time to solve")
    axes.set_ylabel("largest error of the tip, of the actuator's length")


def _marks(low: float, high: float, steps: Iterable[int]) -> list[float]:
    decades = range(math.floor(low), math.ceil(high) + 1)
    marks = [float(f"{m}e{k}") for k in decades for m in steps]
    return [mark for mark in marks if low <= math.log10(mark) <= high]


def time_words(time: float) -> str:
    """A time [s] on an axis."""
    if time < 0.999e-3:
        return f"{1e6 * time:.3g} µs"
    return f"{1e3 * time:.3g} ms" if time < 0.999 else f"{time:.6g} s"


def percent_words(part: float) -> str:
    """A part on an axis."""
    return f"{100 * part:.10f}".rstrip("0").rstrip(".") + " %"


# -- what is drawn -----------------------------------------------------------------------


def _draw_bounds(axes: Axes, study: AccuracyStudy, window: Window) -> list[Box]:
    """The accuracy asked for, and what the reference cannot tell; the room of their words."""
    axes.axhline(study.requested_rel, color=ACCENT, lw=1.2, ls=(0, (5, 2)), zorder=2)
    up = window.up(study.requested_rel)
    points = [window.place(point) for point in study.points]
    asked = f"asked for: {percent_words(study.requested_rel)}"
    boxes = [_say(axes, asked, up, points, ACCENT), Box(0, up - 0.004, 1, up + 0.004, faint=True)]
    found = study.reference
    least = 0.0 if found is None else found.smallest_error_m / study.length
    if least > 10**window.bottom:
        axes.axhspan(10**window.bottom, least, color="#e9e9e9", lw=0, zorder=0)
        words = "at most: below what the reference can tell"
        boxes.append(_say(axes, words, 0.004, points, "#555555"))
    return boxes


def _say(
    axes: Axes, words: str, y: float, points: Sequence[tuple[float, float]], colour: str
) -> Box:
    """Words on a line, from the right on, where they hide fewest points."""
    boxes = [text_box(words, (x, y + 0.004), "right", "bottom", NOTE, SIZE) for x in NOTE_ENDS]
    boxes = [box for box in boxes if box.left > 0.0] or boxes[:1]
    hidden = [sum(_mark_box(point).overlap(box) for point in points) for box in boxes]
    box = boxes[hidden.index(min(hidden))]
    axes.text(
        box.right, y + 0.004, words, ha="right", va="bottom", size=NOTE, color=colour, zorder=6,
        transform=axes.transAxes,
    )  # fmt: skip
    return box


def _mark_box(place: tuple[float, float]) -> Box:
    x, y = place
    return Box(x - 0.011, y - 0.011, x + 0.011, y + 0.011)


def _draw_front(axes: Axes, study: AccuracyStudy, window: Window) -> list[Box]:
    """A staircase: what is below and left of it was not reached."""
    front = study.front
    times = [front[0].solve_s, *(p.solve_s for p in front[1:]), 10**window.right]
    errors = [10**window.top, *(p.tip_error_rel for p in front)]
    x, y = [times[0]], [errors[0]]
    for k, error in enumerate(errors[1:]):
        x += [times[k], times[k + 1]]
        y += [error, error]
    axes.plot(x, y, color=FAINT, lw=2.4, zorder=1.5, solid_joinstyle="miter")
    places = [(window.across(t), window.up(e)) for t, e in zip(x, y, strict=True)]
    return [_stripe(a, b) for a, b in itertools.pairwise(places)]


def _stripe(a: tuple[float, float], b: tuple[float, float]) -> Box:
    half = 0.004
    x, y = sorted((a[0], b[0])), sorted((a[1], b[1]))
    return Box(x[0] - half, y[0] - half, x[1] + half, y[1] + half)


def _draw_branches(axes: Axes, study: AccuracyStudy) -> None:
    """Points that differ by tolerance alone are joined."""
    branches: dict[tuple[str, int, str], list[Point]] = {}
    for point in study.points:
        branches.setdefault((point.model, point.edges, point.solver), []).append(point)
    for points in branches.values():
        ordered = sorted(points, key=lambda point: -point.tolerance)
        axes.plot(
            [p.solve_s for p in ordered], [p.tip_error_rel for p in ordered],
            color=_colour(study, ordered[0]), lw=0.6, alpha=0.45, zorder=2,
        )  # fmt: skip


def _draw_points(axes: Axes, study: AccuracyStudy) -> None:
    """Full on the front, hollow elsewhere; the finer the mesh, the larger."""
    for point in study.points:
        colour = _colour(study, point)
        axes.plot(
            point.solve_s, point.tip_error_rel, marker=_marker(study, point),
            ms=_size(study, point), mec=colour, mew=1.0, ls="none",
            mfc="white" if point.dominated else colour, zorder=3 if point.dominated else 4,
        )  # fmt: skip
    best = study.recommended
    if best is not None:
        axes.plot(
            best.solve_s, best.tip_error_rel, marker="o", ms=14, mec=ACCENT, mew=1.8,
            mfc="none", ls="none", zorder=5,
        )  # fmt: skip


def _colour(study: AccuracyStudy, point: Point) -> str:
    names = [model.name for model in study.models]
    return COLOURS[names.index(point.model) % len(COLOURS)]


def _solvers(study: AccuracyStudy) -> list[str]:
    return list(dict.fromkeys(p.solver for p in study.points if not p.is_stepless))


def _marker(study: AccuracyStudy, point: Point) -> str:
    if point.is_stepless:
        return STEPLESS
    return MARKERS[_solvers(study).index(point.solver) % len(MARKERS)]


def _meshes(study: AccuracyStudy) -> list[int]:
    return sorted({p.edges for p in study.points if not p.is_exact_in_space})


def _size(study: AccuracyStudy, point: Point) -> float:
    if point.is_stepless:
        return 9.0
    meshes = _meshes(study)
    return mark_size(-1 if point.is_exact_in_space else meshes.index(point.edges))


def mark_size(rank: int) -> float:
    """Size of a mark [pt] by how many meshes are coarser; -1: without a mesh."""
    return 5.0 + 1.3 * rank


# -- words -------------------------------------------------------------------------------


def _draw_labels(axes: Axes, study: AccuracyStudy, window: Window, taken: list[Box]) -> None:
    """The front's points by their settings, the recommended one first and loudest."""
    best = study.recommended
    told = spread(study.front, MOST_LABELS)
    if best is not None:
        told = [best, *(point for point in told if point != best)]
    others = [window.place(point) for point in study.points if point not in told]
    room = [*taken, *(_mark_box(place) for place in others)]
    texts = [_label(study, point, point == best) for point in told]
    labels = place_labels(
        [window.place(point) for point in told], texts, room, size=LABEL, side=SIZE
    )
    for point, label in zip(told, labels, strict=True):
        if label.step > 0:
            ends = ([label.point[0], label.x], [label.point[1], label.y])
            axes.plot(*ends, color=GREY, lw=0.6, zorder=2.5, transform=axes.transAxes)
        is_best = point == best
        axes.text(
            label.x, label.y, label.text, ha=label.across, va=label.upright, size=LABEL, zorder=7,
            linespacing=1.1, color=ACCENT if is_best else INK, transform=axes.transAxes,
            weight="bold" if is_best else "normal",
            bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.7, "pad": 0.3},
        )  # fmt: skip


def _label(study: AccuracyStudy, point: Point, is_best: bool) -> str:
    parts = [] if point.is_exact_in_space else [f"{point.edges} edge{'s' * (point.edges != 1)}"]
    if not point.is_stepless:
        parts.append(f"tol {tolerance_words(point.tolerance)}")
    setting = ", ".join(parts) or "no steps"
    if not is_best:
        return setting
    solver = "" if point.is_stepless else f"{point.solver}, "
    return (
        f"recommended for {percent_words(study.requested_rel)}:\n"
        f"{point.model}, {solver}{setting}, {time_words(float(f'{point.solve_s:.2g}'))}"
    )


def _draw_key(made: Figure, study: AccuracyStudy) -> None:
    used = {point.model for point in study.points}
    groups = [
        ("model", [_model_handle(study, m) for m in study.models if m.name in used]),
        ("solver", _solver_handles(study)),
        ("edges a section", _mesh_handles(study)),
        ("", [
            _handle("on the front: no other is both\nfaster and more accurate", "o", INK, 5.0),
            _handle("beaten by another", "o", INK, 5.0, hollow=True),
            Line2D([], [], color=GREY, lw=0.8, label="one setting but for its tolerance"),
        ]),
    ]  # fmt: skip
    top = BOTTOM + SIZE
    across, up = made.get_size_inches()
    for title, handles in groups:
        if not handles:
            continue
        made.legend(
            handles=handles, title=title or None, loc="upper left", borderaxespad=0,
            bbox_to_anchor=((LEFT + SIZE + 0.12) / across, top / up), alignment="left",
            title_fontproperties={"weight": "bold", "size": 8}, handletextpad=0.5, fontsize=7.5,
        )  # fmt: skip
        lines = sum(1 + str(handle.get_label()).count("\n") for handle in handles)
        top -= 0.165 * (lines + bool(title)) + 0.15


def _model_handle(study: AccuracyStudy, model: Model) -> Line2D:
    names = ", ".join((model.name, *model.also))
    colour = COLOURS[study.models.index(model) % len(COLOURS)]
    return _handle(f"{names}:\n{model.words}", "o", colour, 6.0)


def _solver_handles(study: AccuracyStudy) -> list[Line2D]:
    names = _solvers(study)
    handles = [_handle(name, MARKERS[k % len(MARKERS)], INK, 6.0) for k, name in enumerate(names)]
    if any(point.is_stepless for point in study.points):
        handles.append(_handle("none: no steps", STEPLESS, INK, 9.0))
    return handles


def _mesh_handles(study: AccuracyStudy) -> list[Line2D]:
    arcs = any(p.is_exact_in_space and not p.is_stepless for p in study.points)
    handles = [_handle("none: arcs", "o", INK, mark_size(-1))] if arcs else []
    return handles + [
        _handle(str(edges), "o", INK, mark_size(k)) for k, edges in enumerate(_meshes(study))
    ]


def _handle(label: str, marker: str, colour: str, size: float, *, hollow: bool = False) -> Line2D:
    return Line2D(
        [], [], ls="none", marker=marker, ms=size, mec=colour, label=label,
        mfc="white" if hollow else colour,
    )  # fmt: skip
