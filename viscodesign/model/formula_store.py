"""Functions of structures in the user's cache folder, so that they are formulated only once."""

from __future__ import annotations

import io
import pickle
import zlib
from collections.abc import Callable
from enum import Enum
from typing import Any, TypeVar

import casadi as ca
import numpy as np

from viscodesign.model.boundary_work import WorkSplit
from viscodesign.model.elements.balances import BalanceLayout
from viscodesign.model.elements.kinds import Elements, Law
from viscodesign.model.elements.local_form import LocalForm
from viscodesign.model.equation_layout import EquationLayout
from viscodesign.model.graph import Component, Tube
from viscodesign.model.local_equations import LocalEquations
from viscodesign.model.network_equations import NetworkForm
from viscodesign.model.rod_equations import RodForm
from viscodesign.model.taped_function import TapeWithPatterns
from viscodesign.model.unknowns import Block, Traits, Unknowns
from viscodesign.native.code_cache import keep, kept
from viscodesign.native.tape import OPERATIONS, OperationTape

Kept = TypeVar("Kept")

MAX_KEPT_BYTES = 16 * 2**20
"""Bytes of a function that is still kept: beyond, reading it is hardly faster than making it."""
FORMULA_COMPRESSION = 1
"""Level of zlib: a seventh of the size for 2 ms a megabyte."""


class FormulaStore:
    """What was made of the formulas of one structure.

    ``digest``: name of the structure (see `structure_digest`); None where nothing is kept.
    """

    def __init__(self, digest: str | None) -> None:
        self._digest = digest

    def function(
        self, maker: Callable[..., Any], given: tuple[Any, ...], make: Callable[[], ca.Function]
    ) -> ca.Function:
        """What ``make`` gives: a function by ``maker`` with these arguments besides formulas."""
        name = f"{maker.__module__} {maker.__qualname__} {given!r}"
        plain = all(isinstance(value, str | int | float | None) for value in given)
        return self._kept(name if plain else None, make, _bytes_of, _function_of)

    def tape(
        self, maker: Callable[..., Any], given: tuple[Any, ...], make: Callable[[], ca.Function]
    ) -> TapeWithPatterns | None:
        """The tape of what ``make`` gives, likewise; None where it has none."""
        name = f"{maker.__module__} {maker.__qualname__} {given!r} as tape of {OPERATIONS}"
        return self._kept(name, lambda: TapeWithPatterns.of(make()), _packed, _unpacked_tape)

    def layout(self, make: Callable[[], EquationLayout]) -> EquationLayout:
        """What ``make`` gives."""
        return self._kept("layout", make, _packed, _unpacked_layout)

    def local_equations(self, make: Callable[[], LocalEquations | None]) -> LocalEquations | None:
        """What ``make`` gives."""
        return self._kept("local", make, _packed_local, _unpacked_local)

    def _kept(
        self,
        name: str | None,
        make: Callable[[], Kept],
        pack: Callable[[Kept], bytes | None],
        unpack: Callable[[bytes], Kept],
    ) -> Kept:
        if self._digest is None or name is None:
            return make()
        parts = ("formulas", self._digest, name)
        data = kept(parts)
        if data is not None:
            try:
                return unpack(zlib.decompress(data))
            except UNREADABLE:
                pass  # whatever it is, it was not written here
        made = make()
        packed = pack(made)
        if packed is not None and len(packed) <= MAX_KEPT_BYTES:
            keep(parts, zlib.compress(packed, FORMULA_COMPRESSION))
        return made


UNREADABLE: tuple[type[Exception], ...] = (
    *(zlib.error, pickle.UnpicklingError, EOFError, RuntimeError, NotImplementedError),
    *(ValueError, TypeError, AttributeError, LookupError, ImportError),
)
"""Raised by what reads a file that was not written here."""


def _bytes_of(function: ca.Function) -> bytes | None:
    """A function of plain operations; None for others, which may hold a solver."""
    return str(function.serialize()).encode() if function.is_a("SXFunction") else None


def _function_of(data: bytes) -> ca.Function:
    return ca.Function.deserialize(data.decode())


def _unpacked_layout(data: bytes) -> EquationLayout:
    found = _unpacked(data)
    if not isinstance(found, EquationLayout):
        raise TypeError("no layout of equations")
    return found


def _unpacked_tape(data: bytes) -> TapeWithPatterns | None:
    found = _unpacked(data)
    if found is not None and not isinstance(found, TapeWithPatterns):
        raise TypeError("no tape")
    return found


def _packed_local(local: LocalEquations | None) -> bytes:
    if local is None:
        return _packed(None)
    form = local.form
    functions = [f.serialize() for f in (local.start, form.numbers)]
    return _packed((form.balances, form.drives, form.kinds, form.sources, *functions))


def _unpacked_local(data: bytes) -> LocalEquations | None:
    found = _unpacked(data)
    if found is None:
        return None
    balances, drives, kinds, sources, *functions = found
    start, numbers = (ca.Function.deserialize(text) for text in functions)
    return LocalEquations(LocalForm(balances, drives, kinds, sources, numbers), start)


PLAIN = (
    *(EquationLayout, Unknowns, Block, Traits, WorkSplit, Component, Tube, RodForm, NetworkForm),
    *(BalanceLayout, Elements, Law, OperationTape, TapeWithPatterns),
)
"""The classes that are kept; from a file, no other ones are made."""


def _array(dtype: str, shape: tuple[int, ...], data: bytes) -> np.ndarray:
    return np.frombuffer(data, dtype).reshape(shape)


ALLOWED: dict[tuple[str, str], Any] = {
    (thing.__module__, thing.__qualname__): thing for thing in (*PLAIN, _array)
}


class _Packer(pickle.Pickler):
    def reducer_override(self, obj: Any) -> Any:
        if isinstance(obj, np.ndarray):
            return _array, (obj.dtype.str, obj.shape, obj.tobytes())
        if isinstance(obj, Enum):
            return type(obj), (obj.value,)  # before Python 3.11.4 it would need `getattr`
        return NotImplemented


class _Unpacker(pickle.Unpickler):
    def find_class(self, module: str, name: str) -> Any:
        try:
            return ALLOWED[module, name]
        except KeyError:
            raise pickle.UnpicklingError(f"{module}.{name} is never kept") from None


def _packed(plain: object) -> bytes:
    file = io.BytesIO()
    _Packer(file, protocol=5).dump(plain)
    return file.getvalue()


def _unpacked(data: bytes) -> Any:
    return _Unpacker(io.BytesIO(data)).load()
