"""The problem that every solver takes: equations with their numbers, and the times of the run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from viscodesign.model.equations import Equations
from viscodesign.model.rod import Body, RodDiscretisation
from viscodesign.model.step_geometry import STRAIGHT, StepGeometry
from viscodesign.model.unknowns import Unknowns
from viscodesign.solve.numerics.stability import StabilityTest


class Pieces:
    """Coefficients (n, coefficients) of n intervals; neighbours with equal ones store them once.

    ``values`` (m, coefficients): those of m stretches; ``firsts`` (m,): first interval of each.
    """

    def __init__(self, values: np.ndarray, firsts: np.ndarray, count: int) -> None:
        self._values, self._firsts, self._count = values, firsts, count

    def __len__(self) -> int:
        return self._count

    def __getitem__(self, intervals: int | slice | Sequence[int] | np.ndarray) -> np.ndarray:
        """Of one interval (coefficients,), or of several (k, coefficients)."""
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
    floor_volume: float | None
    """Minimum volume, at which a gas-filled bellow ends a run [m3]; None where the model covers
    the contact of its walls, or where the fluid is no gas."""
    max_steps: int
    """Steps after which a run is ended."""
    flow_shares: np.ndarray
    """(Q, B): tube flows per rate of every bellow's volume, where pressure is uniform."""

    @property
    def body(self) -> Body:
        """The actuator as a beam."""
        return self.rod.body

    @cached_property
    def stability(self) -> StabilityTest | None:
        """Judges a static rod by its algebraic equations; None where it is not algebraic."""
        equations = self.equations
        return self._stability_test(equations.algebraics, equations.algebraic_function)

    @cached_property
    def static_stability(self) -> StabilityTest | None:
        """The same by the equations of the equilibrium."""
        return self._stability_test(self.equations.statics, self.equations.static_function)

    @property
    def has_branches(self) -> bool:
        """Whether the algebraic equations have several solutions, on branches to be followed."""
        return self.equations.algebraics.branch_span is not None

    def _stability_test(self, unknowns: Unknowns, function: ca.Function) -> StabilityTest | None:
        if unknowns.branch_span is None:
            return None
        blocks = [block for block in unknowns.blocks.values() if block.traits.of_rod]
        own = sorted(blocks, key=lambda block: not block.traits.is_internal)
        rows = np.concatenate([np.arange(b.span.start, b.span.stop) for b in own])
        order, internal = self.rod.elimination_order()
        return StabilityTest(rows[order], internal, function.sparsity_out(1))

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
