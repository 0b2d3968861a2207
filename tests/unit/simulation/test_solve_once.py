"""How far two solutions are apart."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np

from tests.scenes import leg
from viscodesign import simulate
from viscodesign.simulation.doubts import FLOW_ERROR_WARNED, uncertain_flows
from viscodesign.simulation.solve_once import FlowDifference, flow_difference


def motion(flow: list[list[float]]) -> Any:
    return SimpleNamespace(flow=np.array(flow))


def test_flows_differ_by_a_share_of_the_largest() -> None:
    coarse = motion([[0.0, 0.0], [2.0, -3.0], [9.0, 9.0]])
    fine = motion([[0.0, 0.1], [2.0, -4.0]])
    assert flow_difference(coarse, fine) == FlowDifference(0.25, tube=1, row=1)


def test_no_flow_has_no_difference() -> None:
    still = motion([[0.0], [0.0]])
    assert flow_difference(still, still) is None


def test_uncertain_flows_are_reported_with_size_and_place() -> None:
    run = simulate(leg("bellows.count=4", "run={duration: 0.2 s}"), verify=False)
    verifier: Any = SimpleNamespace(flows_apart=FlowDifference(2.1 * FLOW_ERROR_WARNED, 1, 3))
    (notice,) = uncertain_flows(run, verifier)
    assert notice.code == "uncertain_flows"
    assert notice.where == run.tubes[1]
    assert notice.time_s == run.time[3]
    assert "2.1 % of the peak flow" in notice.message
    verifier.flows_apart = FlowDifference(1.9 * FLOW_ERROR_WARNED, 1, 3)
    assert not list(uncertain_flows(run, verifier))
    # A finer solution that ended before that output is told of by itself.
    verifier.flows_apart = FlowDifference(2.1 * FLOW_ERROR_WARNED, 1, len(run.time))
    assert not list(uncertain_flows(run, verifier))
