"""A scene compiled to a function: values, derivatives, batches, refusals."""

from __future__ import annotations

import pickle
import threading
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from tests.scenes import leg
from viscodesign import Scene, compile, simulate
from viscodesign.compiled.function import CompiledFunction
from viscodesign.errors import SolveError, SpecError
from viscodesign.native.machine import SWITCH
from viscodesign.native.unavailable import NativeUnavailable
from viscodesign.results.channels import trajectory_columns

SHORT = "run={duration: 1 s, output_interval: 20 ms}"
FREE = ("network.tube_radius", "actuator.youngs_modulus", "input.drop", "input.fall_time")
TIP = ("tip_x_m", "tip_z_m")
ROUND_OFF = 1e-9
"""Of the actuator's length; the start is found from another guess."""


@pytest.fixture(scope="module")
def function() -> CompiledFunction:
    return compile(leg(SHORT), FREE, [*TIP, "pressure_L1_pa", "loop_area_m2", "column_lag_s"])


def test_values_are_those_of_a_simulation(function: CompiledFunction) -> None:
    names, columns = trajectory_columns(simulate(leg(SHORT), verify=False))
    found = function()
    for name in (*TIP, "pressure_L1_pa"):
        wanted = columns[:, names.index(name)]
        assert found[name] == pytest.approx(wanted, abs=ROUND_OFF * np.max(np.abs(wanted)))
    metrics = simulate(leg(SHORT), verify=False).metrics
    assert found["loop_area_m2"] == pytest.approx(metrics["loop_area_m2"], rel=1e-6)


def test_other_values_are_those_of_the_changed_scene(function: CompiledFunction) -> None:
    values = function.values * [1.1, 0.9, 1.05, 1.2]
    scene = leg(SHORT, *(f"{k}={v!r}" for k, v in zip(FREE, values.tolist(), strict=True)))
    names, columns = trajectory_columns(simulate(scene, verify=False))
    found = function(dict(zip(FREE, values.tolist(), strict=True)))
    for name in TIP:
        # Scalings and the longest step stay as they were.
        assert found[name] == pytest.approx(columns[:, names.index(name)], abs=0.002 * 0.109)


def test_the_gradient_is_the_jacobian_weighted(function: CompiledFunction) -> None:
    chance, values = np.random.default_rng(3), function.values * 1.02
    weights = {
        "tip_x_m": chance.standard_normal(len(function.times)),
        "pressure_L1_pa": 1e-5 * chance.standard_normal(len(function.times)),
        "loop_area_m2": 300.0,
        "column_lag_s": 0.5,
    }
    slopes = function.jacobian(values)
    wanted = sum(np.asarray(weights[name]) @ slopes[name] if name.endswith(("x_m", "pa"))
                 else weights[name] * slopes[name] for name in weights)  # fmt: skip
    assert function.vjp(values, weights) == pytest.approx(wanted, rel=1e-8)


def test_slopes_by_keys_are_those_of_differences() -> None:
    tight = compile(leg(SHORT), FREE, ["tip_x_m"], tolerance=1e-9)
    slopes, values = tight.jacobian()["tip_x_m"], tight.values
    for k, value in enumerate(values):
        change = np.zeros(len(values))
        change[k] = 1e-3 * value
        near, far = (
            tight(values + n * change)["tip_x_m"] - tight(values - n * change)["tip_x_m"]
            for n in (1, 2)
        )
        largest = np.max(np.abs(slopes[:, k]))
        wanted = (8 * near - far) / (12 * change[k])
        assert slopes[:, k] == pytest.approx(wanted, abs=1e-5 * largest)


def test_metrics_follow_the_period_of_the_input() -> None:
    wave = "input={kind: sine, amplitude: 20 kPa, frequency: 1.1}"
    scene = leg("run={duration: 2 s, output_interval: 20 ms}", wave)
    loop = compile(scene, ["input.frequency"], ["loop_area_m2", "column_lag_s"], tolerance=1e-8)
    slopes, value = loop.jacobian(), loop.values
    for name in loop.outputs:
        near, far = (loop(value + n * 1e-4)[name] - loop(value - n * 1e-4)[name] for n in (1, 2))
        assert slopes[name] == pytest.approx([(8 * near - far) / 12e-4], rel=1e-4)
        assert loop.vjp(None, {name: 1.0}) == pytest.approx(slopes[name], rel=1e-8)


def test_a_rod_without_inertia_has_derivatives() -> None:
    scene = leg(SHORT, "effects={inertia: off, others: auto}", config="horizontal_payload")
    loaded = compile(scene, ["loads.payload"], TIP, tolerance=1e-8)
    slopes, value = loaded.jacobian(), loaded.values
    for name in TIP:
        apart = loaded(value * 1.001)[name] - loaded(value * 0.999)[name]
        largest = np.max(np.abs(slopes[name]))
        assert slopes[name][:, 0] == pytest.approx(apart / (2e-3 * value), abs=1e-6 * largest)
    weights = {name: np.ones(len(loaded.times)) for name in TIP}
    wanted = sum(np.sum(slopes[name], axis=0) for name in TIP)
    assert loaded.vjp(None, weights) == pytest.approx(wanted, rel=1e-9)


def test_rest_is_at_the_baseline_of_the_values() -> None:
    run = "run={duration: 0.3 s, output_interval: 20 ms, start: rest}"
    alone = "effects={pressure_distribution: on, others: off}"
    scene = leg(run, alone, "gauge_pressure=2 kPa", config="leg_4_air")
    found = compile(scene, ["gauge_pressure"], ["pressure_R1_pa"])([5e3])["pressure_R1_pa"]
    names, columns = trajectory_columns(
        simulate(scene.replace({"gauge_pressure": 5e3}), verify=False)
    )
    assert found[0] == pytest.approx(5e3)
    assert found == pytest.approx(columns[:, names.index("pressure_R1_pa")], rel=1e-4)


def test_equilibria_have_derivatives() -> None:
    still = compile(leg(config="steady_left_auto"), ["actuator.youngs_modulus"], TIP)
    slopes, value = still.jacobian(), still.values
    for name in TIP:
        apart = still(value * 1.0001)[name] - still(value * 0.9999)[name]
        assert slopes[name][:, 0] == pytest.approx(apart / (2e-4 * value), rel=1e-5)
    weights = {name: np.ones(len(still.times)) for name in TIP}
    wanted = sum(np.sum(slopes[name], axis=0) for name in TIP)
    assert still.vjp(None, weights) == pytest.approx(wanted, rel=1e-9)


def test_a_batch_names_rows_that_fail(function: CompiledFunction) -> None:
    values = function.values
    batch = function.batch([values, -values, values * 1.01], workers=2)
    assert [status == "complete" for status in batch.status] == [True, False, True]
    assert "network.tube_radius" in batch.status[1]
    assert np.all(np.isnan(batch["tip_x_m"][1]))
    assert np.isnan(batch["loop_area_m2"][1])
    assert np.array_equal(batch["tip_x_m"][0], function(values)["tip_x_m"])


def test_rows_are_solved_together_as_each_alone(function: CompiledFunction) -> None:
    """One of them has corners in another order, one ends, one is out of range."""
    spread = np.linspace(0.98, 1.03, 5)[:, None] * np.ones(4)
    odd = [[1.0, 1.0, 0.1, 1.0], [1.0, 1e-3, 1.0, 1.0], [1.0, -1.0, 1.0, 1.0]]
    rows = function.values * np.concatenate([spread, odd])
    together = [columns is not None for columns in function._solved_together(rows)]
    assert together[:5] == [True] * 5
    assert together[-2:] == [False] * 2
    batch = function.batch(rows)
    for k, row in enumerate(rows):
        if batch.status[k] == "complete":
            alone = function(row)
            assert all(np.array_equal(batch[name][k], alone[name]) for name in alone)
        else:
            assert np.all(np.isnan(batch["tip_x_m"][k]))
            with pytest.raises((SolveError, SpecError)) as failure:
                function(row)
            assert str(failure.value) == batch.status[k]
    assert batch.status[-1] != "complete"


def test_an_empty_batch_has_no_rows(function: CompiledFunction) -> None:
    batch = function.batch([])
    assert batch.status == []
    assert len(batch["tip_x_m"]) == 0


def test_answers_are_the_callers_own(function: CompiledFunction) -> None:
    wanted = function()["tip_z_m"].copy()
    function()["tip_z_m"][:] = 0.0
    function.jacobian()["tip_z_m"][:] = 0.0
    assert np.array_equal(function()["tip_z_m"], wanted)


def test_labels_tell_values_apart(function: CompiledFunction) -> None:
    values = pd.Series(function.values * [1.1, 0.9, 1.0, 1.0], index=FREE)
    shuffled = values.iloc[[3, 1, 0, 2]]
    wanted = function(values.to_numpy())["tip_x_m"]
    assert np.array_equal(function(shuffled)["tip_x_m"], wanted)
    batch = function.batch(pd.DataFrame([values, shuffled]))
    assert np.array_equal(batch["tip_x_m"][1], wanted)


def test_slopes_without_a_period_stay_where_they_can() -> None:
    scene = leg("run={duration: 0.5 s, output_interval: 20 ms}", config="antagonistic_two_inlets")
    both = compile(scene, ["inputs.right.frequency"], ["tip_x_m", "tip_x_max_m"])
    assert np.all(np.isfinite(both.jacobian()["tip_x_max_m"]))
    assert np.all(np.isfinite(both.vjp(None, {"tip_x_m": np.ones(len(both.times))})))
    begun = both.begin()
    assert begun.outputs["tip_x_m"] == pytest.approx(0.0, abs=1e-9)


def test_threads_and_copies_give_the_same_bits(function: CompiledFunction) -> None:
    rows = [function.values * (1 + 0.01 * k) for k in range(6)]
    wanted = [function(row)["tip_x_m"] for row in rows]
    copy = pickle.loads(pickle.dumps(function))
    found: dict[int, np.ndarray] = {}

    def run(k: int) -> None:
        found[k] = (copy if k % 2 else function)(rows[k])["tip_x_m"]

    threads = [threading.Thread(target=run, args=(k,)) for k in range(len(rows))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(found[k], own) for k, own in enumerate(wanted))


def test_a_control_loop_goes_the_way_of_a_table(tmp_path: Path) -> None:
    pressures = [10e3 + 2e3 * k for k in range(10)]
    rows = [(0.05 * (k + late), p) for k, p in enumerate(pressures) for late in (0, 1)]
    table = tmp_path / "steps.csv"
    table.write_text("time_s,pressure_pa\n" + "".join(f"{t},{p}\n" for t, p in rows))
    run = "run={duration: 0.5 s, output_interval: 50 ms}"
    steps = leg(run, f"input={{kind: table, file: {table}}}")
    wanted = simulate(steps, verify=False, tolerance=1e-6).tip
    loop = compile(steps, ["network.tube_radius"], TIP, tolerance=1e-6)
    state = loop.begin(inlets=pressures[0])
    assert state.outputs["tip_z_m"] == pytest.approx(wanted[0, 1], abs=1e-9)
    for k, pressure in enumerate(pressures):
        state = loop.step(state, 0.05, pressure)
        assert state.time == pytest.approx(0.05 * (k + 1))
        assert state.outputs["tip_x_m"] == pytest.approx(wanted[k + 1, 0], abs=1e-5 * 0.109)
        assert state.outputs["inlet_pressure_pa"] == pytest.approx(pressure)
    with pytest.raises(SpecError, match=r"did you mean 'inlet'"):
        loop.step(state, 0.05, {"inlett": 1e3})
    with pytest.raises(SpecError, match="dt: must be a positive number"):
        loop.step(state, 0.0, 1e3)


def test_a_section_pressed_to_nothing_ends_a_run() -> None:
    scene = leg(SHORT, "input={kind: constant, value: 0 kPa}")
    pressed = compile(scene, ["input.value"], TIP)
    with pytest.raises(SolveError, match="section"):
        pressed([-400e3])


def test_effects_are_weighed_again() -> None:
    scene = leg(SHORT, "input.drop=10 kPa", config="leg_16_straight_air_auto")
    gentle = compile(scene, ["input.drop", "network.tube_radius"], TIP)
    assert gentle.judge().suits
    assert {v.name for v in gentle.judge().verdicts} > gentle.effects
    wild = gentle.judge([141.3e3, 1e-3])
    assert wild.missing or wild.unneeded
    assert not set(wild.missing) & gentle.effects


def test_wrong_words_are_told(function: CompiledFunction) -> None:
    with pytest.raises(SpecError, match=r"tip_y_m.*did you mean 'tip_[xz]_m'"):
        compile(leg(SHORT), FREE, ["tip_y_m"])
    with pytest.raises(SpecError, match="name at least one"):
        compile(leg(SHORT), FREE, [])
    with pytest.raises(SpecError, match=r"tube_radii.*did you mean"):
        function({"network.tube_radii": 1e-3})
    with pytest.raises(SpecError, match="expected 4 values"):
        function([1.0])
    with pytest.raises(SpecError, match="must be numbers"):
        function(["a", "b", "c", "d"])
    with pytest.raises(SpecError, match="free: name at least one"):
        compile(leg(SHORT), [3], TIP)  # type: ignore[list-item]
    with pytest.raises(SpecError, match="scene: needs a scene"):
        compile("leg.yaml", FREE, TIP)  # type: ignore[arg-type]
    for tolerance in (-1.0, 0.0, float("nan"), 2.0):
        with pytest.raises(SpecError, match="tolerance: must be above 0"):
            compile(leg(SHORT), FREE, TIP, tolerance=tolerance)
    for weights in ({"tip_x_m": np.ones(3)}, {"tip_x_m": "a"}, None, [1.0]):
        with pytest.raises(SpecError, match="weights"):
            function.vjp(None, weights)  # type: ignore[arg-type]
    for values in (function.values + 1e-20j, function.values[:, None]):
        with pytest.raises(SpecError, match=r"values: must be (real|one number)"):
            function(values)
    with pytest.raises(SpecError, match="workers: must be a whole number of at least 1"):
        function.batch([function.values], workers=0)
    with pytest.raises(SpecError, match="edges_per_section: must be a whole number from 1 to 64"):
        compile(leg(SHORT), FREE, TIP, edges_per_section=2.5)  # type: ignore[arg-type]
    with pytest.raises(SpecError, match="tolerance: must be above 0"):
        compile(leg(SHORT), FREE, TIP, tolerance="x")  # type: ignore[arg-type]


def test_a_failing_solution_raises() -> None:
    with pytest.raises(SolveError, match="limit of steps"):
        compile(leg("run.max_steps=100"), ["input.fall_time"], TIP)


def collapsing(fraction: float) -> Scene:
    """A leg of four bellows of gas that all but collapse."""
    return leg(
        "bellows.count=4",
        "input={kind: double_sigmoid, start: 20 kPa, drop: 60 kPa, fall_time: 0.5 s, "
        "rise_time: 2 s, transition: 0.1 s}",
        "run={duration: 3 s, output_interval: 50 ms}",
        "effects={pressure_distribution: on, feedback: on, collapse: on, others: off}",
        f"bellows.collapse_fraction={fraction}",
    )


def test_where_its_steps_stop_another_solver_goes_on() -> None:
    scene = collapsing(1e-3)
    function = compile(scene, ["bellows.collapse_fraction"], TIP)
    run = simulate(scene, verify=False)
    assert function()["tip_x_m"] == pytest.approx(run.tip[:, 0], abs=1e-6)
    with pytest.raises(NativeUnavailable, match="steps became too small"):
        function.jacobian()


def test_a_start_without_unknowns_is_told() -> None:
    function = compile(collapsing(0.1), ["bellows.collapse_fraction"], TIP)
    with pytest.raises(SolveError, match="no pressures and forces are consistent with the state"):
        function([0.0])
    assert "no pressures" in function.batch([[0.1], [0.0]]).status[1]


def test_a_batch_is_a_mapping(function: CompiledFunction) -> None:
    found = function.batch([function.values])
    assert list(found) == list(function.outputs)
    assert dict(found).keys() == set(function.outputs)
    assert function.batch([])["tip_x_m"].shape == (0, len(function.times))


def test_without_native_code_values_stay(monkeypatch: pytest.MonkeyPatch) -> None:
    wanted = compile(leg(SHORT), FREE, TIP)()
    monkeypatch.setenv(SWITCH, "off")
    formulas = compile(leg(SHORT), FREE, TIP)
    assert formulas()["tip_x_m"] == pytest.approx(wanted["tip_x_m"], abs=1e-6)
    with pytest.raises(
        NativeUnavailable, match="derivatives of a motion need steps in native code"
    ):
        formulas.jacobian()
