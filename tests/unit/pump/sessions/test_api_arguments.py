"""What the functions of `viscodesign.pump` refuse before anything moves."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from tests.scenes import leg
from viscodesign import pump
from viscodesign.errors import UsageError


def test_a_misspelt_playback_plays_nothing() -> None:
    scene = leg("input={kind: sine, amplitude: 4 kPa, frequency: 0.5 Hz}", config="leg_16_pump")
    with pytest.raises(UsageError, match="playback must be one of none, once, loop; got 'nix'"):
        pump.upload(scene, playback="nix")  # type: ignore[arg-type]


@pytest.mark.parametrize("duration", [0.0, -1.0, math.nan, math.inf])
def test_a_recording_has_a_duration_that_can_be(duration: float, tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="--duration must be above 0 s and finite"):
        pump.record(tmp_path / "record.csv", duration=duration)
    assert not list(tmp_path.iterdir())


def test_names_are_listed_before_they_are_used() -> None:
    assert {"plan", "stream", "upload", "record", "calibrate"} <= set(dir(pump))
