"""From sums to equations: a semi-explicit differential-algebraic system of index 1.

    dx/dt = ode(x, z, t),   0 = alg(x, z, t)

Every unknown is divided by its size, every algebraic equation by the size of its
terms, so that one tolerance means the same for all. Which unknowns exist follows
from what the effects added:

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

from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass, fields
from typing import Concatenate, ParamSpec

import casadi as ca
import numpy as np

from viscodesign.model.boundary_work import Clock, Way, rates_and_ways
from viscodesign.model.fluid import Incompressible
from viscodesign.model.graph import Component
from viscodesign.model.jacobian import jacobian
from viscodesign.model.lru_cache import ONE_AT_A_TIME, LruCache
from viscodesign.model.network_equations import NetworkEquations, NetworkForm
from viscodesign.model.rod_equations import RodEquations, RodForm
from viscodesign.model.structure import structure_of, without_numbers
from viscodesign.model.system import System
from viscodesign.model.unknowns import Sizes, SizeSymbols, Unknowns, column, substitute

SX = ca.SX
P = ParamSpec("P")


MOST_KEPT = 16
"""Structures whose formulas are kept for the next scene of the same kind."""
NUMBERS = 6
"""Of what follows from the parameters alone, before the sizes of the unknowns."""
MOST_COMPILED = 12
"""Compiled functions that are kept with each."""


@dataclass(frozen=True)
class Formulas:
    """The equations of one structure: symbols alone, good for every scene of its kind."""

    rod_form: RodForm
    network_form: NetworkForm
    states: Unknowns
    algebraics: Unknowns
    statics: Unknowns
    """Unknowns of the equilibrium: pressures, flows that are not formulas, the rod's shape."""
    time: SX
    pieces: SX
    parameters: SX
    ode: SX
    alg: SX
    rates: dict[str, SX]
    """Powers whose integrals the balances need [W]; those of time alone stand last."""
    quadrature: SX
    """The first of them, over the size of an energy: what an integrator integrates."""
    timed_quadrature: SX
    """The rest, which are formulas of the time."""
    ways: dict[str, Way]
    """How works of forces along paths are integrated, by name."""
    function: ca.Function
    """(x, z, t, pieces, load_factor, sealed_volumes, parameters) -> (ode, alg)."""
    static_function: ca.Function
    """(y, t, pieces, load_factor, sealed_volumes, parameters) -> (residual, Jacobian,
    amounts beyond rest, intrinsic curvatures, intrinsic stretches)."""
    algebraic_function: ca.Function
    """Like `function`, returning (alg, d alg/d z)."""
    output_function: ca.Function
    """(x, z, t, pieces, load_factor, sealed_volumes, parameters) -> named outputs."""
    quantity_function: ca.Function
    """parameters -> (sealed_volumes, rest_amounts, filled_amounts, motion time, swing time,
    energy size, and the sizes of all blocks of states, algebraics and statics)."""
    fed: tuple[Component, ...]
    driven: tuple[str, ...]
    """Inlets whose pressure is given, in the order of the state `inflow`."""
    sealed: tuple[Component, ...]
    storing: tuple[str, ...]
    """Nodes besides the bellows that hold fluid."""
    incompressible: bool
    """Whether an amount in a bellow is its volume."""
    _compiled: LruCache[ca.Function]

    def compiled(
        self, make: Callable[Concatenate[Formulas, P], ca.Function], *args: P.args, **_: P.kwargs
    ) -> ca.Function:
        """What a function makes of these formulas and hashable arguments, made once.

        It gets the symbols alone and no scene's numbers, and its result is shared by scenes and
        threads: it must have no state, as integrators have.
        """
        return self._compiled.get((make, args), lambda: make(self._symbolic, *args))  # type: ignore[call-arg]

    def lent(
        self, make: Callable[Concatenate[Formulas, P], ca.Function], *args: P.args, **_: P.kwargs
    ) -> AbstractContextManager[ca.Function]:
        """The same for what has a state: nobody else has it inside of the context."""
        return self._compiled.lend((make, args), lambda: make(self._symbolic, *args))  # type: ignore[call-arg]

    @property
    def _symbolic(self) -> Formulas:
        return self

    def with_numbers(self, values: np.ndarray) -> Equations:
        """The equations of a scene with these parameter values."""
        found = [np.array(v, dtype=float).ravel() for v in self.quantity_function.call([values])]
        sealed, rest, filled, motion, swing, energy = found[:NUMBERS]
        groups = [self.states, self.algebraics, self.statics]
        ends = NUMBERS + np.cumsum([0, *(len(group.blocks) for group in groups)])
        sized = [g.sized(found[i:j]) for g, i, j in zip(groups, ends, ends[1:], strict=False)]
        own = {f.name: getattr(self, f.name) for f in fields(self)}
        names = ("states", "algebraics", "statics")
        return Equations(
            **{**own, **dict(zip(names, sized, strict=True))},
            formulas=self,
            parameter_values=values,
            sealed_volumes=sealed,
            rest_amounts=rest,
            filled_amounts=filled,
            swing_time=float(swing[0]),
            motion_time=float(motion[0]),
            energy_size=float(energy[0]),
        )


@dataclass(frozen=True)
class Equations(Formulas):
    """Formulas with the numbers of one scene: everything that a solver needs to know."""

    formulas: Formulas
    """The same without numbers."""
    parameter_values: np.ndarray
    sealed_volumes: np.ndarray
    """What each sealed part was filled with [m3 at ambient density]."""
    rest_amounts: np.ndarray
    """What bellows and storing nodes hold at zero gauge [m3]."""
    filled_amounts: np.ndarray
    """The same at the baseline, with nothing loading and no plunger pushed in."""
    swing_time: float
    """Time in which the inlets may change by all of their pressure [s]."""
    motion_time: float
    """Time in which the rod moves by itself: the size of its velocities is length over it [s]."""
    energy_size: float
    """By which energies are divided in `quadrature` [J]."""

    @property
    def _symbolic(self) -> Formulas:
        return self.formulas


_kept: LruCache[Formulas] = LruCache(MOST_KEPT)


def formulate(system: System, sizes: Sizes) -> Equations:
    """Turn a system's sums into equations.

    Derivatives and substitutions are made once for every structure and kept; a system
    that differs from an earlier one by its numbers alone takes them over.
    Raises `SpecError` where one pressure per network is asked for and two inlets
    feed the same network.
    """
    symbols = SizeSymbols(
        pressure=system.parameter("size.pressure", sizes.pressure),
        time=system.parameter("size.time", sizes.time),
        swing=system.parameter("size.swing", sizes.swing),
    )
    with ONE_AT_A_TIME:
        system.settle()
        key = structure_of(system)
        formulas = _kept.get(key, lambda: _Formulation(without_numbers(system), symbols).formulas())
    return formulas.with_numbers(system.parameters()[1])


class _Formulation:
    """One pass over a system; kept together because every step needs the same symbols."""

    def __init__(self, system: System, sizes: SizeSymbols) -> None:
        self.system = system
        self.sizes = sizes
        self.rod = RodEquations(system, sizes)
        self.network = NetworkEquations(system, sizes)
        self.states, self.algebraics, self.statics = Unknowns(), Unknowns(), Unknowns()
        for part in (self.network, self.rod):
            part.name_unknowns(self.states, self.algebraics, self.statics)

    def _resolve(self, expressions: list[SX], unknowns: tuple[Unknowns, ...]) -> list[SX]:
        """Replace flows, resultants, strains, shared pressures and unknowns, in this order."""
        explicit, amounts, *later = self.network.substitutions()
        steps = [explicit, amounts, self.rod.resultants(), self.rod.intrinsic_strains(), *later]
        steps += [list(zip(group.symbols, group.values, strict=True)) for group in unknowns]
        for step in steps:
            expressions = substitute(expressions, step)
        return expressions

    def _balances(self) -> tuple[list[SX], dict[str, SX], dict[str, SX], dict[str, Way]]:
        """(ode, alg), rates, outputs and ways of works, in the unknowns."""
        network, rod = self.network.dynamics(), self.rod.dynamics()
        rates = self.network.rates() | self.rod.rates()
        outputs = self.network.outputs(self.rod.conjugate_volumes()) | self.rod.outputs()
        sides = [column(network[side] + rod[side]) for side in (0, 1)]
        groups = (self.states, self.algebraics)
        resolved = self._resolve([*sides, *rates.values(), *outputs.values()], groups)
        count = 2 + len(rates)
        rates = dict(zip(rates, resolved[2:count], strict=True))
        outputs = dict(zip(outputs, resolved[count:], strict=True))
        x, z = self.states.vector, self.algebraics.vector
        clock = Clock(self.system.time, x, z, resolved[0])
        works, ways = rates_and_ways(clock, outputs, self.network.works())
        rates = {name: rate for name, rate in (rates | works).items() if not rate.is_zero()}
        timed = {name for name, rate in rates.items() if not ca.depends_on(rate, ca.vertcat(x, z))}
        rates = dict(sorted(rates.items(), key=lambda item: item[0] in timed))
        return list(ca.cse(resolved[:2])), rates, outputs, ways

    def _quadratures(self, rates: dict[str, SX]) -> tuple[SX, SX]:
        """Rates over the size of an energy: that depend on unknowns, and on time alone."""
        unknowns, size = ca.vertcat(self.states.vector, self.algebraics.vector), self._energy_size()
        scaled = [rate / size for rate in rates.values()]
        moving = [rate for rate in scaled if ca.depends_on(rate, unknowns)]
        return column(moving), column(scaled[len(moving) :])

    def _energy_size(self) -> SX:
        return self.network.energy_size() + self.rod.energy_size()

    def _statics(self) -> list[SX]:
        rod = self.system.rod
        defects = self.network.equilibrium() + self.rod.equilibrium()
        amounts = self.network.departures()
        return self._resolve(
            [column(defects), amounts, rod.intrinsic_curvature, rod.intrinsic_stretch],
            (self.statics,),
        )

    def _quantities(self) -> list[SX]:
        """Numbers that follow from the parameters alone."""
        nodes = [*self.system.pressure, *self.network.storing]
        return [
            self.network.filled(),
            self.network.rest_amounts(nodes),
            self.network.filled_amounts(nodes),
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
        """Assemble, resolve and compile."""
        (ode, alg), rates, outputs, ways = self._balances()
        quadrature, timed = self._quadratures(rates)
        static, *static_values = self._statics()
        system, network = self.system, self.network
        quantities = self._quantities()
        parameters, _ = system.parameters()
        x, z, y = self.states.vector, self.algebraics.vector, self.statics.vector
        tail = [
            system.time,
            system.pieces,
            system.load_factor,
            network.sealed_volumes,
            parameters,
        ]
        return Formulas(
            rod_form=self.rod.form,
            network_form=network.form,
            states=self.states,
            algebraics=self.algebraics,
            statics=self.statics,
            time=system.time,
            pieces=system.pieces,
            parameters=ca.vertcat(system.load_factor, network.sealed_volumes, parameters),
            ode=ode,
            alg=alg,
            rates=rates,
            quadrature=quadrature,
            timed_quadrature=timed,
            ways=ways,
            function=ca.Function("balances", [x, z, *tail], [ode, alg]),
            static_function=ca.Function(
                "equilibrium", [y, *tail], [static, jacobian(static, y), *static_values]
            ),
            algebraic_function=ca.Function("constraints", [x, z, *tail], [alg, jacobian(alg, z)]),
            output_function=ca.Function(
                "outputs",
                [x, z, *tail],
                [ca.densify(value) for value in outputs.values()],
                _names(7),
                list(outputs),
            ),
            quantity_function=ca.Function("quantities", [parameters], quantities),
            fed=network.fed,
            driven=tuple(network.driven),
            sealed=network.sealed,
            storing=tuple(network.storing),
            incompressible=isinstance(system.fluid, Incompressible),
            _compiled=LruCache(MOST_COMPILED),
        )


def _names(count: int) -> list[str]:
    return [f"i{k}" for k in range(count)]
