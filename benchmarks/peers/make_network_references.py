"""Make the references of the network cases: python benchmarks/peers/make_network_references.py

The chain is linear and symmetric, so its modes are independent: y' = -s y + g p_inlet(t).
Each is carried over an output interval by its exponential and by Gauss-Legendre
quadrature of the convolution integral, on panels short against the fastest mode and the
pulse. Halving the panels moves nothing above 1e-9 of the swing, which is checked here, as
are values that were computed by others' means:

- mode sums in 30 digits of the same chain with air, started from zero, at five times
  (tests/validation/data/network.json, `chain16_air_from_zero`);
- the last bellow at 0.5 s, air, started in equilibrium: 39768.651320 Pa, by
  hypergeometric functions.
"""

from __future__ import annotations

import json
from pathlib import Path

import network
import numpy as np

PANELS = 20
"""Panels of an output interval; the check takes twice as many."""
POINTS = 16
"""Gauss points of a panel."""
ALLOWED = 1e-9
"""Change by halving the panels, over the swing."""
MODE_SUMS = Path(__file__).parents[2] / "tests" / "validation" / "data" / "network.json"
LAST_AT_HALF = 39768.651320
"""Last bellow at 0.5 s, air, from equilibrium [Pa]."""


def main() -> None:
    """Compute, check, store."""
    network.DATA.parent.mkdir(exist_ok=True)
    check_mode_sums()
    stored = {}
    for fluid in network.VISCOSITIES:
        start = network.inlet_pressure(0.0)
        coarse, fine = (pressures(fluid, start, panels) for panels in (PANELS, 2 * PANELS))
        moved = float(np.max(np.abs(fine - coarse))) / network.DROP
        print(f"{fluid}: halving the panels moves {moved:.1e} of the swing")
        assert moved < ALLOWED
        stored[f"network_{fluid}"] = fine
    apart = abs(stored["network_air"][10, -1] - LAST_AT_HALF)
    print(f"air, last bellow at 0.5 s: {apart:.1e} Pa from the value by hypergeometric functions")
    assert apart < 1e-6 * network.DROP
    np.savez_compressed(network.DATA, **stored)


def pressures(fluid: str, start: float, panels: int) -> np.ndarray:
    """Pressures (T, 16) [Pa] from one pressure ``start`` [Pa] in all bellows."""
    a, b = network.rate_matrix(fluid)
    rates, modes = np.linalg.eigh(a)
    drive = modes.T @ b
    y = modes.T @ np.full(network.BELLOWS, start)
    found = [y]
    for begin, end in zip(network.TIMES[:-1], network.TIMES[1:], strict=True):
        y = np.exp(rates * (end - begin)) * y + drive * convolution(rates, begin, end, panels)
        found.append(y)
    return np.array(found) @ modes.T


def convolution(rates: np.ndarray, begin: float, end: float, panels: int) -> np.ndarray:
    """Integrals (16,) of exp(rate (end - t)) p_inlet(t) over begin..end [Pa s]."""
    points, weights = np.polynomial.legendre.leggauss(POINTS)
    width = (end - begin) / panels
    total = np.zeros(len(rates))
    for k in range(panels):
        t = begin + width * (k + (points + 1) / 2)
        inlet = np.array([network.inlet_pressure(float(x)) for x in t])
        total += np.exp(np.outer(rates, end - t)) @ (weights * inlet) * width / 2
    return total


def check_mode_sums() -> None:
    """Compare with the chain started from zero, where an output time is also theirs."""
    theirs = json.loads(MODE_SUMS.read_text())["chain16_air_from_zero"]
    ours = pressures("air", 0.0, PANELS)
    apart = []
    for time, row in zip(theirs["times_s"], theirs["pressure_pa"], strict=True):
        place = round(time / network.INTERVAL)
        if time <= network.DURATION:
            assert abs(network.TIMES[place] - time) < 1e-12
            apart.append(np.max(np.abs(ours[place] - np.array(row, dtype=float))))
    print(f"air from zero, {len(apart)} times: {max(apart):.1e} Pa from mode sums in 30 digits")
    assert max(apart) < 1e-6 * network.DROP


if __name__ == "__main__":
    main()
