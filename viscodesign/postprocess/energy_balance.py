"""The balance of energy: work done is stored or lost."""

from __future__ import annotations

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.boundary_work import FORCE_AND_PATH
from viscodesign.model.network_equations import NetworkForm
from viscodesign.postprocess.solved_edges import SolvedEdges
from viscodesign.postprocess.work_integrals import ENERGIES, EnergyTable, group_ends
from viscodesign.solve.problem import Problem, evaluate_after, evaluate_at
from viscodesign.solve.statics import Start, consistent


@dataclass(frozen=True)
class EnergyTolerances:
    """From where on the balance says something."""

    at_rest: float = 1e-4
    """Part of the stored energy below which next to nothing moves. Steps need not resolve the
    energy of such a motion: its balance is stated where it holds, and omitted elsewhere, rather
    than made relative to what is stored."""
    sampling: float = 1e-4
    """Part of the work by which samples may misjudge works that are summed over them, for the
    balance to be stated."""
    round_off: float = 1e-8
    """Part of the stored energy below which all is round-off, and the residual of equilibria."""
    storage_round_off: float = 1e-9
    """The same of what the bellows might store."""
    steps_per_sample: int = 20
    """Steps between two samples, on average, up to which these resolve the motion."""
    jump_rel: float = 1e-9
    """Part of its size by which an input may change at a corner without a jump."""


TOLERANCES = EnergyTolerances()
INLET_VALUES = ("inlet_pressure", "pushed")
"""Outputs that jump where an input does."""


class EnergyLedger:
    """Energy stored minus all work done; works without a rate are summed here.

    Where an input jumps and pressures follow instantly, the model does not determine the work
    of the jump: the balance then holds on each side of it.
    """

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        self._table = EnergyTable(problem)
        pieces = problem.schedule.pieces
        self._stretches = np.array([0, *pieces.changes, len(pieces)])
        """Edges at which a stretch of smooth input begins, and the last of all."""
        uniform = problem.equations.network_form is NetworkForm.UNIFORM
        # Otherwise contents are states, and what jumps is not part of the balance.
        self._may_jump = uniform or "plunger" in problem.equations.work_splits
        self._stretch = 0
        """Index of the current stretch."""
        self._first = 0
        """Edge of the first row kept."""
        self._kept = np.zeros((0, self._table.width))
        """Rows from the end of the last complete group of intervals."""
        self._opening: np.ndarray | None = None
        """The row with which the current stretch began."""
        self._edges = 0
        self._summed = self._unsure = 0.0
        self._off = self._worst = 0.0
        self._works = dict.fromkeys(FORCE_AND_PATH, 0.0)
        self._largest = {"pump": 0.0, "coupling": 0.0, "stored": 0.0}
        self._low, self._high = np.full((2, len(ENERGIES)), [[np.inf], [-np.inf]])
        self._is_coupled = False

    def add(self, block: SolvedEdges) -> None:
        """Add the edges that follow those before."""
        time = self._problem.schedule.edges[block.first :][: block.integrals.shape[1]]
        rows = self._table.of(time, block.rows, block.integrals)
        self._note_sizes(rows, block)
        at_hand = np.concatenate([self._kept, rows])
        if self._opening is None:
            self._opening = rows[0]
        last = block.first + len(rows) - 1
        jumping = self._jumping_edges(block, last)
        while True:
            end = self._stretches[self._stretch + 1]
            ends = self._ends(int(end), last)
            if len(ends):
                self._close(at_hand, np.concatenate([[0], ends - self._first]))
                at_hand, self._first = at_hand[ends[-1] - self._first :], int(ends[-1])
            if self._first < end or self._stretch + 2 == len(self._stretches):
                break
            if int(end) in jumping:
                at_hand[0] = self._after(block, int(end), at_hand[0])
            self._opening = at_hand[0].copy()
            self._stretch += 1
        self._kept = at_hand

    def _ends(self, stretch_end: int, last: int) -> np.ndarray:
        """Ends of the complete groups that follow, up to the last edge available."""
        if self._table.sums:
            return group_ends(self._first, stretch_end, last)
        return np.arange(self._first + 1, min(stretch_end, last) + 1)

    def _note_sizes(self, rows: np.ndarray, block: SolvedEdges) -> None:
        """Update the scales of an imbalance."""
        energies = self._table.energies(rows)
        self._edges += len(rows)
        self._low = np.minimum(self._low, energies.min(axis=0))
        self._high = np.maximum(self._high, energies.max(axis=0))
        self._note("stored", energies.sum(axis=1))
        self._is_coupled |= bool(np.any(block.rows["unpaired_volume"]))

    def _note(self, name: str, values: np.ndarray) -> None:
        self._largest[name] = max(self._largest[name], float(np.max(np.abs(values))))

    def _close(self, rows: np.ndarray, cuts: np.ndarray) -> None:
        """Balance complete groups of intervals of a stretch, which end at rows ``cuts``."""
        table, opening = self._table, self._opening
        assert opening is not None
        works: dict[str, np.ndarray] = {}
        ends = rows[cuts]
        for name in FORCE_AND_PATH:
            integrated = table.integrated(name, ends)
            parts, unsure = table.summed(name, rows, cuts)
            summed = np.concatenate([[0.0], np.cumsum(parts)])
            works[name] = self._works[name] + integrated - integrated[0] + summed
            self._summed += float(np.abs(parts).sum())
            self._unsure += float(unsure.sum())
            self._works[name] = float(works[name][-1])
        stored, lost = table.energies(ends).sum(axis=1), table.lost(ends)
        done = sum(works.values(), np.zeros(len(ends)))
        gained = (stored - stored[0]) + (lost - lost[0]) - (done - done[0])
        off = self._off + gained
        self._worst = max(self._worst, float(np.max(np.abs(off))))
        self._off = float(off[-1])
        self._note("pump", works["pump"] + works["plunger"])
        self._note("coupling", works["coupling"])

    def _jumping_edges(self, block: SolvedEdges, last: int) -> set[int]:
        """Edges up to the last available at which the value of any inlet changes."""
        corners = self._stretches[1:-1]
        corners = corners[(corners >= block.first) & (corners <= last)]
        if not self._may_jump or not len(corners):
            return set()
        at = corners - block.first
        unknowns = block.states[:, at], block.algebraics[:, at]
        after = evaluate_after(self._problem, *unknowns, corners)
        jumps = [_changes(block.rows[name], at, after[name]) for name in INLET_VALUES]
        return {int(corner) for corner in corners[np.any(jumps, axis=0)]}

    def _after(self, block: SolvedEdges, edge: int, row: np.ndarray) -> np.ndarray:
        """The row with which a stretch begins at a jump, where it differs from the last before."""
        problem, k = self._problem, edge - block.first
        states, schedule = block.states[:, k], problem.schedule
        before = Start(states, block.algebraics[:, k])
        time, piece = float(schedule.edges[edge]), schedule.pieces[edge]
        instant = time, schedule.pieces[edge - 1]
        found = consistent(problem, before, time, piece, instant)
        after = evaluate_at(problem, states, found.algebraics, time, piece)
        for name in ("pressure", "unpaired_volume"):
            after[name] = after[name][:, problem.places]
        rows = self._table.of(row[:1], after, block.integrals[:, k : k + 1])
        return np.asarray(rows[0])

    def balance(self, steps: int) -> tuple[float | None, float | None]:
        """Imbalance over the work done (None if unknown), and the work of unpaired coupling [J]."""
        if len(self._kept) > 1:  # the run ended within a group
            self._close(self._kept, np.array([0, len(self._kept) - 1]))
            self._kept = self._kept[-1:]
        coupled = self._works["coupling"] if self._is_coupled else None
        # Without inflow, energies are converted into each other.
        swing = float(np.max(self._high - self._low))
        moved = max(self._largest["pump"], self._largest["coupling"], swing)
        stored, size = self._largest["stored"], self._problem.equations.energy_size
        scale = max(moved, TOLERANCES.round_off * stored, TOLERANCES.storage_round_off * size)
        # Samples that are sparser than the oscillation look smooth and are not.
        rare = steps > TOLERANCES.steps_per_sample * self._edges
        if (self._summed if rare else self._unsure) > TOLERANCES.sampling * scale:
            return None, coupled
        imbalance = self._worst / scale
        at_rest = TOLERANCES.at_rest
        still = moved < at_rest * max(stored, at_rest * size)
        return None if still and imbalance > TOLERANCES.sampling else imbalance, coupled


def _changes(values: np.ndarray, at: np.ndarray, after: np.ndarray) -> np.ndarray:
    """(m,) whether any of the values (M, n) jumps at rows ``at``, to ``after`` (m, n)."""
    least = TOLERANCES.jump_rel * np.max(np.abs(values), initial=0.0)
    return np.asarray(np.any(np.abs(after - values[at]) > least, axis=1))
