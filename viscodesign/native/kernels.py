"""Kernels: small CasADi functions as machine code that runs several elements at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from weakref import WeakValueDictionary

import casadi as ca

from viscodesign._version import __version__
from viscodesign.native import ir_operations, ir_writer
from viscodesign.native.code_cache import cached, digest, written_by
from viscodesign.native.ir_writer import module_ir
from viscodesign.native.machine import Loaded, load, object_code, this_machine
from viscodesign.storage.lru_cache import ONE_AT_A_TIME

LANES = 8
"""Elements that a kernel treats at once, unless told otherwise."""
OPTIMISE, GENERATE = 0, 0
"""Levels of passes and of code generation.

Formulas have few subexpressions to share. One level more of code generation takes five times as
long and saves a tenth of a step: what 80,000 steps take.
"""


class CompiledKernels:
    """Machine code of some functions; it stays loaded as long as this object lives."""

    def __init__(self, loaded: Loaded, names: Sequence[str]) -> None:
        self._loaded = loaded
        self._names = tuple(names)

    def __len__(self) -> int:
        return len(self._names)

    def address(self, k: int) -> int:
        """Address of kernel k: ``void (double *local, double *numbers, double *out)``.

        Arrays are laid out (entry, lane), and may begin at any multiple of 8 bytes.
        """
        return self._loaded[self._names[k]]


_LOADED: WeakValueDictionary[str, CompiledKernels] = WeakValueDictionary()


def compile_kernels(functions: Sequence[ca.Function], key: str, lanes: int) -> CompiledKernels:
    """Compile scalar functions (local (nl,), numbers (np,)) -> out, or load them from the cache.

    All inputs and the output are dense columns; either input may be empty. ``key``: whatever else
    a cached copy should depend on; the formulas themselves always count. ``lanes``: 1 or more.
    Raises `NativeUnavailable`.
    """
    formulas = [function.serialize() for function in functions]
    return compile_if_missing(lambda: functions, len(functions), (key, *formulas), lanes)


def compile_if_missing(
    make: Callable[[], Sequence[ca.Function]], count: int, key: tuple[str, ...], lanes: int
) -> CompiledKernels:
    """The same for ``count`` functions that are made only if there is no code for ``key``.

    The key tells them apart from all others. Raises `NativeUnavailable`.
    """
    settings = f"{lanes} lanes, levels {OPTIMISE} {GENERATE}, casadi {ca.CasadiMeta.version()}"
    writer = written_by(ir_operations, ir_writer)
    parts = (*key, __version__, writer, str(this_machine()), settings)
    name = digest(parts)
    with ONE_AT_A_TIME:
        kernels = _LOADED.get(name)
        if kernels is None:
            kernels = _LOADED[name] = _compiled(make, count, parts, lanes)
    return kernels


def _compiled(
    make: Callable[[], Sequence[ca.Function]], count: int, parts: tuple[str, ...], lanes: int
) -> CompiledKernels:
    names = [f"kernel{k}" for k in range(count)]

    def code() -> bytes:
        ir = module_ir(make(), names, lanes, this_machine().vector_math)
        return object_code(ir, optimise=OPTIMISE, generate=GENERATE)

    return CompiledKernels(load(cached(parts, code), names), names)
