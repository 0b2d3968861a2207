"""The motion that repeats with the period of the inputs: where a run starts on it.

States x are sought that come back after a period, phi(x) = x. Amounts that are sealed in, and all
else that a period keeps, stay as they are where the search begins. Each guess is extrapolated from
the periods so far (Anderson's method): as good as Newton's steps by GMRES, and a period costs less
than its derivative along one direction.
"""

from __future__ import annotations

import numpy as np

from viscodesign.errors import SolveError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.solve.problem import Problem
from viscodesign.solve.statics import Start
from viscodesign.solve.transient import integrate


@dataclass(frozen=True)
class CycleNumbers:
    """What steers the search for a limit cycle, and when it ends."""

    tolerance_share: float = 0.1
    """Tolerance of the periods solved, relative to that of the run: what they miss adds up where
    the motion takes many periods to settle."""
    closure: float = 0.05
    """Step, in tolerances of the run, below which states count as on the cycle."""
    branch_tol: float = 1e-3
    """Change of unknowns that tell one branch from another, from one period's end to the next,
    in their sizes, above which the motion has changed its branch."""
    max_periods: int = 200
    """Periods solved after which there is no cycle."""
    memory: int = 60
    """Periods that a step is extrapolated from."""
    extrapolation_rel: float = 1e-9
    """Change of the gap, relative to that of the states, below which a period tells nothing."""
    halvings: int = 3
    """Tries of a step, each half the one before, until it leads nearer; then the motion just goes
    on for a period."""
    may_grow: float = 2.0
    """Factor by which a step may enlarge the gap that is left."""
    disturbance: float = 1e-2
    """Disturbance of the states, which has to fade on a cycle that attracts."""
    fading_periods: int = 4
    """Periods for what fades quickly, and as many in which the rest must not grow."""
    max_growth: float = 1.1
    """Factor in as many periods that counts as growth."""


CYCLE = CycleNumbers()


@dataclass(frozen=True)
class LimitCycle:
    """Where a cycle begins, and the work of finding it."""

    start: Start
    periods: int
    """Periods that were solved."""


@dataclass(frozen=True)
class _Tried:
    """A period: how it began, ended, and the gap between both (nx,)."""

    begin: Start
    end: Start
    gap: np.ndarray

    @property
    def size(self) -> float:
        return float(np.linalg.norm(self.gap))

    @property
    def next_begin(self) -> Start:
        """Begin of the next period; integrals begin as before."""
        return Start(self.begin.states + self.gap, self.end.algebraics)


def limit_cycle(problem: Problem, begin: Start, tolerance: float, solver: str) -> LimitCycle:
    """The start of the cycle of a problem whose schedule is one period of the inputs.

    ``begin``: from where it is sought; ``tolerance``, ``solver``: those of the run. Raises
    `SolveError` where no motion repeats, where one that repeats does not attract, or where a period
    cannot be solved.
    """
    period = _Period(problem, CYCLE.tolerance_share * tolerance, solver)
    # The first period only takes the motion nearer to what repeats.
    first = here = period(period(begin).next_begin)
    past = _Extrapolation()
    while True:
        step = past.step(here)
        is_closed = _size(step, here.begin) <= CYCLE.closure * tolerance
        if is_closed and _same_branch(problem, here):
            break
        if period.count >= CYCLE.max_periods:
            raise _no_cycle(problem, here, period.count)
        here = _next(period, here, step, past)
    found = Start(here.begin.states + step, here.end.algebraics)
    if _repels(period, found, first.begin, tolerance):
        raise _unstable(problem)
    return LimitCycle(found, period.count)


class _Period:
    """A period solved from given states."""

    def __init__(self, problem: Problem, tolerance: float, solver: str) -> None:
        self.problem = problem
        self._tolerance, self._solver = tolerance, solver
        self._recurs = np.ones(problem.equations.states.count)
        for block in problem.equations.states.blocks.values():
            self._recurs[block.span] = not block.traits.is_integral
        self.count = 0
        """Solved so far."""

    def __call__(self, begin: Start) -> _Tried:
        """Raises `SolveError` where the end is not reached."""
        self.count += 1
        found = integrate(self.problem, begin, self._tolerance, solver=self._solver)
        if found.asked_to_stop:
            raise KeyboardInterrupt
        if found.failure is not None:
            raise found.failure
        end = Start(found.states[:, -1], found.algebraics[:, -1])
        return _Tried(begin, end, self._recurs * (end.states - begin.states))


class _Extrapolation:
    """Steps towards states that come back, from how the gaps of the periods so far differ."""

    def __init__(self) -> None:
        self._begins: list[np.ndarray] = []
        self._gaps: list[np.ndarray] = []

    def step(self, tried: _Tried) -> np.ndarray:
        """From where a period began (nx,)."""
        self._begins = [*self._begins, tried.begin.states][-CYCLE.memory :]
        self._gaps = [*self._gaps, tried.gap][-CYCLE.memory :]
        if len(self._gaps) < 2:
            return tried.gap
        begins, gaps = np.diff(self._begins, axis=0).T, np.diff(self._gaps, axis=0).T
        sizes = np.linalg.norm(gaps, axis=0)
        told = sizes > CYCLE.extrapolation_rel * np.linalg.norm(begins, axis=0)
        begins, gaps = begins[:, told] / sizes[told], gaps[:, told] / sizes[told]
        shares, *_ = np.linalg.lstsq(gaps, tried.gap, rcond=CYCLE.extrapolation_rel)
        return np.asarray(tried.gap - (begins + gaps) @ shares)

    def forget(self) -> None:
        """The motion has changed too much for what was before to tell anything."""
        self._begins, self._gaps = [], []


def _next(period: _Period, here: _Tried, step: np.ndarray, past: _Extrapolation) -> _Tried:
    """The period after a step, or a part of it that leads nearer; else the one that follows."""
    for halving in range(CYCLE.halvings if len(step) else 0):
        states = here.begin.states + step / 2**halving
        try:
            tried = period(Start(states, here.end.algebraics))
        except SolveError:
            continue  # so far away that a period cannot be solved
        if tried.size <= CYCLE.may_grow * here.size:
            return tried
    past.forget()
    return period(here.next_begin)


def _size(change: np.ndarray, begin: Start) -> float:
    """The largest change of a state, relative or absolute, whichever is smaller."""
    return float(np.max(np.abs(change) / (1 + np.abs(begin.states)), initial=0.0))


def _repels(period: _Period, found: Start, aside: Start, tolerance: float) -> bool:
    """Whether a small disturbance, towards ``aside``, grows from period to period."""
    away = aside.states - found.states
    size = _size(away, found)
    if size <= tolerance:
        return False
    states = found.states + min(1.0, CYCLE.disturbance / size) * away
    begin, sizes = Start(states, found.algebraics), []
    for _ in range(2 * CYCLE.fading_periods):
        begin = period(begin).next_begin
        sizes.append(_size(begin.states - found.states, found))
        if sizes[-1] <= tolerance:
            return False
    return sizes[-1] > CYCLE.max_growth * sizes[CYCLE.fading_periods - 1]


def _same_branch(problem: Problem, tried: _Tried) -> bool:
    """Whether a period ends on the branch, of equations with several solutions, of the last."""
    unknowns = problem.equations.algebraics
    rows = list(unknowns.multivalued)
    if (span := unknowns.branch_span) is not None:
        rows += range(span.start, span.stop)
    moved = np.abs(tried.end.algebraics[rows] - tried.begin.algebraics[rows])
    return bool(np.max(moved, initial=0.0) <= CYCLE.branch_tol)


REMEDY = (
    "Set run.start: equilibrium and a run.duration of many periods, which shows how the motion "
    "goes on."
)


def _no_cycle(problem: Problem, here: _Tried, periods: int) -> SolveError:
    blocks = problem.equations.states.blocks.values()
    gaps = {b.name: float(np.max(np.abs(here.gap[b.span]), initial=0.0)) for b in blocks}
    worst = max(gaps, key=gaps.__getitem__) if gaps else "branch"
    change = f"{worst.replace('_', ' ')} still changes by {gaps.get(worst, 1.0):.3g} of its size"
    return SolveError(
        f"run.start: periodic: no motion was found that repeats every {_length(problem):.6g} s; "
        f"after {periods} periods {change} from one to the next",
        quantity=worst,
        where="limit cycle",
        time_s=0.0,
        remedy=REMEDY,
    )


def _unstable(problem: Problem) -> SolveError:
    return SolveError(
        f"run.start: periodic: the motion that repeats every {_length(problem):.6g} s is "
        "unstable: a small disturbance of it grows from period to period",
        quantity="stability",
        where="limit cycle",
        time_s=0.0,
        remedy=REMEDY,
    )


def _length(problem: Problem) -> float:
    return float(problem.schedule.edges[-1])
