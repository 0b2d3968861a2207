"""Formulas as one graph in which equal subexpressions are one node.

CasADi shares a subexpression only where the same object was used twice. Here two nodes with
the same operation on the same operands are one, and every node knows what it depends on, so
that whatever does not change within a run can be computed once.
"""

from __future__ import annotations

from collections.abc import Sequence
from enum import IntEnum

import casadi as ca

from viscodesign.lazy_dataclass import dataclass
from viscodesign.native.instructions import TWO_OPERANDS, instructions

SX = ca.SX


class Role(IntEnum):
    """What a node depends on, at most."""

    CONSTANT = 0
    PARAMETER = 1
    DRIVE = 2
    """Time, and the coefficients of the inlets' pieces."""
    UNKNOWN = 3


LEAF, CONSTANT = -1, -2
"""Operations of nodes without operands; all others are CasADi's."""


@dataclass(frozen=True)
class Leaves:
    """The symbols that formulas may contain, each a column."""

    unknowns: SX
    time: SX
    pieces: SX
    parameters: SX

    @property
    def groups(self) -> list[SX]:
        """All of them, in the order in which they are numbered."""
        return [self.unknowns, self.time, self.pieces, self.parameters]


ROLES = (Role.UNKNOWN, Role.DRIVE, Role.DRIVE, Role.PARAMETER)
"""Roles of the groups of `Leaves`."""


class ExpressionGraph:
    """Nodes of formulas over `Leaves`; operands always have smaller numbers than their node."""

    def __init__(self, leaves: Leaves) -> None:
        self.leaves = leaves
        self.operation: list[int] = []
        self.operands: list[tuple[int, ...]] = []
        self.roles: list[Role] = []
        self.constants: dict[int, float] = {}
        self.leaf_index: dict[int, int] = {}
        """Place of a leaf among all unknowns, times and pieces (or among the parameters)."""
        self._numbers: dict[tuple[int, tuple[float, ...]], int] = {}
        self._formulas: dict[int, SX] = {}
        self._leaf_nodes = [self._add_leaves(k) for k in range(len(ROLES))]

    def _add_leaves(self, group: int) -> list[int]:
        before = [0, self.leaves.unknowns.numel(), self.leaves.unknowns.numel() + 1, 0]
        nodes = []
        for k, symbol in enumerate(ca.vertsplit(self.leaves.groups[group])):
            node = self._node(LEAF, (group, k), (), ROLES[group])
            self._formulas[node] = symbol
            self.leaf_index[node] = before[group] + k
            nodes.append(node)
        return nodes

    def _node(
        self, operation: int, key: tuple[float, ...], operands: tuple[int, ...], role: Role
    ) -> int:
        known = self._numbers.setdefault((operation, key), len(self.operation))
        if known == len(self.operation):
            self.operation.append(operation)
            self.operands.append(operands)
            self.roles.append(role)
        return known

    def add(self, expressions: SX) -> list[int]:
        """Nodes of a column of formulas; they contain no symbol but those of `Leaves`."""
        function = ca.Function(
            "formulas", self.leaves.groups, [ca.densify(expressions)], {"live_variables": False}
        )
        slots: dict[int, int] = {}
        roots = [-1] * expressions.numel()
        roles = self.roles
        for k, (operation, place, x, y) in enumerate(instructions(function).tolist()):
            if operation == ca.OP_OUTPUT:
                roots[y] = slots[x]
            elif operation == ca.OP_INPUT:
                slots[place] = self._leaf_nodes[x][y]
            elif operation == ca.OP_CONST:
                slots[place] = self._constant(function.instruction_constant(k))
            elif operation == ca.OP_ASSIGN:
                slots[place] = slots[x]
            elif operation in TWO_OPERANDS:
                own = slots[x], slots[y]
                slots[place] = self._node(operation, own, own, max(roles[own[0]], roles[own[1]]))
            else:
                one = slots[x]
                slots[place] = self._node(operation, (one,), (one,), roles[one])
        return roots

    def _constant(self, value: float) -> int:
        node = self._node(CONSTANT, (value,), (), Role.CONSTANT)
        self.constants[node] = value
        self._formulas[node] = SX(value)
        return node

    def formula(self, node: int) -> SX:
        """A node as a formula of the symbols."""
        known = self._formulas
        waiting = [node]
        while waiting:
            last = waiting[-1]
            if last in known:
                waiting.pop()
                continue
            missing = [i for i in self.operands[last] if i not in known]
            if missing:
                waiting += missing
                continue
            known[last] = apply(self.operation[last], [known[i] for i in self.operands[last]])
            waiting.pop()
        return known[node]


def apply(operation: int, operands: Sequence[SX]) -> SX:
    """One of CasADi's scalar operations on one or two formulas."""
    if len(operands) == 1:
        return SX.unary(operation, operands[0])
    return SX.binary(operation, operands[0], operands[1])
