"""Derivatives of a run over its stretches: those of the steps that were taken."""

from __future__ import annotations

from dataclasses import replace

import casadi as ca
import numpy as np

from viscodesign.compiled.row_functions import RowFunction
from viscodesign.compiled.stretches import SolvedStretches
from viscodesign.compiled.symbols import Symbols
from viscodesign.lazy_dataclass import dataclass
from viscodesign.native.derivatives import Dots, pull_back, push_forward
from viscodesign.solve.problem import Problem


@dataclass(frozen=True)
class StretchBars:
    """Slopes of a number by all that a run over its stretches depends on."""

    begin: np.ndarray
    """(nx + nz,) by the unknowns at its start."""
    pieces: np.ndarray
    stops: np.ndarray
    parameters: np.ndarray


@dataclass(frozen=True)
class StretchDots:
    """Rates of the same along d directions, the first axis."""

    begin: np.ndarray
    pieces: np.ndarray
    stops: np.ndarray
    parameters: np.ndarray


class StretchSlopes:
    """Goes back over the stretches of a solved run, or along them in many directions. Stateless."""

    @classmethod
    def of(cls, problem: Problem) -> StretchSlopes:
        """Those of all problems with these formulas."""
        return problem.equations.shared.derived(cls, None, lambda: cls(problem))

    def __init__(self, problem: Problem) -> None:
        local = problem.equations.local
        assert local is not None, "native steps have it"
        self._compiled, own = local.compiled, Symbols.of(problem)
        (numbers,) = local.form.numbers.call([ca.vertcat(1, own.sealed, own.parameters)])
        self._numbers = RowFunction([own.parameters], numbers)

    def pull_back(
        self, solved: SolvedStretches, parameters: np.ndarray, weights: np.ndarray, end: np.ndarray
    ) -> StretchBars:
        """Slopes of weights (T, nx + nz) times the outputs, and ``end`` (nx + nz,) times the end.

        ``parameters`` (p,): those that were solved with.
        """
        own, assembly, (count, unknowns) = (
            self._compiled.differentiable,
            solved.assembly,
            weights.shape,
        )
        n, coefficients = assembly.unknowns, len(solved.stretches[0].march.rest) - 1
        every, y_bar = np.zeros((count, n)), np.zeros(n)
        every[:, :unknowns], y_bar[:unknowns] = weights, end
        pieces = np.zeros((len(solved.stretches), coefficients))
        stops = np.zeros(len(solved.stretches) + 1)
        numbers_bar = np.zeros(len(assembly.all_numbers))
        for k in range(len(solved.stretches) - 1, -1, -1):
            stretch = solved.stretches[k]
            at_edges = np.zeros((len(stretch.march.edges), n))
            at_edges[: stretch.output_count] = every[stretch.outputs]
            bars = pull_back(own, assembly, stretch.march, at_edges, y_bar)
            if k == 0 and stretch.outputs.start > 0:
                bars.begin += every[0]
            first = stretch.begin.pull_back(bars.begin)
            for found in (bars, first):
                pieces[k] += found.rest[:-1]
                stops[k : k + 2] += found.ends
                numbers_bar += found.numbers
            y_bar = first.begin
        return StretchBars(
            y_bar[:unknowns], pieces, stops, self._by_parameters(parameters, numbers_bar)
        )

    def _by_parameters(self, parameters: np.ndarray, bars: np.ndarray) -> np.ndarray:
        """Slopes by the parameters for those by the numbers of the assembly."""
        places = self._compiled.places_of_numbers
        summed = np.bincount(places, bars, self._numbers.size)
        (found,) = self._numbers.pull_back([parameters[None]], summed[None])
        return np.asarray(found[0])

    def push_forward(
        self, solved: SolvedStretches, parameters: np.ndarray, dots: StretchDots
    ) -> tuple[np.ndarray, np.ndarray]:
        """Rates (d, T, nx + nz) of the outputs and (d, nx + nz) of the end."""
        own, assembly, (count, unknowns) = (
            self._compiled.differentiable,
            solved.assembly,
            dots.begin.shape,
        )
        rows = [np.repeat(parameters[None], count, axis=0)]
        places = self._compiled.places_of_numbers
        moved = self._numbers.push_forward(rows, [dots.parameters])[:, places]
        y_dot = np.zeros((count, assembly.unknowns))
        y_dot[:, :unknowns] = dots.begin
        every = np.zeros((count, len(solved.columns), unknowns))
        for k, stretch in enumerate(solved.stretches):
            rest = np.concatenate([dots.pieces[:, k], np.zeros((count, 1))], axis=1)
            own_dots = Dots(y_dot, rest, dots.stops[:, k : k + 2], moved)
            begin = stretch.begin.push_forward(own_dots)
            if k == 0 and stretch.outputs.start > 0:
                every[:, 0] = begin[:, :unknowns]
            found, y_dot = push_forward(
                own, assembly, stretch.march, replace(own_dots, begin=begin)
            )
            every[:, stretch.outputs] = found[:, : stretch.output_count, :unknowns]
        return every, y_dot[:, :unknowns]
