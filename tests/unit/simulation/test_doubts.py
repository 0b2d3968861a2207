"""A motion that is smaller than its stated error is told, once."""

from __future__ import annotations

import pytest

from tests.scenes import leg
from viscodesign import Trajectory, simulate

SINE = "input={{kind: sine, amplitude: {}, frequency: 0.5 Hz}}"
AUTO = "effects=auto"
RUN = "run={duration: 4 s, output_interval: 0.1 s}"
SAG = "loads.gravity={acceleration: 9.81, tilt: 90 deg}"


def told(found: Trajectory) -> list[str]:
    assert found.status == "complete"
    return [n.code for n in found.warnings if n.code in {"unresolved_motion", "uncertain_flows"}]


@pytest.mark.parametrize("amplitude", ["80 Pa", "1 mPa", "1 nPa"])
@pytest.mark.parametrize("load", ["loads.gravity=off", SAG], ids=["hanging", "sagging"])
def test_a_small_input_is_not_resolved_and_says_so(amplitude: str, load: str) -> None:
    """A shape that gravity bends hides nothing: what the input does counts."""
    found = simulate(leg(SINE.format(amplitude), RUN, load, AUTO))
    assert told(found) == ["unresolved_motion"]


def test_the_accuracy_that_it_names_resolves_it() -> None:
    found = simulate(leg(SINE.format("80 Pa"), RUN, AUTO))
    (notice,) = (n for n in found.warnings if n.code == "unresolved_motion")
    percent = notice.message.partition("set `accuracy` to ")[2].partition(" or less")[0]
    finer = simulate(leg(SINE.format("80 Pa"), RUN, AUTO, f"accuracy={percent}"))
    assert told(finer) == []
    assert finer.accuracy.estimated_tip_error_m is not None
    # To first order the tip moves by 1.87e-6 m/Pa across.
    across = 80 * 1.87e-6
    assert abs(finer.tip[:, 0]).max() == pytest.approx(across, rel=0.05)


@pytest.mark.parametrize("amplitude", [1e-3, 1e-9, 1e-12])
def test_next_to_nothing_still_moves_in_proportion(amplitude: float) -> None:
    """With all effects: pressures far below the round-off of a volume have a scale of their own."""
    found = simulate(leg(SINE.format(f"{amplitude} Pa"), RUN))
    assert told(found) == ["unresolved_motion"]
    assert abs(found.tip[:, 0]).max() == pytest.approx(1.88e-6 * amplitude, rel=0.01, abs=1e-16)


@pytest.mark.parametrize(
    "changes",
    [
        (SINE.format("10 kPa"),),
        ("input={kind: constant, value: 10 kPa}",),
        ("input={kind: constant, value: 0}",),
        ("input={kind: constant, value: 0}", SAG),
    ],
    ids=["a motion", "a steady shape", "nothing", "weight alone"],
)
def test_what_moves_enough_or_not_at_all_is_no_matter(changes: tuple[str, ...]) -> None:
    assert "unresolved_motion" not in told(simulate(leg(*changes, RUN, AUTO)))
