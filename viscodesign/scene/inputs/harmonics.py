"""`kind: harmonics`."""

from __future__ import annotations

import math
from typing import Any, ClassVar, Literal

import numpy as np
from pydantic import Field, model_validator

from viscodesign.scene.inputs.base import SmoothInput, points_of, shortest_swing
from viscodesign.scene.spec_part import copied, invalid_at
from viscodesign.units import Pressure, PressureLevel, Time

MAX_HARMONICS = 12
"""Number of harmonics that every input carries, so that one set of equations serves them all."""
SWING_SAMPLES = 64
"""Samples of the highest harmonic's period, between which swings are sought."""


class HarmonicsInput(SmoothInput):
    r"""A sum of harmonics of one period.

    .. math:: p(t) = m + \sum_k a_k \cos(2 \pi k t / T) + b_k \sin(2 \pi k t / T)
    """

    name: ClassVar[str] = "harmonics"
    coefficients: ClassVar[int] = 2 + 2 * MAX_HARMONICS
    kind: Literal["harmonics"]
    cycle: Time = Field(alias="period", gt=0, description="Period of the first harmonic")
    mean: PressureLevel = Field(0.0, description="Mean gauge pressure above the baseline")
    cosine: tuple[Pressure, ...] = Field(
        (), description="Amplitudes of the cosines, from the first harmonic on"
    )
    sine: tuple[Pressure, ...] = Field((), description="Amplitudes of the sines likewise")

    @model_validator(mode="after")
    def _check_counts(self) -> HarmonicsInput:
        for key, own in (("cosine", self.cosine), ("sine", self.sine)):
            if len(own) > MAX_HARMONICS:
                raise invalid_at(key, f"at most {MAX_HARMONICS} harmonics; got {len(own)}")
        if not self.cosine and not self.sine:
            raise invalid_at("cosine", "missing, and sine is, too; give at least one amplitude")
        return self

    @property
    def period(self) -> float:
        return self.cycle

    @classmethod
    def expression(cls, t: Any, piece: Any, functions: Any) -> Any:
        """By rotation from one harmonic to the next, with one sine and one cosine."""
        turn = piece[1] * t
        c, s = functions.cos(turn), functions.sin(turn)
        found, ck, sk = piece[0], c, s
        for k in range(MAX_HARMONICS):
            found = found + piece[2 + k] * ck + piece[2 + MAX_HARMONICS + k] * sk
            ck, sk = ck * c - sk * s, sk * c + ck * s
        return found

    def numbers(self) -> tuple[float, ...]:
        """Mean, angular frequency [rad/s], cosines, sines; those that are not given are 0."""
        return (
            self.mean,
            2 * math.pi / self.cycle,
            *self.cosine,
            *(0.0,) * (MAX_HARMONICS - len(self.cosine)),
            *self.sine,
            *(0.0,) * (MAX_HARMONICS - len(self.sine)),
        )

    def later(self, delay: float) -> HarmonicsInput:
        count = max(len(self.cosine), len(self.sine))
        turn = 2 * math.pi * delay / self.cycle * np.arange(1, count + 1)
        cosine, sine = (own[:count] for own in self._amplitudes())
        found = (
            cosine * np.cos(turn) - sine * np.sin(turn),
            sine * np.cos(turn) + cosine * np.sin(turn),
        )
        names = ("cosine", "sine")
        return copied(
            self, {name: tuple(own.tolist()) for name, own in zip(names, found, strict=True)}
        )

    def corners(self, duration: float) -> list[float]:
        return []

    def extremes(self, duration: float) -> tuple[float, float]:
        """Where the slope is zero within the run, and at its ends."""
        turns = self._level_turns()
        if duration < self.cycle:
            turns = turns[turns * self.cycle < duration]
        times = np.array([0.0, min(duration, self.cycle), *(turns * self.cycle)])
        found = self.values(np.append(times, duration))
        return float(found.min()), float(found.max())

    def steepest(self) -> float:
        """Largest slope of any sign [Pa/s]."""
        turn = 2 * math.pi / self.cycle
        orders = np.arange(1, MAX_HARMONICS + 1) * turn
        cosine, sine = self._amplitudes()
        slope = self.model_copy(
            update={"mean": 0.0, "cosine": tuple(orders * sine), "sine": tuple(-orders * cosine)}
        )
        return max(map(abs, slope.extremes(self.cycle)))

    def swing_time(self) -> float:
        count = SWING_SAMPLES * max(len(self.cosine), len(self.sine), 1)
        time = np.unique(np.append(np.arange(count + 1) / count, self._level_turns()))
        time = np.concatenate([time[:-1], 1.0 + time]) * self.cycle
        profile = points_of(np.column_stack([time, self.values(time)]))
        return shortest_swing(profile) if np.ptp([p for _, p in profile]) > 0.0 else math.inf

    def _amplitudes(self) -> tuple[np.ndarray, np.ndarray]:
        """(MAX_HARMONICS,) of cosines and of sines."""
        own = np.array(self.numbers()[2:])
        return own[:MAX_HARMONICS], own[MAX_HARMONICS:]

    def _level_turns(self) -> np.ndarray:
        """Parts of a period at which the slope is zero, in [0, 1).

        With w = exp(i 2 pi t/T) the slope is a polynomial in w over a power of it; its roots on
        the unit circle are sought, and those near it do no harm as candidates.
        """
        cosine, sine = self._amplitudes()
        orders = np.arange(1, MAX_HARMONICS + 1)
        half = orders * (sine + 1j * cosine) / 2
        used = np.flatnonzero(np.abs(half) > 1e-14 * np.abs(half).max(initial=0.0))
        if not used.size:
            return np.zeros(0)
        half = half[: used[-1] + 1]
        roots = np.roots([*np.conj(half[::-1]), 0.0, *half][::-1])
        near = roots[np.abs(np.abs(roots) - 1.0) < 1e-3]
        return np.asarray((np.angle(near) / (2 * math.pi)) % 1.0)
