"""What the functions of `viscodesign.pump` refuse before anything moves."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

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
    with pytest.raises(UsageError, match="duration must be above 0 s and finite"):
        pump.record(tmp_path / "record.csv", duration=duration)
    assert not list(tmp_path.iterdir())


def test_names_are_listed_before_they_are_used() -> None:
    assert {"plan", "stream", "upload", "record", "calibrate"} <= set(dir(pump))


SPEC: Any = "leg.yaml"
SCENE_WANTED = "expected a scene, such as load('leg.yaml') returns"


@pytest.mark.parametrize(
    "call",
    [
        lambda: pump.plan(SPEC),
        lambda: pump.stream(SPEC, "out"),
        lambda: pump.upload(SPEC),
        lambda: pump.rehearse(SPEC),
        lambda: pump.record("rest.csv", scene=SPEC, duration=1.0),
        lambda: pump.status(scene=SPEC),
        lambda: pump.calibrate(SPEC, pump.BoardAddress("dynamixel"), confirm=bool),
    ],
)
def test_a_path_is_no_scene(call: Callable[[], object], tmp_path: Path) -> None:
    with contextlib.chdir(tmp_path), pytest.raises(UsageError) as refused:
        call()
    assert str(refused.value).startswith(SCENE_WANTED)
    assert str(refused.value).endswith("got 'leg.yaml'")
    assert not list(tmp_path.iterdir())


BOARD: Any = "dynamixel"
NUMBER: Any = "1 s"
YES: Any = True


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: pump.status(BOARD), "address: expected an address, such as pump.BoardAddress"),
        (lambda: pump.stop(BOARD), "address: expected an address"),
        (lambda: pump.record("rest.csv", duration=NUMBER), "duration: expected a number in SI"),
        (lambda: pump.record("rest.csv", rate=NUMBER), "rate: expected a number in SI"),
        (lambda: pump.stream(leg(), "out", confirm=YES), "confirm: expected a function; got on"),
        (lambda: pump.stream(leg(), YES), "folder: expected a path"),
        (lambda: pump.stream(leg(), "out", stop=YES), "stop: expected a pump.StopRequest"),
        (lambda: pump.upload(leg(), tolerance=YES), "tolerance: expected text with a unit"),
    ],
)
def test_arguments_of_another_type_are_refused(call: Callable[[], object], words: str) -> None:
    with pytest.raises(UsageError, match=words):
        call()


def test_a_pace_may_be_a_number() -> None:
    from viscodesign.pump.bus.clock import WallClock

    assert isinstance(pump.BoardAddress("dynamixel", "x", pace=1).clock(), WallClock)
    with pytest.raises(UsageError, match="pace 2: only the simulated"):
        pump.BoardAddress("dynamixel", "x", pace=2).clock()
