"""The equations in a form whose terms are local: what sums over many parts is an unknown.

The strains and resultants of the sections, and where terms depend on them the amounts of fluid
and the accelerations, stay unknowns with an equation each instead of being replaced by what they
are.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

import casadi as ca
import numpy as np

from viscodesign.model.boundary_work import FORCE_AND_PATH, MotionRates, works_and_splits
from viscodesign.model.elements.balances import Balances, Potential, Slope
from viscodesign.model.elements.expression_graph import Leaves
from viscodesign.model.network_equations import NetworkEquations
from viscodesign.model.rod_equations import ACCELERATIONS, RATES, RodEquations, RodForm
from viscodesign.model.sums import GradientRows, Rows, rows_of
from viscodesign.model.system import System
from viscodesign.model.unknowns import SymbolicUnknowns, column, substitute

SX = ca.SX
Block = list[Rows]


class LocalFormulation:
    """One pass over a system, whose unknowns are those of its formulas and sums besides."""

    def __init__(
        self,
        system: System,
        network: NetworkEquations,
        rod: RodEquations,
        states: SymbolicUnknowns,
        algebraics: SymbolicUnknowns,
    ) -> None:
        self.system, self.network, self.rod = system, network, rod
        self.states, self.algebraics = states, algebraics
        self.sums = SymbolicUnknowns()
        """Unknowns that the formulas do not have."""
        bends = rod.form is not RodForm.ARCS
        amounts = column(list(system.amount.values()))
        energies = system.kinetic_energy.total + system.load_potential.total
        self._keeps_amounts = bends and ca.depends_on(energies, amounts)
        weighs = rod.form is RodForm.DYNAMIC and not rod.coupled and self._keeps_amounts
        ode, alg = rod.dynamics(rod.coupled or weighs)
        own: list[Block] = []
        if weighs:
            size = rod.rod.coordinate_size / rod.sizes.time**2
            self.sums.add(ACCELERATIONS, rod.acceleration, size)
            own.append(alg.pop())
        sums = rod.intermediates()
        if self._keeps_amounts:
            stored = column([system.stored(name) for name in system.amount])
            sums.append((amounts, stored, network.volume_size()))
        for k, (symbol, rows, size) in enumerate(sums):
            self.sums.add(f"sum_{k}", symbol, size)
            own.append([_divided(rows, size), -symbol / size])
        network_ode, network_alg = (_as_blocks(side) for side in network.dynamics())
        self._blocks: list[Block] = [*network_ode, *ode, *network_alg, *alg, *own]

    def balances(
        self, time: SX, pieces: SX, parameters: SX, rates: Sequence[str], energy_size: SX
    ) -> Balances | None:
        """All equations, with those of the integrals of ``rates`` at their end.

        ``rates``: names of powers, which are integrated over ``energy_size``. None where one of
        them is not local.
        """
        groups = (self.states, self.algebraics, self.sums)
        plain = [_plain(block) for block in self._blocks]
        gradients = list(self._gradients())
        terms = [column(list(part.terms)) for _, part in gradients]
        outputs = self.network.outputs(self.rod.conjugate_volumes())
        works = self.network.works()
        used = dict.fromkeys(itertools.chain(*(FORCE_AND_PATH[name] for name in works)))
        known = self.network.rates() | self.rod.rates()
        found = iter(
            self._resolve([*plain, *terms, *known.values(), *(outputs[n] for n in used)], groups)
        )
        rows = column([next(found) for _ in plain])
        terms = [next(found) for _ in terms]
        known = {name: next(found) for name in known}
        paths = dict(zip(used, found, strict=True))
        z = ca.vertcat(self.algebraics.vector, self.sums.vector)
        hidden, ode = SX.sym("hidden"), ca.vec(rows[: self.states.count])
        for first, part in gradients:
            for k in range(first, min(first + part.variables.numel(), self.states.count)):
                ode[k] = hidden
        motion = MotionRates(time, self.states.vector, z, ode)
        known |= works_and_splits(motion, paths, works)[0]
        integrals = column([known[name] / energy_size for name in rates])
        if ca.depends_on(integrals, hidden):
            return None
        count = int(integrals.numel())
        unknowns = ca.vertcat(*(g.vector for g in groups), SX.sym("integrals", count))
        return Balances(
            leaves=Leaves(unknowns, time, pieces, parameters),
            rows=ca.vertcat(rows, integrals),
            potentials=list(self._potentials(gradients, terms)),
            mass=np.concatenate([np.ones(self.states.count), np.zeros(z.numel()), np.ones(count)]),
            weak=self._weak(int(unknowns.numel())),
            states=self.states.count,
            algebraics=self.algebraics.count,
            integrals=count,
        )

    def _weak(self, size: int) -> np.ndarray:
        """Positions of a rod without inertia: along a straight axis only its strain holds them."""
        found = np.zeros(size, dtype=bool)
        span = self.algebraics.branch_span
        if span is not None:
            found[self.states.count :][span] = True
        return found

    def start(self, ode: SX, motion_time: SX) -> SX:
        """Scaled sums as formulas that are not resolved; ``ode``: resolved rates of the states."""
        values: list[SX] = []
        sums = self.sums
        for name, symbol, size in zip(sums.blocks, sums.symbols, sums.sizes, strict=True):
            if name == ACCELERATIONS:
                values.append(ode[self.states.blocks[RATES].span] * motion_time)
            else:
                values.append(symbol / size)
        return column(values)

    def _gradients(self) -> Iterator[tuple[int, GradientRows]]:
        """First row and contents of every contribution that is a gradient."""
        first = 0
        for block in self._blocks:
            yield from ((first, part) for part in block if isinstance(part, GradientRows))
            first += rows_of(block)

    def _resolve(self, formulas: list[SX], groups: Sequence[SymbolicUnknowns]) -> list[SX]:
        explicit, amounts, *later = self.network.substitutions()
        steps = [explicit]
        if not self._keeps_amounts:
            steps.append(amounts)
        if self.rod.form is RodForm.ARCS:
            steps += [self.rod.resultants(), self.rod.intrinsic_strains()]
        else:
            steps.append(self.rod.intrinsic_strains()[2:])
        steps += later
        steps += [list(zip(group.symbols, group.values, strict=True)) for group in groups]
        for step in steps:
            formulas = substitute(formulas, step)
        return formulas

    def _potentials(
        self, gradients: Sequence[tuple[int, GradientRows]], terms: Sequence[SX]
    ) -> Iterator[Potential]:
        places = self._places()
        for (first, part), own in zip(gradients, terms, strict=True):
            variables = ca.vertsplit(part.variables)
            factors = ca.vertsplit(_as_many(part.factors, len(variables)))
            slopes = {}
            for k, (variable, factor) in enumerate(zip(variables, factors, strict=True)):
                unknown, size = places[variable.element_hash()]
                slopes[unknown] = Slope(first + k, factor / size)
            yield Potential(ca.vertsplit(own) if own.numel() else [], slopes)

    def _places(self) -> dict[int, tuple[int, SX]]:
        """Number and size of every unknown, by the hash of its symbol."""
        found: dict[int, tuple[int, SX]] = {}
        for group in (self.states, self.algebraics, self.sums):
            for symbol, size in zip(group.symbols, group.sizes, strict=True):
                each = ca.vertsplit(_as_many(size, symbol.numel()))
                for one, own in zip(ca.vertsplit(symbol), each, strict=True):
                    found[one.element_hash()] = len(found), own
        return found


def _as_blocks(rows: Sequence[SX]) -> list[Block]:
    return [[SX(part)] for part in rows]


def _plain(block: Block) -> SX:
    """What is not a gradient in a block of rows."""
    parts = [part for part in block if not isinstance(part, GradientRows)]
    return sum(parts, SX.zeros(rows_of(block)))


def _divided(rows: Rows, size: SX) -> Rows:
    if isinstance(rows, GradientRows):
        return GradientRows(rows.terms, rows.variables, rows.factors / size)
    return rows / size


def _as_many(values: SX, count: int) -> SX:
    """One value for all, or one for each (count,)."""
    return values if values.numel() == count else ca.repmat(values, count, 1)
