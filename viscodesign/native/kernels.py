"""Kernels: small CasADi functions as machine code that runs several elements at once."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca

from viscodesign.native.unavailable import NativeUnavailable

LANES = 8
"""Elements that a kernel treats at once, unless told otherwise."""


class CompiledKernels:
    """Machine code of some functions; it stays loaded as long as this object lives."""

    def address(self, k: int) -> int:
        """Address of kernel k: ``void (double *local, double *numbers, double *out)``.

        Arrays are laid out (entry, lane), and may begin at any multiple of 8 bytes.
        """
        raise NotImplementedError


def compile_kernels(functions: Sequence[ca.Function], key: str, lanes: int) -> CompiledKernels:
    """Compile scalar functions (local (nl,), numbers (np,)) -> out, or load them from the cache.

    All inputs and the output are dense columns; either input may be empty. ``key``: whatever else
    a cached copy should depend on; the formulas themselves always count. ``lanes``: 1 or more.
    Raises `NativeUnavailable`.
    """
    raise NativeUnavailable("native code is not built yet")
