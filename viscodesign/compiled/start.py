"""Where a run starts, as a function of a scene's numbers with derivatives."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

from viscodesign.compiled.row_functions import RowFunction
from viscodesign.compiled.scene_numbers import ProblemNumbers
from viscodesign.compiled.symbols import Symbols, parameter_names
from viscodesign.errors import SolveError, SpecError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model import formulas as of
from viscodesign.model.equations import LEADING_QUANTITIES, Equations
from viscodesign.model.network_equations import BELLOW_AMOUNTS, BELLOW_PRESSURES
from viscodesign.model.rod_equations import RodForm
from viscodesign.model.unknowns import Block, Unknowns
from viscodesign.native.algebraic_part import solve_each
from viscodesign.solve.branch_following import on_same_branch
from viscodesign.solve.problem import Problem
from viscodesign.solve.statics import Start, rest, static_equilibrium

SX = ca.SX
EQUILIBRIUM_TOL = 1e-12
"""Correction of an equilibrium, in sizes of its unknowns, at which it counts as found."""
MAX_UNDAMPED_CORRECTIONS = 8
"""Undamped ones, before the loads are raised step by step instead."""


@dataclass(frozen=True)
class FoundEquilibrium:
    """Where a run starts, and the unknowns that it follows from."""

    start: Start
    unknowns: np.ndarray
    """(nu,) of the implicit equations."""


class StartEquations:
    """The implicit equations of a start, and the start by their unknowns. Stateless."""

    def __init__(self, unknowns: SX, piece: SX, parameters: SX, residual: SX, start: SX) -> None:
        arguments = (unknowns, piece, parameters)
        # A start takes a few rows a solution.
        self.residual = RowFunction(arguments, residual, is_merged=False)
        self.start = RowFunction(arguments, start, is_merged=False)
        slopes = ca.jacobian(residual, unknowns)
        self._pattern = slopes.sparsity()
        self._places = tuple(np.array(k, dtype=int) for k in self._pattern.get_triplet())
        entries = ca.vertcat(SX(0, 1), *ca.vertsplit(slopes.nz[:]))
        self.slopes = RowFunction(arguments, entries, is_merged=False)

    @classmethod
    def of(cls, problem: Problem, *, steady: bool) -> StartEquations:
        """Those of all problems with these formulas, in equilibrium or at rest."""
        straight = b"" if steady else _straight(problem).tobytes()

        def made() -> StartEquations:
            own = Symbols.of(problem)
            make = _steady_formulas if steady else _rest_formulas
            unknowns, residual, start = make(problem, own.piece, own.parameters)
            return cls(unknowns, own.piece, own.parameters, residual, start)

        return problem.equations.shared.derived(cls, (steady, straight), made)

    def jacobians(self, rows: Sequence[np.ndarray]) -> np.ndarray:
        """(m, nu, nu) of the implicit equations."""
        found = np.zeros((len(rows[0]), *self._pattern.shape))
        found[:, self._places[0], self._places[1]] = self.slopes(*rows)
        return found


class StartFunction:
    """States and algebraic unknowns (nx + nz,) at t = 0 by the first inlet coefficients and the
    parameters.

    They follow from unknowns u of implicit equations: the static ones of an equilibrium, or what
    a straight rod at rest displaces.
    """

    def __init__(self, problem: Problem, *, steady: bool) -> None:
        self._steady, self._own = steady, StartEquations.of(problem, steady=steady)
        piece_now = problem.schedule.initial_piece
        self._near = static_equilibrium(problem, 0.0, piece_now) if steady else None
        self._statics, self._stability = problem.equations.statics, problem.static_stability

    def __call__(self, problem: Problem, numbers: ProblemNumbers) -> FoundEquilibrium:
        """Raises `SolveError` where there is none."""
        piece = numbers.initial_piece
        if self._near is not None:
            rows = piece[None], problem.equations.parameter_values[None]
            unknowns, is_found = self._nearby(*rows)
            if not is_found[0]:
                unknowns = static_equilibrium(problem, 0.0, piece)[None]
            start = self._own.start(unknowns, *rows)[0]
            states = problem.equations.states.count
            return FoundEquilibrium(Start(*np.split(start, [states])), unknowns[0])
        start = rest(problem, piece)
        return FoundEquilibrium(start, _rest_unknowns(problem, start))

    def near(self, pieces: np.ndarray, parameters: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Starts (m, nx + nz) of m rows of inlet coefficients and parameters, and which count (m,).

        Those that do not are too far from the one that this was made near, or at rest.
        """
        if self._near is None:
            count = self._own.start.size
            return np.zeros((len(pieces), count)), np.zeros(len(pieces), dtype=bool)
        unknowns, is_found = self._nearby(pieces, parameters)
        return self._own.start(unknowns, pieces, parameters), is_found

    def _nearby(self, pieces: np.ndarray, parameters: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Equilibria (m, nu) on the same branch as one of other numbers, and which count (m,)."""
        assert self._near is not None, "a start at rest has none"
        y = np.repeat(self._near[None], len(pieces), axis=0)
        is_found, still = np.zeros(len(y), dtype=bool), np.arange(len(y))
        if any(b.traits.is_multivalued for b in self._statics.blocks.values()):
            return y, is_found
        for _ in range(MAX_UNDAMPED_CORRECTIONS):
            rows = [y[still], pieces[still], parameters[still]]
            step = solve_each(self._own.jacobians(rows), self._own.residual(*rows))
            y[still] -= step
            sizes = np.max(np.abs(step), axis=1, initial=0.0)
            is_found[still[sizes <= EQUILIBRIUM_TOL]] = True
            still = still[(sizes > EQUILIBRIUM_TOL) & (sizes < np.inf)]
            if not len(still):
                break
        found = np.flatnonzero(is_found)
        is_found[found] = self._are_accepted(y[found], pieces[found], parameters[found])
        return y, is_found

    def _are_accepted(
        self, found: np.ndarray, pieces: np.ndarray, parameters: np.ndarray
    ) -> np.ndarray:
        """Whether equilibria are stable, and near that of other numbers (m,)."""
        span, near = self._statics.branch_span, self._near
        if self._stability is None or span is None or near is None or not len(found):
            return np.ones(len(found), dtype=bool)
        is_near = [on_same_branch(span, (near,), own) for own in found]
        return self._stability.are_stable(self._own.slopes(found, pieces, parameters)) & is_near

    def pull_back(
        self,
        problem: Problem,
        found: FoundEquilibrium,
        numbers: ProblemNumbers,
        weights: np.ndarray,
    ) -> ProblemNumbers:
        """Slopes of weights (nx + nz,) times the start by all numbers."""
        rows = self._rows(problem, found.unknowns)
        own, piece, parameters = self._own.start.pull_back(rows, weights[None])
        passed = self._solve(rows, own[0], transposed=True)
        _, more_piece, more = self._own.residual.pull_back(rows, -passed[None])
        slopes = numbers.zeros()
        slopes.initial_piece[:] = (piece + more_piece)[0]
        slopes.parameters[:] = (parameters + more)[0]
        return slopes

    def push_forward(
        self,
        problem: Problem,
        found: FoundEquilibrium,
        numbers: ProblemNumbers,
        dots: ProblemNumbers,
    ) -> np.ndarray:
        """Rates (d, nx + nz) of the start along d directions, the first axis of all ``dots``."""
        del numbers
        count, given = len(dots.parameters), [dots.initial_piece, dots.parameters]
        rows = [np.repeat(row, count, axis=0) for row in self._rows(problem, found.unknowns)]
        still = np.zeros((count, len(found.unknowns)))
        defect = self._own.residual.push_forward(rows, [still, *given])
        own = -self._solve(self._rows(problem, found.unknowns), defect.T).T
        return self._own.start.push_forward(rows, [own, *given])

    def _rows(self, problem: Problem, unknowns: np.ndarray) -> list[np.ndarray]:
        parameters = problem.equations.parameter_values
        return [unknowns[None], problem.schedule.initial_piece[None], parameters[None]]

    def _solve(
        self, rows: list[np.ndarray], right: np.ndarray, *, transposed: bool = False
    ) -> np.ndarray:
        if not right.size:
            return right
        (slopes,) = self._own.jacobians(rows)
        try:
            return np.linalg.solve(slopes.T if transposed else slopes, right)
        except np.linalg.LinAlgError as error:
            raise SolveError(
                "the start of the run has no derivatives: its equations are singular",
                quantity="equilibrium",
                where="rod",
                time_s=0.0,
                remedy="Move the first pressures or the loads a little.",
            ) from error


def _steady_formulas(problem: Problem, piece: SX, parameters: SX) -> tuple[SX, SX, SX]:
    """Unknowns, their equations, and the start that follows from them."""
    equations = problem.equations
    y = SX.sym("y", equations.statics.count)
    residual, states, algebraics = _from_static_unknowns(equations, y, piece, parameters)
    return y, residual, ca.vertcat(*states.values(), *algebraics.values())


def _rest_formulas(problem: Problem, piece: SX, parameters: SX) -> tuple[SX, SX, SX]:
    """The same for a straight rod at rest with all pressures at the baseline.

    What a rod displaces that is held straight under pressure, and its internal unknowns, follow
    from the algebraic equations.
    """
    equations = problem.equations
    y = _resting_unknowns(problem, parameters)
    _, states, algebraics = _from_static_unknowns(equations, y, piece, parameters)
    free = _solved_at_rest(problem)
    symbols = {name: SX.sym(name, equations_block(equations, name).count) for name in free}
    states = {name: symbols.get(name, value) for name, value in states.items()}
    algebraics = {name: symbols.get(name, value) for name, value in algebraics.items()}
    x, z = ca.vertcat(*states.values()), ca.vertcat(*algebraics.values())
    sealed, *_ = equations.compiled(of.quantities).call([parameters])
    alg, _ = equations.algebraic_function.call([x, z, SX(0), piece, SX(1), sealed, parameters])
    rows = [alg[equations.algebraics.blocks[row].span] for row in free.values()]
    return ca.vertcat(SX(0, 1), *symbols.values()), ca.vertcat(SX(0, 1), *rows), ca.vertcat(x, z)


def equations_block(equations: Equations, name: str) -> Block:
    """A block of states or of algebraic unknowns."""
    return (equations.states.blocks | equations.algebraics.blocks)[name]


def _solved_at_rest(problem: Problem) -> dict[str, str]:
    """Blocks of the start that algebraic equations determine, and whose rows these are."""
    equations = problem.equations
    if equations.rod_form is RodForm.ARCS or BELLOW_AMOUNTS not in equations.states.blocks:
        return {}
    blocks = equations.algebraics.blocks
    internal = [name for name, block in blocks.items() if block.traits.is_internal]
    return {BELLOW_AMOUNTS: BELLOW_PRESSURES, **{name: name for name in internal}}


def _rest_unknowns(problem: Problem, start: Start) -> np.ndarray:
    """Values of the unknowns of `_rest_formulas` in a start."""
    equations = problem.equations
    parts = [np.zeros(0)]
    for name in _solved_at_rest(problem):
        own = start.states if name in equations.states.blocks else start.algebraics
        parts.append(own[equations_block(equations, name).span])
    return np.concatenate(parts)


def _straight(problem: Problem) -> np.ndarray:
    """Coordinates of the straight, unloaded rod, in their sizes."""
    sections = problem.body.sections
    return np.asarray(problem.rod.unloaded_coordinates(np.zeros(sections), np.ones(sections)))


def _resting_unknowns(problem: Problem, parameters: SX) -> SX:
    """Static unknowns of a straight rod with all pressures at the baseline."""
    equations = problem.equations
    quantities = equations.compiled(of.quantities).call([parameters])
    sizes = quantities[-len(equations.statics.blocks) :]
    baseline = parameters[parameter_names(equations).index("gauge_pressure")]
    parts, used = [SX(0, 1)], 0
    straight = _straight(problem)
    for block, size in zip(equations.statics.blocks.values(), sizes, strict=True):
        if block.traits.is_multivalued or equations.rod_form is RodForm.STATIC:
            raise SpecError.plain(
                "run.start: rest has no derivatives here: the start of a rod without inertia and "
                "of bellows that snap is found step by step; use run.start: equilibrium"
            )
        if block.traits.is_pressure:
            parts.append(ca.repmat(baseline, block.count, 1) / size)
        elif block.traits.identifies_branch:
            parts.append(SX(straight[used : used + block.count]))
            used += block.count
        else:
            parts.append(SX.zeros(block.count))
    return ca.vertcat(*parts)


def _from_static_unknowns(
    equations: Equations, y: SX, piece: SX, parameters: SX
) -> tuple[SX, dict[str, SX], dict[str, SX]]:
    """The static residual, and blocks of states and algebraic unknowns with all rates zero."""
    sealed, *_ = quantities = equations.compiled(of.quantities).call([parameters])
    residual, _, amounts, *_ = equations.static_function.call(
        [y, SX(0), piece, SX(1), sealed, parameters]
    )
    sizes = iter(quantities[LEADING_QUANTITIES:])

    def spread(unknowns: Unknowns) -> dict[str, SX]:
        parts, used = {}, 0
        for name, block in unknowns.blocks.items():
            size = next(sizes)
            if block.traits.is_amount:
                parts[name] = amounts[used : used + block.count] / size
                used += block.count
            elif name in equations.statics.blocks:
                parts[name] = y[equations.statics.blocks[name].span]
            else:
                parts[name] = SX.zeros(block.count)
        return parts

    return residual, spread(equations.states), spread(equations.algebraics)
