"""A function of those numbers of a scene that have derivatives, of many that may have none."""

from __future__ import annotations

from collections.abc import Sequence

from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.compiled.function import CompiledFunction
from viscodesign.errors import SpecError
from viscodesign.scene.scene import Scene

LeftOut = tuple[tuple[str, str], ...]
"""Keys that were refused, and why."""


def differentiable(
    scene: Scene,
    keys: Sequence[str],
    outputs: Sequence[str],
    *,
    by_percent: bool,
    tolerance: float | None = None,
    effects: frozenset[str] | None = None,
) -> tuple[CompiledFunction, LeftOut]:
    """Outputs as a function of the numbers with these keys; ``by_percent``: that are not zero.

    Keys are left out as they are refused, until the others have derivatives. Those on which
    nothing depends are among what is left out, and free all the same: without them the function
    would have to be made again. ``tolerance``, ``effects``: as of `CompiledFunction`. Raises
    `SpecError` where nothing moves the outputs.
    """
    left_out: dict[str, str] = {}
    keys = list(keys)
    while True:
        keys = [key for key in keys if key not in left_out]
        try:
            if by_percent:
                zero = [number.name for number in FreeKeys(scene, keys).numbers if not number.value]
                left_out |= dict.fromkeys(zero, "it is 0, of which a percent is nothing")
                keys = [key for key in keys if key not in left_out]
            function = CompiledFunction(
                scene, keys, outputs, tolerance, effects=effects, keeps_unused=True
            )
            if len(function.unused) == len(function.names):
                raise SpecError(function.unused)
            function.jacobian()
        except SpecError as error:
            faults = {fault.key: fault.message for fault in error.faults if fault.key in keys}
            if not faults or len(faults) == len(keys):
                raise
            left_out |= {key: _reason(why) for key, why in faults.items()}
        else:
            left_out |= {fault.key: _reason(fault.message) for fault in function.unused}
            return function, tuple(sorted(left_out.items()))


def _reason(why: str) -> str:
    return why.removeprefix("cannot be free: ")
