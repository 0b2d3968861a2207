"""What the page of measured motions tells of a swing, where the swing is known exactly."""

from __future__ import annotations

import importlib
from types import ModuleType

import numpy as np
import pytest

from tests.scenes import ROOT
from viscodesign import load

DOCS = ROOT / "docs"


@pytest.fixture
def measured_swing(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(DOCS)
    return importlib.import_module("measured_swing")


def test_a_damped_cosine_is_read_back(measured_swing: ModuleType) -> None:
    """x = a (1 - exp(-d t/T) cos(2 pi t/T)): extremes where its slope is zero."""
    rest, period, decrement = 0.017, 0.23, 0.35
    rate = 2 * np.pi / period
    time = np.arange(0.0, 5.0, 0.01)
    phase = np.pi + np.arctan(-decrement / (2 * np.pi))  # first extreme below
    x = rest * (1 - np.exp(-decrement * time / period) * np.cos(rate * time))
    swing = measured_swing.Swing(time, np.column_stack([x, np.full(len(time), 0.1)]))
    first = rest * (1 - np.exp(-decrement * phase / (2 * np.pi)) * np.cos(phase))
    assert swing.static == pytest.approx(rest, rel=5e-3)
    assert swing.lowest == pytest.approx(first, rel=1e-3)
    assert swing.period == pytest.approx(period, rel=2e-3)
    assert swing.decrement == pytest.approx(decrement, rel=0.03)
    assert swing.early_middle == pytest.approx(rest, rel=1e-6)
    late = measured_swing.Swing(time + 0.012, swing.tip)
    rms, shift = swing.rms(late)
    assert (rms, shift) == (pytest.approx(0.0, abs=1e-5), pytest.approx(-0.012))


def test_the_specs_of_the_page_are_valid() -> None:
    for name in ("beam", "arm"):
        load(DOCS / "validation" / f"{name}.yaml")


def test_recordings_that_are_not_there_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(DOCS)
    page = importlib.import_module("make_validation")
    missing = page.missing_files(ROOT / "no_such_folder")
    named = (page.PAYLOADS, page.PRESSURES, page.SEGMENT_PRESSURES)
    assert len(missing) == sum(map(len, named))
