"""The problem that every solver takes: equations with their numbers, and the times of the run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.equations import Equations
from viscodesign.model.rod import Body, RodDiscretisation
from viscodesign.model.rod_equations import RodForm
from viscodesign.model.scene_number import Numbers
from viscodesign.model.step_geometry import STRAIGHT, StepGeometry
from viscodesign.model.taped_function import TapedFunction
from viscodesign.model.unknowns import Unknowns
from viscodesign.solve.modal_system import ModalSystem, modal_system
from viscodesign.solve.numerics.stability import StabilityTest
from viscodesign.solve.obstacles import Remedies
from viscodesign.storage.cached_property import cached_property
from viscodesign.storage.distinct import distinct


class Pieces:
    """Coefficients (n, coefficients) of n intervals; neighbours with equal ones store them once.

    ``values`` (m, coefficients): those of m stretches; ``firsts`` (m,): first interval of each.
    """

    def __init__(self, values: np.ndarray, firsts: np.ndarray, count: int) -> None:
        self._values, self._firsts, self._count = values, firsts, count

    def __len__(self) -> int:
        return self._count

    def __getitem__(self, intervals: int | slice | Sequence[int] | np.ndarray) -> np.ndarray:
        """Coefficients of one interval (coefficients,), or of several (k, coefficients)."""
        if isinstance(intervals, slice):
            intervals = np.arange(*intervals.indices(self._count))
        stretch = np.searchsorted(self._firsts, intervals, side="right") - 1
        return np.asarray(self._values[stretch])

    @property
    def changes(self) -> np.ndarray:
        """Intervals whose coefficients differ from those of the one before, ascending."""
        new = np.any(self._values[1:] != self._values[:-1], axis=1)
        return np.asarray(self._firsts[1:][new])

    def among(self, edges: np.ndarray, finer: np.ndarray) -> Pieces:
        """The same for the intervals of ``finer``, which holds all of these ``edges``."""
        return Pieces(self._values, np.searchsorted(finer, edges[self._firsts]), len(finer) - 1)


SAME_TIME = 1e-12
"""Times that differ by less than this part of the run's end count as equal."""


def merged(times: np.ndarray, end: float) -> np.ndarray:
    """Ascending times up to ``end`` [s], those within round-off of each other made one."""
    ordered = distinct(times)
    keep = np.concatenate([[True], np.diff(ordered) > SAME_TIME * end])
    found = ordered[keep]
    found[-1] = end
    return np.asarray(found)


@dataclass(frozen=True)
class Schedule:
    """Times of a run and the inlets' piecewise coefficients.

    ``edges`` (n + 1,): 0, every output time, every corner of an input and the end,
    ascending; ``pieces`` (n, coefficients): valid inside each interval; ``outputs``:
    indices into ``edges``.
    """

    edges: np.ndarray
    pieces: Pieces
    outputs: np.ndarray
    initial_piece: np.ndarray
    """Coefficients just before t = 0, at which the initial equilibrium is found."""

    @classmethod
    def of(
        cls, times: np.ndarray, stops: np.ndarray, pieces: np.ndarray, initial_piece: np.ndarray
    ) -> Schedule:
        """Outputs at ``times`` (T,); ``pieces`` (m, coefficients) between ``stops`` (m + 1,)."""
        end = float(stops[-1])
        edges = merged(np.concatenate([times, stops]), end)
        firsts = np.searchsorted((edges[:-1] + edges[1:]) / 2, stops[:-1])
        outputs = np.searchsorted(edges, times - SAME_TIME * end)
        return cls(edges, Pieces(pieces, firsts, len(edges) - 1), outputs, initial_piece)


@dataclass(frozen=True)
class DrawingLimits:
    """How far a syringe can empty the bellows."""

    vacuum: float
    """Gauge pressure of a vacuum [Pa], below which no bellow is drawn."""
    least_volume: float | None
    """Volume of a bellow, as a mean of all, that is left at the end [m3]; None where the law of
    the bellows knows it."""


@dataclass(frozen=True)
class Problem:
    """Equations and the numbers that go into them."""

    equations: Equations
    rod: RodDiscretisation
    inlets: tuple[str, ...]
    bellows: tuple[str, ...]
    bellows_along_tubes: tuple[str, ...]
    """The same in the order of the unknowns."""
    baseline: float
    """Gauge pressure about which the inputs vary [Pa]."""
    schedule: Schedule
    has_straight_inputs: bool
    """Whether every input is a straight line between its corners."""
    rest_volume: Numbers
    """Volume of a bellow at zero gauge, without what tubes share with it [m3]."""
    floor_volume: Numbers | None
    """Minimum volume, at which a gas-filled bellow ends a run [m3]; None where the model covers
    the contact of its walls, or where the fluid is not a gas."""
    drawing: DrawingLimits | None
    """How far a syringe can empty the bellows; None without one."""
    remedies: Remedies
    """What the scene and its effects offer where a run cannot go on."""
    max_steps: int
    """Steps after which a run is ended."""
    flow_shares: np.ndarray
    """(Q, B): tube flows per rate of every bellow's volume, where pressure is uniform."""
    junctions: tuple[str, ...] = ()

    @property
    def body(self) -> Body:
        """The actuator as a beam."""
        return self.rod.body

    @cached_property
    def stability(self) -> StabilityTest | None:
        """Judges a static rod by its algebraic equations; None where it is not algebraic."""
        equations = self.equations
        return self._stability_test(equations.algebraics, equations.constraints_by_tape)

    @cached_property
    def static_stability(self) -> StabilityTest | None:
        """The same by the equations of the equilibrium."""
        return self._stability_test(self.equations.statics, self.equations.statics_by_tape)

    def _stability_test(self, unknowns: Unknowns, function: TapedFunction) -> StabilityTest | None:
        if unknowns.branch_span is None:
            return None
        blocks = [block for block in unknowns.blocks.values() if block.traits.of_rod]
        own = sorted(blocks, key=lambda block: not block.traits.is_internal)
        rows = np.concatenate([np.arange(b.span.start, b.span.stop) for b in own])
        order, internal = self.rod.elimination_order()
        return StabilityTest(rows[order], internal, function.sparsities[1])

    @cached_property
    def modal_system(self) -> ModalSystem | None:
        """The modes of linear equations with constant coefficients; None for any others."""
        return modal_system(self.equations, self.numbers(), float(self.schedule.edges[-1]))

    def step_geometry(self, unknowns: Unknowns) -> StepGeometry:
        """How an iteration steps in a vector of unknowns."""
        span = unknowns.branch_span
        return STRAIGHT if span is None else self.rod.step_geometry(span)

    @property
    def unknowns(self) -> int:
        """Number of states and algebraic unknowns."""
        return self.equations.states.count + self.equations.algebraics.count

    @property
    def places(self) -> np.ndarray:
        """Position of each of the bellows in the order of the unknowns (B,)."""
        place = {name: k for k, name in enumerate(self.bellows_along_tubes)}
        return np.array([place[name] for name in self.bellows])

    def numbers(self, load_factor: float = 1.0) -> np.ndarray:
        """The parameter vector of the integrator: load factor, sealed volumes, parameters."""
        return np.concatenate(
            [[load_factor], self.equations.sealed_volumes, self.equations.parameter_values]
        )

    def tail(
        self, time: float, piece: np.ndarray, load_factor: float = 1.0
    ) -> tuple[float | np.ndarray, ...]:
        """Arguments that follow the unknowns in every function of the equations."""
        return (
            time,
            piece,
            load_factor,
            self.equations.sealed_volumes,
            self.equations.parameter_values,
        )


def evaluate_along(
    problem: Problem, states: np.ndarray, algebraics: np.ndarray, first: int = 0
) -> dict[str, np.ndarray]:
    """All named outputs (m, n) at m edges from ``first`` on, from unknowns (nx, m) and (nz, m)."""
    return _evaluate_rows(problem, rows_along(problem, states, algebraics, first))


def evaluate_after(
    problem: Problem, states: np.ndarray, algebraics: np.ndarray, edges: np.ndarray
) -> dict[str, np.ndarray]:
    """The same at the numbers of m edges, in the intervals that begin there."""
    return _evaluate_rows(problem, _rows_at(problem, states, algebraics, edges, edges))


def evaluate_times(
    problem: Problem,
    states: np.ndarray,
    algebraics: np.ndarray,
    time: np.ndarray,
    pieces: np.ndarray,
) -> dict[str, np.ndarray]:
    """The same at any times (m,), with the inputs' coefficients (m, c), or (c,) where equal."""
    return _evaluate_rows(problem, _arguments(problem, states, algebraics, time, pieces))


def _evaluate_rows(problem: Problem, rows: Sequence[np.ndarray]) -> dict[str, np.ndarray]:
    output = problem.equations.outputs_by_tape
    return dict(zip(output.names, output.rows(rows, len(rows[0])), strict=True))


def rows_along(
    problem: Problem, states: np.ndarray, algebraics: np.ndarray, first: int
) -> list[np.ndarray]:
    """Arguments of the equations' functions at m edges from ``first`` on: (m, n) each, or (n,)
    where equal at all of them.
    """
    edges = np.arange(first, first + states.shape[1])
    # A state just before a corner belongs to the interval that ends there.
    return _rows_at(problem, states, algebraics, edges, np.maximum(edges - 1, 0))


def _rows_at(
    problem: Problem,
    states: np.ndarray,
    algebraics: np.ndarray,
    edges: np.ndarray,
    intervals: np.ndarray,
) -> list[np.ndarray]:
    """The same at the numbers of m edges, with the input of as many intervals."""
    schedule = problem.schedule
    return _arguments(
        problem, states, algebraics, schedule.edges[edges], schedule.pieces[intervals]
    )


def _arguments(
    problem: Problem,
    states: np.ndarray,
    algebraics: np.ndarray,
    time: np.ndarray,
    pieces: np.ndarray,
) -> list[np.ndarray]:
    equations = problem.equations
    return [
        states.T,
        algebraics.T,
        time[:, None],
        pieces,
        np.ones(1),
        equations.sealed_volumes,
        equations.parameter_values,
    ]


def evaluate_at(
    problem: Problem, states: np.ndarray, algebraics: np.ndarray, time: float, piece: np.ndarray
) -> dict[str, np.ndarray]:
    """All named outputs (1, n) at one instant."""
    output = problem.equations.outputs_by_tape
    found = output(states, algebraics, *problem.tail(time, piece))
    return {n: np.array(v).reshape(1, -1) for n, v in zip(output.names, found, strict=True)}


def section_strains(
    problem: Problem, values: Mapping[str, np.ndarray]
) -> tuple[np.ndarray, np.ndarray]:
    """Smallest stretch and turn of every section (n, S) by named outputs at n edges."""
    if problem.equations.rod_form is not RodForm.ARCS:
        return problem.rod.section_strains(values)
    turn = values["intrinsic_curvature"] * problem.body.section_lengths
    return 1 + values["intrinsic_stretch"], turn


def evaluate(function: ca.Function, *arguments: float | np.ndarray) -> list[ca.DM]:
    """Call a CasADi function with numbers."""
    return list(function.call([ca.DM(argument) for argument in arguments]))
