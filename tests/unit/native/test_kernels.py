"""Kernels that several threads ask for."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from threading import Event

import casadi as ca

from viscodesign.native.kernels import LANES, CompiledKernels, Wanted, compile_if_missing
from viscodesign.storage.lru_cache import LruCache

formulas: LruCache[ca.Function] = LruCache(4)


def power(exponent: int) -> ca.Function:
    """(x, numbers) -> x**exponent."""
    x = ca.SX.sym("x")
    return ca.Function("power", [x, ca.SX.sym("numbers", 0)], [x**exponent])


def test_formulas_that_wait_for_kernels_and_kernels_that_wait_for_formulas() -> None:
    """One thread makes formulas that need a kernel, the other a kernel that needs formulas."""
    one_began, other_began = Event(), Event()

    def kernels(exponent: int) -> CompiledKernels:
        def make() -> Sequence[ca.Function]:
            other_began.set()
            return [formulas.get(exponent, lambda: power(exponent))]

        return compile_if_missing([Wanted(("powers", str(exponent)), 1, LANES, make)])[0]

    def formula_first() -> int:
        def make() -> ca.Function:
            one_began.set()
            other_began.wait(timeout=0.5)  # in vain, if one lock serves both
            kernels(2)
            return power(2)

        return int(formulas.get("with kernels", make).numel_out(0))

    def kernel_first() -> int:
        one_began.wait()
        return len(kernels(3))

    pool = ThreadPoolExecutor(2)
    try:
        found = [pool.submit(work) for work in (formula_first, kernel_first)]
        assert [one.result(timeout=30.0) for one in found] == [1, 1]
    finally:
        pool.shutdown(wait=False)
