"""The equations that a solver is given: functions of one structure, and numbers of one scene."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from contextlib import AbstractContextManager
from dataclasses import fields
from typing import Any, Concatenate, ParamSpec, TypeVar

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model import formulas as of
from viscodesign.model.equation_layout import EquationLayout
from viscodesign.model.formula_store import FormulaStore
from viscodesign.model.formulas import Formulas
from viscodesign.model.local_equations import LocalEquations
from viscodesign.model.taped_function import TapedFunction
from viscodesign.storage.cached_property import cached_property
from viscodesign.storage.lru_cache import LruCache

P = ParamSpec("P")
Made = TypeVar("Made")

LEADING_QUANTITIES = 6
"""Results of `formulas.quantities` before the sizes of the unknowns."""
MAX_COMPILED = 20
"""Functions that are kept with each structure, and as many other things that are made of it."""


class SharedFormulas:
    """Functions of one structure, made when first asked for, for all scenes and threads.

    ``make``: gives the formulas; not called where the user's cache folder has all that is
    asked for.
    """

    def __init__(self, store: FormulaStore, make: Callable[[], Formulas]) -> None:
        self._store = store
        self._make = make
        self._formulas: LruCache[Formulas] = LruCache(1)
        self._local: LruCache[LocalEquations | None] = LruCache(1)
        self._compiled: LruCache[ca.Function] = LruCache(MAX_COMPILED)
        self._taped: LruCache[TapedFunction] = LruCache(MAX_COMPILED)
        self._derived: LruCache[Any] = LruCache(MAX_COMPILED)
        self.layout = store.layout(lambda: self.formulas.layout)

    @property
    def formulas(self) -> Formulas:
        """The equations in symbols, without any scene's numbers."""
        return self._formulas.get("formulas", self._make)

    @property
    def local(self) -> LocalEquations | None:
        """The equations as sums of local terms; None where they are not such sums."""
        return self._local.get("local", self._local_equations)

    def _local_equations(self) -> LocalEquations | None:
        return self._store.local_equations(lambda: self.formulas.take_apart())

    def compiled(
        self, make: Callable[Concatenate[Formulas, P], ca.Function], *args: P.args, **_: P.kwargs
    ) -> ca.Function:
        """The result of ``make`` for these formulas and hashable arguments, made once.

        ``make`` gets the symbols without any scene's numbers. Its result is shared by scenes and
        threads: it must be stateless, which integrators are not.
        """

        def stored() -> ca.Function:
            return self._store.function(make, args, lambda: make(self.formulas, *args))  # type: ignore[call-arg]

        return self._compiled.get((make, args), stored)

    def taped(
        self, make: Callable[Concatenate[Formulas, P], ca.Function], *args: P.args, **_: P.kwargs
    ) -> TapedFunction:
        """The same as a tape of operations, which is read from disk faster than a function."""

        def function() -> ca.Function:
            return make(self.formulas, *args)  # type: ignore[call-arg]

        def stored() -> TapedFunction:
            tape = self._store.tape(make, args, function)
            return TapedFunction(tape, lambda: self.compiled(make, *args))  # type: ignore[call-arg]

        return self._taped.get((make, args), stored)

    def lent(
        self, make: Callable[Concatenate[Formulas, P], ca.Function], *args: P.args, **_: P.kwargs
    ) -> AbstractContextManager[ca.Function]:
        """The same for a stateful result, which is used exclusively inside the context."""
        return self._compiled.lend((make, args), lambda: make(self.formulas, *args))  # type: ignore[call-arg]

    def derived(self, kind: type[Made], key: Hashable, make: Callable[[], Made]) -> Made:
        """What ``make`` gives, made once for every ``key``.

        It must be stateless, and depend on nothing but these formulas and the key.
        """
        found: Made = self._derived.get((kind, key), make)
        return found

    def with_numbers(self, values: np.ndarray) -> Equations:
        """The equations of a scene with these parameter values."""
        function, layout = self.compiled(of.quantities), self.layout
        found = [np.array(v, dtype=float).ravel() for v in function.call([values])]
        sealed, rest, filled, motion, swing, energy = found[:LEADING_QUANTITIES]
        groups = [layout.states, layout.algebraics, layout.statics]
        ends = LEADING_QUANTITIES + np.cumsum([0, *(len(group.blocks) for group in groups)])
        sized = [g.sized(found[i:j]) for g, i, j in zip(groups, ends, ends[1:], strict=False)]
        own = {f.name: getattr(layout, f.name) for f in fields(layout)}
        names = ("states", "algebraics", "statics")
        return Equations(
            **{**own, **dict(zip(names, sized, strict=True))},
            shared=self,
            parameter_values=values,
            sealed_volumes=sealed,
            rest_amounts=rest,
            filled_amounts=filled,
            swing_time=float(swing[0]),
            motion_time=float(motion[0]),
            energy_size=float(energy[0]),
        )


@dataclass(frozen=True)
class Equations(EquationLayout):
    """Functions with the numbers of one scene: all that a solver needs."""

    shared: SharedFormulas
    """What it has in common with all scenes of its structure."""
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
    """Energy by which integrals of powers are divided [J]."""

    @cached_property
    def function(self) -> ca.Function:
        """See `formulas.balances`."""
        return self.compiled(of.balances)

    @cached_property
    def static_function(self) -> ca.Function:
        """See `formulas.equilibrium`."""
        return self.compiled(of.equilibrium)

    @cached_property
    def algebraic_function(self) -> ca.Function:
        """See `formulas.constraints`."""
        return self.compiled(of.constraints)

    @cached_property
    def output_function(self) -> ca.Function:
        """See `formulas.outputs`."""
        return self.compiled(of.outputs)

    @property
    def statics_by_tape(self) -> TapedFunction:
        """`static_function` for numbers."""
        return self.taped(of.equilibrium)

    @property
    def constraints_by_tape(self) -> TapedFunction:
        """`algebraic_function` for numbers."""
        return self.taped(of.constraints)

    @property
    def outputs_by_tape(self) -> TapedFunction:
        """`output_function` for numbers."""
        return self.taped(of.outputs)

    @property
    def formulas(self) -> Formulas:
        """The equations in symbols, without any scene's numbers; made if they were not needed."""
        return self.shared.formulas

    @property
    def local(self) -> LocalEquations | None:
        """The equations as sums of local terms; None where they are not such sums."""
        return self.shared.local

    def compiled(
        self, make: Callable[Concatenate[Formulas, P], ca.Function], *args: P.args, **_: P.kwargs
    ) -> ca.Function:
        """See `SharedFormulas.compiled`."""
        return self.shared.compiled(make, *args)  # type: ignore[call-arg]

    def taped(
        self, make: Callable[Concatenate[Formulas, P], ca.Function], *args: P.args, **_: P.kwargs
    ) -> TapedFunction:
        """See `SharedFormulas.taped`."""
        return self.shared.taped(make, *args)  # type: ignore[call-arg]

    def lent(
        self, make: Callable[Concatenate[Formulas, P], ca.Function], *args: P.args, **_: P.kwargs
    ) -> AbstractContextManager[ca.Function]:
        """See `SharedFormulas.lent`."""
        return self.shared.lent(make, *args)  # type: ignore[call-arg]
