"""Formulas of the physics in symbols: each traced once, and then applied by one call.

An operation between symbols costs far more from Python than inside CasADi, and a network has the
same formulas at every tube and node.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import casadi as ca

SX = ca.SX


def traced(formula: Callable[..., Any], *arguments: SX | float) -> SX:
    """What ``formula(*arguments, functions=casadi)`` gives, operation by operation.

    ``formula`` depends on its arguments alone; those that are numbers are folded into it.
    """
    given = tuple(a.shape if isinstance(a, SX) else float(a) for a in arguments)
    function = _function(formula, given)
    (result,) = function.call([a for a in arguments if isinstance(a, SX)])
    return result


@cache
def _function(
    formula: Callable[..., Any], given: tuple[tuple[int, int] | float, ...]
) -> ca.Function:
    """With a symbol for every argument of which a shape is given, in place of a number."""
    arguments = [SX.sym("a", *a) if isinstance(a, tuple) else a for a in given]
    symbols = [a for a in arguments if isinstance(a, SX)]
    return ca.Function("traced", symbols, [formula(*arguments, functions=ca)])
