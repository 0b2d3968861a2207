"""Failures of runs whose solution has lost its meaning."""

from __future__ import annotations

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.solve.obstacles import Obstacle, advice
from viscodesign.solve.problem import Problem


class EventError(SolveError):
    """An event that ends a run: no other solver, and no smaller step, goes beyond it."""

    time_s: float

    def __init__(
        self, message: str, *, quantity: str, where: str, time_s: float, remedy: str
    ) -> None:
        super().__init__(message, quantity=quantity, where=where, remedy=remedy)
        self.time_s = time_s


def thinnest_section(time: float, stretch: np.ndarray) -> EventError:
    """The failure of the section whose stretch (S,) is smallest."""
    section, least = int(np.argmin(stretch)), float(np.min(stretch))
    return EventError(
        f"section {section + 1} is compressed to {100 * max(least, 0.0):.3g} % of its length at "
        f"t = {time:.6g} s; the linear law no longer holds",
        quantity="stretch",
        where=f"section {section + 1}",
        time_s=time,
        remedy="Raise the lowest pressure, or check bellows.extension_per_pressure and "
        "actuator.youngs_modulus.",
    )


def emptied_bellow(problem: Problem, time: float, volume: np.ndarray) -> EventError:
    """The failure of the bellow whose volume (B,) is smallest: no gas fills a negative one.

    The smallest is that with the least of its rest volume.
    """
    shares = volume / problem.rest_volume
    name, share = problem.bellows[int(np.argmin(shares))], float(np.min(shares))
    return EventError(
        f"{name} reached its minimum (collapsed) volume at t = {time:.6g} s, with {share:.3g} "
        "of its rest volume: the linear law continues to negative volumes, which no fluid can fill",
        quantity="volume",
        where=name,
        time_s=time,
        remedy=advice(problem.remedies, Obstacle.EMPTY_BELLOW, "Raise the lowest pressure"),
    )


def overdrawn_bellow(problem: Problem, time: float, pressure: np.ndarray) -> EventError:
    """The failure of bellows that have no more to give; the one whose pressure (B,) is lowest."""
    name = problem.bellows[int(np.argmin(pressure))]
    return EventError(
        f"{name} is emptied at t = {time:.6g} s, at {pressure.min() / 1e3:.4g} kPa gauge: the "
        "syringe draws more than the bellows can give",
        quantity="volume",
        where=name,
        time_s=time,
        remedy=advice(problem.remedies, Obstacle.OVERDRAWN),
    )


def folded_axis(time: float, section: int) -> EventError:
    """The failure of an axis that folds onto itself in a section (from 0 at the clamp)."""
    return EventError(
        f"the angle in section {section + 1} jumps at t = {time:.6g} s: the rod folds onto itself "
        "between two nodes",
        quantity="section angle",
        where=f"section {section + 1}",
        time_s=time,
        remedy="Lower the loads, or tighten `accuracy`, which refines the mesh.",
    )
