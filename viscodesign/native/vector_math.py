"""The C library's functions for several numbers at once, where glibc has them (libmvec)."""

from __future__ import annotations

import ctypes
import platform
import sys
from functools import cache

from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class VectorMath:
    """Functions for vectors of one width, to four units in the last place.

    Their names are those of the vector ABI: ``_ZGVeN8vv_pow`` for two vectors of eight.
    """

    letter: str
    width: int
    glibc: str

    def __str__(self) -> str:
        return f"libmvec {self.glibc} {self.letter}{self.width}"

    def name(self, function: str, arguments: int) -> str | None:
        """Name of the version for vectors, if there is one."""
        full = f"_ZGV{self.letter}N{self.width}{'v' * arguments}_{function}"
        library = _library()
        return full if library is not None and hasattr(library, full) else None


NONE = VectorMath("", 1, "")
"""No such functions: one number after the other."""


def vector_math(features: str) -> VectorMath:
    """What a processor with these features can call."""
    if _library() is None:
        return NONE
    have, glibc = features.split(","), platform.libc_ver()[1]
    if "+avx512f" in have and "+avx512dq" in have:
        return VectorMath("e", 8, glibc)
    return VectorMath("d", 4, glibc) if "+avx2" in have and "+fma" in have else NONE


@cache
def _library() -> ctypes.CDLL | None:
    """The library, for all machine code to find."""
    if sys.platform != "linux" or platform.machine() != "x86_64":
        return None
    try:
        return ctypes.CDLL("libmvec.so.1", ctypes.RTLD_GLOBAL)
    except OSError:
        return None
