"""How many ticks a second the link to a pump can hold, measured before anything moves."""

from __future__ import annotations

import math
from collections.abc import Callable
from statistics import median

from viscodesign.errors import PumpError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.bus.clock import Clock

ROUNDS = 12  # of reading that are timed
LOWEST_RATE = 10.0  # slower ticks would take longer than a silence may last [Hz]
HIGHEST_RATE = 100.0  # [Hz]


@dataclass(frozen=True)
class RoundTrip:
    """Time to read everything once: all axes, sensors and limit switches."""

    median: float
    """[s]"""
    worst: float
    """[s]"""

    def __str__(self) -> str:
        return f"{1e3 * self.median:.0f} ms (worst {1e3 * self.worst:.0f} ms)"


def measure_round_trip(read: Callable[[], object], clock: Clock) -> RoundTrip:
    """Time what every tick reads, such as `Pump.look`; moves nothing."""
    times = []
    for _ in range(ROUNDS):
        began = clock.now()
        read()
        times.append(clock.now() - began)
    return RoundTrip(median(times), max(times))


def sustainable_rate(requested: float, trip: RoundTrip, share: float = 0.8) -> tuple[float, str]:
    """Rate to stream at [Hz], and a note for the user where it is not the ``requested`` one.

    ``share`` of a tick that reading may take; the rest is left for sending and recording.

    Raises `PumpError` where the link does not even hold `LOWEST_RATE`.
    """
    if requested * trip.median <= share:
        return requested, ""
    rate = float(math.floor(share / trip.median))
    if rate < LOWEST_RATE:
        raise PumpError(
            f"reading the pump once takes {trip}, too long for {LOWEST_RATE:g} set-points a "
            "second; lower the adapter's latency: `viscodesign pump ports` says how"
        )
    return rate, (
        f"rate lowered from {requested:g} to {rate:g} Hz: reading the pump once takes {trip}; "
        "a lower adapter latency allows more (see `viscodesign pump ports`)"
    )
