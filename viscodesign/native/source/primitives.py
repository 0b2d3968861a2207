"""What the loops in Python use in place of three native instructions; see `docs/make_loops.py`."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

PythonKernel = Callable[[np.ndarray, np.ndarray, np.ndarray], None]
"""(local, numbers, out) on flat arrays, laid out (entry, lane)."""


def call_kernel(
    kernels: Sequence[PythonKernel], k: int, local: np.ndarray, numbers: np.ndarray, out: np.ndarray
) -> None:
    """Call kernel k; natively, its address."""
    kernels[k](local, numbers, out)


def power_of_two(whole: float) -> float:
    """2 to the power of a whole number from -1022 to 1024, the last one infinite."""
    return float(np.ldexp(1.0, int(whole)))


def part(array: np.ndarray, start: int) -> np.ndarray:
    """An array from an entry on."""
    return array[start:]
