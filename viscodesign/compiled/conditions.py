"""What formulas take for granted: decisions by the values that numbers had."""

from __future__ import annotations

import itertools
from collections.abc import Hashable, Iterator
from dataclasses import field
from typing import NamedTuple

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass

SX = ca.SX

DECIDED_REL_TOL = 1e-11
"""Relative difference of two numbers up to which a decision between them may go either way."""
SAME_NUMBER_REL = 1e-9
"""Relative difference of two values that counts as none where a number may not change."""
EQUAL_DEPTH = 20
"""Operations up to which two formulas are compared."""
MAX_PAIRS = 200
"""Pairs beyond which the numbers that were compared must all keep their order: sorting n numbers
compares n log n pairs, of which n - 1 imply the others."""


class Known(NamedTuple):
    """A number that was compared: its value, and its formula where it has one."""

    value: float
    symbolic: SX | None = None

    @property
    def formula(self) -> SX:
        """Its formula, or the constant that it is."""
        return SX(self.value) if self.symbolic is None else self.symbolic

    @property
    def key(self) -> Hashable:
        """Equal for the same number."""
        return self.value if self.symbolic is None else self.symbolic.element_hash()


@dataclass(frozen=True)
class Condition:
    """What a decision took for granted: that one number is at most another, or equal to it."""

    less: Known
    more: Known
    is_equality: bool
    place: str

    @property
    def gap(self) -> SX:
        """Not negative where it holds, or zero."""
        return self.more.formula - self.less.formula

    @property
    def scale(self) -> SX:
        """Size of the two."""
        return ca.fabs(self.less.formula) + ca.fabs(self.more.formula)

    @property
    def margin(self) -> SX:
        """Not negative where it holds, to rounding error."""
        rounding = DECIDED_REL_TOL * self.scale
        return rounding - ca.fabs(self.gap) if self.is_equality else self.gap + rounding

    @property
    def is_tight(self) -> bool:
        """Whether the two are equal."""
        size = abs(self.less.value) + abs(self.more.value)
        return abs(self.more.value - self.less.value) <= SAME_NUMBER_REL * size


@dataclass
class Tape:
    """The conditions of one trace."""

    place: str = ""
    """What is being traced, in words; where a trace fails, it tells what failed."""
    constants: list[SX] = field(default_factory=list)
    """Formulas of numbers that somebody tried to copy: see `Traced.__reduce_ex__`."""
    is_paused: bool = False
    """Whether decisions are not noted."""
    meetings: list[tuple[SX, SX]] = field(default_factory=list)
    """Formulas of two numbers each that count as one."""
    _noted: dict[Hashable, Condition] = field(default_factory=dict)

    def note_order(self, less: Known, more: Known) -> None:
        """Two numbers whose order something was decided by."""
        self._note(less, more, False)

    def note_equal(self, one: Known, other: Known) -> None:
        """Two numbers whose equality something was decided by."""
        if not ca.is_equal(one.formula, other.formula, EQUAL_DEPTH):
            self._note(one, other, True)

    def _note(self, less: Known, more: Known, is_equality: bool) -> None:
        key = less.key, more.key, is_equality
        if not self.is_paused and key not in self._noted:
            self._noted[key] = Condition(less, more, is_equality, self.place)

    def margins(self) -> SX:
        """All of which must not be negative (n,)."""
        every = self._noted.values()
        orders = [condition for condition in every if not condition.is_equality]
        kept = [condition for condition in every if condition.is_equality or condition.is_tight]
        kept += _chained(orders) if len(orders) > MAX_PAIRS else orders
        return ca.vertcat(SX(0, 1), *(condition.margin for condition in kept))

    def parting(self, symbols: SX, values: np.ndarray) -> list[int]:
        """Positions of the free numbers, at values (f,), that move apart what counts as one."""
        if not self.meetings:
            return []
        ends = [ca.vertcat(*formulas) for formulas in zip(*self.meetings, strict=True)]
        function = ca.Function("slopes", [symbols], [ca.jacobian(end, symbols) for end in ends])
        one, other = (np.array(slopes) for slopes in function(values))
        moves = np.abs(other - one) > SAME_NUMBER_REL * (np.abs(one) + np.abs(other))
        return np.flatnonzero(np.any(moves, axis=0)).tolist()

    def blocked(self, symbols: SX, values: np.ndarray) -> Iterator[Blocked]:
        """What stops free numbers at values (f,) that just meet conditions."""
        tight = [condition for condition in self._noted.values() if condition.is_tight]
        gaps = ca.vertcat(SX(0, 1), *(condition.gap for condition in tight))
        scales = ca.vertcat(SX(0, 1), *(condition.scale for condition in tight))
        found = ca.Function("slopes", [symbols], [ca.jacobian(gaps, symbols), scales])
        slopes, scale = found(values)
        rows, columns = (np.array(places, dtype=int) for places in slopes.sparsity().get_triplet())
        steps = np.where(values, np.abs(values), 1.0)[columns]
        moves = np.abs(slopes.nonzeros()) * steps > SAME_NUMBER_REL * scale.full().ravel()[rows]
        for k in np.flatnonzero(moves):
            yield Blocked(int(columns[k]), float(slopes.nonzeros()[k]), tight[rows[k]])


@dataclass(frozen=True)
class Blocked:
    """A free number, by its position, whose change in one direction breaks a condition."""

    number: int
    slope: float
    """Slope of the condition's gap."""
    condition: Condition


def _chained(orders: list[Condition]) -> list[Condition]:
    """Conditions by which all numbers of others keep their order, except equal ones.

    They ask for more than the others did. Their count is linear in that of the numbers, of which
    many may be equal: between two values stands the mean of a number of each.
    """
    numbers = {n.key: n for condition in orders for n in (condition.less, condition.more)}
    groups: list[list[Known]] = []
    for number in sorted(numbers.values(), key=lambda number: number.value):
        if groups and Condition(groups[-1][0], number, False, "").is_tight:
            groups[-1].append(number)
        else:
            groups.append([number])
    found = []
    for before, after in itertools.pairwise(groups):
        ends = before[0], after[0]
        value, formula = (n.value for n in ends), (n.formula for n in ends)
        between = Known(sum(value) / 2, sum(formula, SX(0)) / 2)
        found += [Condition(less, between, False, "") for less in before]
        found += [Condition(between, more, False, "") for more in after]
    return found
