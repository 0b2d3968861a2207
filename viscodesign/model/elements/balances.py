"""Equations as they are given to be taken apart."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.elements.expression_graph import Leaves

SX = ca.SX


@dataclass(frozen=True)
class Slope:
    """Where the derivative of a term by one unknown goes: to an equation, times a factor."""

    row: int
    factor: SX


@dataclass(frozen=True)
class Potential:
    """Scalar terms whose derivatives with respect to unknowns are parts of equations."""

    terms: Sequence[SX]
    slopes: Mapping[int, Slope]
    """By the number of the unknown."""


@dataclass(frozen=True)
class BalanceLayout:
    """What equations and unknowns there are."""

    mass: np.ndarray
    """(n,) 1 where the equation gives a rate, 0 where it is a constraint."""
    weak: np.ndarray
    """(n,) whether an equation is a constraint that may depend on its own unknown by round-off
    only, such as that of a node that others hold."""
    states: int
    algebraics: int
    integrals: int
    """Unknowns of each kind: states come first, integrals last, sums before them."""

    @property
    def unknowns_of_formulas(self) -> int:
        """Unknowns that are not sums."""
        return self.states + self.algebraics + self.integrals


@dataclass(frozen=True)
class Balances(BalanceLayout):
    """M dy/dt = rows + slopes of the potentials."""

    leaves: Leaves
    rows: SX
    """One formula for every equation."""
    potentials: Sequence[Potential]

    def layout(self) -> BalanceLayout:
        """The same without formulas."""
        return BalanceLayout(**{f.name: getattr(self, f.name) for f in fields(BalanceLayout)})
