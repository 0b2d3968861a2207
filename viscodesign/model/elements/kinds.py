"""Kinds of local terms: terms whose formulas differ by the symbols alone share one kernel."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.elements.expression_graph import ExpressionGraph, Role, apply
from viscodesign.storage.lru_cache import LruCache

SX = ca.SX

LOCAL, NUMBER, LITERAL = -1, -2, -3
"""Instructions that read a local variable, a number of the scene, a constant of the law."""
POWERS = (ca.OP_POW, ca.OP_CONSTPOW)
Program = tuple[tuple[float, ...], ...]
"""Instructions of a formula; an operand is the place of an earlier instruction."""
MAX_KINDS = 512
"""Kernels that are kept for other scenes."""


@dataclass(frozen=True)
class Term:
    """One formula, written so that equal laws give equal programs."""

    program: Program
    variables: tuple[int, ...]
    """Nodes of the local variables, in the order in which the program reads them."""
    numbers: tuple[int, ...]
    """Nodes that parameters determine, likewise."""


def term_of(graph: ExpressionGraph, root: int, given: Role = Role.DRIVE) -> Term:
    """A node's formula over its local variables: leaves, and what is no more than ``given``.

    What parameters alone determine is a number.
    """
    places: dict[int, int] = {}
    program: list[tuple[float, ...]] = []
    variables: list[int] = []
    numbers: list[int] = []
    waiting = [root]
    while waiting:
        node = waiting[-1]
        if node in places:
            waiting.pop()
            continue
        own, role = graph.operands[node], graph.roles[node]
        if role <= Role.PARAMETER:
            numbers.append(node)
            instruction: tuple[float, ...] = (NUMBER,)
        elif role <= given or not own:
            variables.append(node)
            instruction = (LOCAL,)
        else:
            missing = [i for i in own if i not in places]
            if graph.operation[node] in POWERS and own[1] in graph.constants:
                # An exponent belongs to the law: its derivative would need a logarithm.
                missing = [i for i in missing if i != own[1]]
                if not missing:
                    program.append((LITERAL, graph.constants[own[1]]))
                    instruction = (graph.operation[node], places[own[0]], len(program) - 1)
            else:
                instruction = (graph.operation[node], *(places.get(i, -1) for i in own))
            if missing:
                waiting += missing[::-1]
                continue
        places[node] = len(program)
        program.append(instruction)
        waiting.pop()
    return Term(tuple(program), tuple(variables), tuple(numbers))


@dataclass(frozen=True)
class Law:
    """What a kernel computes: everything that its code depends on."""

    program: Program
    variables: int
    numbers: int
    slopes: tuple[int, ...] | None
    """Local variables by which the formula is differentiated, one result each; None: its value."""
    results: int
    """Each is multiplied by a number of its own, which follow the formula's numbers."""


@dataclass(frozen=True)
class Slopes:
    """Derivatives of a law's results by its local variables."""

    function: ca.Function
    """The same arguments -> entries that are not zero by structure (z,)."""
    pattern: np.ndarray
    """(2, z): result and local variable of every entry."""


_values: LruCache[ca.Function] = LruCache(MAX_KINDS)
_slopes: LruCache[Slopes] = LruCache(MAX_KINDS)


def value_of(law: Law) -> ca.Function:
    """(local variables (v,), numbers (m + r,)) -> results (r,), made once."""
    return _values.get(law, lambda: _value(law))


def slopes_of(law: Law) -> Slopes:
    """Their derivatives, made once."""
    return _slopes.get(law, lambda: _slopes_of_all(law))


def rate_of(law: Law, variable: int | None) -> ca.Function:
    """The same arguments -> slopes (r,) by one variable, such as the time; zero for None."""
    local, numbers, results = _results(law)
    slope = SX.zeros(law.results) if variable is None else ca.jacobian(results, local[variable])
    return ca.Function("rate", [local, numbers], [ca.densify(slope)])


def pull_of(function: ca.Function) -> ca.Function:
    """(arguments and weights of the results (v + r,), numbers (m,)) -> slopes (v + m,).

    Those of the weighted sum of the results of a function (v,), (m,) -> (r,).
    """
    local, numbers, values = _symbolic(function)
    weights = SX.sym("weights", values.numel())
    slopes = ca.gradient(ca.dot(weights, values), ca.vertcat(local, numbers))
    return ca.Function("pull", [ca.vertcat(local, weights), numbers], [ca.cse(ca.densify(slopes))])


def push_of(function: ca.Function) -> ca.Function:
    """(arguments and rates of arguments and numbers (v + v + m,), numbers) -> rates (r,)."""
    local, numbers, values = _symbolic(function)
    moved = ca.vertcat(local, numbers)
    rates = SX.sym("rates", moved.numel())
    found = ca.jtimes(values, moved, rates)
    return ca.Function("push", [ca.vertcat(local, rates), numbers], [ca.cse(ca.densify(found))])


def _symbolic(function: ca.Function) -> tuple[SX, SX, SX]:
    """Arguments, numbers and results of a function as symbols and formulas."""
    local = SX.sym("local", function.numel_in(0))
    numbers = SX.sym("numbers", function.numel_in(1))
    (values,) = function.call([local, numbers])
    return local, numbers, values


def _value(law: Law) -> ca.Function:
    local, numbers, results = _results(law)
    return ca.Function("value", [local, numbers], [ca.cse(results)])


def _slopes_of_all(law: Law) -> Slopes:
    local, numbers, results = _results(law)
    slopes = ca.jacobian(results, local)
    rows, columns = slopes.sparsity().get_triplet()
    entries = ca.vec(ca.densify(slopes.nz[:])) if slopes.nnz() else SX(0, 1)
    function = ca.Function("slopes", [local, numbers], [ca.cse(entries)])
    return Slopes(function, np.array([rows, columns], dtype=np.int64).reshape(2, -1))


def _results(law: Law) -> tuple[SX, SX, SX]:
    """Symbols of local variables and numbers, and the results."""
    local = SX.sym("local", law.variables)
    numbers = SX.sym("numbers", law.numbers + law.results)
    formula = _run(law.program, ca.vertsplit(local), ca.vertsplit(numbers[: law.numbers]))
    if law.slopes is None:
        values = ca.repmat(formula, law.results, 1)
    else:
        values = ca.gradient(formula, local)[list(law.slopes)]
    return local, numbers, ca.densify(values * numbers[law.numbers :])


def _run(program: Program, variables: Sequence[SX], numbers: Sequence[SX]) -> SX:
    left, given = iter(variables), iter(numbers)
    found: list[SX] = []
    for operation, *operands in program:
        if operation == LOCAL:
            found.append(next(left))
        elif operation == NUMBER:
            found.append(next(given))
        elif operation == LITERAL:
            found.append(SX(operands[0]))
        else:
            found.append(apply(int(operation), [found[int(k)] for k in operands]))
    return found[-1]


@dataclass
class Elements:
    """All terms of one kind."""

    law: Law
    variables: list[tuple[int, ...]] = field(default_factory=list)
    """Places of every element's variables among those of the whole model."""
    numbers: list[tuple[int, ...]] = field(default_factory=list)
    """Places of every element's numbers among those of the scene."""
    rows: list[tuple[int, ...]] = field(default_factory=list)
    """Equations that every element's results add to."""
    is_source: bool = False
    """Whether they give drives instead of adding to equations."""
    time: int | None = None
    """Which of the variables of a source is the time."""
