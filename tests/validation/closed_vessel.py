"""A plunger on a closed vessel of barrel and bellows, computed independently of the package."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from tests.validation.rc_network import AMBIENT, COMPLIANCE, REST_VOLUME, resistance

DIAMETER, START, DEAD = 0.0349, 0.05, 5e-6
AREA = np.pi * DIAMETER**2 / 4
VISCOSITY, STIFF = 5e-4, 2e9
COUNT = 4
Ratio = Callable[[float], float]
"""Density relative to that at ambient pressure, as a function of gauge pressure."""


def gas(exponent: float) -> tuple[str, Ratio]:
    words = f"fluid={{name: thick gas, viscosity: {VISCOSITY}, density: 1.2, "
    words += f"gas_constant: 287.05, polytropic_exponent: {exponent!r}}}"
    return words, lambda p: (1 + p / AMBIENT) ** (1 / exponent)


def liquid() -> tuple[str, Ratio]:
    words = f"fluid={{name: thick liquid, viscosity: {VISCOSITY}, density: 900, "
    return words + f"bulk_modulus: {STIFF}}}", lambda p: 1 + p / STIFF


def syringe(plan: str) -> str:
    barrel = f"diameter: {DIAMETER}, start: {START}, dead_volume: {DEAD}"
    return f"input={{kind: syringe, {barrel}, {plan}}}"


def steady_pressure(
    pushed: float, ratio: Ratio, network_ratio: Ratio, baseline: float = 0.0
) -> float:
    """The whole vessel at one pressure: the amount in barrel and bellows is constant."""
    full = AREA * START + DEAD

    def held(p: float, out: float) -> float:
        bellows = COUNT * (REST_VOLUME + COMPLIANCE * p) * network_ratio(p)
        return (full - out) * ratio(p) + bellows

    filled = held(baseline, 0.0)
    return float(brentq(lambda p: held(p, pushed) - filled, -5e4, 5e5, xtol=1e-9, rtol=1e-14))


def stiff(p: float) -> float:
    """Density of an incompressible network."""
    del p
    return 1.0


def reference(
    place: Callable[[float], float],
    corners: list[float],
    times: np.ndarray,
    ratio: Ratio,
    compressible: bool,
) -> np.ndarray:
    """Pressures (T, 1 + bellows) of barrel and chain; ``place`` is the plunger's position.

    States are what barrel and bellows hold; a pressure is found from each by bracketing.
    """
    full = AREA * START + DEAD
    conductance = 1 / resistance(VISCOSITY)
    network = ratio if compressible else stiff

    def pressures(held: np.ndarray, pushed: float) -> np.ndarray:
        barrel = brentq(lambda p: (full - pushed) * ratio(p) / held[0] - 1, -9e4, 1e6, xtol=1e-8)
        if not compressible:
            return np.append(barrel, (held[1:] - REST_VOLUME) / COMPLIANCE)
        own = [
            brentq(
                lambda p, s=s: (REST_VOLUME + COMPLIANCE * p) * network(p) / s - 1,
                -3e4,
                1e6,
                xtol=1e-8,
            )
            for s in held[1:]
        ]
        return np.array([barrel, *own])

    def potential(p: np.ndarray) -> np.ndarray:
        if not compressible:
            return p
        return np.asarray(((AMBIENT + p) ** 2 - AMBIENT**2) / (2 * AMBIENT))  # n = 1 alone

    def rate(t: float, held: np.ndarray) -> np.ndarray:
        # Scaled by the rest volume, so that one tolerance fits all.
        p = pressures(held * REST_VOLUME, AREA * place(t))
        flow = -np.diff(potential(p)) * conductance
        return np.diff(np.concatenate([[0.0], flow, [0.0]])) / -REST_VOLUME

    held = np.append(full, np.full(COUNT, REST_VOLUME)) / REST_VOLUME
    found = []
    edges = [0.0, *corners, float(times[-1])]
    for k, (begin, end) in enumerate(itertools.pairwise(edges)):
        inside = times[(times > begin) & (times <= end)] if k else times[times <= end]
        solved = solve_ivp(
            rate,
            (begin, end),
            held,
            method="LSODA",
            t_eval=[*inside[:-1], end],
            rtol=1e-10,
            atol=1e-12,
        )
        assert solved.success, solved.message
        assert inside[-1] == end
        found += [
            pressures(y * REST_VOLUME, AREA * place(t))
            for t, y in zip(solved.t, solved.y.T, strict=True)
        ]
        held = solved.y[:, -1]
    return np.array(found)
