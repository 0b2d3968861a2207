"""Rows of a measurement as a run follows them: without noise, in few straight pieces, or as is."""

from __future__ import annotations

from typing import Any, get_args

import numpy as np
from pydantic import Field
from pydantic_core import PydanticCustomError

from viscodesign.errors import described
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.spec_part import SpecPart, invalid_at
from viscodesign.scene.tables.noise import white_noise
from viscodesign.scene.tables.smoothing import below_cut_off, without_noise
from viscodesign.scene.tables.straight_pieces import connected, straight_pieces
from viscodesign.units import Frequency, Pressure, QuantityKind, Time

MAX_FOLLOWED = 50_000
"""Rows that a run follows one by one; of more, straight pieces are made."""
BOUND_SHARE = 0.1
"""Pressure that straight pieces may be off, relative to accuracy times the range of the table.

The whole range moves the tip by a length of the actuator or so, so that such an error moves it by a
tenth of the accuracy or so.
"""
NOISE_SHARE = 0.25
"""The same in standard deviations of the noise that was found: below it nothing is known."""
_TIME: QuantityKind = get_args(Time)[1]
_FREQUENCY: QuantityKind = get_args(Frequency)[1]


class MeasuredTable(SpecPart):
    """Where the rows of a table come from; written by the program into a resolved spec."""

    file: str = Field("", description="The file that the rows were read from")
    columns: str = Field("", description="Headers of the columns that were read")
    rows: int = Field(ge=2, description="Rows of the file")
    noise: Pressure | None = Field(
        None, ge=0, description="Root mean square of the noise that was taken out"
    )
    largest: Pressure | None = Field(
        None, ge=0, description="Largest difference between a row of the file and what is followed"
    )

    def sentence(self, followed: int) -> str:
        """What was done to the rows, of which this many are followed."""
        source = f"{self.file}: {self.rows} rows" if self.file else f"{self.rows} rows"
        source += f" of {self.columns}" if self.columns else ""
        if not self.largest:
            return source
        noise = f"noise of {self.noise:.3g} Pa rms taken out, " if self.noise else ""
        return (
            f"{source}; {noise}followed by {followed - 1} straight pieces, at most "
            f"{self.largest:.3g} Pa from any row (smooth: off follows every row)"
        )


@dataclass(frozen=True, eq=False)
class Followed:
    """The rows that a run follows."""

    time: np.ndarray
    value: np.ndarray
    noise: float = 0.0
    """Root mean square of what was taken out."""
    largest: float = 0.0


def cut_off_period(given: Any) -> float | None:
    """The period of a cut-off [s] that `smooth` states; 0 for off, None for auto."""
    if given in (None, "auto"):
        return None
    if given is False or given == "off":
        return 0.0
    if isinstance(given, str):
        for kind in (_TIME, _FREQUENCY):
            try:
                value = kind.parse(given)
            except PydanticCustomError:
                continue
            if value > 0.0 and any(char.isalpha() for char in given):
                return value if kind is _TIME else 1.0 / value
    raise invalid_at(
        "smooth",
        f"must be auto, off, or a cut-off as a time or a frequency, such as '50 ms' or '20 Hz'; "
        f"got {described(given)}",
    )


def followed(time: np.ndarray, value: np.ndarray, smooth: Any, accuracy: float) -> Followed:
    """The rows (n,) to follow at an accuracy of the tip, for a choice of `smooth`.

    ``off``: all. ``auto``: all, unless white noise is found, or they are too many; then straight
    pieces along the rows without it. A cut-off: straight pieces along what is slower.
    """
    period = cut_off_period(smooth)
    noise = white_noise(time, value) if period is None else 0.0
    if period == 0.0 or (period is None and not noise and len(time) <= MAX_FOLLOWED):
        if len(time) > MAX_FOLLOWED:
            raise invalid_at(
                "smooth",
                f"off follows every row, {len(time)} of them; at most {MAX_FOLLOWED} are allowed. "
                "Use smooth: auto or a cut-off",
            )
        return Followed(time, value)
    bound = BOUND_SHARE * accuracy * float(np.ptp(value))
    own_time, own = time, value
    if period:
        own_time, own = below_cut_off(time, value, period)
    elif noise:
        own = without_noise(time, value, noise, bound)
    kept = straight_pieces(own_time, own, max(bound, NOISE_SHARE * noise), MAX_FOLLOWED)
    if len(kept) > MAX_FOLLOWED:
        raise invalid_at(
            "smooth",
            f"more than {MAX_FOLLOWED} straight pieces are needed at this accuracy. Use a larger "
            "accuracy, or smooth: with a lower cut-off",
        )
    found = Followed(own_time[kept], own[kept])
    removed = value - _along(time, found) if period else value - connected(time, own, kept)
    rms = float(np.sqrt(np.mean(removed**2))) if period or noise else 0.0
    return Followed(found.time, found.value, rms, float(np.abs(removed).max()))


def _along(time: np.ndarray, found: Followed) -> np.ndarray:
    return np.asarray(np.interp(time, found.time, found.value))
