"""Sums whose terms stay apart."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Self

import casadi as ca

from viscodesign.lazy_dataclass import dataclass

SX = ca.SX


class Terms:
    """A scalar sum that effects add to with ``+=`` and ``-=``; each term should be local."""

    def __init__(self) -> None:
        self.terms: list[SX] = []

    def __iadd__(self, term: SX) -> Self:
        self.terms.append(SX(term))
        return self

    def __isub__(self, term: SX) -> Self:
        self.terms.append(-SX(term))
        return self

    @property
    def total(self) -> SX:
        """The sum as one formula."""
        return total(self.terms)

    def is_zero(self) -> bool:
        """Whether there is nothing in it."""
        return all(term.is_zero() for term in self.terms)


def total(terms: Iterable[SX]) -> SX:
    """Sum of scalar formulas."""
    return sum(terms, SX(0))


@dataclass(frozen=True)
class GradientRows:
    """Rows of equations: factors times the gradient of a sum of terms.

    The terms stay apart, so that equal ones can be computed by one kernel.
    """

    terms: Sequence[SX]
    variables: SX
    """(n,) symbols."""
    factors: SX
    """(n,), or one for all; of parameters alone."""

    def whole(self) -> SX:
        """The rows as formulas (n,)."""
        return self.factors * ca.gradient(total(self.terms), self.variables)


Rows = SX | GradientRows


def rows_of(block: Sequence[Rows]) -> int:
    """How many rows a block of contributions has."""
    first = block[0]
    return int((first.variables if isinstance(first, GradientRows) else first).numel())


def whole(rows: Sequence[Rows], count: int) -> SX:
    """The sum of several contributions to the same ``count`` rows."""
    parts = (part.whole() if isinstance(part, GradientRows) else part for part in rows)
    return sum(parts, SX.zeros(count))
