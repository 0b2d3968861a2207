"""CasADi functions as tapes of operations, evaluated for many rows of arguments at once.

A tape is read from disk in no time, and one of its operations runs over 32 rows before the next
one begins, in a fifth of the time of CasADi's virtual machine. Results are equal bit for bit.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.native.instructions import instructions
from viscodesign.native.loops import DTYPES, Loops, native_loops
from viscodesign.native.machine import this_machine
from viscodesign.native.source import tape as source

_NAMES = {value: name[3:] for name, value in vars(ca).items() if name.startswith("OP_")}
_SAME = {"CONSTPOW": "POW", "LIFT": "ASSIGN"}
"""Operations that are others by another name."""
_CODES = {
    name: value for name, value in vars(source).items() if name.isupper() and type(value) is int
}
_OWN = np.full(max(_NAMES) + 1, -1)
"""The number that an operation has on tapes; -1 for those that are on none."""
for _number, _name in _NAMES.items():
    _OWN[_number] = _CODES.get(_SAME.get(_name, _name), -1)
OPERATIONS = " ".join(f"{name} {code}" for name, code in sorted(_CODES.items()))
"""What the numbers on tapes mean."""
PLACES_KEPT = 256
"""Shapes of arguments whose places are remembered."""


@dataclass(frozen=True, eq=False)
class OperationTape:
    """The operations of a function of columns, in their order.

    ``code`` int32 (steps, 4): operation, place of the result, and two operands, as `source.tape`
    has them; ``constants`` (k,): in the order of their steps.
    """

    code: np.ndarray
    constants: np.ndarray
    places: int
    """Places that are worked in."""
    given: tuple[int, ...]
    """Entries of the arguments."""
    names: tuple[str, ...]
    """Names of the results."""
    sizes: tuple[int, ...]
    """Entries of the results that are not zero by structure."""

    def __call__(
        self, arguments: Sequence[np.ndarray], rows: int, loops: Loops | None = None
    ) -> list[np.ndarray]:
        """Results (m, size) for arguments (m, n) each, or (n,) where equal for all rows.

        Raises `NativeUnavailable`.
        """
        if loops is None:
            this_machine()  # code that was made before may have been switched off
            loops = native_loops()
        arrays = [np.ascontiguousarray(values, dtype=float) for values in arguments]
        shared = [values.ndim == 1 for values in arrays]
        shapes = [values.shape for values in arrays]
        due = [(n,) if own else (rows, n) for n, own in zip(self.given, shared, strict=True)]
        if shapes != due:
            raise ValueError(f"arguments of shapes {shapes}, where {due} belong")
        strides = [0 if own else n for n, own in zip(self.given, shared, strict=True)]
        numbers = [values.size for values in arrays]
        ends = rows * np.cumsum((0, *self.sizes))
        found = np.zeros(int(ends[-1]))
        unknown = loops(
            "run_tape",
            *(len(self.code), self.code.reshape(-1), self.constants),
            *_placed(tuple(numbers), self.given, tuple(strides)),
            np.concatenate([values.reshape(-1) for values in (*arrays, np.zeros(1))]),
            *_placed(tuple(rows * size for size in self.sizes), self.sizes, self.sizes),
            *(rows, np.empty(self.places * source.WIDTH), found),
        )
        if unknown:
            raise ValueError(f"step {unknown - 1} of a tape has no known operation")
        parts = np.split(found, ends[1:-1])
        return [part.reshape(rows, n) for part, n in zip(parts, self.sizes, strict=True)]


@lru_cache(PLACES_KEPT)
def _placed(
    numbers: tuple[int, ...], sizes: tuple[int, ...], strides: tuple[int, ...]
) -> tuple[np.ndarray, np.ndarray]:
    """Where the entries of several arrays stand in the first row, and how far the next one is.

    ``numbers``: entries of each array, in all rows.
    """
    begins = np.repeat(np.cumsum((0, *numbers))[:-1], sizes)
    within = np.concatenate([np.arange(n) for n in sizes])
    counts = DTYPES["counts"]
    return (begins + within).astype(counts), np.repeat(strides, sizes).astype(counts)


def tape_of(function: ca.Function) -> OperationTape | None:
    """The tape of a function; None where it does more than plain operations on columns."""
    if not function.is_a("SXFunction"):
        return None
    given = tuple(function.nnz_in(k) for k in range(function.n_in()))
    sizes = tuple(function.nnz_out(k) for k in range(function.n_out()))
    listed = instructions(function)
    operations, own = listed[:, 0], _OWN[listed[:, 0]]
    if np.any(own < 0):
        return None
    steps = listed.astype(DTYPES["places"])
    steps[:, 0] = own
    constant, read, written = (operations == k for k in (ca.OP_CONST, ca.OP_INPUT, ca.OP_OUTPUT))
    constants = np.ascontiguousarray(listed[constant, 2:]).view(float).ravel()
    steps[constant, 2], steps[constant, 3] = np.arange(len(constants)), 0
    firsts, ends = (np.cumsum((0, *counts)) for counts in (given, sizes))
    steps[read, 2], steps[read, 3] = firsts[listed[read, 2]] + listed[read, 3], 0
    steps[written, 1] = 0
    steps[written, 3] += ends[listed[written, 1]].astype(DTYPES["places"])
    return OperationTape(
        code=steps,
        constants=np.append(constants, 0.0),
        places=max(int(function.sz_w()), 1),
        given=given,
        names=tuple(function.name_out()),
        sizes=sizes,
    )
