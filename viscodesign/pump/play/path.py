"""The way from where the plungers are to the profile, and along it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from viscodesign.pump.profile import Profile

LEAD_SPEED = 50.0
"""On the way to a start or back [counts/s]: 3.8 mm/s, half a minute for the whole rack."""
AROUND = 0.1
"""A plunger may be this much earlier or later than its course [s]."""
SHORTEST = 0.1
"""Of such a way [s]."""


@dataclass(frozen=True)
class TargetPath:
    """Set-points against time from the first tick on; S servos."""

    profile: Profile
    begins: float
    """Where the planned profile begins, from the first tick [s]."""
    zero: float
    """Where the scene's own time begins, from the first tick [s]."""

    @property
    def duration(self) -> float:
        """Way to the profile included [s]."""
        return self.profile.duration

    def goals(self, elapsed: float) -> np.ndarray:
        """(S,) counts, not rounded."""
        return self.profile.at(elapsed)

    def wanted(self, elapsed: float) -> tuple[float | None, ...]:
        """(S,) gauge pressure that the model expects [Pa]; None on the way to the profile."""
        profile = self.profile
        if elapsed < self.begins:
            return (None,) * len(profile.inlets)
        return tuple(float(np.interp(elapsed, profile.time, p)) for p in profile.pressure.T)

    def paces(self, elapsed: float) -> dict[int, float]:
        """By servo, the steepest that its course is about this moment [counts/s]."""
        time = self.profile.time
        first = max(int(np.searchsorted(time, elapsed - AROUND, "right")) - 1, 0)
        last = int(np.searchsorted(time, elapsed + AROUND, "left"))
        steepest = self._steepness[first:last].max(axis=0, initial=0.0)
        return dict(zip(self.profile.servos, steepest.tolist(), strict=True))

    @cached_property
    def _steepness(self) -> np.ndarray:
        """(T - 1, S) between two instants each [counts/s]."""
        rise: np.ndarray = np.abs(np.diff(self.profile.counts, axis=0))
        return rise / np.diff(self.profile.time)[:, None]

    @cached_property
    def top_speed(self) -> float:
        """Of its steepest part [counts/s]."""
        return top_speed(self.profile)

    def reach(self, seconds: float) -> int:
        """Largest step in a time, rounded up and one more for rounding [counts]."""
        return math.ceil(self.top_speed * seconds) + 1


def top_speed(profile: Profile) -> float:
    """Of a profile's steepest part [counts/s]."""
    rise = np.abs(np.diff(profile.counts, axis=0)).max(axis=1, initial=0.0)
    return float((rise / np.diff(profile.time)).max(initial=0.0))


def led_in(profile: Profile, present: Mapping[int, int], lead: float = 0.0) -> TargetPath:
    """A profile behind a slow way to its first counts.

    ``present``: position of each servo [counts]; ``lead``: part of the profile that lies before
    the scene's own start [s].
    """
    here = np.array([float(present[servo]) for servo in profile.servos])
    way = float(np.max(np.abs(profile.counts[0] - here), initial=0.0)) / LEAD_SPEED
    # Not at once even where it is there already: times have to rise.
    begins = max(way, SHORTEST)
    joined = Profile(
        inlets=profile.inlets,
        servos=profile.servos,
        time=np.concatenate(([0.0], profile.time + begins)),
        counts=np.concatenate((here[None], profile.counts)),
        pressure=np.concatenate((profile.pressure[:1], profile.pressure)),
    )
    return TargetPath(joined, begins, begins + lead)


def way_back(profile: Profile, goals: Mapping[int, int], home: int) -> TargetPath:
    """Slowly from the goals in force to home; no pressure is expected on the way."""
    servos = profile.servos
    here = np.array([float(goals[servo]) for servo in servos])
    there = np.full(len(servos), float(home))
    way = max(float(np.max(np.abs(there - here))) / LEAD_SPEED, SHORTEST)
    counts, none = np.stack((here, there)), np.zeros((2, len(servos)))
    back = Profile(profile.inlets, servos, np.array([0.0, way]), counts, none)
    return TargetPath(back, math.inf, math.inf)
