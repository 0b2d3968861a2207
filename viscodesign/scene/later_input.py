"""An input that is another one, by a delay later."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from viscodesign.scene.inputs.base import Input, PiecewiseLinear
from viscodesign.scene.inputs.table import TableInput
from viscodesign.scene.several import SameInput


def later_input(source: Input, delay: float, duration: float) -> Input | None:
    """The input by a delay later [s], for a run of this duration; None where there is none.

    Straight lines become a table; what a periodic input was before t = 0 comes first, of any
    other its initial value.
    """
    if delay == 0.0:
        return source
    found = source.later(delay)
    if found is not None or not (source.gives_pressure and isinstance(source, PiecewiseLinear)):
        return found
    rows = _later_lines(source, delay, duration)
    if source.period is not None:
        rows = _later_cycle(source, delay % source.period)
    table = {"kind": "table", "rows": rows, "repeat": source.period is not None}
    return TableInput.model_validate({**table, "transient_time": source.transient_time})


def own_inputs(inputs: Mapping[str, Any], duration: float) -> dict[str, Input]:
    """Inputs with values of their own, for a run of this duration [s].

    Without those of kinds that cannot be later.
    """
    found: dict[str, Input] = {}
    for name, given in inputs.items():
        own: Input | None = given if isinstance(given, Input) else None
        if isinstance(given, SameInput):
            own = later_input(inputs[given.source], given.delay, duration)
        if own is not None:
            found[name] = own
    return found


def _later_lines(source: PiecewiseLinear, delay: float, duration: float) -> list[list[float]]:
    """Rows [s, Pa] of lines that begin after the initial value was held."""
    held = [[0.0, source.initial()], [delay, source.initial()]]
    moved = [[t + delay, value] for t, value in source.vertices(duration).tolist()]
    return [row for k, row in enumerate([*held, *moved]) if k < 2 or row != held[-1]]


def _later_cycle(source: PiecewiseLinear, delay: float) -> list[list[float]]:
    """Rows of one period, from its last ``delay`` on [s]."""
    period = source.period or 0.0
    begin, end = period - delay, 2 * period - delay
    inner = [
        [t - begin, value] for t, value in source.vertices(3 * period).tolist() if begin < t < end
    ]
    first, last = source.values(np.array([begin, np.nextafter(end, 0.0)])).tolist()
    return [[0.0, first], *inner, [period, last]]
