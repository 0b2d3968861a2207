"""What the loops in Python use in place of two native instructions; see `docs/make_loops.py`."""

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


def part(array: np.ndarray, start: int) -> np.ndarray:
    """An array from an entry on."""
    return array[start:]
