"""The balances of one structure, taken apart into kinds of local terms.

    M dy/dt = sum over elements of kernel(v there, numbers there)

v holds the unknowns y, the drives (what time and the inlets alone determine), the time, the
coefficients of the inlets' pieces, and the number one. What is linear is a kind of its own.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence

import casadi as ca

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.elements.balances import BalanceLayout, Balances, Potential, Slope
from viscodesign.model.elements.expression_graph import ExpressionGraph, Role
from viscodesign.model.elements.kinds import LOCAL, Elements, Law, Term, term_of
from viscodesign.model.elements.splitting import summands

SX = ca.SX
LINEAR = Law(((LOCAL,),), 1, 0, None, 1)
"""A number times a variable."""
ONE = -1
"""In the place of a node: the number one."""


@dataclass(frozen=True)
class LocalForm:
    """Kinds of elements, and the numbers that they need."""

    balances: BalanceLayout
    drives: int
    kinds: tuple[Elements, ...]
    sources: tuple[Elements, ...]
    """Elements that give the drives: their rows are numbers of drives, their variables the
    time and the pieces."""
    numbers: ca.Function
    """parameters -> all numbers that elements read (m,)."""

    @property
    def size(self) -> int:
        """Number of unknowns, integrals included."""
        return len(self.balances.mass)

    @property
    def time(self) -> int:
        """Place of the time among the variables; pieces follow, then the number one."""
        return self.size + self.drives


def local_form(balances: Balances) -> LocalForm:
    """Take equations apart."""
    return _Taking(balances).form()


class _Taking:
    """One pass over the balances."""

    def __init__(self, balances: Balances) -> None:
        self.balances = balances
        self.graph = ExpressionGraph(balances.leaves)
        self.size = int(balances.leaves.unknowns.numel())
        self.kinds: dict[Law, Elements] = {}
        self.sources: dict[tuple[Law, int | None], Elements] = {}
        self.drives: dict[int, int] = {}
        self._formulas: list[SX] = []
        self._number_of: dict[int, int] = {}

    def form(self) -> LocalForm:
        given = self.balances
        self._take_rows(self.graph.add(given.rows))
        self._take_potentials(given.potentials)
        for node, drive in self.drives.items():
            self._take_drive(node, drive)
        moved = {node: self.size + k for node, k in self.drives.items()}
        for kinds, known in ((self.kinds, moved), (self.sources, {})):
            for kind in kinds.values():
                kind.variables = [
                    tuple(self._place(node, known) for node in own) for own in kind.variables
                ]
        formulas = ca.vertcat(*self._formulas) if self._formulas else SX(0, 1)
        return LocalForm(
            balances=given.layout(),
            drives=len(self.drives),
            kinds=tuple(self.kinds.values()),
            sources=tuple(self.sources.values()),
            numbers=ca.Function("numbers", [given.leaves.parameters], [ca.densify(formulas)]),
        )

    def _place(self, node: int, drives: Mapping[int, int]) -> int:
        """Place of a node among the variables."""
        if node in drives:
            return drives[node]
        after = self._time()
        if node == ONE:
            return after + 1 + int(self.balances.leaves.pieces.numel())
        leaf = self.graph.leaf_index[node]
        return leaf if leaf < self.size else after + leaf - self.size

    def _time(self) -> int:
        """Place of the time among the variables, once all drives are known."""
        return self.size + len(self.drives)

    # -- rows -------------------------------------------------------------------

    def _take_rows(self, roots: Sequence[int]) -> None:
        """Linear parts, and terms of their own; a term of several equations is one element."""
        targets: dict[int, list[tuple[int, SX]]] = {}
        for row, root in enumerate(roots):
            for part in summands(self.graph, root):
                if part.node is None or self._is_variable(part.node):
                    node = ONE if part.node is None else part.node
                    self._add(LINEAR, Term((), (node,), ()), [row], [part.factor])
                else:
                    targets.setdefault(part.node, []).append((row, part.factor))
        for node, own in targets.items():
            term = term_of(self.graph, node)
            law = Law(term.program, len(term.variables), len(term.numbers), None, len(own))
            self._add(law, term, [row for row, _ in own], [f for _, f in own])

    def _is_variable(self, node: int) -> bool:
        return self.graph.roles[node] == Role.DRIVE or not self.graph.operands[node]

    # -- potentials -------------------------------------------------------------

    def _take_potentials(self, potentials: Sequence[Potential]) -> None:
        """One element for each term, whatever equations its slopes go to."""
        # Two equal terms of one sum are two elements.
        slopes: dict[tuple[int, int], dict[int, Slope]] = {}
        for potential in potentials:
            count: Counter[int] = Counter()
            for root in self.graph.add(ca.vertcat(*potential.terms)) if potential.terms else ():
                known = slopes.setdefault((root, count[root]), {})
                assert not known.keys() & potential.slopes.keys()
                known.update(potential.slopes)
                count[root] += 1
        for (root, _), targets in slopes.items():
            term = term_of(self.graph, root)
            leaves = [self.graph.leaf_index.get(node, -1) for node in term.variables]
            which = [
                k
                for k, (node, leaf) in enumerate(zip(term.variables, leaves, strict=True))
                if self.graph.roles[node] == Role.UNKNOWN and leaf in targets
            ]
            if not which:
                continue
            own = [targets[leaves[k]] for k in which]
            law = Law(term.program, len(term.variables), len(term.numbers), tuple(which), len(own))
            self._add(law, term, [s.row for s in own], [s.factor for s in own])

    # -- drives -----------------------------------------------------------------

    def _take_drive(self, node: int, drive: int) -> None:
        term = term_of(self.graph, node, Role.PARAMETER)
        law = Law(term.program, len(term.variables), len(term.numbers), None, 1)
        places = [self._place(own, {}) for own in term.variables]
        time = places.index(self._time()) if self._time() in places else None
        kind = self.sources.setdefault((law, time), Elements(law, is_source=True, time=time))
        self._append(kind, term, [drive], [SX(1)])

    # -- elements ---------------------------------------------------------------

    def _add(self, law: Law, term: Term, rows: Sequence[int], factors: Sequence[SX]) -> None:
        if law not in self.kinds:
            self.kinds[law] = Elements(law)
        self._note_drives(term)
        self._append(self.kinds[law], term, rows, factors)

    def _append(
        self, kind: Elements, term: Term, rows: Sequence[int], factors: Sequence[SX]
    ) -> None:
        kind.variables.append(term.variables)
        numbers = [self._number(node) for node in term.numbers]
        kind.numbers.append((*numbers, *(self._new_number(factor) for factor in factors)))
        kind.rows.append(tuple(rows))

    def _note_drives(self, term: Term) -> None:
        for node in term.variables:
            if node != ONE and self.graph.roles[node] == Role.DRIVE:
                self.drives.setdefault(node, len(self.drives))

    def _number(self, node: int) -> int:
        if node not in self._number_of:
            self._number_of[node] = self._new_number(self.graph.formula(node))
        return self._number_of[node]

    def _new_number(self, formula: SX) -> int:
        self._formulas.append(formula)
        return len(self._formulas) - 1
