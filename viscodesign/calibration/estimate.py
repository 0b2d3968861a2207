"""The most likely numbers: gross samples found and left out, noise taken from what remains."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from viscodesign.calibration.misfit import Misfit, noise_groups
from viscodesign.calibration.noise_level import NORMAL_MAD
from viscodesign.calibration.spread import covariance_of
from viscodesign.calibration.unknowns import ranges_of
from viscodesign.interrupt import StopRequest
from viscodesign.lazy_dataclass import dataclass
from viscodesign.studies.least_squares import (
    BestSoFar,
    FitStatus,
    SearchLimits,
    least_squares,
)


@dataclass(frozen=True)
class EstimateRules:
    """When a sample is gross, and when a descent ends."""

    robust_scale: float = 2.0
    """Residual, in standard deviations, from which it counts less while gross ones are sought."""
    gross_deviations: float = 4.5
    """Standard deviations from which a sample is gross: of 10,000 good ones 0.07 are."""
    most_gross: float = 0.1
    """Part of a group's samples that may be gross: more are not slips of the tracking, but a model
    that does not fit."""
    reweightings: int = 2
    max_fit_evaluations: int = 60
    """Limit of one descent."""
    fit_rel_tol: float = 1e-6
    """Relative change of the squares that ends a descent: of 1,000 samples' squares it is a
    number's move by 0.03 standard deviations. Below it are changes by the steps of the solver."""
    most_polishing: int = 6
    polished: float = 0.02
    """Largest step, in standard deviations, at which an estimate has settled."""
    solver_rise: float = 0.05
    """Rise of the sum of squares by such a step that is attributed to the solver."""
    least_level: float = 1e-3
    """Noise relative to that found in the data alone, below which it does not fall."""


RULES = EstimateRules()

Report = Callable[[BestSoFar], None]


@dataclass(frozen=True)
class Estimate:
    """Numbers that were found, and the misfit, with its noise, that they are best for."""

    values: np.ndarray
    misfit: Misfit
    status: FitStatus


class Search:
    """What all estimates of one fit share: the request to stop, and who hears of progress."""

    def __init__(self, stop: StopRequest, report: Report | None = None) -> None:
        self.stop, self._report = stop, report
        self.evaluations = 0

    def descend(
        self, misfit: Misfit, start: np.ndarray, *, robust: bool = False
    ) -> tuple[np.ndarray, FitStatus]:
        """The least squares near a start.

        The robust one keeps the signs of the spec: from far off, numbers of the other sign are a
        second optimum, from which no sample brings it back.
        """
        limits = SearchLimits(
            stop=self.stop,
            report=self._report,
            evaluations=RULES.max_fit_evaluations,
            converged=RULES.fit_rel_tol,
        )
        found = least_squares(
            misfit,
            ranges_of(misfit.models, misfit.unknowns, keeps_signs=robust),
            [start],
            limits=limits,
            loss="soft_l1" if robust else "linear",
            loss_scale=RULES.robust_scale if robust else 1.0,
            scaling="slopes",
        )
        self.evaluations += found.evaluations
        return found.values, found.status


def estimated(search: Search, misfit: Misfit, start: np.ndarray) -> Estimate:
    """The numbers that fit best, from a start: first a robust fit, then without gross samples."""
    values, status = search.descend(misfit, start, robust=True)
    return refined(search, _cleaned(misfit, values), values, status)


def refined(
    search: Search,
    misfit: Misfit,
    start: np.ndarray,
    status: FitStatus = "converged",
    rounds: int = RULES.reweightings,
) -> Estimate:
    """The same from a good start, whose noise is then taken from its residuals."""
    values = start
    for _ in range(rounds):
        if status == "interrupted":
            break
        values, status = search.descend(misfit, values)
        if status != "interrupted":
            misfit = _cleaned(misfit.with_(levels=residual_levels(misfit, values)), values)
    return Estimate(values, misfit, status)


def polished(search: Search, found: Estimate, misfit: Misfit) -> Estimate:
    """An estimate moved to where it is best for another misfit that differs a little.

    By Gauss-Newton steps with the derivatives where it is, which settle within a few percent of a
    standard deviation: models that are slow to differentiate need values alone.
    """
    values, ranges = found.values, ranges_of(misfit.models, misfit.unknowns)
    jacobian = misfit.jacobian(values) * misfit.sizes(values)
    covariance = covariance_of(jacobian)
    deviations = np.sqrt(np.diag(covariance))
    residual = misfit(values)
    for _ in range(RULES.most_polishing):
        if search.stop.asked:
            return Estimate(values, misfit, "interrupted")
        steps = -covariance @ (jacobian.T @ residual)
        moved = np.clip(misfit.stepped(values, steps), ranges.low, ranges.high)
        new = misfit(moved)
        if not new @ new <= residual @ residual + RULES.solver_rise:
            break
        values, residual = moved, new
        if np.max(np.abs(steps / deviations)) < RULES.polished:
            break
    levels = residual_levels(misfit, values)
    return Estimate(values, _cleaned(misfit.with_(levels=levels), values), found.status)


def _cleaned(misfit: Misfit, values: np.ndarray) -> Misfit:
    """Without samples that are grossly off at these values."""
    kept = []
    apart = misfit.deviations(values)
    for model, own in zip(misfit.models, apart, strict=True):
        mask = np.isfinite(own)
        for group in noise_groups(model):
            mask[:, group] &= ~_gross(own[:, group])
        kept.append(mask)
    return misfit.with_(kept=kept)


def _gross(apart: np.ndarray) -> np.ndarray:
    """Which residuals (T, c) of a group are gross; none where they are too many."""
    known = np.isfinite(apart)
    size = np.abs(apart[known])
    level = float(np.median(size)) / NORMAL_MAD
    found = known & (np.abs(np.where(known, apart, 0.0)) > RULES.gross_deviations * level)
    return found if found.sum() <= RULES.most_gross * known.sum() else np.zeros_like(found)


def residual_levels(misfit: Misfit, values: np.ndarray) -> list[np.ndarray]:
    """(C,) a run: noise by the residuals, and by how many unknowns each group of them tells."""
    residuals, levers = misfit.data_residuals(values), _levers(misfit, values)
    found, begin = [], 0
    for model, level, kept in zip(misfit.models, misfit.levels, misfit.kept, strict=True):
        channel = np.nonzero(kept)[1]
        own = slice(begin, begin + len(channel))
        begin += len(channel)
        new = level.copy()
        for group in noise_groups(model):
            rows = np.isin(channel, group)
            free = float(rows.sum() - levers[own][rows].sum())
            if free > 1.0:
                squares = float(np.sum(residuals[own][rows] ** 2)) / free
                new[group] = level[group] * max(np.sqrt(squares), RULES.least_level)
        found.append(new)
    return found


def _levers(misfit: Misfit, values: np.ndarray) -> np.ndarray:
    """(n,) By how much each sample pulls its own expectation: they sum to the unknowns told."""
    jacobian = misfit.jacobian(values) * misfit.sizes(values)
    rows = len(jacobian) - len(misfit.pulled)
    left, sizes, _ = np.linalg.svd(jacobian, full_matrices=False)
    return np.asarray(np.sum(left[:rows, sizes > 1e-12 * sizes[0]] ** 2, axis=1))
