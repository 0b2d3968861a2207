"""The outcome of a plan, as lines of text."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tests.plans import made_plan
from viscodesign.cli.texts.plan_text import _outcome
from viscodesign.pump.profile import Profile
from viscodesign.results.findings import Notice


def test_a_plan_states_no_error_bare_where_a_run_leaves_its_model() -> None:
    profile = Profile(("inlet",), (1,), np.array([0.0, 1.0]), np.zeros((2, 1)), np.zeros((2, 1)))
    plan = replace(made_plan(profile), limits={"battery_life_s": 1e9})
    (inside,) = (line for line in _outcome(plan) if "errors of both runs" in line)
    assert "does not hold" not in inside
    left = replace(plan.wanted_run, violations=(Notice("choking", "too fast", "inlet", 0.5),))
    (outside,) = (
        line for line in _outcome(replace(plan, wanted_run=left)) if "errors of both runs" in line
    )
    assert outside == f"{inside}, of a model that does not hold here"
