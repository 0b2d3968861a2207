"""Every bundled config: its balances, and its tip's path held against that of an earlier version.

    pytest tests/golden                    within a hundredth of each scene's accuracy
    pytest tests/golden --golden exact     to the last digit: for a change that must move nothing
    pytest tests/golden --golden update    write the paths anew, after a change that must

Another processor rounds otherwise, so only runs on one machine can agree to the last digit.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from tests.scenes import ACTUATOR_SPECS
from viscodesign import Trajectory, load, simulate

PATHS = Path(__file__).parent / "paths"
ROWS = 81
"""Output times kept of each run."""
TOLERANCE_OF_ACCURACY = 0.01
"""How far a tip may lie from its golden path, in parts of the accuracy asked for."""
SPECS = ACTUATOR_SPECS


@pytest.fixture(scope="module", params=SPECS, ids=lambda spec: spec.stem)
def spec(request: pytest.FixtureRequest) -> Path:
    """A bundled config."""
    return Path(request.param)


@pytest.fixture(scope="module")
def found(spec: Path) -> Trajectory:
    """Its run, solved once for all tests."""
    run = simulate(load(spec))
    assert run.status == "complete", run.failure
    return run


def test_tip_path_equals_the_golden_path(spec: Path, found: Trajectory, golden: str) -> None:
    path, file = tip_path(found), PATHS / f"{spec.stem}.csv"
    if golden == "update":
        path.to_csv(file, index=False, float_format="%.17g")
        return
    expected = np.loadtxt(file, delimiter=",", skiprows=1, ndmin=2)
    if golden == "exact":
        np.testing.assert_array_equal(path.to_numpy(), expected)
        return
    allowed = TOLERANCE_OF_ACCURACY * found.accuracy.requested_m
    # Time, x, z, angle: a length of the actuator is taken as a radian of the tip.
    moved = np.abs(path.to_numpy() - expected) / [1.0, 1.0, 1.0, 1.0 / found.length]
    assert np.array_equal(path["time_s"], expected[:, 0])
    assert np.max(moved) <= allowed


def test_balances_are_satisfied(found: Trajectory) -> None:
    assert found.accuracy.estimated_tip_error_m is not None
    assert found.accuracy.estimated_tip_error_m <= found.accuracy.requested_m
    assert found.invariants.volume_imbalance_rel is not None
    assert found.invariants.volume_imbalance_rel <= 1e-8
    energy = found.invariants.energy_imbalance_rel
    assert energy is None or energy <= 1e-3
    assert np.all(np.isfinite(found.tip))
    assert np.max(np.abs(np.diff(found.tip[:, 2]))) < 1.0


def test_every_golden_path_has_a_config() -> None:
    assert {file.stem for file in PATHS.glob("*.csv")} == {spec.stem for spec in SPECS}


def tip_path(found: Trajectory) -> pd.DataFrame:
    """Time and place of the tip at evenly spread output times, the first and the last included."""
    rows = np.unique(np.linspace(0, len(found.time) - 1, ROWS).round().astype(int))
    columns = ["time_s", "tip_x_m", "tip_z_m", "tip_angle_rad"]
    return found.frame()[columns].iloc[rows].reset_index(drop=True)
