"""Kernels: small CasADi functions as machine code that runs several elements at once."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from weakref import WeakValueDictionary

import casadi as ca

from viscodesign._version import __version__
from viscodesign.lazy_dataclass import dataclass
from viscodesign.native import instructions, ir_operations, ir_writer
from viscodesign.native.code_cache import digest, keep, kept, written_by
from viscodesign.native.ir_writer import module_ir
from viscodesign.native.machine import Loaded, load, object_code, this_machine
from viscodesign.storage.lru_cache import ONE_AT_A_TIME

LANES = 8
"""Elements that a kernel treats at once, unless told otherwise."""
KERNEL_PASSES, KERNEL_GENERATION = 0, 0
"""Levels of passes and of code generation.

Formulas have few subexpressions to share. One level more of code generation takes five times as
long and saves a tenth of a step: what 80,000 steps take.
"""


class CompiledKernels:
    """Machine code of some functions; it stays loaded as long as this object lives."""

    def __init__(self, loaded: Loaded, names: Sequence[str], told: bytes = b"") -> None:
        self._loaded = loaded
        self._names = tuple(names)
        self.told = told
        """What its maker told of the functions."""

    def __len__(self) -> int:
        return len(self._names)

    def address(self, k: int) -> int:
        """Address of kernel k: ``void (double *local, double *numbers, double *out)``.

        Arrays are laid out (entry, lane), and may begin at any multiple of 8 bytes.
        """
        return self._loaded[self._names[k]]


@dataclass(frozen=True)
class Wanted:
    """Kernels that are compiled and kept together, such as those of one law."""

    key: tuple[str, ...]
    """Tells them apart from all others."""
    count: int
    lanes: int
    make: Callable[[], Sequence[ca.Function]]
    """The functions; called only if there is no code for the key."""
    tell: Callable[[], bytes] = bytes
    """What is kept beside the code."""


_LOADED: WeakValueDictionary[str, CompiledKernels] = WeakValueDictionary()


def compile_kernels(functions: Sequence[ca.Function], key: str, lanes: int) -> CompiledKernels:
    """Compile scalar functions (local (nl,), numbers (np,)) -> out, or load them from the cache.

    All inputs and the output are dense columns; either input may be empty. ``key``: whatever else
    a cached copy should depend on; the formulas themselves always count. ``lanes``: 1 or more.
    Raises `NativeUnavailable`.
    """
    formulas = [function.serialize() for function in functions]
    wanted = Wanted((key, *formulas), len(functions), lanes, lambda: functions)
    return compile_if_missing([wanted])[0]


def compile_if_missing(wanted: Sequence[Wanted]) -> list[CompiledKernels]:
    """The same for many: each compiled by itself, and all that are not in memory loaded at once.

    Raises `NativeUnavailable`.
    """
    names = [digest((*own.key, *_setting(own.lanes))) for own in wanted]
    with ONE_AT_A_TIME:
        found = {name: kernels for name in names if (kernels := _LOADED.get(name))}
        missing = {n: own for n, own in zip(names, wanted, strict=True) if n not in found}
        if missing:
            found |= _loaded(missing)
        _LOADED.update(found)
    return [found[name] for name in names]


def _loaded(missing: dict[str, Wanted]) -> dict[str, CompiledKernels]:
    """Load kernels by their digests."""
    codes, told, symbols = [], {}, {}
    for name, own in missing.items():
        symbols[name] = [f"kernel{k}_{name}" for k in range(own.count)]
        content = kept((name,))
        if content is None:
            content = _compiled(own, symbols[name])
            keep((name,), content)
        end = HEAD + int.from_bytes(content[:HEAD], "little")
        told[name] = content[HEAD:end]
        codes.append(content[end:])
    loaded = load(codes, [symbol for own in symbols.values() for symbol in own])
    return {name: CompiledKernels(loaded, symbols[name], told[name]) for name in missing}


HEAD = 8
"""Bytes before what is told and the code: the length of what is told."""


def _compiled(wanted: Wanted, names: Sequence[str]) -> bytes:
    """What is kept of them."""
    told = wanted.tell()
    ir = module_ir(wanted.make(), names, wanted.lanes, this_machine().vector_math)
    code = object_code(ir, optimise=KERNEL_PASSES, generate=KERNEL_GENERATION)
    return len(told).to_bytes(HEAD, "little") + told + code


def _setting(lanes: int) -> tuple[str, ...]:
    """What code depends on besides its formulas."""
    levels = f"levels {KERNEL_PASSES} {KERNEL_GENERATION}"
    settings = f"{lanes} lanes, {levels}, casadi {ca.CasadiMeta.version()}"
    writer = written_by(instructions, ir_operations, ir_writer)
    return __version__, writer, str(this_machine()), settings
