"""How far a fit is off, in counts, volume and pressure, and how far it may be."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from pydantic_core import PydanticCustomError

from viscodesign.errors import PumpError, UsageError
from viscodesign.pump.poses.fit import PoseFit
from viscodesign.units import QuantityKind

_PRESSURE = QuantityKind("pressure", "Pa", "1 kPa")
_VOLUME = QuantityKind("volume", "m^3", "0.1 mL")


@dataclass(frozen=True)
class FitError:
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
        """Of a fit; ``volume_per_count`` [m3].

        ``pressure_per_count`` (P,) [Pa], of the barrels at their stiffest.
        """
        largest = np.max(np.abs(fit.error), axis=0)
        counts = float(np.max(largest))
        pressure = float(np.max(largest * np.asarray(pressure_per_count)))
        return cls(counts, counts * volume_per_count, pressure)

    def __str__(self) -> str:
        return (
            f"{self.counts:.2f} counts, {1e6 * self.volume:.3g} mL, "
            f"up to {self.pressure / 1e3:.3g} kPa"
        )


@dataclass(frozen=True)
class Tolerance:
    """The largest error that may be played; exactly one of three."""

    text: str
    counts: float | None = None
    volume: float | None = None
    """[m3]"""
    pressure: float | None = None
    """[Pa]"""

    @classmethod
    def of(cls, text: str) -> Tolerance:
        """Read '1 kPa', '0.1 mL' or '2 counts'."""
        number, _, word = text.strip().rpartition(" ")
        if word in ("count", "counts"):
            return cls(text, counts=_positive(text, _number(number, text)))
        try:
            if _is_volume(text):
                return cls(text, volume=_positive(text, _VOLUME.parse(text)))
            return cls(text, pressure=_positive(text, _PRESSURE.parse(text)))
        except PydanticCustomError:
            raise _unread(text) from None

    def allows(self, error: FitError) -> bool:
        """Whether a fit may be played."""
        pairs = (
            (self.counts, error.counts),
            (self.volume, error.volume),
            (self.pressure, error.pressure),
        )
        return all(allowed is None or found <= allowed for allowed, found in pairs)


def _is_volume(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        pass
    else:
        raise _unread(text)
    try:
        _VOLUME.parse(text)
    except PydanticCustomError:
        return False
    return True


def _number(text: str, whole: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise _unread(whole) from None


def _positive(text: str, value: float) -> float:
    if not value > 0.0:
        raise _unread(text)
    return value


def _unread(text: str) -> UsageError:
    return UsageError(
        f"--tolerance {text!r}; give a pressure, a volume or counts above zero, with the unit: "
        "'1 kPa', '0.1 mL' or '2 counts'"
    )


def refuse_coarse(fit: PoseFit, error: FitError, tolerance: Tolerance) -> None:
    """Raise `PumpError` where a fit is farther off than it may be, with what would help."""
    if tolerance.allows(error):
        return
    number = len(fit.sequence.moves), len(fit.sequence.poses)
    raise PumpError(
        f"the closest that 46 moves and 30 poses come to the profile is {error}; --tolerance is "
        f"{tolerance.text} (the fit has {number[0]} moves, {number[1]} poses). "
        f"{_remedy(fit)}"
    )


def _remedy(fit: PoseFit) -> str:
    gap = float(np.max(np.abs(fit.wanted[-1] - fit.wanted[0])))
    if fit.looped and gap > 1.0:
        return (
            f"The profile ends {gap:.1f} counts from where it begins, so it cannot go round: make "
            "run.duration whole cycles of the input, and long enough for the pressures inside to "
            "settle; or leave --loop out"
        )
    shorter = "slow the input down" if fit.looped else "--loop one cycle of it, slow it down"
    return f"`pump stream` has no such limits; else {shorter}, or allow more by --tolerance"
