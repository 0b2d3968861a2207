"""How far a fit is off, in counts, volume and pressure, and how far it may be."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from viscodesign.errors import PumpError, UsageError
from viscodesign.pump.poses.engine import MAX_MOVES, MAX_POSES
from viscodesign.pump.poses.fit import PoseFit
from viscodesign.units import QuantityKind


class FitError(NamedTuple):
    """Largest errors of a fit, of any plunger at any time."""

    counts: float
    volume: float
    """[m3]"""
    pressure: float
    """[Pa]; as a quick error makes it, before the network takes part of it."""

    @classmethod
    def of(
        cls, fit: PoseFit, volume_per_count: float, pressure_per_count: Sequence[float]
    ) -> FitError:
        """``volume_per_count`` [m3]; ``pressure_per_count`` (P,) [Pa] at the barrels' stiffest."""
        largest = np.max(np.abs(fit.error), axis=0)
        counts = float(np.max(largest))
        pressure = float(np.max(largest * np.asarray(pressure_per_count)))
        return cls(counts, counts * volume_per_count, pressure)

    def __str__(self) -> str:
        return (
            f"{self.counts:.2f} counts, {1e6 * self.volume:.3g} mL, "
            f"up to {self.pressure / 1e3:.3g} kPa"
        )


class Tolerance(NamedTuple):
    """The largest error that may be played."""

    text: str
    quantity: str
    """A field of `FitError`."""
    value: float

    @classmethod
    def of(cls, text: str) -> Tolerance:
        """Read '1 kPa', '0.1 mL' or '2 counts'; `UsageError` where it is none."""
        for quantity, read in _READERS.items():
            with contextlib.suppress(ValueError):
                value = read(text)
                # A bare number has no unit, so it is no quantity here.
                if value > 0.0 and not text.strip()[-1].isdigit():
                    return cls(text, quantity, value)
        raise UsageError(
            f"tolerance {text!r}: expected a pressure, a volume or counts above zero, with the "
            "unit: '1 kPa', '0.1 mL' or '2 counts'"
        )

    def refuse(self, fit: PoseFit, error: FitError) -> None:
        """Raise `PumpError` where a fit is farther off than allowed, with what would help."""
        if getattr(error, self.quantity) <= self.value:
            return
        moves, poses = len(fit.sequence.moves), len(fit.sequence.poses)
        raise PumpError(
            f"the best fit with {MAX_MOVES} moves and {MAX_POSES} poses is off by {error} (it "
            f"uses {moves} and {poses}); the tolerance is {self.text}. {_remedy(fit)}"
        )


def _counts(text: str) -> float:
    number, _, unit = text.strip().rpartition(" ")
    if unit not in ("count", "counts"):
        raise ValueError(unit)
    return float(number)


_READERS: dict[str, Callable[[str], float]] = {
    "counts": _counts,
    "volume": QuantityKind("volume", "m^3", "0.1 mL").parse,
    "pressure": QuantityKind("pressure", "Pa", "1 kPa").parse,
}


def _remedy(fit: PoseFit) -> str:
    gap = float(np.max(np.abs(fit.requested[-1] - fit.requested[0])))
    if fit.looped and gap > 1.0:
        return (
            f"The profile ends {gap:.1f} counts from where it begins, so it cannot be looped: "
            "make run.duration whole cycles of the input, and long enough for the pressures "
            "inside to settle; or do not loop it"
        )
    shorter = "slow the input down" if fit.looped else "loop one cycle of it, slow it down"
    return f"`pump stream` has no such limits; or {shorter}, or allow a larger tolerance"
