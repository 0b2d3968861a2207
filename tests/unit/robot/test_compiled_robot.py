"""A robot compiled to a function: values, derivatives of its stance, refusals."""

from __future__ import annotations

import pickle

import numpy as np
import pytest

from tests.robots import hexapod
from viscodesign import CompiledRobot, SpecError, compile, stand
from viscodesign.errors import SolveError

SHIFT = 1e-3
WORST = 1e-6
"""Of the largest derivative of an output, scaled by the numbers."""
FREE = (
    *("robot.payload", "gauge_pressure", "robot.legs.LF.lean", "robot.legs.RM.splay"),
    *("robot.foot.radius", "robot.centre_of_mass.x", "actuators.leg.actuator.youngs_modulus"),
    *("actuators.leg.bellows.extension_per_pressure", "robot.ground.slope"),
)
OUTPUTS = (
    *("height_m", "pitch_rad", "roll_rad", "tip_stiffness_n_per_m"),
    *("LF.tip_x_m", "RM.tip_z_m", "LR.normal_force_n"),
)
UNEVEN = ("robot.payload=100 g", "robot.centre_of_mass.x=10 mm", "robot.ground.slope=2 deg")


@pytest.fixture(scope="module")
def function() -> CompiledRobot:
    return compile(hexapod(*UNEVEN), FREE, OUTPUTS)


def test_derivatives_are_those_of_differences(function: CompiledRobot) -> None:
    slopes, own = function.jacobian(), function.values
    for output in OUTPUTS:
        assert slopes[output].shape == own.shape
    scales = np.abs(own)
    for k, name in enumerate(function.names):
        step = SHIFT * scales[k]
        at = {n: function(own + n * step * np.eye(len(own))[k]) for n in (-2, -1, 1, 2)}
        for output in OUTPUTS:
            near = (at[1][output] - at[-1][output]) / (2 * step)
            far = (at[2][output] - at[-2][output]) / (4 * step)
            off = scales[k] * abs((4 * near - far) / 3 - slopes[output][k])
            assert off <= WORST * np.max(np.abs(scales * slopes[output])), (output, name)


def test_values_are_those_of_a_stance(function: CompiledRobot) -> None:
    own, found = stand(hexapod(*UNEVEN)).own, function()
    for name in OUTPUTS[:4]:
        assert found[name] == pytest.approx(getattr(own, name), rel=1e-9)
    weights = {"height_m": 2.0, "LF.tip_x_m": -3.0}
    slopes = function.jacobian()
    wanted = 2 * slopes["height_m"] - 3 * slopes["LF.tip_x_m"]
    assert function.vjp(None, weights) == pytest.approx(wanted)
    again = pickle.loads(pickle.dumps(function))
    assert again() == found
    rows = function.batch([function.values, [9.0, *function.values[1:]]])
    assert rows["height_m"][0] == found["height_m"]
    assert np.isnan(rows["height_m"][1])
    assert "sways on its legs" in rows.status[1]


def test_what_has_no_derivative_is_told() -> None:
    function = compile(hexapod(), ["robot.payload"], ["sway_limit_n", "advance_per_cycle_m"])
    with pytest.raises(SpecError, match="sway_limit_n: has no derivative: it is found to a thou"):
        function.jacobian()
    limit = compile(hexapod(), ["robot.payload"], ["sway_limit_n"])
    assert limit()["sway_limit_n"] == pytest.approx(stand(hexapod()).own.sway_limit_n)


@pytest.mark.parametrize(
    ("free", "output", "told"),
    [
        ("robot.payload", "heigth_m", "did you mean 'height_m'"),
        ("robot.payloads", "height_m", "did you mean 'robot.payload'"),
        ("robot.stiff_sections", "height_m", "not a number"),
        ("accuracy", "height_m", "how finely"),
    ],
)
def test_what_cannot_be_is_told(free: str, output: str, told: str) -> None:
    with pytest.raises(SpecError, match=told):
        compile(hexapod(), [free], [output])


def test_values_out_of_range_are_told() -> None:
    function = compile(hexapod(), ["robot.payload"], ["height_m"])
    with pytest.raises(SpecError, match=r"robot.payload: must be at least 0 kg; got -1 kg"):
        function([-1.0])
    with pytest.raises(SolveError, match="sways on its legs at the spec's gauge pressure"):
        function([9.0])
