"""What a dissipation has to be for forces to follow from it: quadratic in the rod's rates."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

from viscodesign.model.system import System

DECADES = 2.0
"""Rates are from 1 down to this many decades below [m/s], [rad/s]."""
REL_TOLERANCE = 1e-6


def is_quadratic(system: System, powers: Sequence[ca.SX]) -> bool:
    r"""Whether a sum of powers [W] is homogeneous of degree 2 in the rod's rates.

    .. math:: P(2 v) = 4 P(v)

    Exactly then is half its gradient a force whose power is P, by Euler's theorem on
    homogeneous functions. Compared at random rates, the same in every run, with the scene's
    own parameters; where a power has no finite value, nothing is concluded.
    """
    symbols, numbers = system.parameters()
    rod = system.rod
    known = [ca.vertcat(rod.rates, rod.section_rates, rod.strain_rates), symbols]
    terms = ca.vertcat(*powers)
    free = ca.vertcat(*ca.Function("powers", known, [terms], {"allow_free": True}).free_sx())
    function = ca.Function("powers", [*known, free], [terms])
    random, count = np.random.default_rng(1), known[0].numel()
    others = random.uniform(0.5, 1.0, free.numel())
    rates = random.choice([-1.0, 1.0], count) * 10.0 ** -random.uniform(0.0, DECADES, count)
    once, twice = (
        float(np.sum(function(speeds, numbers, others).full())) for speeds in (rates, 2 * rates)
    )
    is_other = abs(twice - 4 * once) > REL_TOLERANCE * max(abs(twice), abs(4 * once))
    return not is_other
