"""Work of forces along paths: which a run has, and its rate where one is known.

The rate of a path is known where it depends on states and time alone. Else, where the force
does, the work is taken by parts: force times path at the ends, less the path's integral over
the force. What is left has no rate, and is summed over the solved times.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca
import numpy as np

SX = ca.SX

FORCE_AND_PATH = {
    "pump": ("specific_work", "stored"),
    "plunger": ("plunger_pressure", "pushed"),
    "coupling": ("unpaired_volume", "pressure"),
    "carried": ("carried_energy", "stored"),
}
"""Works by name: the outputs whose product force times d(path) they sum."""


@dataclass(frozen=True)
class Way:
    """How the parts of one work are integrated."""

    by_parts: np.ndarray
    """(n,) where the integral needs force times path at the ends of every smooth stretch."""
    sampled: np.ndarray
    """(n,) where there is no rate at all."""


@dataclass(frozen=True)
class Clock:
    """What moves with time: of the unknowns, the states alone have rates."""

    time: SX
    states: SX
    algebraics: SX
    ode: SX

    def rate(self, value: SX) -> SX:
        """Along the motion, of what depends on states and time."""
        return ca.jacobian(value, self.time) + ca.jtimes(value, self.states, self.ode)

    def tells(self, values: SX) -> np.ndarray:
        """Which of them (n,) depend on nothing but states and time."""
        rows, _ = ca.jacobian(values, self.algebraics).sparsity().get_triplet()
        return ~np.isin(np.arange(values.numel()), rows)


def rates_and_ways(
    clock: Clock, outputs: Mapping[str, SX], names: list[str]
) -> tuple[dict[str, SX], dict[str, Way]]:
    """Rates [W] of the named works, as far as they have any, and how all are integrated."""
    rates, ways = {}, {}
    for name in names:
        force, path = (outputs[value] for value in FORCE_AND_PATH[name])
        if not force.numel():
            continue
        direct = clock.tells(path)
        by_parts = clock.tells(force) & ~direct
        if not clock.states.numel():
            # No integrator: what depends on time alone has integrals all the same.
            direct, by_parts = direct & clock.tells(force), np.zeros_like(by_parts)
        rates[name] = _chosen(force * clock.rate(path), direct) - _chosen(
            path * clock.rate(force), by_parts
        )
        ways[name] = Way(by_parts, ~(direct | by_parts))
    return rates, ways


def _chosen(values: SX, which: np.ndarray) -> SX:
    """Sum of some of them."""
    return ca.sum1(values[np.flatnonzero(which).tolist()]) if which.any() else SX(0)
