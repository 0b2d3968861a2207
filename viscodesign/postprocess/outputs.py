"""Named outputs at a block of solved edges, and what follows from them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.arc_shape import arc_nodes
from viscodesign.model.network_equations import NetworkForm
from viscodesign.model.rod import ROD_VALUES
from viscodesign.model.rod_equations import RodForm
from viscodesign.postprocess.spline_rates import spline_rates
from viscodesign.solve.algebraic_polish import polish
from viscodesign.solve.problem import Problem, evaluate_along, section_strains
from viscodesign.solve.transient import Solution
from viscodesign.storage.disk_arrays import DISK_ROWS, release_pages

SHAPE_POINTS = 64
"""Points of an axis, at least."""
MARGIN_EDGES = 64
"""Edges read on either side of a block: rates of splines do not depend on what is farther."""
BLOCK_NUMBERS = 2_000_000
"""Numbers that are read at once, about."""


ROD_OUTPUTS = ("intrinsic_curvature", "intrinsic_stretch", *ROD_VALUES)
"""Outputs from which the shapes of rods are read."""


@dataclass(frozen=True)
class Outputs:
    """Named outputs (n, ...) at n edges; those from ``begin`` to ``end`` are its own.

    The rows before and after them are a margin that other blocks own.
    """

    problem: Problem
    first: int
    """Which edge of the schedule its first row is."""
    begin: int
    end: int
    """Edge behind its own last row, likewise."""
    time: np.ndarray
    values: Mapping[str, np.ndarray]

    def __getitem__(self, name: str) -> np.ndarray:
        return self.values[name]

    def rows_to(self, edge: int) -> slice:
        """Its own rows before an edge of the schedule."""
        return slice(self.begin - self.first, edge - self.first)

    def section_strains(self) -> tuple[np.ndarray, np.ndarray]:
        """Smallest stretch and turn of every section (n, S)."""
        return section_strains(self.problem, self.values)

    def shapes(self, keep: np.ndarray) -> np.ndarray:
        """Axis (T, K, 2) from the clamp on, at some rows (T,); of several rods one by one."""
        return np.concatenate([shape for shape, _ in self._axes(keep)], axis=1)

    def arc(self) -> np.ndarray:
        """Reference arc length (K,) of the points of a shape from the clamp of its rod [m]."""
        counts = [shape.shape[1] for shape, _ in self._axes(np.arange(1))]
        lengths = zip(self.problem.body.lengths, counts, strict=True)
        return np.concatenate([np.linspace(0.0, length, count) for length, count in lengths])

    def tips(self, keep: np.ndarray) -> np.ndarray:
        """x, z and angle of the tips (T, 3 rods) at some rows (T,): the ends of the shapes."""
        if self.problem.equations.rod_form is RodForm.ARCS:
            ends = [np.column_stack((shape[:, -1], angle)) for shape, angle in self._axes(keep)]
            return np.column_stack(ends)
        own = {name: self[name][keep] for name in self.values if name in ROD_OUTPUTS}
        ends = [
            np.column_stack((values["position"][:, -2:], values["angle"][:, -1]))
            for _, values in self.problem.rod.rods(own)
        ]
        return np.column_stack(ends)

    def _axes(self, keep: np.ndarray) -> list[tuple[np.ndarray, np.ndarray]]:
        """Axis (T, K, 2) and angle of the tip (T,) of every rod."""
        own = {name: values[keep] for name, values in self.values.items() if name in ROD_OUTPUTS}
        clamp, found = np.zeros((len(keep), 1, 2)), []
        for rod, values in self.problem.rod.rods(own):
            if self.problem.equations.rod_form is RodForm.ARCS:
                nodes, angles = arc_nodes(
                    values["intrinsic_curvature"],
                    1 + values["intrinsic_stretch"],
                    rod.body.section_length,
                    -(-SHAPE_POINTS // rod.body.sections),
                )
                angle = angles[:, -1]
            else:
                nodes, angle = rod.axis(values, SHAPE_POINTS)
            found.append((np.concatenate([clamp, nodes], axis=1), angle))
        return found

    def flows(self) -> np.ndarray:
        """Tube flows (n, Q); with one pressure per network, those that volume changes require."""
        if self.problem.equations.network_form is NetworkForm.DISTRIBUTED:
            return self["flow"]
        if len(self.time) < 2:
            return np.zeros((len(self.time), len(self.problem.flow_shares)))
        rates = spline_rates(self.time, self["volume"])
        return np.asarray(rates @ self.problem.flow_shares.T)


def read_outputs(
    problem: Problem, solution: Solution, at_once: int | None = None
) -> Iterator[Outputs]:
    """The outputs of a solution, in blocks of up to ``at_once`` edges."""
    width = sum(problem.equations.outputs_by_tape.sizes)
    most = at_once or int(np.clip(BLOCK_NUMBERS // max(width, 1), DISK_ROWS // 8, DISK_ROWS))
    for begin in range(0, solution.reached, most):
        end = min(begin + most, solution.reached)
        yield _read(problem, solution, begin, end)
        for table in (solution.states, solution.algebraics, solution.integrals):
            release_pages(table)


def _read(problem: Problem, solution: Solution, begin: int, end: int) -> Outputs:
    """Call the output function at the edges from ``begin`` to ``end``, and in the margin."""
    equations = problem.equations
    first, last = max(begin - MARGIN_EDGES, 0), min(end + MARGIN_EDGES, solution.reached)
    states, algebraics = solution.states[:, first:last], solution.algebraics[:, first:last]
    shared = equations.network_form is NetworkForm.UNIFORM and equations.sealed
    if shared or "junction_pressure" in equations.algebraics.blocks:
        # Between the steps of an integrator, the balances of junctions and of sealed parts hold
        # only to its tolerance.
        algebraics = polish(problem, states, algebraics, first)
    values = evaluate_along(problem, states, algebraics, first)
    if equations.network_form is NetworkForm.DISTRIBUTED:
        # From the states, in which storage and inflow agree to round-off.
        blocks = [n for n in ("volume", "node_volume") if n in equations.states.blocks]
        held = [equations.states.physical(n, states).T for n in blocks]
        values["stored"] = equations.rest_amounts + np.concatenate(held, axis=1)
        if equations.incompressible:
            bellows = values["stored"][:, : len(problem.bellows)]
            values["volume"] = bellows - values["tube_volume"]
    for name in ("pressure", "volume", "unpaired_volume"):
        values[name] = values[name][:, problem.places]
    return Outputs(problem, first, begin, end, problem.schedule.edges[first:last], values)
