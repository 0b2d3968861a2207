"""Work of forces along paths at the boundary of the model, and its rate where one is known.

The rate of a path is known where it depends on states and time alone. Otherwise, where the
force does, the work is integrated by parts: force times path at the ends, minus the integral
of the path over the force. The rest has no rate, and is summed over the solved times.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass

SX = ca.SX

FORCE_AND_PATH = {
    "pump": ("specific_work", "stored"),
    "plunger": ("plunger_pressure", "pushed"),
    "coupling": ("unpaired_volume", "pressure"),
    "carried": ("carried_energy", "stored"),
    "contact": ("contact_force", "contact_path"),
}
"""Works by name: the outputs whose product force times d(path) they sum."""
WITHOUT_RATES = frozenset({"contact"})
"""Works whose forces may change at any time, although no equation tells how."""


@dataclass(frozen=True)
class WorkSplit:
    """How the parts of one work are integrated."""

    by_parts: np.ndarray
    """(n,) where the work needs force times path at the ends of every smooth stretch."""
    sampled: np.ndarray
    """(n,) where no rate is known, so that it is summed over samples."""


@dataclass(frozen=True)
class MotionRates:
    """Rates of change along the motion: of the unknowns, only states have known ones."""

    time: SX
    states: SX
    algebraics: SX
    ode: SX

    def rate(self, value: SX) -> SX:
        """Rate of change of a quantity that depends on states and time alone."""
        return ca.jacobian(value, self.time) + ca.jtimes(value, self.states, self.ode)

    def has_rate(self, values: SX) -> np.ndarray:
        """Which of them (n,) depend on states and time alone."""
        rows, _ = ca.jacobian(values, self.algebraics).sparsity().get_triplet()
        return ~np.isin(np.arange(values.numel()), rows)


def works_and_splits(
    motion: MotionRates, outputs: Mapping[str, SX], names: list[str]
) -> tuple[dict[str, SX], dict[str, WorkSplit]]:
    """Rates [W] of the named works, as far as they have any, and how all are integrated."""
    rates, splits = {}, {}
    for name in names:
        force, path = (outputs[value] for value in FORCE_AND_PATH[name])
        if not force.numel():
            continue
        direct = motion.has_rate(path)
        by_parts = motion.has_rate(force) & ~direct & (name not in WITHOUT_RATES)
        if not motion.states.numel():
            # No integrator: what depends on time alone has integrals all the same.
            direct, by_parts = direct & motion.has_rate(force), np.zeros_like(by_parts)
        rates[name] = _chosen(force * motion.rate(path), direct) - _chosen(
            path * motion.rate(force), by_parts
        )
        splits[name] = WorkSplit(by_parts, ~(direct | by_parts))
    return rates, splits


def _chosen(values: SX, which: np.ndarray) -> SX:
    """Sum of some of them."""
    return ca.sum1(values[np.flatnonzero(which).tolist()]) if which.any() else SX(0)
