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
    scene: Scene, keys: Sequence[str], outputs: Sequence[str], *, by_percent: bool
) -> tuple[CompiledFunction, LeftOut]:
    """Outputs as a function of the numbers with these keys; ``by_percent``: that are not zero.

    They are left out as they are refused, until the others have derivatives. Raises `SpecError`
    where none is left.
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
            function = CompiledFunction(scene, keys, outputs)
            function.jacobian()
        except SpecError as error:
            faults = {fault.key: fault.message for fault in error.faults if fault.key in keys}
            if not faults or len(faults) == len(keys):
                raise
            left_out |= {key: why.removeprefix("cannot be free: ") for key, why in faults.items()}
        else:
            return function, tuple(sorted(left_out.items()))
