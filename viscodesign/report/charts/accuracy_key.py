"""How `accuracy.png` marks a setting (colour, symbol, size), and its key."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from matplotlib.lines import Line2D

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.layout.look import look
from viscodesign.results.accuracy_points import Model, Point
from viscodesign.results.accuracy_study import AccuracyStudy

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MARKERS = ("o", "s", "^", "D", "v", "P", "X")
"""One per solver."""
STEPLESS = "*"
"""Mark of settings without time steps, and hence without a solver."""
STEPLESS_SIZE = 9.0
"""[pt]"""
KEY_LINE_HEIGHT, KEY_GAP = 0.165, 0.15
"""Height of a line, and space after a group [inch]."""


@dataclass(frozen=True)
class PointMarks:
    """Colour by model, symbol by solver, size by mesh."""

    study: AccuracyStudy

    @property
    def solvers(self) -> list[str]:
        """Solvers that took time steps, in order of appearance."""
        return list(dict.fromkeys(p.solver for p in self.study.points if not p.is_stepless))

    @property
    def meshes(self) -> list[int]:
        """Edges per section, ascending."""
        return sorted({p.edges for p in self.study.points if not p.is_exact_in_space})

    def colour(self, point: Point) -> str:
        """Colour of a point."""
        return self.model_colour(self.study.model(point))

    def model_colour(self, model: Model) -> str:
        """Colour of a model."""
        colours = look().models
        return colours[self.study.models.index(model) % len(colours)]

    def marker(self, point: Point) -> str:
        """Symbol of a point."""
        return STEPLESS if point.is_stepless else self.solver_marker(point.solver)

    def solver_marker(self, solver: str) -> str:
        """Symbol of a solver."""
        return MARKERS[self.solvers.index(solver) % len(MARKERS)]

    def size(self, point: Point) -> float:
        """Size of a point [pt]: the finer the mesh, the larger."""
        if point.is_stepless:
            return STEPLESS_SIZE
        return mark_size(-1 if point.is_exact_in_space else self.meshes.index(point.edges))


def mark_size(rank: int) -> float:
    """Size of a mark [pt] by the number of coarser meshes; -1 without a mesh."""
    return 5.0 + 1.3 * rank


def draw_key(made: Figure, study: AccuracyStudy, left: float, top: float) -> None:
    """Groups of the key, one below the other, from a place of the figure [inch]."""
    across, up = made.get_size_inches()
    for title, handles in _groups(PointMarks(study)):
        if not handles:
            continue
        made.legend(
            handles=handles, title=title or None, loc="upper left", borderaxespad=0,
            bbox_to_anchor=(left / across, top / up), alignment="left",
            title_fontproperties={"weight": "bold", "size": 8}, handletextpad=0.5, fontsize=7.5,
        )  # fmt: skip
        top -= _group_height(title, handles)


def key_height(study: AccuracyStudy) -> float:
    """Height of the whole key [inch]."""
    groups = _groups(PointMarks(study))
    return sum(_group_height(title, handles) for title, handles in groups if handles)


def _group_height(title: str, handles: Sequence[Line2D]) -> float:
    lines = sum(1 + str(handle.get_label()).count("\n") for handle in handles)
    return KEY_LINE_HEIGHT * (lines + bool(title)) + KEY_GAP


def _groups(marks: PointMarks) -> Sequence[tuple[str, list[Line2D]]]:
    used = {point.model for point in marks.study.points}
    models = [model for model in marks.study.models if model.name in used]
    ink = look().ink
    return (
        ("model", [_model_handle(marks, model) for model in models]),
        ("solver", _solver_handles(marks)),
        ("edges per section", _mesh_handles(marks)),
        ("", [
            _handle("on the Pareto front: none is\nboth faster and more accurate", "o", ink, 5.0),
            _handle("dominated by another setting", "o", ink, 5.0, hollow=True),
            Line2D([], [], color=look().grey, lw=0.8, label="same setting, other tolerances"),
        ]),
    )  # fmt: skip


def _model_handle(marks: PointMarks, model: Model) -> Line2D:
    names = ", ".join((model.name, *model.also))
    return _handle(f"{names}:\n{model.words}", "o", marks.model_colour(model), 6.0)


def _solver_handles(marks: PointMarks) -> list[Line2D]:
    handles = [_handle(name, marks.solver_marker(name), look().ink, 6.0) for name in marks.solvers]
    if any(point.is_stepless for point in marks.study.points):
        handles.append(_handle("none: no time steps", STEPLESS, look().ink, STEPLESS_SIZE))
    return handles


def _mesh_handles(marks: PointMarks) -> list[Line2D]:
    arcs = any(p.is_exact_in_space and not p.is_stepless for p in marks.study.points)
    handles = [_handle("none: exact arcs", "o", look().ink, mark_size(-1))] if arcs else []
    return handles + [
        _handle(str(edges), "o", look().ink, mark_size(k)) for k, edges in enumerate(marks.meshes)
    ]


def _handle(label: str, marker: str, colour: str, size: float, *, hollow: bool = False) -> Line2D:
    return Line2D(
        [], [], ls="none", marker=marker, ms=size, mec=colour, label=label,
        mfc=look().ground if hollow else colour,
    )  # fmt: skip
