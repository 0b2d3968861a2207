"""CasADi functions with their derivatives, called for many rows of arguments at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import casadi as ca
import numpy as np

from viscodesign.model.row_blocks import evaluate_rows
from viscodesign.model.taped_function import TapedFunction, TapeWithPatterns
from viscodesign.storage.cached_property import cached_property

SX = ca.SX


class RowFunction:
    """A function of several columns with one column as its result, and its derivatives.

    Rows of arguments are (m, n_k) each; those of the last ``shared`` arguments are the same for
    all rows and given once. ``is_merged``: whether equal terms are computed once, which is worth it
    from some 10,000 rows on: it saves up to a third of each, and finding them takes that long.
    """

    def __init__(
        self, arguments: Sequence[SX], result: SX, *, shared: int = 0, is_merged: bool = True
    ) -> None:
        self._merged: Callable[[SX], SX] = ca.cse if is_merged else _as_is
        self._shared = shared
        self._sizes = [int(argument.numel()) for argument in arguments]
        self._formulas = list(arguments), ca.densify(result)
        self.size = int(result.numel())
        """Entries of the result."""

    @cached_property
    def _value(self) -> TapedFunction:
        given, result = self._formulas
        return _taped(given, self._merged(result))

    @cached_property
    def _back(self) -> TapedFunction:
        """Slopes of the weighted result by all arguments."""
        given, result = self._formulas
        weights = SX.sym("weights", self.size)
        slopes = ca.jtimes(result, ca.vertcat(*given), weights, True)
        return _taped([*given, weights], self._merged(ca.densify(slopes)))

    @cached_property
    def _along(self) -> TapedFunction:
        """Rates of the result for those of all arguments."""
        given, result = self._formulas
        whole = ca.vertcat(*given)
        rates = SX.sym("rates", whole.numel())
        along = ca.densify(ca.jtimes(result, whole, rates))
        return _taped([*given, rates], self._merged(along))

    def __call__(self, *arguments: np.ndarray) -> np.ndarray:
        """Results (m, size)."""
        return self._found(self._value, arguments)

    def pull_back(self, arguments: Sequence[np.ndarray], weights: np.ndarray) -> list[np.ndarray]:
        """Slopes of the sum of weights (m, size) times results, one array per argument.

        Those of a shared argument are summed over the rows.
        """
        found = self._found(self._back, arguments, weights)
        parts = np.split(found, np.cumsum(self._sizes)[:-1], axis=1)
        own = len(parts) - self._shared
        return [*parts[:own], *(part.sum(axis=0) for part in parts[own:])]

    def push_forward(
        self, arguments: Sequence[np.ndarray], rates: Sequence[np.ndarray]
    ) -> np.ndarray:
        """Rates (m, size) for the rates of all arguments, shaped like them."""
        count = len(arguments[0])
        own = len(rates) - self._shared
        parts = [part.reshape(count, -1) for part in rates[:own]]
        parts += [np.broadcast_to(part, (count, len(part))) for part in rates[own:]]
        moved = np.concatenate(parts, axis=1)
        return self._found(self._along, arguments, moved)

    def _found(
        self, function: TapedFunction, arguments: Sequence[np.ndarray], *more: np.ndarray
    ) -> np.ndarray:
        """Results (m, ...) for the arguments and ``more`` of them, which are not shared."""
        own, count = len(arguments) - self._shared, len(arguments[0])
        rows = [values.reshape(count, -1) for values in arguments[:own]]
        given = [*rows, *arguments[own:], *more]
        if count > 1:
            (found,) = function.rows(given, count)
        else:  # a tape works through several rows at once
            single = [values.reshape(1, -1) for values in given]
            (found,) = evaluate_rows(function.casadi, single, function.sizes, 1)
        return found


def _as_is(result: SX) -> SX:
    return result


def _taped(arguments: Sequence[SX], result: SX) -> TapedFunction:
    function = ca.Function("rows", list(arguments), [result])
    return TapedFunction(TapeWithPatterns.of(function), lambda: function)
