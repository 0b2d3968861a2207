"""A clean table whose rows are closer than the motion can resolve is told, with the way out."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from tests.scenes import leg, problem_of
from viscodesign import Scene, simulate
from viscodesign.checks.check import check

DURATION = 1.0


def recorded(folder: Path, interval: float, **keys: str) -> Scene:
    """Four bellows that follow a clean table from a file with this time between rows [s]."""
    time = np.arange(round(1.2 * DURATION / interval) + 1) * interval
    rows = [f"{t:.4f},{8e3 * np.sin(2 * t) ** 2:.6f}" for t in time]
    (folder / "in.csv").write_text("\n".join(["time_s,p_Pa", *rows, ""]))
    given = ", ".join(f"{key}: {value}" for key, value in keys.items())
    return leg(
        f"input={{kind: table, file: {folder / 'in.csv'}, {given}}}",
        f"run={{duration: {DURATION} s, output_interval: 20 ms}}",
        "bellows.count=4",
        "effects={pressure_distribution: on, others: off}",
    )


def fine(notes: tuple[str, ...]) -> list[str]:
    return [note for note in notes if "too close for the motion" in note]


def test_the_proposed_cut_off_leaves_few_rows_and_the_motion(tmp_path: Path) -> None:
    whole = recorded(tmp_path, 5e-4)
    (note,) = fine(check(whole).facts)
    assert "input: 2000 rows of the run are less than" in note
    proposed = re.search(r"smooth: (.* ms)$", note)
    assert proposed is not None
    smooth = recorded(tmp_path, 5e-4, smooth=proposed[1])
    assert not fine(check(smooth).facts)
    corners = [len(problem_of(scene).schedule.pieces.changes) for scene in (whole, smooth)]
    assert corners[1] < 0.1 * corners[0]
    exact, found = (simulate(scene, verify=False) for scene in (whole, smooth))
    assert fine(exact.notes) == [note]
    assert np.abs(found.tip - exact.tip)[:, :2].max() < 0.1 * whole.accuracy * whole.actuator.length


@pytest.mark.parametrize("interval", [0.01, 0.004])
def test_rows_that_are_few_are_not_told(tmp_path: Path, interval: float) -> None:
    assert not fine(check(recorded(tmp_path, interval)).facts)


def test_the_rows_of_all_cycles_count() -> None:
    rows = "[[0, 0], [0.5 ms, 1 kPa], [1 ms, 0], [0.1, 5 kPa], [0.2, 0]]"
    for duration, count in ((20.0, 0), (60.0, 600)):
        scene = leg(
            f"input={{kind: table, repeat: true, rows: {rows}}}",
            f"run={{duration: {duration} s, output_interval: 0.1 s}}",
        )
        found = fine(check(scene).facts)
        assert len(found) == bool(count)
        assert all(f"input: {count} rows" in note for note in found)
