"""The equations as sums of local terms, for native code."""

from __future__ import annotations

from dataclasses import field

import casadi as ca

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.elements.assembly import CompiledForm
from viscodesign.model.elements.local_form import LocalForm
from viscodesign.model.taped_function import TapedFunction, TapeWithPatterns
from viscodesign.storage.cached_property import cached_property
from viscodesign.storage.lru_cache import LruCache


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

    @cached_property
    def start_by_tape(self) -> TapedFunction:
        """`start` for numbers, all of its results."""
        given = self.start.sx_in()
        dense = ca.Function("start", given, [ca.densify(self.start.call(given)[0])])
        return TapedFunction(TapeWithPatterns.of(dense), lambda: dense)

    @property
    def compiled(self) -> CompiledForm:
        """The same in native code, made once. Raises `NativeUnavailable`."""
        return self._compiled.get("compiled", lambda: CompiledForm(self.form))
