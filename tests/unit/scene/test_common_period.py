"""When all inputs of a scene repeat together."""

from __future__ import annotations

import pytest

from tests.scenes import leg
from viscodesign import simulate

SINE = "{kind: sine, amplitude: 10 kPa, frequency: 0.5 Hz}"
FASTER = "{kind: sine, amplitude: 10 kPa, frequency: 0.75 Hz}"
UNRELATED = "{kind: sine, amplitude: 10 kPa, frequency: 0.7320508 Hz}"
SQUARE = "{kind: square, high: 10 kPa, low: 0 Pa, frequency: 2 Hz}"
CONSTANT = "{kind: constant, value: 5 kPa}"
STEP = "{kind: step, value: 5 kPa, time: 1 s}"


@pytest.mark.parametrize(
    ("left", "right", "period"),
    [
        (SINE, SINE, 2.0),
        (SINE, SQUARE, 2.0),
        (SINE, FASTER, 4.0),
        (SINE, CONSTANT, 2.0),
        (SINE, STEP, None),
        (SINE, UNRELATED, None),
        (CONSTANT, CONSTANT, None),
    ],
)
def test_of_two_inlets(left: str, right: str, period: float | None) -> None:
    inputs = f"inputs={{left: {left}, right: {right}}}"
    found = leg(inputs, config="antagonistic_two_inlets").period
    assert found == (None if period is None else pytest.approx(period, rel=1e-12))


def test_a_run_knows_the_period_of_its_inputs() -> None:
    run = simulate(
        leg("bellows.count=4", f"input={SINE}", "run={duration: 5 s, output_interval: 50 ms}"),
        verify=False,
    )
    assert run.period == 2.0
    # The last period, after a transient from a rest that is no part of it.
    last = run.tip[run.time >= 3.0 - 1e-9]
    assert run.metrics["loop_width_m"] == pytest.approx(last[:, 0].max() - last[:, 0].min())
    assert run.metrics["loop_width_m"] < run.tip[:, 0].max() - run.tip[:, 0].min()
