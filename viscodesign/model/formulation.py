"""From sums to equations: a semi-explicit differential-algebraic system of index 1.

    dx/dt = ode(x, z, t),   0 = alg(x, z, t)

Every unknown is divided by its size, every algebraic equation by the size of its
terms, so that one tolerance means the same for all. Which unknowns exist depends on
the terms that effects have added:

===========================  ==============================================
kinetic energy               positions and velocities are states
  of turning edges           accelerations are algebraic as well
only dissipation             positions are states, velocities algebraic
only loads                   positions are algebraic (a static rod)
nothing                      the rod is a row of arcs; no rod unknowns at all
pressure drops along tubes   amounts of fluid are states, pressures algebraic
  not proportional to flow   flows are algebraic as well
  with inertance             flows are states as well
no pressure drops            one pressure per connected network
===========================  ==============================================
"""

from __future__ import annotations

from collections.abc import Hashable

import casadi as ca

from viscodesign.model.boundary_work import MotionRates, WorkSplit, works_and_splits
from viscodesign.model.contact_point import contact_friction, contact_paths
from viscodesign.model.elements.local_form import local_form
from viscodesign.model.equation_layout import EquationLayout
from viscodesign.model.equations import Equations, SharedFormulas
from viscodesign.model.fluid import Incompressible
from viscodesign.model.formula_store import FormulaStore
from viscodesign.model.formulas import Formulas
from viscodesign.model.local_balances import LocalFormulation
from viscodesign.model.local_equations import LocalEquations
from viscodesign.model.network_equations import NetworkEquations
from viscodesign.model.rod_equations import RodEquations
from viscodesign.model.structure import structure_of, without_numbers
from viscodesign.model.structure_digest import structure_digest
from viscodesign.model.sums import rows_of, whole
from viscodesign.model.system import System
from viscodesign.model.unknowns import Sizes, SizeSymbols, SymbolicUnknowns, column, substitute
from viscodesign.storage.lru_cache import ONE_AT_A_TIME, LruCache

SX = ca.SX


MAX_STRUCTURES = 16
"""Structures whose formulas are cached for the next scene of the same kind."""

_kept: LruCache[SharedFormulas] = LruCache(MAX_STRUCTURES)


def formulate(system: System, sizes: Sizes) -> Equations:
    """Turn a system's sums into equations.

    Derivatives and substitutions are made once for every structure and cached; a system
    that differs from an earlier one by its numbers alone reuses them.
    Raises `SpecError` where one pressure per network is asked for and two inlets
    feed the same network.
    """
    with ONE_AT_A_TIME:
        symbols = settle(system, sizes)
        key = structure_of(system)
        shared = _kept.get(key, lambda: _shared(key, without_numbers(system), symbols))
    return shared.with_numbers(system.parameters()[1])


def settle(system: System, sizes: Sizes) -> SizeSymbols:
    """Register every parameter that the equations of a system will have."""
    symbols = SizeSymbols(
        pressure=system.parameter("size.pressure", sizes.pressure),
        time=system.parameter("size.time", sizes.time),
        swing=system.parameter("size.swing", sizes.swing),
    )
    system.settle()
    return symbols


def _shared(key: Hashable, system: System, symbols: SizeSymbols) -> SharedFormulas:
    store = FormulaStore(structure_digest(key))
    return SharedFormulas(store, lambda: _Formulation(system, symbols).formulas())


class _Formulation:
    """One pass over a system; in one class since every step needs the same symbols."""

    def __init__(self, system: System, sizes: SizeSymbols) -> None:
        self.system = system
        self.sizes = sizes
        self.rod = RodEquations(system, sizes)
        self.network = NetworkEquations(system, sizes)
        self.states, self.algebraics, self.statics = (
            SymbolicUnknowns(),
            SymbolicUnknowns(),
            SymbolicUnknowns(),
        )
        for part in (self.network, self.rod):
            part.name_unknowns(self.states, self.algebraics, self.statics)
        self._rod_rows = self.rod.dynamics(self.rod.coupled)

    def _resolve(self, expressions: list[SX], unknowns: tuple[SymbolicUnknowns, ...]) -> list[SX]:
        """Replace flows, resultants, strains, shared pressures and unknowns, in this order."""
        explicit, amounts, *later = self.network.substitutions()
        steps = [explicit, amounts, self.rod.resultants(), self.rod.intrinsic_strains(), *later]
        steps += [list(zip(group.symbols, group.values, strict=True)) for group in unknowns]
        for step in steps:
            expressions = substitute(expressions, step)
        return expressions

    def _balances(self) -> tuple[list[SX], dict[str, SX], dict[str, SX], dict[str, WorkSplit]]:
        """(ode, alg), rates, outputs and splits of works, in the unknowns."""
        network, rod = self.network.dynamics(), self._rod_sides()
        rates = self.network.rates() | self.rod.rates()
        outputs = self.network.outputs(self.rod.conjugate_volumes()) | self.rod.outputs()
        sides = [column(network[side] + rod[side]) for side in (0, 1)]
        groups = (self.states, self.algebraics)
        resolved = self._resolve([*sides, *rates.values(), *outputs.values()], groups)
        count = 2 + len(rates)
        rates = dict(zip(rates, resolved[2:count], strict=True))
        outputs = dict(zip(outputs, resolved[count:], strict=True))
        x, z = self.states.vector, self.algebraics.vector
        motion = MotionRates(self.system.time, x, z, resolved[0])
        names = self.network.works() + self.rod.works()
        works, splits = works_and_splits(motion, outputs, names)
        rates = {name: rate for name, rate in (rates | works).items() if not rate.is_zero()}
        timed = {name for name, rate in rates.items() if not ca.depends_on(rate, ca.vertcat(x, z))}
        rates = dict(sorted(rates.items(), key=lambda item: item[0] in timed))
        return list(ca.cse(resolved[:2])), rates, outputs, splits

    def _rod_sides(self) -> tuple[list[SX], list[SX]]:
        """(ode, alg) of the rod as formulas."""
        ode, alg = self._rod_rows
        counts = (rows_of(block) for block in (*ode, *alg))
        formulas = [whole(block, n) for block, n in zip((*ode, *alg), counts, strict=True)]
        return formulas[: len(ode)], formulas[len(ode) :]

    def _quadratures(self, rates: dict[str, SX]) -> tuple[SX, SX]:
        """Rates over the size of an energy: those that depend on unknowns, those on time alone."""
        unknowns, size = ca.vertcat(self.states.vector, self.algebraics.vector), self._energy_size()
        scaled = [rate / size for rate in rates.values()]
        moving = [rate for rate in scaled if ca.depends_on(rate, unknowns)]
        return column(moving), column(scaled[len(moving) :])

    def _energy_size(self) -> SX:
        return self.network.energy_size() + self.rod.energy_size()

    def _statics(self) -> list[SX]:
        rod = self.system.rod
        defects = self.network.equilibrium() + self.rod.equilibrium()
        amounts = self.network.content.departures()
        found = self._resolve(
            [column(defects), amounts, rod.intrinsic_curvature, rod.intrinsic_stretch],
            (self.statics,),
        )
        return substitute(found, self.rod.without_contact())

    def _quantities(self) -> list[SX]:
        """Numbers that follow from the parameters alone."""
        content = self.network.content
        nodes = [*self.system.pressure, *content.storing]
        return [
            content.filled(),
            content.rest_amounts(nodes),
            content.filled_amounts(nodes),
            self.sizes.time,
            self.sizes.swing,
            self._energy_size(),
            *(
                size
                for group in (self.states, self.algebraics, self.statics)
                for size in group.sizes
            ),
        ]

    def formulas(self) -> Formulas:
        """Assemble and resolve."""
        (ode, alg), rates, outputs, splits = self._balances()
        quadrature, timed = self._quadratures(rates)
        static, *static_values = self._statics()
        system, network = self.system, self.network
        parameters, _ = system.parameters()
        tail = [
            system.time,
            system.pieces,
            system.load_factor,
            network.content.sealed_volumes,
            parameters,
        ]
        every = ca.vertcat(*tail[2:])
        return Formulas(
            layout=self._layout(rates, splits, quadrature.numel()),
            states=self.states,
            algebraics=self.algebraics,
            statics=self.statics,
            time=system.time,
            pieces=system.pieces,
            parameters=every,
            tail=tail,
            ode=ode,
            alg=alg,
            quadrature=quadrature,
            time_only_quadrature=timed,
            statics_rows=static,
            statics_values=static_values,
            outputs=outputs,
            contact_paths=self._resolve(
                [contact_paths(system.contacts)], (self.states, self.algebraics)
            )[0],
            contact_friction=contact_friction(system.contacts),
            quantities=self._quantities(),
            take_apart=lambda: self._take_apart(ode, quadrature, rates, every),
        )

    def _layout(
        self, rates: dict[str, SX], splits: dict[str, WorkSplit], integrals: int
    ) -> EquationLayout:
        content = self.network.content
        return EquationLayout(
            rod_form=self.rod.form,
            network_form=self.network.form,
            states=self.states.without_symbols(),
            algebraics=self.algebraics.without_symbols(),
            statics=self.statics.without_symbols(),
            rates=tuple(rates),
            integrals=integrals,
            work_splits=splits,
            fed=content.fed,
            driven=tuple(content.driven),
            sealed=content.sealed,
            storing=tuple(self.network.storing),
            incompressible=isinstance(self.system.fluid, Incompressible),
            contacts=tuple(point.name for point in self.system.contacts),
        )

    def _take_apart(
        self, ode: SX, quadrature: SX, rates: dict[str, SX], parameters: SX
    ) -> LocalEquations | None:
        """The equations as sums of local terms."""
        system = self.system
        if system.contacts:
            return None  # solved by a part of its own, which needs none
        local = LocalFormulation(system, self.network, self.rod, self.states, self.algebraics)
        moving = list(rates)[: quadrature.numel()]
        size = self._energy_size()
        balances = local.balances(system.time, system.pieces, parameters, moving, size)
        if balances is None:
            return None
        sums = self._resolve([local.start(ode, self.sizes.time)], (self.states, self.algebraics))
        x, z = self.states.vector, self.algebraics.vector
        start = ca.Function("sums", [x, z, system.time, system.pieces, parameters], sums)
        return LocalEquations(local_form(balances), start)
