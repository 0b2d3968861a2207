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

from dataclasses import dataclass

import casadi as ca
import numpy as np

from viscodesign.model.fluid import Incompressible
from viscodesign.model.graph import Component
from viscodesign.model.network_equations import NetworkEquations, NetworkForm
from viscodesign.model.rod_equations import RodEquations, RodForm
from viscodesign.model.system import System
from viscodesign.model.unknowns import Sizes, Unknowns, column, substitute

SX = ca.SX


@dataclass(frozen=True)
class Equations:
    """The equations of one system, with everything a solver needs to know."""

    rod_form: RodForm
    network_form: NetworkForm
    states: Unknowns
    algebraics: Unknowns
    statics: Unknowns
    """Unknowns of the equilibrium: pressures, flows that are not formulas, the rod's shape."""
    time: SX
    pieces: SX
    parameters: SX
    parameter_values: np.ndarray
    ode: SX
    alg: SX
    rates: dict[str, SX]
    """Powers and flows whose integrals the balances need."""
    function: ca.Function
    """(x, z, t, pieces, load_factor, sealed_volumes, parameters) -> (ode, alg)."""
    static_function: ca.Function
    """(y, t, pieces, load_factor, sealed_volumes, parameters) -> (residual, Jacobian,
    amounts beyond rest, intrinsic curvatures, intrinsic stretches)."""
    algebraic_function: ca.Function
    """Like `function`, returning (alg, d alg/d z)."""
    output_function: ca.Function
    """(x, z, t, pieces, load_factor, sealed_volumes, parameters) -> named outputs."""
    fed: tuple[Component, ...]
    sealed: tuple[Component, ...]
    sealed_volumes: np.ndarray
    """What each sealed part was filled with [m3 at ambient density]."""
    storing: tuple[str, ...]
    """Nodes besides the bellows that hold fluid."""
    incompressible: bool
    """Whether an amount in a bellow is its volume."""
    rest_amounts: np.ndarray
    """What bellows and storing nodes hold at zero gauge [m3]."""


def formulate(system: System, sizes: Sizes) -> Equations:
    """Turn a system's sums into equations.

    Raises `SpecError` where one pressure per network is asked for and two inlets
    feed the same network.
    """
    return _Formulation(system, sizes).equations()


class _Formulation:
    """One pass over a system; kept together because every step needs the same symbols."""

    def __init__(self, system: System, sizes: Sizes) -> None:
        self.system = system
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

    def _balances(self) -> tuple[list[SX], dict[str, SX], dict[str, SX]]:
        """(ode, alg), rates and outputs, in the unknowns."""
        network, rod = self.network.dynamics(), self.rod.dynamics()
        rates = self.network.rates() | self.rod.rates()
        outputs = self.network.outputs(self.rod.conjugate_volumes()) | self.rod.outputs()
        sides = [column(network[side] + rod[side]) for side in (0, 1)]
        groups = (self.states, self.algebraics)
        resolved = self._resolve([*sides, *rates.values(), *outputs.values()], groups)
        count = 2 + len(rates)
        return (
            list(ca.cse(resolved[:2])),
            dict(zip(rates, resolved[2:count], strict=True)),
            dict(zip(outputs, resolved[count:], strict=True)),
        )

    def _statics(self) -> list[SX]:
        rod = self.system.rod
        defects = self.network.equilibrium() + self.rod.equilibrium()
        amounts = self.network.departures()
        return self._resolve(
            [column(defects), amounts, rod.intrinsic_curvature, rod.intrinsic_stretch],
            (self.statics,),
        )

    def _rest_amounts(self, symbols: SX, values: np.ndarray) -> np.ndarray:
        nodes = [*self.system.pressure, *self.network.storing]
        function = ca.Function("rest", [symbols], [self.network.rest_amounts(nodes)])
        return np.asarray(function(values), dtype=float).ravel()

    def equations(self) -> Equations:
        """Assemble, resolve and compile."""
        (ode, alg), rates, outputs = self._balances()
        static, *static_values = self._statics()
        system, network = self.system, self.network
        parameters, values = system.parameters()
        x, z, y = self.states.vector, self.algebraics.vector, self.statics.vector
        tail = [
            system.time,
            system.pieces,
            system.load_factor,
            network.sealed_volumes,
            parameters,
        ]
        return Equations(
            rod_form=self.rod.form,
            network_form=network.form,
            states=self.states,
            algebraics=self.algebraics,
            statics=self.statics,
            time=system.time,
            pieces=system.pieces,
            parameters=ca.vertcat(system.load_factor, network.sealed_volumes, parameters),
            parameter_values=values,
            ode=ode,
            alg=alg,
            rates=rates,
            function=ca.Function("balances", [x, z, *tail], [ode, alg]),
            static_function=ca.Function(
                "equilibrium", [y, *tail], [static, ca.jacobian(static, y), *static_values]
            ),
            algebraic_function=ca.Function(
                "constraints", [x, z, *tail], [alg, ca.jacobian(alg, z)]
            ),
            output_function=ca.Function(
                "outputs", [x, z, *tail], list(outputs.values()), _names(7), list(outputs)
            ),
            fed=network.fed,
            sealed=network.sealed,
            sealed_volumes=network.filled(),
            incompressible=isinstance(system.fluid, Incompressible),
            storing=tuple(network.storing),
            rest_amounts=self._rest_amounts(parameters, values),
        )


def _names(count: int) -> list[str]:
    return [f"i{k}" for k in range(count)]
