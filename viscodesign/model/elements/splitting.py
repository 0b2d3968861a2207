"""Formulas as sums: constant parts, linear parts, and terms that are neither."""

from __future__ import annotations

import casadi as ca

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.elements.expression_graph import ExpressionGraph, Role

SX = ca.SX


@dataclass(frozen=True)
class Summand:
    """One part of a sum: a factor that parameters determine, times a node."""

    factor: SX
    node: int | None
    """None for the number one."""


def summands(graph: ExpressionGraph, root: int) -> list[Summand]:
    """The sum that a formula is, taken apart at additions and at factors of parameters alone."""
    found: list[Summand] = []
    waiting: list[tuple[int, SX]] = [(root, SX(1))]
    while waiting:
        node, factor = waiting.pop()
        role, operation = graph.roles[node], graph.operation[node]
        own = graph.operands[node]
        if role <= Role.PARAMETER:
            if graph.constants.get(node) != 0.0:
                found.append(Summand(factor * graph.formula(node), None))
        elif role == Role.DRIVE or not own:
            found.append(Summand(factor, node))
        elif operation == ca.OP_ADD:
            waiting += [(own[0], factor), (own[1], factor)]
        elif operation == ca.OP_SUB:
            waiting += [(own[0], factor), (own[1], -factor)]
        elif operation == ca.OP_NEG:
            waiting.append((own[0], -factor))
        elif operation == ca.OP_TWICE:
            waiting.append((own[0], 2 * factor))
        elif operation == ca.OP_MUL and min(graph.roles[i] for i in own) <= Role.PARAMETER:
            fixed, moving = sorted(own, key=lambda i: graph.roles[i])
            waiting.append((moving, factor * graph.formula(fixed)))
        elif operation == ca.OP_DIV and graph.roles[own[1]] <= Role.PARAMETER:
            waiting.append((own[0], factor / graph.formula(own[1])))
        else:
            found.append(Summand(factor, node))
    return found
