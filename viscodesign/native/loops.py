"""The loops in native code, and the same loops in Python as their twin.

``loops.ll`` is made of `source` when that changes (`docs/make_loops.py`), finished for the
processor of the user by the first run, and kept in the cache folder.
"""

from __future__ import annotations

import ctypes
import hashlib
from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from functools import cache
from inspect import getsource
from pathlib import Path
from types import FunctionType, ModuleType
from typing import Any

import numpy as np

from viscodesign._version import __version__
from viscodesign.native.code_cache import cached
from viscodesign.native.machine import load, object_code, this_machine
from viscodesign.native.source import (
    angles,
    axes,
    bands,
    elimination,
    equilibria,
    factors,
    filters,
    forward,
    replay,
    reverse,
    row_operations,
    rows,
    slopes,
    steps,
    sums,
    tape,
)
from viscodesign.native.source.primitives import PythonKernel

Kernel = int | PythonKernel
"""An address of machine code, or the same in Python for the loops in Python."""

SOURCES = (
    sums,
    elimination,
    factors,
    steps,
    slopes,
    replay,
    reverse,
    forward,
    rows,
    row_operations,
    tape,
    angles,
    axes,
    filters,
    bands,
    equilibria,
)
IR_FILE = Path(__file__).parent / "loops.ll"
LOOP_PASSES, LOOP_GENERATION = 3, 3
"""Levels of passes and of code generation."""

_KERNELS = ("counts", "counts")
_LU = ("places", "places", "places", "reals")
_RECORDED = (
    *(*_KERNELS, "counts", "places", "places", "places", "reals", "places", "places"),
    *("count", *["places"] * 5, "count", *["places"] * 3),
    *("reals", "reals", "reals", "count", "count", "reals", "count", "reals"),
)
SIGNATURES: dict[str, tuple[str, ...]] = {
    "residual": (*_KERNELS, "places", "places", *["reals"] * 5),
    "jacobian": (*_KERNELS, "places", "places", *["reals"] * 5),
    "drive": (*_KERNELS, "places", "places", *["reals"] * 4),
    "drive_rates": (*_KERNELS, "places", "places", *["reals"] * 5),
    "pair_up": ("count", *["places"] * 6),
    "elimination_order": ("count", *["places"] * 5, "count", *["places"] * 10),
    "lu_pattern": ("count", "places", "places", "count", *["places"] * 4),
    "lu_fill": ("count", "count", "reals", "places", "reals", "real", "reals"),
    "lu_factor": ("count", *_LU, "reals"),
    "lu_solve": ("count", "places", "count", *_LU, *["reals"] * 3),
    "march": (
        *(*_KERNELS, "places", "places", "places", "reals", "places", "places"),
        *("count", *["places"] * 5),
        *("reals", "count", "reals", "reals", "reals", "reals", "count", "count"),
        *("reals", "reals", "reals", "counts", "reals", "count", "count", "reals", "reals"),
    ),
    "sums_of_rows": (
        *(*_KERNELS, "places", "places", "places", "count", "count", "reals", "count"),
        *["reals"] * 5,
    ),
    "march_rows": (
        *(*_KERNELS, "places", "places", "places", "places", "places"),
        *("count", *["places"] * 5, "reals", "count", "reals", "reals"),
        *("count", "count", "reals", "count", "reals", "reals", "reals", "counts", "reals"),
        *("count", "reals", "counts", "reals", "counts", "reals"),
    ),
    "lu_solve_transposed": ("count", "places", "count", *_LU, *["reals"] * 3),
    "lu_solve_sides": ("count", "places", "count", *_LU, *["reals"] * 3),
    "slopes_at": (*_KERNELS, "counts", "places", "places", *["reals"] * 8),
    "rates_at": (*_KERNELS, "counts", "places", "places", *["reals"] * 7),
    "reverse": (*_RECORDED, *["reals"] * 6),
    "forward": (
        *(*_RECORDED[:-1], "count", "reals", "reals", "reals", "count", "reals", "count"),
        *["reals"] * 3,
    ),
    "run_tape": (
        *("count", "places", "reals", "counts", "counts", "reals", "counts", "counts"),
        *("count", "reals", "reals"),
    ),
    "sines_and_cosines": ("count", *["reals"] * 3),
    "lay_axes": ("count", "count", "count", "real", *["reals"] * 6),
    "strain_axes": ("count", "count", "count", "real", *["reals"] * 9),
    "follow": ("count", "count", "count", *["reals"] * 6),
    "follow_turning": ("count", "count", "count", *["reals"] * 7),
    "have_signs": (*["count"] * 4, "places", "places", *["reals"] * 3, "counts"),
    "follow_equilibria": (
        *(*_KERNELS, "places", "places", "places", "reals", "count", *["places"] * 5),
        *("reals", "count", "reals", "count", "count", *["reals"] * 7),
    ),
}
"""Arguments of the loops: numbers, or arrays without any gaps."""
DTYPES = {"counts": np.int64, "places": np.int32, "reals": np.float64}


class Loops(ABC):
    """The loops of `source`, called with arrays."""

    @abstractmethod
    def __call__(self, name: str, *arguments: Any) -> int:
        """Call a loop by its name."""

    @abstractmethod
    def kernels(self, kernels: Sequence[Kernel]) -> Any:
        """Kernels in the form in which the loops take them."""


class NativeLoops(Loops):
    """Machine code; releases the interpreter's lock while it runs."""

    def __init__(self) -> None:
        ir = IR_FILE.read_text(encoding="utf-8")
        settings = f"loops, levels {LOOP_PASSES} {LOOP_GENERATION}, not unrolled"
        parts = (settings, __version__, str(this_machine()), ir)
        code = cached(
            parts, lambda: object_code(ir, optimise=LOOP_PASSES, generate=LOOP_GENERATION)
        )
        self._loaded = load([code], list(SIGNATURES))
        self._calls = {name: self._foreign(name) for name in SIGNATURES}

    def _foreign(self, name: str) -> Callable[..., int]:
        kinds: dict[str, Any] = {"count": ctypes.c_int64, "real": ctypes.c_double}
        arguments = [kinds.get(kind, ctypes.c_void_p) for kind in SIGNATURES[name]]
        return ctypes.CFUNCTYPE(ctypes.c_int64, *arguments)(self._loaded[name])

    def __call__(self, name: str, *arguments: Any) -> int:
        return self._calls[name](*[
            argument if kind in ("count", "real") else address(argument, kind)
            for argument, kind in zip(arguments, SIGNATURES[name], strict=True)
        ])  # fmt: skip

    def kernels(self, kernels: Sequence[Kernel]) -> np.ndarray:
        return np.array([k for k in kernels if isinstance(k, int)], dtype=np.int64)


class PythonLoops(Loops):
    """The twin: slow, and independent of llvmlite."""

    def __init__(self) -> None:
        self._functions: dict[str, Callable[..., Any]] = {
            name: vars(module)[name] for module in SOURCES for name in functions_of(module)
        }

    def __call__(self, name: str, *arguments: Any) -> int:
        with np.errstate(all="ignore"):
            return self._functions[name](*arguments) or 0

    def kernels(self, kernels: Sequence[Kernel]) -> list[PythonKernel]:
        return [k for k in kernels if not isinstance(k, int)]


@cache
def native_loops() -> NativeLoops:
    """The loops in native code. Raises `NativeUnavailable`."""
    return NativeLoops()


def source_digest() -> str:
    """What tells whether ``loops.ll`` belongs to its source."""
    texts = [getsource(module) for module in SOURCES]
    return hashlib.sha256("".join([*texts, repr(SIGNATURES)]).encode()).hexdigest()


def functions_of(module: ModuleType) -> list[str]:
    """Names of the functions that a file of loops defines."""
    own = (v for v in vars(module).values() if isinstance(v, FunctionType))
    return [v.__name__ for v in own if v.__module__ == module.__name__]


def address(array: np.ndarray, kind: str) -> int:
    """Where the values of an array begin."""
    if array.dtype != DTYPES[kind] or not array.flags.c_contiguous:
        raise ValueError(f"needs an array of {DTYPES[kind].__name__} without gaps")
    try:
        # In a fifth of the time of the array interface, and a run asks a hundred times.
        return ctypes.addressof(ctypes.c_char.from_buffer(array))  # type: ignore[arg-type]
    except (TypeError, ValueError):  # a read-only array, or one without entries
        return int(array.__array_interface__["data"][0])
