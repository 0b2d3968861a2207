"""Tables that repeat, and tables that do not reach over the run."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from tests.scenes import leg
from tests.unit.scene.tables.written import scene_of, table
from viscodesign import check
from viscodesign.errors import SpecError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.scene.inputs.table import TableInput
from viscodesign.scene.scene import Scene

RUN = "run={duration: 6 s, output_interval: 0.1 s}"


def cycle(rows: str, *overrides: str) -> TableInput:
    found = leg(f"input={{kind: table, rows: {rows}, repeat: true}}", RUN, *overrides).input
    assert isinstance(found, TableInput)
    return found


@pytest.mark.parametrize(
    "rows",
    [
        "[[0, 0], [1, 2e3], [3, 0]]",
        "[[0, 0], [1, 2e3], [3, 1e3]]",  # a jump where the cycle ends
        "[[0, 0], [1, 2e3], [1, 1e3], [3, 0]]",
        "[[0.5, 1e3], [1, 2e3], [2, 1e3]]",  # from anywhere on the cycle
        "[[0.5, 1e3], [1, 2e3], [2, 4e3]]",
        "[[12, 1e3], [13, 2e3], [15, 4e3]]",
    ],
)
def test_a_cycle_repeats_its_rows(rows: str) -> None:
    found, once = cycle(rows), leg(f"input={{kind: table, rows: {rows}}}").input
    assert once is not None
    assert found.period is not None
    first, last = once.covered or (0.0, 0.0)
    assert found.period == pytest.approx(last - first)
    inside = np.linspace(first + 1e-6, last - 1e-6, 101)
    phases = np.concatenate([(inside + k * found.period) for k in range(-20, 5)])
    places = phases[(phases > 0) & (phases < 6.0)]
    turn = first + (places - first) % found.period
    assert found.values(places) == pytest.approx(once.values(turn), abs=1e-6)
    edges = np.array([0.0, *found.corners(6.0), 6.0])
    middles = (edges[:-1] + edges[1:]) / 2
    pieces = [found.expression(t, p, np) for t, p in zip(middles, found.pieces(edges), strict=True)]
    assert pieces == pytest.approx(found.values(middles), abs=1e-6)


def test_a_cycle_counts_as_periodic_and_meets_where_its_ends_do() -> None:
    scene = leg(
        "input={kind: table, rows: [[0, 0], [1, 2e3], [3, 0]], repeat: yes}",
        RUN, "run.start=periodic",
    )  # fmt: skip
    assert scene.period == 3.0
    assert scene.input is not None
    assert scene.input.corners(6.0) == [1.0, 3.0, 4.0]
    assert scene.input.transient(6.0) == pytest.approx(0.98)
    with pytest.raises(SpecError, match="'periodic' needs inputs that repeat"):
        leg("input={kind: table, rows: [[0, 0], [1, 2e3], [3, 0]]}", "run.start=periodic")


def test_no_swing_is_cut_where_a_cycle_ends() -> None:
    """The rise from 2.5 s to 3.5 s goes on over the end of the cycle at 3 s."""
    found = cycle("[[0, 1e3], [0.5, 2e3], [2.5, 0], [3, 1e3]]")
    assert found.transient(6.0) == pytest.approx(0.98)


def test_a_jump_of_a_cycle_is_told() -> None:
    scene = leg("input={kind: table, rows: [[0, 0], [1, 2e3], [3, 1.5e3]], repeat: true}", RUN)
    (told,) = [n for n in check(scene).warnings if n.code == "cycle_jumps"]
    assert "ends at 1.5 kPa and begins at 0 kPa" in told.message
    assert "every 3 s" in told.message


def test_ends_of_a_noisy_cycle_meet(tmp_path: Path) -> None:
    time = np.arange(0, 2.005, 0.01)
    noise = np.random.default_rng(1).normal(0, 60, len(time))
    rows = zip(time, 1e4 * np.sin(np.pi * time / 2) ** 2 + noise, strict=True)
    text = "time_s,pressure_pa\n" + "".join(f"{t:.2f},{p:.1f}\n" for t, p in rows)
    found = table(tmp_path, text, repeat="true")
    assert (found.rows or ())[0][1] == (found.rows or ())[-1][1]
    assert not [
        n for n in check(scene_of(tmp_path, text, repeat="true")).warnings if "jump" in n.code
    ]


@pytest.mark.parametrize(
    ("rows", "overrides", "words"),
    [
        ("[[1, 0], [1, 2e3]]", (), "a cycle needs a duration"),
        ("[[0, 0], [1e-5, 2e3]]", (), "periods in 6 s"),
        (str([[k * 1e-3, k % 7] for k in range(1000)]), ("run.duration=3000 s",),
         "1000 rows in each of 3004 periods"),
    ],
)  # fmt: skip
def test_refusals(rows: str, overrides: tuple[str, ...], words: str) -> None:
    with pytest.raises(SpecError, match=words):
        cycle(rows, *overrides)


# -- what a table leaves of a run ------------------------------------------------------------


def codes(scene: Scene) -> dict[str, str]:
    return {notice.code: notice.message for notice in check(scene).warnings}


def test_measured_rows_that_do_not_reach_over_the_run_are_told(tmp_path: Path) -> None:
    text = "time_s,pressure_pa\n1,0\n2,2e3\n3,1e3\n"
    found = codes(scene_of(tmp_path, text, RUN))
    assert "from 0 s on, the input stays at 0 kPa" in found["table_starts_late"]
    assert "to the end of the run at 6 s the input stays at 1 kPa" in found["table_ends_early"]
    sampled = "".join(f"{0.01 * k:.2f},{k}\n" for k in range(1, 600))
    for whole in ("0,0\n2,2e3\n6,1e3\n", sampled):
        scene = scene_of(tmp_path, f"time_s,pressure_pa\n{whole}", RUN)
        assert not [code for code in codes(scene) if "table" in code]


def test_a_table_that_misses_the_run_is_told_and_has_no_transient(tmp_path: Path) -> None:
    text = "time_s,pressure_pa\n10,0\n12,2e3\n"
    for scene in (
        scene_of(tmp_path, text, RUN),
        leg("input={kind: table, rows: [[10, 0], [12, 2e3]]}", RUN),
    ):
        assert "from 10 s to 12 s, the run ends at 6 s" in codes(scene)["table_misses_run"]
        assert SceneQuantities(scene).scales.t_i == math.inf


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ("{kind: step, value: 3 kPa, time: 7 s}", math.inf),
        ("{kind: step, value: 3 kPa, time: 5 s}", 0.0),
        ("{kind: step, value: 3 kPa}", 0.0),
        ("{kind: square, high: 2, low: 1, frequency: 0.05 Hz}", math.inf),
        ("{kind: square, high: 2, low: 1, frequency: 0.1 Hz}", 0.0),
        ("{kind: table, rows: [[0, 0], [4, 1e3], [20, 1e3], [20.1, 0]]}", 0.98 * 4),
        ("{kind: double_sigmoid, start: 0, drop: 5 kPa, fall_time: 90 s, rise_time: 99 s, transition: 1 s}", math.inf),
        ("{kind: step, value: 3 kPa, time: 7 s, transient_time: 1 s}", 1.0),
    ],
)  # fmt: skip
def test_the_transient_time_is_that_of_the_run(given: str, expected: float) -> None:
    assert SceneQuantities(leg(f"input={given}", RUN)).scales.t_i == pytest.approx(expected)
