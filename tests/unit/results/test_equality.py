"""Results with arrays are themselves alone: comparing them never raises."""

from __future__ import annotations

from tests.scenes import leg
from viscodesign import compile as compiled
from viscodesign import simulate

SHORT = (
    "bellows.count=2",
    "run={duration: 0.2 s, output_interval: 0.1 s}",
    "effects={others: off}",
)


def test_trajectories_compare_and_hash() -> None:
    scene = leg(*SHORT)
    one, other = (simulate(scene, verify=False) for _ in range(2))
    assert one == one
    assert one != other
    assert one in [other, one]
    assert len({one, other}) == 2


def test_batches_compare() -> None:
    function = compiled(leg(*SHORT), free=["actuator.youngs_modulus"], outputs=["tip_x_m"])
    one, other = (function.batch([[1.8e6], [2e6]]) for _ in range(2))
    assert (one == one, one == other) == (True, False)
