"""Every bundled config: its balances, and its motion held against that of an earlier version.

    pytest tests/golden                    within a thousandth of each scene's accuracy
    pytest tests/golden --golden exact     to the last digit: for a change that must move nothing
    pytest tests/golden --golden update    write the paths anew, after a change that must

The last digit depends on the machine: formulas are compiled for the processor at hand, which may
multiply and add with one rounding or two, and in vectors of two to eight; so do OpenBLAS, numpy and
the C library. `machine.txt` tells on which one the paths were written. On any other one, `exact`
compares to `ROUND_OFF_OF_ACCURACY`. An update writes all paths on one machine: run it without -k.
"""

from __future__ import annotations

from pathlib import Path

import casadi as ca
import numpy as np
import pandas as pd
import pytest

from tests.robots import moved
from tests.scenes import ACTUATOR_SPECS, ROBOT_SPECS, SEVERAL_SPECS
from tests.thorough import ALL, configs
from viscodesign import (
    Trajectory,
    load,
    load_robot,
    load_several,
    simulate,
    simulate_several,
)
from viscodesign.native.machine import this_machine

PATHS = Path(__file__).parent / "paths"
ROWS = 81
"""Output times kept of each run."""
TOLERANCE_OF_ACCURACY = 1e-3
"""How far a tip may lie from its golden path, in parts of the accuracy asked for."""
ROUND_OFF_OF_ACCURACY = 3e-5
"""The same for another machine's rounding. Code without fused operations and vectors, in formulas,
OpenBLAS, numpy and the C library, moved `syringe_water` by 8e-6, which follows the small difference
of large volumes, and all others by less than 2e-6."""
STEPS_OF_ROBOT = 40
"""Of its cycle: enough for a motion that is that of a robot."""
MACHINE = Path(__file__).parent / "machine.txt"
SPECS = ACTUATOR_SPECS


@pytest.fixture(scope="module", params=SPECS, ids=lambda spec: spec.stem)
def spec(request: pytest.FixtureRequest) -> Path:
    """A bundled config; one of each kind, unless the paths are written or compared to the digit."""
    path = Path(request.param)
    if path not in configs() and request.config.getoption("--golden") == "check":
        pytest.skip("differs by numbers alone from one that is tested; VISCODESIGN_TESTS=all")
    return path


@pytest.fixture(scope="module")
def found(spec: Path) -> Trajectory:
    """Its run, solved once for all tests."""
    run = simulate(load(spec))
    assert run.status == "complete", run.failure
    return run


def test_tip_path_equals_the_golden_path(spec: Path, found: Trajectory, golden: str) -> None:
    compare(tip_path(found), spec.stem, golden, found.accuracy.requested_m, found.length)


@pytest.mark.parametrize("spec", SEVERAL_SPECS, ids=lambda spec: spec.stem)
def test_tip_paths_of_several_actuators_equal_the_golden_ones(spec: Path, golden: str) -> None:
    if spec.stem == "two_legs" and golden == "check" and not ALL:
        pytest.skip("tests/validation/test_coupled_actuators.py has smaller ones")
    runs = simulate_several(load_several(spec)).runs
    paths = [tip_path(run).add_prefix(f"{name}_") for name, run in runs.items()]
    accuracy = min(run.accuracy.requested_m for run in runs.values())
    length = min(run.length for run in runs.values())
    compare(pd.concat(paths, axis=1), spec.stem, golden, accuracy, length)


def test_a_cycle_of_a_robot_equals_the_golden_one(golden: str) -> None:
    """With a fixed step: that of a walk depends on what its errors turn out to be."""
    (spec,) = ROBOT_SPECS
    scene = load_robot(spec)
    motion = moved(scene, STEPS_OF_ROBOT, 1)
    columns = ["body_x_m", "body_z_m", "pitch_rad", "roll_rad"]
    path = pd.DataFrame(motion.body, columns=columns)
    path.insert(0, "time_s", motion.time)
    accuracy = scene.accuracy * abs(motion.advances[-1])
    compare(path, spec.stem, golden, accuracy, motion.body[0, 1])


def compare(path: pd.DataFrame, name: str, golden: str, accuracy: float, length: float) -> None:
    """Hold a motion against the stored one, or store it.

    ``accuracy`` [m], of which a part may be missed; over ``length`` [m] that of an angle.
    """
    file = PATHS / f"{name}.csv"
    if golden == "update":
        path.to_csv(file, index=False, float_format="%.17g")
        MACHINE.write_text(this_computer() + "\n", encoding="utf-8")
        return
    header = file.read_text(encoding="utf-8").partition("\n")[0]
    assert header == ",".join(path)
    expected = pd.DataFrame(
        np.loadtxt(file, delimiter=",", skiprows=1, ndmin=2), columns=path.columns
    )
    if golden == "exact" and MACHINE.read_text(encoding="utf-8").strip() == this_computer():
        np.testing.assert_array_equal(path.to_numpy(), expected.to_numpy())
        return
    part = ROUND_OFF_OF_ACCURACY if golden == "exact" else TOLERANCE_OF_ACCURACY
    for column in path:
        moved_by = np.max(np.abs(path[column] - expected[column]))
        if column.endswith("time_s"):
            assert moved_by == 0.0
        else:
            size = length if column.endswith("_rad") else 1.0
            assert moved_by * size <= part * accuracy, column


def this_computer() -> str:
    """All that the last digits may depend on, besides the code."""
    blas = np.show_config(mode="dicts")["Build Dependencies"]["blas"]["version"]
    versions = f"numpy {np.__version__}, OpenBLAS {blas}, CasADi {ca.CasadiMeta.version()}"
    return f"{this_machine()}, {versions}"


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
    specs = (*SPECS, *SEVERAL_SPECS, *ROBOT_SPECS)
    assert {file.stem for file in PATHS.glob("*.csv")} == {spec.stem for spec in specs}


def tip_path(found: Trajectory) -> pd.DataFrame:
    """Time and place of the tip at evenly spread output times, the first and the last included."""
    rows = np.unique(np.linspace(0, len(found.time) - 1, ROWS).round().astype(int))
    columns = ["time_s", "tip_x_m", "tip_z_m", "tip_angle_rad"]
    return found.frame()[columns].iloc[rows].reset_index(drop=True)
