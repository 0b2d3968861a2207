"""Studies of accuracy that nobody had to solve."""

from __future__ import annotations

from typing import Any

from viscodesign.results.accuracy_points import Model, Point, Reference, with_dominated
from viscodesign.results.accuracy_study import AccuracyStudy

LENGTH = 0.1
MODELS = (
    Model("IV", ()),
    Model("auto", ("pressure_distribution", "inertia", "damping"), ("II",), True, True),
    Model(
        "everything", ("pressure_distribution", "inertia", "damping", "feedback"), (), True, True
    ),
)


def point(solve_s: float, error: float, **changes: Any) -> Point:
    """A point of `auto` with this time [s] and error [lengths]."""
    given: dict[str, Any] = {
        "model": "auto", "edges": 1, "tolerance": 1e-3, "solver": "idas", "solve_s": solve_s,
        "build_s": 0.05, "tip_error_m": error * LENGTH, "tip_error_rel": error,
    }  # fmt: skip
    return Point(**{**given, **changes})


STEPLESS = point(0.001, 0.2, model="IV", is_stepless=True, is_exact_in_space=True)
POINTS = (
    STEPLESS,
    point(0.010, 0.02, tolerance=1e-2),
    point(0.012, 0.004, tolerance=3e-3),
    point(0.020, 0.0008, tolerance=1e-4),
    point(0.050, 0.0009, edges=2, tolerance=1e-4),
    point(0.060, 0.00002, model="everything", edges=2, tolerance=1e-6, is_bound=True),
    point(2.000, 0.003, solver="radau"),
)
REFERENCE = Reference(
    ("pressure_distribution", "inertia", "damping", "feedback"), 16, 1e-7, "rosenbrock", 3.2,
    LENGTH * 6.7e-6, 6.7e-6, LENGTH * 2e-5, True,
)  # fmt: skip


def made_study(**changes: Any) -> AccuracyStudy:
    """A study with three models, two solvers and two meshes, which asks for 0.5 %."""
    points = with_dominated(changes.pop("points", POINTS))
    given: dict[str, Any] = {
        "name": "leg_made_up", "version": "0.1", "spec_sha256": "0" * 64, "status": "complete",
        "length": LENGTH, "requested_rel": 0.005, "models": MODELS, "taken": MODELS[1].effects,
        "reference": REFERENCE, "points": points, "start": points[3] if len(points) > 3 else None,
        "notes": ("skipped: time limit: something",), "limit_s": 60.0, "spent_s": 12.0,
    }  # fmt: skip
    return AccuracyStudy(**{**given, **changes})
