"""A scene as a function of free numbers, with derivatives."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from typing import Any, Protocol

import numpy as np

from viscodesign.checks.contact import refuse_contact
from viscodesign.checks.refusals import refuse_beyond_numbers, refuse_unsolvable
from viscodesign.compiled.batch import (
    COMPLETE,
    BatchRow,
    Outputs,
    batch_of,
    in_parts,
)
from viscodesign.compiled.batch import Batch as Batch
from viscodesign.compiled.directions import independent
from viscodesign.compiled.free_keys import FreeKeys, SceneKeys, over_one_period
from viscodesign.compiled.given_values import (
    Values,
    listed_rows,
    names_of,
    values_in_order,
    whole_number,
)
from viscodesign.compiled.held_inlets import ControlState, HeldInlets, Inlets
from viscodesign.compiled.integrated import IntegratedMotion
from viscodesign.compiled.keyed_function import KeyedFunction
from viscodesign.compiled.outputs import ChosenOutputs
from viscodesign.compiled.reading import Members
from viscodesign.compiled.scene_numbers import ProblemNumbers, SceneNumbers
from viscodesign.compiled.side_by_side import SideBySide
from viscodesign.compiled.solution import MotionFunction
from viscodesign.effects.allowed_sets import AllowedSets
from viscodesign.effects.select import select_effects
from viscodesign.errors import Fault, SolveError, SpecError, ViscodesignError
from viscodesign.estimate.joined_quantities import quantities_of
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.native.unavailable import NativeUnavailable
from viscodesign.results.findings import Verdict
from viscodesign.scene.scene import Scene
from viscodesign.simulation.build_problem import Settings, suggest_settings
from viscodesign.simulation.solve_once import KEPT_PROBLEMS
from viscodesign.solve.problem import Problem
from viscodesign.solve.transient import suitable_solver
from viscodesign.storage.cached_property import cached_property
from viscodesign.storage.lru_cache import LruCache

LARGEST_TOLERANCE = 1.0
"""Largest tolerance of the steps, relative to the unknowns' sizes."""
MAX_COMPILED_EDGES = 64
"""Largest number of edges of a section."""
PERIOD_CHANGE = 1e-5
"""Relative change of a number of an input by which periods are differenced."""
KEPT_SOLUTIONS = 2
"""Latest solutions that a function keeps: a value and its derivatives share one."""


class SolvedOutputs(Protocol):
    """What a motion solved."""

    @property
    def columns(self) -> np.ndarray:
        """(T, columns)"""

    @property
    def steps(self) -> int:
        """Steps taken."""


class DifferentiableMotion(Protocol):
    """Columns of a run as a function of the numbers of its problem."""

    times: np.ndarray

    @property
    def side_by_side(self) -> SideBySide | None:
        """Solves many rows of numbers at once, if anything does."""

    def solve(self, numbers: ProblemNumbers, *, recorded: bool = True) -> Any: ...

    def pull_back(
        self, solved: Any, numbers: ProblemNumbers, weights: np.ndarray
    ) -> ProblemNumbers: ...

    def push_forward(
        self, solved: Any, numbers: ProblemNumbers, dots: ProblemNumbers
    ) -> np.ndarray: ...


@dataclass(frozen=True)
class Judgement:
    """How the effects that a function holds fixed suit other values."""

    verdicts: tuple[Verdict, ...]
    """On every effect, for these values."""
    missing: tuple[str, ...]
    """Effects that these values call for and the function leaves out."""
    unneeded: tuple[str, ...]
    """Effects that the function includes and these values do not call for."""

    @property
    def suits(self) -> bool:
        """Whether no effect is missing."""
        return not self.missing


@dataclass(frozen=True)
class _Solved:
    """One solution and its numbers."""

    values: np.ndarray
    numbers: ProblemNumbers
    solution: SolvedOutputs
    period: float | None
    """Common period of all inputs [s], where metrics need it."""


class CompiledFunction(KeyedFunction[SceneKeys]):
    """Outputs of a scene as a function of free numbers [SI], with derivatives.

    Effects, mesh, tolerance and output times are those of the scene that it was made of; names of
    ``effects`` take the place of those that it calls for. Safe in threads, and picklable: a copy
    compiles the same scene again. With ``one_period`` the run lasts one period of its only input,
    and output times keep their share of it as the period changes; derivatives are those at times
    that stay. With ``keeps_unused`` numbers may be free on which nothing depends.
    """

    def __init__(
        self,
        scene: Scene,
        free: Sequence[str],
        outputs: Sequence[str],
        tolerance: float | None = None,
        edges_per_section: int | None = None,
        *,
        one_period: bool = False,
        effects: frozenset[str] | None = None,
        keeps_unused: bool = False,
        keys: SceneKeys | None = None,
    ) -> None:
        """``keys``: what the free numbers are of the scene, where they are keys of another spec."""
        free, outputs = names_of("free", free), names_of("outputs", outputs)
        if not isinstance(scene, Scene):
            raise SpecError.plain(f"scene: needs a scene, such as load({scene!r}); got {scene!r}")
        is_number = isinstance(tolerance, (int, float))
        if tolerance is not None and not (is_number and 0.0 < tolerance < LARGEST_TOLERANCE):
            raise SpecError.plain(
                f"tolerance: must be above 0 and below {LARGEST_TOLERANCE:g}; got {tolerance!r}"
            )
        if edges_per_section is not None:
            whole_number(edges_per_section, "edges_per_section", 1, MAX_COMPILED_EDGES)
        if one_period:
            scene = over_one_period(scene)
        self._made_of = (scene, free, outputs, tolerance, edges_per_section)
        self._options: dict[str, Any] = {
            "one_period": one_period,
            "effects": effects,
            "keeps_unused": keeps_unused,
        }
        quantities = quantities_of(scene)
        refuse_beyond_numbers(quantities)
        self._active = select_effects(quantities).active if effects is None else effects
        refuse_unsolvable(quantities, self._active)
        refuse_contact(
            quantities,
            "a function with derivatives, as compile, fit, design, "
            "sensitivity and `uncertainty` need it,",
        )
        members = AllowedSets(quantities).members(self._active)
        settings = suggest_settings(quantities, members)
        if tolerance is not None:
            settings = replace(settings, tolerance=tolerance)
        if edges_per_section is not None:
            settings = replace(settings, edges_per_section=edges_per_section)
        if keys is None:
            keys = FreeKeys(scene, free, one_period=one_period)
        self._keys = keys
        self._numbers = SceneNumbers(quantities, members, settings, keys, keeps_unused=keeps_unused)
        problem = KEPT_PROBLEMS.problem(quantities, members, settings).problem
        self._built = quantities, members, settings, problem
        own = self._numbers.at(self._numbers.values)
        self._kept: LruCache[_Solved] = LruCache(KEPT_SOLUTIONS)
        self._kept_slopes: LruCache[Outputs] = LruCache(1)  # who tries them asks for them next
        self._motion, self._chosen, solution = _motion(
            quantities, problem, settings, outputs, own, follow=one_period
        )
        if solution is not None:
            values = self._numbers.values
            found = _Solved(values, own, solution, self._period(values))
            self._kept.keep(values.tobytes(), found)

    def __reduce__(self) -> tuple[Callable[..., CompiledFunction], tuple[Any, ...]]:
        return partial(CompiledFunction, **self._options), self._made_of

    @property
    def times(self) -> np.ndarray:
        """(T,) output times [s]."""
        return self._motion.times.copy()

    @property
    def outputs(self) -> tuple[str, ...]:
        """Names of the outputs."""
        return self._chosen.names

    @property
    def settings(self) -> Settings:
        """Mesh and tolerance of its solutions."""
        return self._built[2]

    @property
    def effects(self) -> frozenset[str]:
        """Names of the effects that are included."""
        return self._active

    @property
    def is_used(self) -> np.ndarray:
        """(f,) Whether anything depends on each of the free numbers."""
        return self._numbers.branch.is_used.copy()

    @property
    def unused(self) -> tuple[Fault, ...]:
        """Why nothing depends on those of which that is so."""
        return self._numbers.unused

    # -- values and derivatives ---------------------------------------------------

    def __call__(self, values: Values | None = None) -> Outputs:
        """Every output at values (f,), by default the scene's own.

        Raises `SpecError` for values that are out of range, `SolveError` where the solution fails.
        """
        solved = self._solved(values)
        return self._chosen.read(solved.solution.columns, solved.period)

    def jacobian(self, values: Values | None = None) -> Outputs:
        """Derivatives of every output (T, f) or (f,), by the free numbers.

        Where a column has a kink, such as at an output time at which an input jumps, that of one
        side.
        """
        solved = self._solved(values)
        key = solved.values.tobytes()
        found = self._kept_slopes.found(key)
        if found is None:
            found = self._kept_slopes.keep(key, self._slopes(solved))
        return {name: np.array(own) for name, own in found.items()}

    def _slopes(self, solved: _Solved) -> Outputs:
        slopes = self._numbers.jacobian_at(solved.values)
        dots = ProblemNumbers(*(np.moveaxis(part, -1, 0) for part in slopes))
        columns, period_rates = solved.solution.columns, self._period_slopes(solved)
        own, parts = independent(dots, solved.numbers)
        rates = self._motion.push_forward(solved.solution, solved.numbers, dots.row(own))
        if parts is not None:
            rates = np.tensordot(parts, rates, 1)
        return self._chosen.push_forward(columns, solved.period, rates, period_rates)

    def vjp(self, values: Values | None, weights: Mapping[str, Any]) -> np.ndarray:
        """Gradient (f,) of the sum of weights times outputs, by one adjoint solution.

        ``weights``: of some or all outputs, shaped like them.
        """
        solved = self._solved(values)
        columns, period_weight = self._chosen.pull_back(
            solved.solution.columns, solved.period, weights
        )
        bars = self._motion.pull_back(solved.solution, solved.numbers, columns)
        slopes = self._numbers.pull_back(solved.values, bars)
        return slopes + period_weight * self._period_slopes(solved) if period_weight else slopes

    def batch(self, rows: Iterable[Values] | np.ndarray, workers: int | None = None) -> Batch:
        """Outputs of many rows of values (N, f), in so many threads, one by default.

        A data frame is read by its columns, as a mapping is by its keys. A row that is out of
        range or whose solution fails is NaN, and `Batch.status` says why.
        """
        workers = 1 if workers is None else whole_number(workers, "workers", 1)
        parts = in_parts(
            listed_rows(rows, self.names),
            self._motion.times.size * self._built[3].unknowns,
            workers,
        )
        if workers == 1:
            found = list(map(self._some_rows, parts))
        else:
            with ThreadPoolExecutor(workers) as pool:
                found = list(pool.map(self._some_rows, parts))
        return batch_of([row for part in found for row in part], self._chosen.blank())

    def _some_rows(self, rows: Sequence[Values]) -> list[BatchRow]:
        """Rows of a batch: side by side where that can be, else one by one."""
        solved = self._solved_together(rows)
        return [
            self._row(values) if columns is None else self._read_row(values, columns)
            for values, columns in zip(rows, solved, strict=True)
        ]

    def _solved_together(self, rows: Sequence[Values]) -> list[np.ndarray | None]:
        """Columns (T, c) of every row; None of those that are to be solved alone."""
        found: list[np.ndarray | None] = [None] * len(rows)
        together = self._motion.side_by_side
        if together is None or len(rows) == 1:
            return found
        try:
            given = np.array([self._array(values) for values in rows])
            given = given.reshape(len(rows), len(self.names))
            for places, numbers in self._numbers.rows_at(given):
                solved = together.solve(numbers)
                for k, columns in zip(places[solved.rows], solved.columns, strict=True):
                    found[k] = columns
        except (ViscodesignError, ValueError, NativeUnavailable):
            return found  # alone, each row tells what is wrong with it
        return found

    def _row(self, values: Values) -> BatchRow:
        try:
            solved = self._solve(self._array(values), recorded=False)
        except ViscodesignError as error:
            return None, str(error)
        return self._chosen.read(solved.solution.columns, solved.period), COMPLETE

    def _read_row(self, values: Values, columns: np.ndarray) -> BatchRow:
        return self._chosen.read(columns, self._period(self._array(values))), COMPLETE

    # -- what else can be asked -----------------------------------------------------

    def scene(self, values: Values | None = None) -> Scene:
        """The scene with these values. Raises `SpecError` where they make no valid spec."""
        return self._numbers.scene(self._array(values))

    def judge(self, values: Values | None = None) -> Judgement:
        """Weigh all effects again for these values."""
        quantities = quantities_of(self.scene(values))
        refuse_beyond_numbers(quantities)
        selection = select_effects(quantities)
        return Judgement(
            selection.verdicts,
            tuple(sorted(selection.active - self.effects)),
            tuple(sorted(self.effects - selection.active)),
        )

    def begin(self, values: Values | None = None, inlets: Inlets | None = None) -> ControlState:
        """The equilibrium with the inlets held, at which a control loop may start.

        ``inlets``: as for `step`, all zero by default. Raises `SolveError` where there is none.
        """
        given = self._array(values)
        return self._held.begin(self._numbers.checked_at(given).parameters, inlets)

    def step(self, state: ControlState, dt: float, inlets: Inlets) -> ControlState:
        """The state one interval of ``dt`` [s] later, with the inlets held over it.

        ``inlets``: pressure above the baseline [Pa] by inlet, or the volume that a plunger has
        pushed out [m3]; a number alone for the only inlet. Raises `SolveError` where it fails.
        """
        return self._held.step(state, dt, inlets)

    @cached_property
    def _held(self) -> HeldInlets:
        return HeldInlets(*self._built)

    # -- solutions ------------------------------------------------------------------

    def _solved(self, values: Values | None) -> _Solved:
        given = self._array(values)
        found = self._kept.found(given.tobytes())
        return self._kept.keep(given.tobytes(), self._solve(given)) if found is None else found

    def _solve(self, given: np.ndarray, *, recorded: bool = True) -> _Solved:
        numbers = self._numbers.checked_at(given)
        solution = self._motion.solve(numbers, recorded=recorded)
        return _Solved(given, numbers, solution, self._period(given))

    def _period(self, given: np.ndarray) -> float | None:
        """The period of all inputs [s], if any metric may need it.

        None of actuators that share fluid: what one has at its inlets need not repeat.
        """
        if not self._chosen.has_metrics or self._made_of[0].members:
            return None
        return self._numbers.keys.placed(given.tolist()).period

    def _period_slopes(self, solved: _Solved) -> np.ndarray:
        """(f,) of the period, by differences: a period is a sum or an inverse of few numbers."""
        slopes = np.zeros(len(self.names))
        for k, name in enumerate(self.names if solved.period else ()):
            if name.startswith("input"):
                change = np.zeros(len(slopes))
                change[k] = PERIOD_CHANGE * (abs(solved.values[k]) or 1.0)
                ends = [self._period(solved.values + s * change) or np.nan for s in (1, -1)]
                slopes[k] = (ends[0] - ends[1]) / (2 * change[k])
        return slopes

    def _array(self, values: Values | None) -> np.ndarray:
        """Values in order (f,)."""
        return values_in_order(values, self.names, self._numbers.values)


def _motion(
    quantities: SceneQuantities,
    problem: Problem,
    settings: Settings,
    outputs: Sequence[str],
    numbers: ProblemNumbers,
    *,
    follow: bool,
) -> tuple[DifferentiableMotion, ChosenOutputs, SolvedOutputs | None]:
    """How the columns are solved for, how outputs are read from them, and a first solution."""
    members, start = Members.of(quantities), quantities.scene.run.start
    chosen = ChosenOutputs(problem, members, outputs)
    columns, tolerance = chosen.columns, settings.tolerance
    failure: NativeUnavailable | SolveError | None = None
    if problem.equations.states.count:
        try:
            own = MotionFunction(problem, tolerance, members, columns, start=start, follow=follow)
            # Its equations may be singular at the start, or stop the steps on the way.
            return own, chosen, own.solve(numbers)
        except (NativeUnavailable, SolveError) as error:
            failure = error
    reason = failure.short if isinstance(failure, SolveError) else str(failure or "")
    solver = suitable_solver(problem, settings.solver, settings.is_free)
    integrated = IntegratedMotion(
        problem, tolerance, solver, members, columns, start=start, reason=reason, follow=follow
    )
    if not isinstance(failure, SolveError):
        return integrated, chosen, None
    try:
        return integrated, chosen, integrated.solve(numbers)
    except SolveError:
        raise failure from None
