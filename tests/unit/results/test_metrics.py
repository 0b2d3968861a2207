"""Metrics of motions whose size, area, length and lag are known, and their gradients."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import pytest
from scipy.special import ellipe

from tests.scenes import ROOT
from tests.trajectories import made_run, pulse
from viscodesign.results.metrics import (
    METRIC_NAMES,
    METRICS,
    MetricInputs,
    column_weights,
    metric,
    metric_gradients,
    metric_table,
    metric_values,
)

BELLOWS = ("R1", "R2", "L1", "L2")
WIDTH, HEIGHT = 0.04, 0.01
"""Half axes of the ellipse [m]."""
LOOP = ("loop_width_m", "loop_height_m", "path_length_m", "loop_area_m2")


def ellipse(
    outputs: int,
    *,
    rounds: float = 1.0,
    sense: float = 1.0,
    period: float | None = 2.0,
    growth: float = 0.0,
    delay: float = 0.3,
) -> MetricInputs:
    """An ellipse in 2 s, about z = 0.1 m, whose size may grow; pressures are delayed sines."""
    time = np.linspace(0.0, 2.0 * rounds, outputs)
    turn, size = math.pi * time + 0.2, np.exp(growth * time)
    tip = np.column_stack(
        (size * WIDTH * np.cos(turn), 0.1 + sense * size * HEIGHT * np.sin(turn), turn)
    )
    right, left = (1e4 * size * np.sin(math.pi * (time - shift)) for shift in (0.0, delay))
    pressure = np.column_stack((1.2 * right, 0.8 * right, 0.5 * left, 0.3 * left))
    return MetricInputs.of(time, tip, pressure, BELLOWS, period)


def test_an_ellipse() -> None:
    perimeter = 4 * WIDTH * ellipe(1 - (HEIGHT / WIDTH) ** 2)
    found = metric_values(ellipse(2001))
    assert found["loop_width_m"] == pytest.approx(2 * WIDTH, rel=1e-5)
    assert found["loop_height_m"] == pytest.approx(2 * HEIGHT, rel=1e-5)
    assert found["path_length_m"] == pytest.approx(perimeter, rel=1e-5)
    assert found["loop_area_m2"] == pytest.approx(math.pi * WIDTH * HEIGHT, rel=1e-5)
    assert found["column_lag_s"] == pytest.approx(0.3, abs=1e-6)


def test_clockwise_is_negative() -> None:
    found = metric_values(ellipse(2001, sense=-1.0))
    assert found["loop_area_m2"] == pytest.approx(-math.pi * WIDTH * HEIGHT, rel=1e-5)


def test_area_and_length_are_of_order_two_in_the_output_interval() -> None:
    exact = {
        "loop_area_m2": math.pi * WIDTH * HEIGHT,
        "path_length_m": 4 * WIDTH * ellipe(1 - (HEIGHT / WIDTH) ** 2),
    }
    for name, wanted in exact.items():
        coarse, fine = (abs(metric_values(ellipse(n))[name] - wanted) for n in (101, 201))
        assert coarse / fine == pytest.approx(4.0, abs=0.1), name


def test_of_a_periodic_run_the_last_period_counts() -> None:
    """Wherever it begins: at an output time, or between two."""
    once = metric_values(ellipse(101))
    for outputs in (301, 338):
        found = metric_values(ellipse(outputs, rounds=3.0))
        for name in LOOP:
            assert found[name] == pytest.approx(once[name], rel=2e-3), name
        assert found["column_lag_s"] == pytest.approx(0.3, abs=1e-3)
    whole = metric_values(ellipse(301, rounds=3.0, period=None))
    assert whole["path_length_m"] == pytest.approx(3 * once["path_length_m"], rel=1e-6)
    assert whole["loop_area_m2"] == pytest.approx(3 * once["loop_area_m2"], rel=1e-6)


def test_what_comes_before_the_last_period_does_not_count() -> None:
    found = metric_values(ellipse(301, rounds=3.0, growth=0.5))
    later = metric_values(ellipse(101, growth=0.5))
    for name, power in (("loop_width_m", 1), ("path_length_m", 1), ("loop_area_m2", 2)):
        assert found[name] == pytest.approx(math.exp(0.5 * 4.0 * power) * later[name], rel=1e-6)


def test_a_run_shorter_than_its_period_counts_entirely() -> None:
    found = metric_values(ellipse(101, rounds=0.5))
    assert found["loop_area_m2"] == pytest.approx(math.pi * WIDTH * HEIGHT / 2, rel=1e-3)


def test_extremes_are_found_in_the_table_again() -> None:
    run = made_run()
    table = run.frame()
    for axis in "xz":
        column = table[f"tip_{axis}_m"]
        for word, row in (("min", column.idxmin()), ("max", column.idxmax())):
            assert run.metrics[f"tip_{axis}_{word}_m"] == column[row]
            assert run.metrics[f"tip_{axis}_{word}_time_s"] == table["time_s"][row]


def test_of_equal_extremes_the_first_is_told() -> None:
    tip = np.array([[0.0, 0.1], [0.02, 0.1], [0.02, 0.1], [0.01, 0.1]])
    inputs = MetricInputs.of(np.arange(4.0), tip, np.zeros((4, 4)), BELLOWS)
    assert metric_values(inputs, ["tip_x_max_time_s"]) == {"tip_x_max_time_s": 1.0}
    assert metric_gradients(inputs, ["tip_x_max_m"])["tip_x_max_m"].tip[:, 0].tolist() == [
        0,
        1,
        0,
        0,
    ]


def test_the_left_column_of_a_chain_is_behind() -> None:
    lag = made_run().metrics["column_lag_s"]
    slower = made_run(lag=0.021).metrics["column_lag_s"]
    assert 0.1 < lag < slower < 2.0
    turned = made_run()
    swapped = turned.with_arrays(pressure=np.roll(turned.pressure, 8, axis=1))
    assert swapped.metrics["column_lag_s"] == pytest.approx(-lag, rel=1e-9)


def test_the_lag_hardly_depends_on_the_output_interval() -> None:
    lags = [
        made_run(time=np.linspace(0.0, 8.0, outputs)).metrics["column_lag_s"]
        for outputs in (101, 401, 1601)
    ]
    assert lags[1:] == pytest.approx([lags[2]] * 2, rel=1e-3)
    assert lags[0] == pytest.approx(lags[2], rel=1e-2)


def test_bellows_belong_to_the_column_of_their_name() -> None:
    weights = column_weights(("L2", "R1", "L1", "R2"))
    assert pytest.approx(np.array([[0, 0.5, 0, 0.5], [0.5, 0, 0.5, 0]])) == weights.T


def test_a_run_without_output_has_none() -> None:
    run = made_run()
    empty = run.with_arrays(
        time=run.time[:0], tip=run.tip[:0], pressure=run.pressure[:0], shape=run.shape[:0]
    )
    assert all(math.isnan(value) for value in empty.metrics.values())
    assert set(empty.summary()["metrics"].values()) == {None}


def test_a_single_output_has_extremes_only() -> None:
    run = made_run(time=np.zeros(1), inlet=lambda time: 0 * time + 2e4)
    found = run.summary()["metrics"]
    assert found["tip_x_max_m"] == run.tip[0, 0]
    assert found["tip_x_max_time_s"] == 0.0
    assert [found[name] for name in (*LOOP, "column_lag_s")] == [None] * 5


def test_two_outputs_have_a_path_but_no_lag() -> None:
    run = made_run(time=np.array([0.0, 0.5]), inlet=pulse)
    assert run.metrics["path_length_m"] == pytest.approx(np.hypot(*np.diff(run.tip[:, :2].T)[:, 0]))
    assert run.metrics["loop_area_m2"] == pytest.approx(0.0, abs=1e-18)
    assert math.isnan(run.metrics["column_lag_s"])


def test_a_period_within_an_output_interval_has_a_straight_path() -> None:
    found = metric_values(ellipse(9, period=0.1))
    assert found["path_length_m"] == pytest.approx(
        math.hypot(found["loop_width_m"], found["loop_height_m"])
    )
    assert found["loop_area_m2"] == pytest.approx(0.0, abs=1e-15)


def test_constant_pressures_have_no_lag() -> None:
    still = made_run(inlet=lambda time: 0 * time + 3e4)
    assert still.summary()["metrics"]["column_lag_s"] is None
    assert still.metrics["loop_width_m"] == pytest.approx(0.0, abs=1e-12)


def test_names_are_those_of_the_interface() -> None:
    extremes = [f"tip_{axis}_{word}_{what}" for axis in "xz" for word in ("min", "max")
                for what in ("m", "time_s")]  # fmt: skip
    assert list(METRIC_NAMES) == [*extremes, *LOOP, "column_lag_s"]
    assert list(made_run().summary()["metrics"]) == list(METRIC_NAMES)
    with pytest.raises(KeyError, match="loop_size"):
        metric("loop_size")


def test_the_page_lists_every_metric() -> None:
    page = (ROOT / "docs" / "quantities.md").read_text(encoding="utf-8")
    assert len(list(metric_table())) == len(METRICS)
    for line in metric_table():
        assert f"| {' | '.join(line)} |" in page


CASES = {
    "a period between output intervals": ellipse(331, rounds=3.0, growth=-0.05, period=2.007),
    "a period of output intervals": ellipse(301, rounds=3.0, growth=-0.05),
    "a whole run": ellipse(301, rounds=1.4, growth=-0.05, period=None),
    "columns in turn": ellipse(301, rounds=3.0, growth=-0.05, delay=-0.4),
}


@pytest.mark.parametrize("name", METRIC_NAMES)
@pytest.mark.parametrize("case", CASES)
def test_gradients_equal_central_differences(case: str, name: str) -> None:
    """Along smooth changes of the motion; they are the same forward and backward."""
    inputs = CASES[case]
    pressure = inputs.columns @ (np.array(column_weights(BELLOWS)) > 0).T
    tips, pressures, periods = changes(inputs.time, 4)
    if case != "a period between output intervals":
        periods = 0 * periods  # elsewhere the period has a derivative to either side, or none
    gradient = metric_gradients(inputs, [name])[name]
    found = gradient.along(tips, pressures, periods)
    for k in range(4):
        step = 1e-4

        def value(size: float, k: int = k) -> float:
            moved = MetricInputs.of(
                inputs.time,
                inputs.tip + size * tips[..., k],
                pressure + size * pressures[..., k],
                BELLOWS,
                inputs.period and inputs.period + size * periods[k],
            )
            return metric_values(moved, [name])[name]

        difference = (value(step) - value(-step)) / (2 * step)
        assert found[k] == pytest.approx(difference, rel=1e-6, abs=1e-9)
        backward = np.sum(gradient.tip * tips[..., k]) + np.sum(
            gradient.pressure * pressures[..., k]
        )
        assert backward + gradient.period * periods[k] == pytest.approx(found[k], rel=1e-9)


def changes(time: np.ndarray, count: int) -> Sequence[np.ndarray]:
    """Smooth changes of the tip (T, 2, n) [m], pressures (T, B, n) [Pa] and the period (n,) [s]."""
    rng = np.random.default_rng(5)
    waves = np.cos(np.outer(time, rng.uniform(0.5, 3.0, 6)) + rng.uniform(0, 6, 6))
    tips = np.einsum("tw,wcn->tcn", waves, 1e-3 * rng.normal(size=(6, 2, count)))
    pressures = np.einsum("tw,wbn->tbn", waves, 300.0 * rng.normal(size=(6, 4, count)))
    return tips, pressures, 0.01 * rng.normal(size=count)


def test_what_is_not_defined_has_no_gradient() -> None:
    inputs = MetricInputs.of(np.zeros(1), np.zeros((1, 3)), np.zeros((1, 4)), BELLOWS)
    gradients = metric_gradients(inputs)
    assert np.isnan(gradients["column_lag_s"].pressure).all()
    assert np.isnan(gradients["loop_area_m2"].tip).all()
    assert gradients["tip_x_max_m"].tip.tolist() == [[1.0, 0.0]]
