"""Sensitivities: slopes, bands against a sample, and tolerances that are refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from tests.unit.studies.test_sweep import quick, scene
from viscodesign import compile, sensitivity
from viscodesign.errors import SpecError
from viscodesign.results.sensitivity_study import SensitivityStudy
from viscodesign.studies.sampled_variance import sampled_variance

TOLERANCES = {"network.tube_radius": "5 %", "fluid.viscosity": 0.1, "actuator.length": "1 mm"}


@pytest.fixture(scope="module")
def study() -> SensitivityStudy:
    return sensitivity(scene(), TOLERANCES)


def test_a_percent_of_each_number_moves_the_tip_so_far(study: SensitivityStudy) -> None:
    """By solutions with one percent more and less."""
    tip = compile(scene(), list(TOLERANCES), ["tip_x_m", "tip_z_m"], tolerance=1e-7)
    for k, number in enumerate(study.numbers):
        change = np.zeros(3)
        change[k] = 0.01 * number.value
        ends = [tip(tip.values + sign * change) for sign in (1, -1)]
        moved = [(ends[0][name] - ends[1][name]) / 2 for name in ("tip_x_m", "tip_z_m")]
        expected = 1e3 * np.column_stack(moved)
        largest = np.abs(expected).max()
        assert study.mm_per_percent[:, :, k] == pytest.approx(expected, abs=0.01 * largest)


def test_the_band_is_that_of_a_sample(study: SensitivityStudy) -> None:
    """Within five percent, at every time at which it is not small."""
    from scipy.stats import norm, qmc

    assert [n.deviation for n in study.numbers] == pytest.approx([1.625e-5, 1.79e-6, 1e-3])
    drawn = norm.ppf(qmc.LatinHypercube(3, seed=np.random.default_rng(1)).random(256))
    tip = compile(scene(), list(TOLERANCES), ["tip_x_m", "tip_z_m"])
    found = tip.batch(tip.values + drawn * [n.deviation for n in study.numbers])
    for c, name in enumerate(("tip_x_m", "tip_z_m")):
        sampled, linear = found[name].std(axis=0), study.band[:, c]
        wide = linear > 0.2 * linear.max()
        assert wide.sum() >= 3
        assert linear[wide] == pytest.approx(sampled[wide], rel=0.05)


def test_shares_add_up_to_one(study: SensitivityStudy) -> None:
    assert study.shares.sum() == pytest.approx(1.0)
    assert study.worst_shares.sum(axis=1) == pytest.approx(1.0)
    table = study.frame()
    assert table.columns[:5].tolist() == [
        "time_s", "tip_x_m", "tip_z_m", "tip_x_sd_m", "tip_z_sd_m",
    ]  # fmt: skip
    assert table["fluid.viscosity:tip_x_mm_per_percent"].to_numpy() == pytest.approx(
        study.mm_per_percent[:, 0, 1]
    )


def test_without_tolerances_all_numbers_have_slopes() -> None:
    found = sensitivity(scene())
    keys = {number.key for number in found.numbers}
    assert {"network.tube_radius", "input.drop", "actuator.length"} <= keys
    left_out = dict(found.left_out)
    assert left_out["loads.payload"] == "it is 0, of which a percent is nothing"
    assert "nothing in this scene's equations depends on it" in left_out["fluid.density"]
    assert not found.has_band
    assert found.order[0] == int(np.argmax(found.sizes.max(axis=0)))


def test_sampled_variances_of_a_known_function() -> None:
    """x = a + 2 b, z = a b about zero: no slope shows z, and neither number does it alone."""

    def tip_at(rows: np.ndarray) -> np.ndarray:
        a, b = rows.T
        return np.column_stack([a + 2 * b, a * b])

    slopes = np.array([[1.0, 2.0], [0.0, 0.0]])
    found = sampled_variance(tip_at, np.zeros(2), np.ones(2), slopes, 0)
    assert found.solutions == 4 * found.size
    assert found.deviation_m == pytest.approx([np.sqrt(5), 1.0], rel=0.1)
    assert found.first_order[0] == pytest.approx([0.2, 0.8], abs=0.05)
    assert found.first_order[1] == pytest.approx([0.0, 0.0], abs=0.2)
    assert found.total_order[1] == pytest.approx([1.0, 1.0], abs=0.2)


def test_solutions_that_fail_are_counted() -> None:
    def tip_at(rows: np.ndarray) -> np.ndarray:
        found = np.column_stack([rows[:, 0], rows[:, 0]])
        found[rows[:, 0] > 2.0] = np.nan
        return found

    found = sampled_variance(tip_at, np.zeros(1), np.ones(1), np.ones((2, 1)), 0)
    assert 0 < found.failed < 0.05 * found.solutions
    assert found.deviation_m == pytest.approx([1.0, 1.0], rel=0.05)


@pytest.mark.parametrize(
    ("tolerances", "words"),
    [
        ([], "no tolerance is given"),
        ("network.tube_radius=5", "has no unit"),
        ("network.tube_radius=-5%", "above 0 and below 100 %"),
        ("network.tube_radius=100%", "above 0 and below 100 %"),
        ("network.tube_radius=0 mm", "above 0 and below 100 %"),
        ("network.tube_radius=5 kg", "is a mass"),
        ({"network.tube_radius": float("nan")}, "not finite"),
        ("network.tube_radius=wide", "has no number"),
        ("network.tub_radius=5%", "no such number in this scene; did you mean"),
        ("fluid=5%", "cannot be free"),
        ("loads.payload=5%", "is 0, of which 5% is nothing"),
        ("network.tube_radius", "names no key; write KEY=5%"),
    ],
)
def test_tolerances_that_are_refused(tolerances: Any, words: str) -> None:
    with pytest.raises(SpecError, match=words):
        sensitivity(scene(), tolerances)


def test_a_sample_needs_tolerances() -> None:
    with pytest.raises(SpecError, match="a sample needs tolerances"):
        sensitivity(scene(), sobol=True)


def test_a_sweep_over_a_sensitive_number_agrees(study: SensitivityStudy) -> None:
    """Between two designs one percent apart the extreme of z moves as its slope says."""
    ends = quick(scene(), {"actuator.length": [0.02725 * 0.995, 0.02725 * 1.005]})
    moved = np.diff(ends.frame()["tip_z_max_m"].to_numpy(float))[0]
    row = int(np.argmax(study.tip[:, 1]))
    assert 1e3 * moved == pytest.approx(study.mm_per_percent[row, 1, 2], rel=0.02)
