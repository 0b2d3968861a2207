"""Random inputs of every kind."""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from typing import Any

from tests.fuzz.random_numbers import chance_of, share

Spec = dict[str, Any]
Maker = Callable[[Random, float, float, float], Spec]
"""Of one kind of input, from the time it takes [s] and two pressures [Pa]."""


def source(rng: Random, duration: float, *, syringe: bool) -> Spec:
    """One input; a plunger only where ``syringe`` allows one."""
    high, low = share(rng, -8e4, 1e5), share(rng, -5e4, 5e4)
    time = duration * 10 ** rng.uniform(-1.3, 0.5)
    kinds = [*KINDS, _syringe] if syringe else KINDS
    found = rng.choice(kinds)(rng, time, high, low)
    if chance_of(rng, 0.05):
        found["transient_time"] = time
    return found


def _constant(rng: Random, time: float, high: float, low: float) -> Spec:
    return {"kind": "constant", "value": high}


def _step(rng: Random, time: float, high: float, low: float) -> Spec:
    return {"kind": "step", "value": high, "time": rng.choice([0.0, 0.3 * time, time])}


def _sine(rng: Random, time: float, high: float, low: float) -> Spec:
    phase = share(rng, -6.3, 6.3)
    return {
        "kind": "sine", "amplitude": high, "mean": low / 2, "frequency": 1 / time, "phase": phase
    }  # fmt: skip


def _square(rng: Random, time: float, high: float, low: float) -> Spec:
    return {
        "kind": "square",
        "high": max(high, low),
        "low": min(high, low),
        "frequency": 1 / time,
        "duty": rng.uniform(0.01, 0.99),
    }


def _trapezoid(rng: Random, time: float, high: float, low: float) -> Spec:
    parts = {key: time * rng.choice([0.0, 0.1, 0.5]) for key in ("rise", "hold", "fall", "rest")}
    return {"kind": "trapezoid", "high": high, "low": low, **parts, "fall": time / 4}


def _double_sigmoid(rng: Random, time: float, high: float, low: float) -> Spec:
    return {
        "kind": "double_sigmoid",
        "start": low,
        "drop": high,
        "fall_time": time / 4,
        "rise_time": time * rng.choice([0.0, 0.3, 1.0]),
        "transition": time / rng.choice([4, 40, 4000]),
    }


def _table(rng: Random, time: float, high: float, low: float) -> Spec:
    """Rows that wander, jump, and may lie so close that they nearly do."""
    now, rows = rng.choice([0.0, time / 10]), []
    for k in range(rng.choice([2, 3, 10, 40])):
        rows.append([now, rng.uniform(min(low, high), max(low, high))])
        jumps = k % 2 == 1 and chance_of(rng, 0.2)
        now += 0.0 if jumps else time * rng.choice([0.01, 0.1, 0.3, 1e-6])
    return {"kind": "table", "rows": rows}


def _syringe(rng: Random, time: float, high: float, low: float) -> Spec:
    found: Spec = {"kind": "syringe", "diameter": 0.02, "start": rng.choice([0.01, 0.05])}
    if chance_of(rng, 0.3):
        found["dead_volume"] = rng.choice([1e-6, 1e-5])
    if chance_of(rng, 0.5):
        return {**found, "rows": [[0.0, 0.0], [time, rng.uniform(-0.005, 0.009)]]}
    speed = rng.uniform(-0.005, 0.008) / time
    return {**found, "speeds": [[0.0, speed], [time, 0.0]]}


KINDS: list[Maker] = [_constant, _step, _sine, _square, _trapezoid, _double_sigmoid, _table]
