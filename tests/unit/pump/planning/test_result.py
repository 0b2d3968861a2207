"""What a plan says of itself."""

from __future__ import annotations

import numpy as np

from tests.plans import made_plan
from viscodesign.pump.profile import Profile


def test_a_plan_names_the_limits_that_forbid_it() -> None:
    profile = Profile(("inlet",), (1,), np.array([0.0, 1.0]), np.zeros((2, 1)), np.zeros((2, 1)))
    assert repr(made_plan(profile)) == "<PumpPlan leg: complete, feasible, 1 s>"
    forbidden = repr(made_plan(profile, feasible=False))
    assert forbidden == "<PumpPlan leg: complete, infeasible (pressure), 1 s>"
