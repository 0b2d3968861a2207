"""Several actuators compiled to a function: values, derivatives, what is solved together."""

from __future__ import annotations

import pickle
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from tests.coupled_specs import FLOW_ALONE, LEFT, SINE, SYRINGE, coupled_spec, on_one_syringe
from viscodesign import compile, load_several, simulate_several
from viscodesign.compiled.several import CompiledActuators
from viscodesign.errors import SpecError

ANY_ERROR = 1e30
"""Tolerance at which the sizes of steps depend on the times alone: differences are smooth."""
SHIFT = 1e-3
WORST = 1e-6
"""Of the largest derivative of an output, scaled by the numbers; differences are of order four."""


def spec(**changes: Any) -> dict[str, Any]:
    """Actuators on two pressures, the second of which is the first, later; none shares fluid."""
    found = coupled_spec(
        actuators={
            "left": {**LEFT, "source": "A"},
            "twin": {"like": "left"},
            "late": {"like": "left", "source": "B", "loads": {"payload": "5 g"}},
        },
        inputs={"A": SINE, "B": {"as": "A", "delay": "0.3 s"}},
        effects=FLOW_ALONE,
        **changes,
    )
    del found["tubes"]
    return found


def worst(function: CompiledActuators) -> dict[tuple[str, str], float]:
    """How far derivatives are from differences, by output and number, over the output's largest."""
    found, slopes, own = {}, function.jacobian(), function.values
    for k, name in enumerate(function.names):
        step = SHIFT * abs(own[k])
        at = {n: function(own + n * step * np.eye(len(own))[k]) for n in (-2, -1, 1, 2)}
        for output in function.outputs:
            near = (np.asarray(at[1][output]) - at[-1][output]) / (2 * step)
            far = (np.asarray(at[2][output]) - at[-2][output]) / (4 * step)
            off = np.max(np.abs((4 * near - far) / 3 - slopes[output][..., k])) * abs(own[k])
            found[output, name] = float(off / np.max(np.abs(slopes[output] * own)))
    return found


@pytest.mark.parametrize(
    ("given", "free", "outputs"),
    [
        (
            coupled_spec(),
            ("actuators.left.bellows.height", "tubes[T-right.inlet].length", "inputs.A.amplitude",
             "actuators.right.network.tube_radius", "actuators.right.actuator.youngs_modulus",
             "gauge_pressure"),
            ("left.tip_x_m", "right.tip_z_m", "left.inlet_pressure_pa", "right.path_length_m"),
        ),
        (
            on_one_syringe(effects=FLOW_ALONE),
            ("inputs.A.diameter", "actuators.right.network.tubes[R1-L1].length"),
            ("left.m1_x_m", "right.tip_angle_rad", "inlet_pressure_A_pa"),
        ),
        (
            spec(),
            ("inputs.A.frequency", "inputs.B.delay", "actuators.left.network.tube_length"),
            ("left.tip_x_m", "late.tip_x_m", "late.loop_area_m2"),
        ),
        (
            spec() | {"inputs": {"A": SYRINGE},
                      "actuators": {"left": {**LEFT, "source": "A"}, "twin": {"like": "left"}}},
            ("inputs.A.diameter", "actuators.left.bellows.area_per_pressure"),
            ("twin.tip_x_m", "left.inlet_pressure_pa"),
        ),
    ],
    ids=["tee", "unequal on a syringe", "later", "equal on a syringe"],
)  # fmt: skip
def test_derivatives_are_those_of_differences(
    given: dict[str, Any],
    free: Sequence[str],
    outputs: Sequence[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("viscodesign.compiled.function.LARGEST_TOLERANCE", 2 * ANY_ERROR)
    function = compile(load_several(given), free, outputs, tolerance=ANY_ERROR)
    found = worst(function)
    assert max(found.values()) < WORST, {k: v for k, v in found.items() if v >= WORST}
    chance, slopes = np.random.default_rng(1), function.jacobian()
    weights = {n: chance.standard_normal(np.shape(v)) for n, v in function().items()}
    by_hand = sum(np.tensordot(w, slopes[n], w.ndim) for n, w in weights.items())
    assert function.vjp(None, weights) == pytest.approx(by_hand, rel=1e-9)


def test_values_are_those_of_a_simulation() -> None:
    scene = load_several(coupled_spec(effects=FLOW_ALONE, accuracy="0.001 %"))
    outputs = (
        *("left.tip_x_m", "right.tip_angle_rad", "right.pressure_R1_pa", "left.flow_R1-R2_m3_s"),
        *("left.inlet_pressure_pa", "junction_pressure_T_pa", "flow_T-right.inlet_m3_s"),
    )
    found = compile(scene, ["gauge_pressure"], [*outputs, "left.path_length_m"])()
    runs = simulate_several(scene, verify=False)
    names, table = runs.table()
    for name in outputs:
        wanted = table[:, names.index(name)]
        # The first step follows from rates that are round-off, and with it all others.
        assert found[name] == pytest.approx(wanted, abs=1e-6 * np.max(np.abs(wanted)))
    assert found["left.path_length_m"] == pytest.approx(runs["left"].metrics["path_length_m"])


def test_equal_actuators_are_solved_once() -> None:
    outputs = ["left.tip_x_m", "twin.tip_x_m"]
    function = compile(load_several(spec()), ["inputs.A.amplitude"], outputs)
    assert len(function.effects) == 1
    found = function.batch([[9e3], [-11e3], [np.nan]])
    assert found.status[0] == "complete"
    assert "finite" in found.status[2]
    assert np.array_equal(found["left.tip_x_m"][:2], found["twin.tip_x_m"][:2])
    assert np.all(np.isnan(found["left.tip_x_m"][2]))
    again = pickle.loads(pickle.dumps(function))
    assert np.array_equal(again([9e3])["twin.tip_x_m"], found["twin.tip_x_m"][0])
    assert function.scene([9e3]).inputs["A"].amplitude == 9e3
    assert all(own.suits for own in function.judge([9e3]).values())


@pytest.mark.parametrize(
    ("changes", "free", "outputs", "told"),
    [
        ({}, "actuators.twin.bellows.height", "left.tip_x_m", "is like 'left'"),
        ({}, "actuators.left.bellows.hight", "left.tip_x_m", "did you mean"),
        ({}, "inputs.A.amplitude", "tip_x_m", "not an output of several actuators"),
        ({}, "inputs.A.amplitude", "left.tip_y_m", "tip_x_m"),
        ({}, "actuators.left.source", "left.tip_x_m", "not a number"),
        ({}, "inputs.B.delay", "left.tip_x_m", "none of the outputs depends on it"),
        ({}, "accuracy", "left.tip_x_m", "how finely"),
        (
            {"inputs": {"A": SYRINGE}, "actuators": {n: {**LEFT, "source": "A"} for n in "ab"}},
            "actuators.a.bellows.height", "a.tip_x_m", "make them differ",
        ),
    ],
)  # fmt: skip
def test_what_cannot_be_is_told(
    changes: dict[str, Any], free: str, outputs: str, told: str
) -> None:
    with pytest.raises(SpecError, match=told):
        compile(load_several(spec() | changes), free, outputs)
