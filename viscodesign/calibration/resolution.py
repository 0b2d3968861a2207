"""Whether a mesh and a tolerance are fine enough for what data determine, and finer ones where not.

A coarse mesh moves the numbers that fit best. By how much follows from the change of the expected
channels on a finer mesh, to first order; what is allowed is a part of a standard deviation.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from viscodesign.calibration.estimate import Estimate, Search, polished
from viscodesign.calibration.run_model import RunModel, Solving
from viscodesign.calibration.spread import spread_of
from viscodesign.errors import ViscodesignError
from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class ResolutionRules:
    """How finely the models of a fit are solved."""

    most_bias: float = 0.1
    """Standard deviations by which mesh or tolerance may move a number."""
    first_tolerance: float = 1e-4
    """With larger ones of the steps the squares jump by a tenth of what an interval's end adds."""
    most_fit_edges: int = 16
    """Largest number of edges of a section."""
    least_fit_tolerance: float = 1e-7
    space_order: int = 2
    """By which errors fall with the mesh; those in time fall faster from one round to the next."""
    finer_tolerance: float = 10.0
    most_refinements: int = 4


RULES = ResolutionRules()

Models = Callable[[Solving], list[RunModel]]
"""Models of all recordings, solved so finely."""


@dataclass(frozen=True)
class ResolutionCheck:
    """How far mesh and tolerance move the numbers."""

    edges_per_section: int
    tolerance: float
    bias: float
    """Largest move of a free number, in standard deviations."""
    key: str
    """Key of that number."""
    is_sufficient: bool


def first_solving(models: Sequence[RunModel]) -> Solving:
    """The mesh of the scene's accuracy, and a tolerance at which squares are smooth."""
    settings = models[0].function.settings
    return Solving(settings.edges_per_section, min(RULES.first_tolerance, settings.tolerance))


def resolved(
    search: Search, found: Estimate, models: Models, solving: Solving
) -> tuple[Estimate, ResolutionCheck]:
    """An estimate on a mesh that is fine enough, and how far a finer one would move it.

    Once the user asked to stop, neither is looked for.
    """
    if search.stop.asked:
        first = solving.edges_per_section or 1, solving.tolerance or RULES.first_tolerance
        return found, ResolutionCheck(*first, math.inf, "", False)
    for round_ in range(RULES.most_refinements):
        check = _checked(found, models, solving)
        is_last = round_ == RULES.most_refinements - 1 or not math.isfinite(check.bias)
        if check.is_sufficient or is_last or search.stop.asked:
            break
        finer = _finer(check, solving)
        if finer == solving:
            break
        try:
            found = polished(search, found, found.misfit.with_(models=models(finer)))
        except ViscodesignError:
            break  # The coarser one has a solution, and says how far it may be off.
        solving = finer
    return found, check


def _checked(found: Estimate, models: Models, solving: Solving) -> ResolutionCheck:
    """How far twice as fine a mesh, and a tenth of the tolerance, would move the free numbers."""
    misfit, values, free = found.misfit, found.values, found.misfit.pulled
    edges, tolerance = solving.edges_per_section or 1, solving.tolerance or RULES.first_tolerance
    try:
        finer = misfit.with_(models=models(Solving(2 * edges, tolerance / RULES.finer_tolerance)))
        change = finer.data_residuals(values) - misfit.data_residuals(values)
    except ViscodesignError:
        return ResolutionCheck(edges, tolerance, math.inf, "", False)
    spread = spread_of(misfit, values)
    moves = np.abs(spread.moved_by(change) / spread.deviations)[free]
    worst = int(np.argmax(moves))
    bias = float(moves[worst]) / (1 - 2.0**-RULES.space_order)
    name = misfit.unknowns[free[worst]].name
    return ResolutionCheck(edges, tolerance, bias, name, bias <= RULES.most_bias)


def _finer(check: ResolutionCheck, solving: Solving) -> Solving:
    """What should do."""
    ratio = (check.bias / RULES.most_bias) ** (1 / RULES.space_order)
    edges = check.edges_per_section * 2 ** math.ceil(math.log2(ratio))
    tolerance = max(check.tolerance / RULES.finer_tolerance, RULES.least_fit_tolerance)
    return Solving(min(edges, max(RULES.most_fit_edges, solving.edges_per_section or 1)), tolerance)
