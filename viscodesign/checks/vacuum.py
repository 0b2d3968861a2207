"""Absolute pressures of zero or less, at which no fluid is."""

from __future__ import annotations

from collections.abc import Iterator

from viscodesign.errors import Fault


def vacuum_faults(
    key: str, gauge: float, ambient: float, *, varies: bool = False, file: str = ""
) -> Iterator[Fault]:
    """A fault where the pressure of a key is zero absolute or less, or not a number.

    ``gauge``: that pressure, the lowest one if it ``varies`` [Pa]; ``ambient``: absolute [Pa];
    ``file``: of the spec.
    """
    absolute = ambient + gauge
    if absolute > 0.0:
        return
    stated = f"{gauge / 1e3:.6g} kPa gauge at an ambient_pressure of {ambient / 1e3:.6g} kPa"
    subject = f"the lowest pressure, {stated}," if varies else stated
    likely = ", or an amplitude too large" if varies else ", or a gauge pressure as absolute"
    message = (
        f"{subject} is {absolute / 1e3:.4g} kPa absolute; must be above 0. Is an absolute pressure "
        f"written as gauge{likely}?"
    )
    yield Fault(message, key, file)
