"""Numbers of a scene that may change: code written for numbers runs on them as it is.

A `Traced` number carries its value in the scene and its formula in the free numbers. Arithmetic
and elementary functions act on both, comparisons on the value. Whatever is decided by a value is
noted as a condition on the formulas: where it fails, the formulas no longer hold. Nothing turns a
traced number into a plain one, so a formula that needs one raises `TypeError` instead of losing
its derivative.
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Sequence
from typing import Any

import casadi as ca
import numpy as np

from viscodesign.compiled.conditions import Known, Tape
from viscodesign.scene.inputs.base import periods_to_cover

SX = ca.SX


class Traced:
    """A number with a formula."""

    __slots__ = ("formula", "tape", "value")
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, value: float, formula: SX, tape: Tape) -> None:
        self.value = value
        self.formula = formula
        self.tape = tape

    def __repr__(self) -> str:
        return repr(self.value)

    def __format__(self, spec: str) -> str:
        return format(self.value, spec)

    def __reduce_ex__(self, protocol: Any) -> Any:
        """Refuse to be copied: the key of a structure asks everything that formulas hold."""
        self.tape.constants.append(self.formula)
        raise TypeError("a traced number cannot be copied")

    # -- arithmetic -----------------------------------------------------------

    def _with(self, operation: Callable[..., Any], *numbers: Any) -> Any:
        """An operation on numbers of which this is one."""
        if not all(_is_number(number) for number in numbers):
            return NotImplemented
        value = operation(*(value_of(number) for number in numbers))
        return Traced(value, operation(*(formula_of(number) for number in numbers)), self.tape)

    def __add__(self, other: Any) -> Any:
        return self._with(operator.add, self, other)

    def __radd__(self, other: Any) -> Any:
        return self._with(operator.add, other, self)

    def __sub__(self, other: Any) -> Any:
        return self._with(operator.sub, self, other)

    def __rsub__(self, other: Any) -> Any:
        return self._with(operator.sub, other, self)

    def __mul__(self, other: Any) -> Any:
        return self._with(operator.mul, self, other)

    def __rmul__(self, other: Any) -> Any:
        return self._with(operator.mul, other, self)

    def __truediv__(self, other: Any) -> Any:
        return self._with(operator.truediv, self, other)

    def __rtruediv__(self, other: Any) -> Any:
        return self._with(operator.truediv, other, self)

    def __pow__(self, other: Any) -> Any:
        return self._with(operator.pow, self, other)

    def __rpow__(self, other: Any) -> Any:
        return self._with(operator.pow, other, self)

    def __neg__(self) -> Any:
        return self._with(operator.neg, self)

    def __pos__(self) -> Traced:
        return self

    def __abs__(self) -> Any:
        return self._function(abs, ca.fabs)

    # -- functions, as numpy calls them on objects ------------------------------

    def _function(self, of_number: Callable[[float], float], of_formula: Any) -> Traced:
        return Traced(float(of_number(self.value)), of_formula(self.formula), self.tape)

    def sqrt(self) -> Traced:
        """As `numpy.sqrt`; so are the others."""
        return self._function(math.sqrt, ca.sqrt)

    def exp(self) -> Traced:
        """Exponential."""
        return self._function(math.exp, ca.exp)

    def log(self) -> Traced:
        """Natural logarithm."""
        return self._function(math.log, ca.log)

    def sin(self) -> Traced:
        """Sine."""
        return self._function(math.sin, ca.sin)

    def cos(self) -> Traced:
        """Cosine."""
        return self._function(math.cos, ca.cos)

    def tan(self) -> Traced:
        """Tangent."""
        return self._function(math.tan, ca.tan)

    def tanh(self) -> Traced:
        """Hyperbolic tangent."""
        return self._function(math.tanh, ca.tanh)

    def arctan(self) -> Traced:
        """Inverse tangent."""
        return self._function(math.atan, ca.atan)

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        """The smaller and the larger of two numbers as formulas; all else number by number."""
        if method != "__call__":
            return NotImplemented
        chosen = _EXTREMES.get(ufunc)
        if chosen is not None and all(_is_number(number) for number in inputs):
            value = float(ufunc(*(value_of(number) for number in inputs)))
            return Traced(value, chosen(*(formula_of(n) for n in inputs)), self.tape)
        return ufunc(*(_boxed(given) for given in inputs), **options)

    # -- decisions --------------------------------------------------------------

    def __lt__(self, other: Any) -> bool:
        return self._ordered(operator.lt, other)

    def __le__(self, other: Any) -> bool:
        return self._ordered(operator.le, other)

    def __gt__(self, other: Any) -> bool:
        return self._ordered(operator.gt, other)

    def __ge__(self, other: Any) -> bool:
        return self._ordered(operator.ge, other)

    def __eq__(self, other: object) -> bool:
        return self._equals(other)

    def __ne__(self, other: object) -> bool:
        return not self._equals(other)

    def __bool__(self) -> bool:
        return not self._equals(0.0)

    def __floor__(self) -> int:
        found = math.floor(self.value)
        self.tape.note_order(known(found), known(self))
        self.tape.note_order(known(self), known(found + 1))
        return found

    def _ordered(self, compare: Callable[[float, float], bool], other: Any) -> bool:
        if isinstance(other, np.ndarray):
            return NotImplemented  # type: ignore[no-any-return]  # element by element
        self._refuse_formulas(other)
        found = compare(self.value, value_of(other))
        ends = known(self), known(other)
        is_less = found == (compare in (operator.lt, operator.le))
        self.tape.note_order(*(ends if is_less else ends[::-1]))
        return found

    def _equals(self, other: Any) -> bool:
        if isinstance(other, np.ndarray):
            return NotImplemented  # type: ignore[no-any-return]
        if not _is_number(other):
            self._refuse_formulas(other, isinstance(other, SX))
            return False
        found = bool(self.value == value_of(other))
        ends = known(self), known(other)
        if found:
            self.tape.note_equal(*ends)
        else:
            self.tape.note_order(*(ends if self.value < value_of(other) else ends[::-1]))
        return found

    @staticmethod
    def _refuse_formulas(other: Any, refused: bool | None = None) -> None:
        if refused if refused is not None else not _is_number(other):
            raise TypeError(f"a traced number cannot be compared with {type(other).__name__}")


_EXTREMES: dict[Any, Any] = {
    np.minimum: ca.fmin,
    np.maximum: ca.fmax,
    np.fmin: ca.fmin,
    np.fmax: ca.fmax,
}


@periods_to_cover.register
def _(ratio: Traced) -> int:
    """No condition: what is made of the periods is compared with the end of the run."""
    return periods_to_cover(ratio.value)


def free_numbers(
    names: Sequence[str], values: Sequence[float] | np.ndarray, tape: Tape
) -> tuple[SX, list[Traced]]:
    """Free numbers: their symbols (f,), and the same as traced numbers."""
    symbols = [SX.sym(name) for name in names]
    traced = [Traced(float(v), s, tape) for v, s in zip(values, symbols, strict=True)]
    return ca.vertcat(*symbols), traced


def _is_number(given: Any) -> bool:
    return isinstance(given, Traced | int | float | np.number)


def _boxed(given: Any) -> Any:
    """A traced number as an array of objects without axes."""
    if not isinstance(given, Traced):
        return given
    box = np.empty((), dtype=object)
    box[()] = given
    return box


def value_of(number: Any) -> float:
    """The value of a number, traced or not."""
    return number.value if isinstance(number, Traced) else float(number)


def formula_of(number: Any) -> SX:
    """The formula of a number, traced or not."""
    return number.formula if isinstance(number, Traced) else SX(float(number))


def known(number: Any) -> Known:
    """A number, traced or not, with its value and its formula."""
    if isinstance(number, Traced):
        return Known(number.value, number.formula)
    return Known(float(number))


def matrix_of(numbers: np.ndarray) -> SX:
    """The formulas of an array (n,) or (n, m) of numbers, traced or not."""
    rows = np.atleast_2d(numbers) if numbers.ndim == 2 else np.reshape(numbers, (-1, 1))
    if not rows.size:
        return SX(*rows.shape)
    return ca.vertcat(*(ca.horzcat(*(formula_of(number) for number in row)) for row in rows))
