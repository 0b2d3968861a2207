"""The equations that a solver is given: formulas of one structure, and the numbers of one scene."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import AbstractContextManager
from dataclasses import dataclass, field, fields
from typing import Concatenate, ParamSpec

import casadi as ca
import numpy as np

from viscodesign.elements.assembly import CompiledForm
from viscodesign.elements.local_form import LocalForm
from viscodesign.model.boundary_work import WorkSplit
from viscodesign.model.graph import Component
from viscodesign.model.network_equations import NetworkForm
from viscodesign.model.rod_equations import RodForm
from viscodesign.model.unknowns import Unknowns
from viscodesign.storage.lru_cache import LruCache

SX = ca.SX
P = ParamSpec("P")

LEADING_QUANTITIES = 6
"""Results of `Formulas.quantity_function` before the sizes of the unknowns."""


@dataclass(frozen=True)
class LocalEquations:
    """The same equations as sums of local terms, with sums over many parts as unknowns."""

    form: LocalForm
    """Its unknowns: states, algebraic unknowns, sums, integrals."""
    start: ca.Function
    """(x, z, t, pieces, parameters) -> scaled sums."""
    _compiled: LruCache[CompiledForm] = field(default_factory=lambda: LruCache(1))

    @property
    def sums(self) -> int:
        """How many unknowns the formulas do not have."""
        return self.form.size - self.form.balances.unknowns_of_formulas

    @property
    def compiled(self) -> CompiledForm:
        """The same in native code, made once. Raises `NativeUnavailable`."""
        return self._compiled.get("compiled", lambda: CompiledForm(self.form))


@dataclass(frozen=True)
class Formulas:
    """The equations of one structure in symbols, valid for every scene of its kind."""

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
    """Powers whose integrals the balances need [W]; those that depend on time alone come last."""
    quadrature: SX
    """The others, over the size of an energy, for an integrator."""
    time_only_quadrature: SX
    """Those that depend on time alone, scaled likewise."""
    work_splits: dict[str, WorkSplit]
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
    """Nodes other than bellows that store fluid."""
    incompressible: bool
    """Whether the amount of fluid in a bellow equals its volume."""
    _compiled: LruCache[ca.Function]
    _local: LruCache[LocalEquations | None]
    _take_apart: Callable[[], LocalEquations | None]

    @property
    def local(self) -> LocalEquations | None:
        """The equations as sums of local terms, made once; None where they are no such sums."""
        return self._local.get("local", self._take_apart)

    def compiled(
        self, make: Callable[Concatenate[Formulas, P], ca.Function], *args: P.args, **_: P.kwargs
    ) -> ca.Function:
        """The result of ``make`` for these formulas and hashable arguments, made once.

        ``make`` gets the symbols without any scene's numbers. Its result is shared by scenes and
        threads: it must be stateless, which integrators are not.
        """
        return self._compiled.get((make, args), lambda: make(self._symbolic, *args))  # type: ignore[call-arg]

    def lent(
        self, make: Callable[Concatenate[Formulas, P], ca.Function], *args: P.args, **_: P.kwargs
    ) -> AbstractContextManager[ca.Function]:
        """The same for a stateful result, which is used exclusively inside the context."""
        return self._compiled.lend((make, args), lambda: make(self._symbolic, *args))  # type: ignore[call-arg]

    @property
    def _symbolic(self) -> Formulas:
        return self

    def with_numbers(self, values: np.ndarray) -> Equations:
        """The equations of a scene with these parameter values."""
        found = [np.array(v, dtype=float).ravel() for v in self.quantity_function.call([values])]
        sealed, rest, filled, motion, swing, energy = found[:LEADING_QUANTITIES]
        groups = [self.states, self.algebraics, self.statics]
        ends = LEADING_QUANTITIES + np.cumsum([0, *(len(group.blocks) for group in groups)])
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
    """Formulas with the numbers of one scene: all that a solver needs."""

    formulas: Formulas
    """The same without numbers."""
    parameter_values: np.ndarray
    sealed_volumes: np.ndarray
    """Amount with which each sealed part was filled [m3 at ambient density]."""
    rest_amounts: np.ndarray
    """Contents of bellows and storing nodes at zero gauge [m3]."""
    filled_amounts: np.ndarray
    """The same at the baseline, unloaded, with no plunger pushed in."""
    swing_time: float
    """Time in which the inlets may change by all of their pressure [s]."""
    motion_time: float
    """Time scale of the rod's motion [s]: its velocities are scaled by length over it."""
    energy_size: float
    """Energy by which `quadrature` is divided [J]."""

    @property
    def _symbolic(self) -> Formulas:
        return self.formulas
