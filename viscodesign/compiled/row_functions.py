"""CasADi functions with their derivatives, called for many rows of arguments at once."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

from viscodesign.model.row_blocks import BLOCK_ROWS, evaluate_rows
from viscodesign.storage.cached_property import cached_property

SX = ca.SX


class RowFunction:
    """A function of several columns with one column as its result, and its derivatives.

    Rows of arguments are (m, n_k) each; those of the last ``shared`` arguments are the same for
    all rows and given once.
    """

    def __init__(
        self,
        arguments: Sequence[SX],
        result: SX,
        *,
        shared: int = 0,
        at_once: int = BLOCK_ROWS,
    ) -> None:
        self._shared, self._at_once = shared, at_once
        self._sizes = [int(argument.numel()) for argument in arguments]
        self._formulas = list(arguments), ca.densify(result)
        self.size = int(result.numel())
        """Entries of the result."""

    @cached_property
    def _value(self) -> ca.Function:
        given, result = self._formulas
        return ca.Function("value", given, [ca.cse(result)]).map(self._at_once)

    @cached_property
    def _back(self) -> ca.Function:
        """Slopes of the weighted result by all arguments."""
        given, result = self._formulas
        weights = SX.sym("weights", self.size)
        slopes = ca.jtimes(result, ca.vertcat(*given), weights, True)
        found = [ca.cse(ca.densify(slopes))]
        return ca.Function("back", [*given, weights], found).map(self._at_once)

    @cached_property
    def _along(self) -> ca.Function:
        """Rates of the result for those of all arguments."""
        given, result = self._formulas
        whole = ca.vertcat(*given)
        rates = SX.sym("rates", whole.numel())
        found = [ca.cse(ca.densify(ca.jtimes(result, whole, rates)))]
        return ca.Function("along", [*given, rates], found).map(self._at_once)

    def __call__(self, *arguments: np.ndarray) -> np.ndarray:
        """Results (m, size)."""
        return self._evaluate(self._value, self._rows(arguments), self.size)

    def pull_back(self, arguments: Sequence[np.ndarray], weights: np.ndarray) -> list[np.ndarray]:
        """Slopes of the sum of weights (m, size) times results, one array per argument.

        Those of a shared argument are summed over the rows.
        """
        rows = [*self._rows(arguments), weights]
        found = self._evaluate(self._back, rows, sum(self._sizes))
        parts = np.split(found, np.cumsum(self._sizes)[:-1], axis=1)
        own = len(parts) - self._shared
        return [*parts[:own], *(part.sum(axis=0) for part in parts[own:])]

    def push_forward(
        self, arguments: Sequence[np.ndarray], rates: Sequence[np.ndarray]
    ) -> np.ndarray:
        """Rates (m, size) for the rates of all arguments, shaped like them."""
        rows = self._rows(arguments)
        moved = np.concatenate(self._rows(rates), axis=1)
        return self._evaluate(self._along, [*rows, moved], self.size)

    def _evaluate(self, function: ca.Function, rows: Sequence[np.ndarray], size: int) -> np.ndarray:
        (found,) = evaluate_rows(function, rows, [size], self._at_once)
        return found

    def _rows(self, arguments: Sequence[np.ndarray]) -> list[np.ndarray]:
        own = len(arguments) - self._shared
        count = len(arguments[0])
        shared = [np.broadcast_to(values, (count, len(values))) for values in arguments[own:]]
        return [*arguments[:own], *shared]
