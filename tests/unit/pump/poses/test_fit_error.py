"""An error in three units, and what is said where it is too large."""

from __future__ import annotations

from contextlib import nullcontext
from dataclasses import replace

import numpy as np
import pytest

from tests.pose_rig import swing
from viscodesign.errors import PumpError, UsageError
from viscodesign.pump.poses.fit import PoseFit, fit_poses
from viscodesign.pump.poses.fit_error import FitError, Tolerance

ERROR = FitError(counts=2.0, volume=0.145e-6, pressure=800.0)


@pytest.fixture(scope="module")
def fit() -> PoseFit:
    return fit_poses(swing((1, 2)), loop=True)


def test_the_error_is_the_largest_of_all_plungers(fit: PoseFit) -> None:
    error = np.zeros_like(fit.played)
    error[3], error[5] = (-1.0, 0.5), (0.2, 3.0)
    off = replace(fit, played=fit.requested + error)
    assert FitError.of(off, 0.0725e-6, [400.0, 100.0]) == FitError(
        pytest.approx(3.0), pytest.approx(0.2175e-6), pytest.approx(400.0)
    )


@pytest.mark.parametrize(
    ("text", "allows"),
    [
        ("1 kPa", True),
        ("0.5 kPa", False),
        ("800 Pa", True),
        ("0.2 mL", True),
        ("100 uL", False),
        ("2 counts", True),
        ("1.9 counts", False),
        ("1 count", False),
    ],
)
def test_tolerances_are_read_with_their_units(text: str, allows: bool, fit: PoseFit) -> None:
    with nullcontext() if allows else pytest.raises(PumpError, match=f"the tolerance is {text}"):
        Tolerance.of(text).refuse(fit, ERROR)


@pytest.mark.parametrize(
    "text", ["", "1", "kPa", "counts", "-1 kPa", "0 counts", "nan counts", "1 mm", "1 parrot", "1e"]
)
def test_an_invalid_tolerance_is_refused_with_examples(text: str) -> None:
    with pytest.raises(UsageError, match=r"'1 kPa', '0\.1 mL' or '2 counts'"):
        Tolerance.of(text)


def test_a_coarse_fit_is_refused_with_a_remedy(fit: PoseFit) -> None:
    Tolerance.of("1 kPa").refuse(fit, ERROR)
    with pytest.raises(PumpError) as told:
        Tolerance.of("0.1 kPa").refuse(fit, ERROR)
    for words in (
        "2.00 counts, 0.145 mL, up to 0.8 kPa",
        "the tolerance is 0.1 kPa",
        "pump stream",
    ):
        assert words in str(told.value)


def test_an_open_loop_is_refused_with_its_gap() -> None:
    half = swing()
    half = replace(half, time=half.time[:31], steps=half.steps[:31], pressure=half.pressure[:31])
    fit = fit_poses(half, loop=True)
    # It cannot be at both ends at once: half of the gap is the least.
    assert fit.largest_error == pytest.approx(40.0, abs=2.0)
    with pytest.raises(PumpError, match=r"ends 80\.0 counts from where it begins"):
        Tolerance.of("1 counts").refuse(fit, ERROR)
