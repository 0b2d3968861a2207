"""Sines and cosines of many angles against NumPy's."""

from __future__ import annotations

import numpy as np
import pytest

from viscodesign.native import angles
from viscodesign.native.angles import MAX_ANGLE, sines_and_cosines
from viscodesign.native.loops import Loops, PythonLoops, native_loops

QUARTERS = np.arange(-9, 10) * (np.pi / 2)
ANGLES = np.concatenate(
    [QUARTERS, QUARTERS + 1e-9, QUARTERS / 2]
    + [np.random.default_rng(4).normal(scale=scale, size=300) for scale in (1e-8, 1.0, 30.0, 2e4)]
)


@pytest.mark.parametrize("loops", [native_loops, PythonLoops])
def test_the_loop_keeps_all_digits(loops: type[Loops], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(angles, "native_loops", loops)
    for found, exact in zip(sines_and_cosines(ANGLES), (np.sin, np.cos), strict=True):
        assert np.max(np.abs(found - exact(ANGLES))) <= 3e-16
    small = np.array([-1e-9, 1e-12, 1e-200])
    assert sines_and_cosines(small)[0] == pytest.approx(small, rel=1e-15)


def test_any_shape_and_layout() -> None:
    given = np.random.default_rng(5).normal(size=(3, 4, 5)).swapaxes(0, 2)
    sine, cosine = sines_and_cosines(given)
    assert sine == pytest.approx(np.sin(given), rel=1e-14)
    assert cosine == pytest.approx(np.cos(given), rel=1e-13)
    assert sines_and_cosines(np.zeros((0, 3)))[0].shape == (0, 3)


def test_what_the_loop_cannot_reduce_is_left_to_numpy() -> None:
    """Also beside small angles, and where there is no native code."""
    given = np.array([1.0, 3 * MAX_ANGLE, 1e22])
    assert np.array_equal(sines_and_cosines(given), (np.sin(given), np.cos(given)))
    with np.errstate(invalid="ignore"):
        assert np.all(np.isnan(sines_and_cosines(np.array([np.nan, np.inf]))))


def test_without_native_code(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("VISCODESIGN_NATIVE", "off")
    assert np.array_equal(sines_and_cosines(ANGLES), (np.sin(ANGLES), np.cos(ANGLES)))
