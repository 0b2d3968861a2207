"""A small, independent network of bellows and tubes to compare the package with.

Nothing of the package is used: nodes store what a function of their pressure says, tubes
let through what a function of the two end pressures says, `scipy` integrates.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import scipy.linalg
from scipy.integrate import solve_ivp

Law = Callable[[np.ndarray], np.ndarray]
Source = Callable[[float], float]

LENGTH = 0.018
"""Length of a bellow along the flow [m]."""
COMPLIANCE = LENGTH * 3.413e-9
"""Compliance C of a bellow of the paper's leg [m3/Pa]."""
REST_VOLUME = 0.010 * 0.012 * LENGTH
RADIUS = 3.25e-4
TUBE = 0.0375
AMBIENT = 101325.0
MODULUS = 1.8e6
INLET = -1
"""Index of the inlet among the ends of tubes."""


def resistance(viscosity: float, length: float = TUBE, radius: float = RADIUS) -> float:
    """Hagen-Poiseuille [Pa s/m3]."""
    return 8 * viscosity * length / (np.pi * radius**4)


def only(*effects: str) -> str:
    """Override that includes the network, the named effects, and nothing else."""
    named = ", ".join(f"{name}: on" for name in ("pressure_distribution", *effects))
    return f"effects={{{named}, others: off}}"


def outputs(times: np.ndarray, start: str = "equilibrium") -> str:
    """Override of a run with outputs at ``times``."""
    return f"run={{duration: {float(times[-1])!r}, start: {start}, output_times: {times.tolist()}}}"


def sine(mean: float, amplitude: float, frequency: float) -> tuple[str, Source]:
    """Override of the input, and the same as a function of time; it starts at its minimum."""
    words = f"input={{kind: sine, mean: {mean!r}, amplitude: {amplitude!r}, "
    words += f"frequency: {frequency!r}, phase: {-np.pi / 2!r}}}"
    return words, lambda t: mean - amplitude * np.cos(2 * np.pi * frequency * t)


@dataclass(frozen=True)
class Network:
    """Nodes 0..n-1 that store fluid; tubes (start, end), `INLET` for the source."""

    tubes: Sequence[tuple[int, int]]
    stiffness: Law
    """Pressures (n,) [Pa] -> d(stored)/dp (n,) [m3/Pa]."""
    flow: Callable[[np.ndarray, np.ndarray], np.ndarray]
    """Pressures (Q,) at the tubes' starts and ends [Pa] -> flows (Q,) [m3/s]."""

    def rates(self, pressure: np.ndarray, inlet: float) -> np.ndarray:
        """dp/dt of every node [Pa/s]."""
        every = np.append(pressure, inlet)  # the inlet is the last one, -1
        start, end = np.array(self.tubes).T
        flow = self.flow(every[start], every[end])
        inflow = np.zeros(len(every))
        np.add.at(inflow, end, flow)
        np.subtract.at(inflow, start, flow)
        return np.asarray(inflow[:-1] / self.stiffness(pressure))

    def follow(self, inlet: Source, start: np.ndarray, times: np.ndarray) -> np.ndarray:
        """Pressures (T, n) [Pa] at ``times`` from ``start`` (n,) at t = 0."""
        found = solve_ivp(
            lambda t, p: self.rates(p, inlet(t)),
            (0.0, times[-1]),
            start,
            method="Radau",
            t_eval=times,
            rtol=1e-8,
            atol=1e-5,
        )
        assert found.success, found.message
        return np.asarray(found.y.T)


def chain(count: int) -> list[tuple[int, int]]:
    """Tubes of inlet, 0, 1, ... in a row."""
    return [(k - 1 if k else INLET, k) for k in range(count)]


def step_response(
    rate: np.ndarray, drive: np.ndarray, times: np.ndarray, start: np.ndarray | None = None
) -> np.ndarray:
    """y' = rate y + drive from ``start`` or zero, at ``times``, by the matrix exponential."""
    steady = -np.linalg.solve(rate, drive)
    away = (0.0 if start is None else start) - steady
    return np.array([steady + scipy.linalg.expm(rate * t) @ away for t in times])


def worst(found: np.ndarray, expected: np.ndarray) -> float:
    """Largest difference, relative to the swing of the expected values."""
    return float(np.max(np.abs(found - expected)) / np.ptp(expected))


def columns(count: int, left: str, right: str) -> tuple[str, ...]:
    """Overrides: one inlet for all left bellows, another for all right ones."""
    tubes = ", ".join(
        f"{{from: {inlet}, to: {inlet[0].upper()}{j + 1}}}"
        for inlet in ("left", "right")
        for j in range(count // 2)
    )
    return (
        f"bellows.count={count}",
        f"network={{layout: custom, tube_radius: {RADIUS}, tube_length: {TUBE}, tubes: [{tubes}]}}",
        "input=null",
        f"inputs={{left: {left}, right: {right}}}",
    )


def two_columns(count: int, left: float, right: float) -> tuple[str, ...]:
    """Overrides: every left bellow at one steady pressure, every right one at another."""
    steady = [f"{{kind: constant, value: {pressure!r}}}" for pressure in (left, right)]
    return (*columns(count, *steady), "run={duration: 0.1 s}")


def arc_tip(angle: float, length: float) -> tuple[float, float, float]:
    """Tip (x, z, angle) of an axis of ``length`` [m] that is one arc of ``angle`` [rad]."""
    half = angle / 2
    chord = length * np.sinc(half / np.pi)
    return float(chord * np.sin(half)), float(chord * np.cos(half)), angle
