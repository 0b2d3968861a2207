"""Recordings in space, as `fit` and `compare` read them: frame, plane of motion, gaps, faults."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tests.recordings import small_scene
from viscodesign.calibration.recording import read_recording
from viscodesign.comparison.measured_motion import measured_motion
from viscodesign.errors import SpecError, ViscodesignError
from viscodesign.scene.reading.markers_file import read_markers
from viscodesign.scene.scene import Scene

CLAMP = {"m3": [0.016, -0.025, 0.006], "m4": [-0.0125, 0.025, 0.006], "m5": [0.015, 0.025, 0.006]}
LENGTH = 0.1
ROWS, HELD = 40, 8
"""Rows, and how many of them before time zero."""
PLACES: dict[str, Any] = {
    "clamp": CLAMP,
    "tip": ["m1", "m2"],
    "time_zero": {"swing": 0.08},
    "tip_before": [0.0, LENGTH],
}
TURN = Rotation.from_rotvec([0.7, -1.9, 0.4])
SHIFT = np.array([0.3, -0.2, 0.11])


@pytest.fixture(scope="module")
def scene() -> Scene:
    return small_scene()


def true_tip() -> np.ndarray:
    """x and z (T, 2) of a tip that is held and then let go [m]."""
    angle = 0.3 * np.sin(0.4 * np.maximum(np.arange(ROWS) - HELD, 0))
    return LENGTH * np.column_stack([np.sin(angle), np.cos(angle)])


def recording(path: Path, unit: float = 1.0, mirror: bool = False) -> Path:
    """A file in a camera's frame: two markers beside the tip, one lost twice, three at the clamp."""
    x, z = true_tip().T
    tips = [np.column_stack([x, np.full(ROWS, y), z]) for y in (-0.02, 0.02)]
    own = np.stack([*tips, *(np.tile(place, (ROWS, 1)) for place in CLAMP.values())], axis=1)
    seen = (TURN.apply(own.reshape(-1, 3)) + SHIFT) * ([1, 1, -1] if mirror else [1, 1, 1])
    seen = seen.reshape(ROWS, -1) / unit
    seen[[3, 20], 4] = np.nan
    word = "m" if unit == 1.0 else "mm"
    header = ["time_s", *(f"m{k}_{axis}_{word}" for k in range(1, 6) for axis in "xyz"),
              "inlet_pressure_pa"]  # fmt: skip
    time = np.arange(ROWS) / 100
    rows = np.column_stack([time, seen, 1e3 * time])
    path.parent.mkdir(exist_ok=True)
    np.savetxt(path, rows, fmt="%.7f", delimiter=",", header=",".join(header), comments="")
    return path


@pytest.mark.parametrize("unit", [1.0, 1e-3])
def test_tip_is_found_in_the_frame_of_the_clamp(tmp_path: Path, scene: Scene, unit: float) -> None:
    file = recording(tmp_path / "swing.csv", unit)
    found = read_recording(file, scene, read_markers(PLACES))
    by_name = {own.output: own.values for own in found.channels}
    assert found.time == pytest.approx(np.arange(ROWS - HELD) / 100)
    assert by_name["inlet_pressure_pa"] == pytest.approx(1e3 * np.arange(HELD, ROWS) / 100)
    tip = np.column_stack([by_name["tip_x_m"], by_name["tip_z_m"]])
    assert list(np.flatnonzero(np.isnan(tip[:, 0]))) == [20 - HELD]
    known = np.isfinite(tip[:, 0])
    assert tip[known] == pytest.approx(true_tip()[HELD:][known], abs=1e-6)
    motion = measured_motion(file, read_markers(PLACES))
    assert motion.tip == pytest.approx(tip[known])
    assert "projected to the plane of motion" in motion.note


def test_wrong_places_of_the_clamp_move_no_known_tip(tmp_path: Path) -> None:
    """1.5 mm at markers 28 mm apart turn a frame by 3 degrees; the tip's place mends that."""
    off = {**CLAMP, "m4": [-0.0125, 0.025, 0.0075]}
    file = recording(tmp_path / "swing.csv")
    found = {
        key: measured_motion(file, read_markers({**PLACES, "clamp": off, "tip_before": place}))
        for key, place in (("known", [0.0, LENGTH]), ("unknown", None))
    }
    kept = np.delete(true_tip()[HELD:], 20 - HELD, axis=0)
    worst = {key: float(np.abs(own.tip - kept).max()) for key, own in found.items()}
    assert worst["known"] < 0.5e-3 < 2e-3 < worst["unknown"]


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"clamp": {"m3": CLAMP["m3"], "m4": CLAMP["m4"]}}, "3 markers or more"),
        ({"clamp": {"m3": [0, 0, 0], "m4": [0, 0, 0.01], "m5": [0, 0, 0.03]}}, "one line"),
        ({"clamp": {"m3": [0, 0], "m4": 3}}, "x, y and z of each marker"),
        ({"tip": []}, "each once: [m2, m3]; got"),
        ({"tip": ["m1", "m9"]}, "has no marker m9; its markers are m1, m2"),
        ({"time_zero": {"swong": 0.1}}, "has no time for swing"),
        ({"time_zero": 7.0}, "the recording goes from 0 to 0.39 s"),
        ({"time_zero": None}, "no row before time_zero"),
        ({"clamp": {k: [10 * x for x in v] for k, v in CLAMP.items()}}, "check names, units"),
    ],
)
def test_what_is_wrong_is_told(tmp_path: Path, change: dict[str, Any], words: str) -> None:
    file = recording(tmp_path / "swing.csv")
    with pytest.raises(SpecError) as caught:
        measured_motion(file, read_markers({**PLACES, **change}))
    assert words in str(caught.value)


def test_mirrored_coordinates_are_refused(tmp_path: Path) -> None:
    """The clamp's markers lie in a plane, so that a turned frame fits their mirror image."""
    file = recording(tmp_path / "swing.csv", mirror=True)
    with pytest.raises(SpecError, match="right-handed"):
        measured_motion(file, read_markers({**PLACES, "tip_before": None}))


def test_a_file_that_is_not_there_is_told(tmp_path: Path) -> None:
    with pytest.raises(SpecError, match="it says where markers are"):
        read_markers(tmp_path / "markers.yaml")
    with pytest.raises(SpecError, match="tip: missing"):
        read_markers("clamp: {m3: [0, 0, 0], m4: [0, 1, 0], m5: [1, 0, 0]}\n")


def test_markers_in_space_have_to_be_named(tmp_path: Path, scene: Scene) -> None:
    file = recording(tmp_path / "swing.csv")
    with pytest.raises(ViscodesignError, match="--markers FILE"):
        read_recording(file, scene)
    with pytest.raises(ViscodesignError, match="--markers FILE"):
        measured_motion(file)
