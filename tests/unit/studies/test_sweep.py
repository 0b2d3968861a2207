"""Sweeps: rows by a compiled function and by `simulate`, folders, failures and what is refused."""

from __future__ import annotations

import functools
import json
import os
import pickle
import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.scenes import CONFIGS, ROOT, leg
from viscodesign import Scene, simulate, sweep
from viscodesign.errors import SpecError, UsageError
from viscodesign.results.metrics import METRIC_NAMES
from viscodesign.studies.design_solver import DesignSolver
from viscodesign.studies.designs import latin_hypercube
from viscodesign.studies.swept_keys import swept_keys

COARSE = ("run={duration: 4 s, output_interval: 200 ms}",)
QUASI_STATIC = (*COARSE, "effects={pressure_distribution: on, damping: on, others: off}")


quick = functools.partial(sweep, verify=0)


def scene(*overrides: str) -> Scene:
    """A leg of four bellows that is solved in milliseconds."""
    return leg(*QUASI_STATIC, *overrides, config="leg_4_air")


def lines(folder: Path) -> list[Any]:
    """Rows as they were kept."""
    text = (folder / "sweep.rows.jsonl").read_text()
    return [json.loads(line) for line in text.splitlines()[1:]]


# -- numbers ----------------------------------------------------------------------


def test_a_row_is_what_simulate_says() -> None:
    table = quick(scene(), {"network.tube_radius": [0.3e-3, 0.4e-3], "fluid": ["air", "water"]})
    assert table.status == "complete"
    frame = table.frame()
    assert list(zip(frame["network.tube_radius_m"], frame["fluid"], strict=True)) == [
        (0.3e-3, "air"), (0.3e-3, "water"), (0.4e-3, "air"), (0.4e-3, "water"),
    ]  # fmt: skip
    run = simulate(scene("network.tube_radius=0.4 mm", "fluid=water"), verify=False)
    assert frame.loc[3, list(METRIC_NAMES)].to_numpy(float) == pytest.approx(
        np.array(list(run.metrics.values())), rel=1e-12, nan_ok=True
    )


def test_compiled_rows_are_those_of_simulate() -> None:
    """To the accuracy of the scene, of which effects that `simulate` leaves out take a part."""
    given = leg(*COARSE, "effects={inertia: off, others: auto}", config="leg_4_air")
    over = {"network.tubes[*].length": "20 mm..80 mm", "input.start": "5 kPa..15 kPa"}
    keys = swept_keys(given, over)
    rows = list(enumerate(latin_hypercube(keys, 3, 0)))
    tables = [DesignSolver(given, keys, {(): n}).solve(rows) for n in (1000, 1)]
    tip = [METRIC_NAMES.index(f"tip_{axis}_{end}_m") for axis in "xz" for end in ("min", "max")]
    compiled, simulated = (np.array([r.metrics for r in table])[:, tip] for table in tables)
    assert compiled == pytest.approx(simulated, abs=given.accuracy * given.actuator.length)
    assert all(c.effects >= s.effects for c, s in zip(*tables, strict=True))


def test_the_same_seed_draws_the_same_designs() -> None:
    keys = swept_keys(
        scene(), {"network.tubes[*].length": "10 mm..80 mm:log", "fluid": "air,water"}
    )
    one, same, other = (latin_hypercube(keys, 10, seed) for seed in (1, 1, 2))
    assert one == same != other
    lengths = np.array([design[:4] for design in one])
    # One in each tenth of the range, by ratios.
    parts = np.sort((np.log(lengths / 0.01) / np.log(8) * 10).astype(int), axis=0)
    assert np.array_equal(parts, np.tile(np.arange(10)[:, None], 4))
    assert Counter(design[4] for design in one) == {"air": 5, "water": 5}


def test_failed_rows_are_named_and_the_others_go_on() -> None:
    table = quick(scene(), ["network.tube_radius=-1 mm,0.3 mm", "fluid=air,whater"])
    assert [r.row for r in table.failures] == [0, 1, 3]
    assert "above 0 m; got -0.001 m" in table.failures[0].failure
    assert table.failures[2].failure.startswith("fluid: unknown fluid 'whater'")
    assert table.words(3) == "network.tube_radius=0.0003 m, fluid=whater"
    assert np.isfinite(table.results[2].metrics[0])
    assert table.frame()["status"].tolist() == ["failed", "failed", "complete", "failed"]


def test_hardly_meant_values_are_warned_of() -> None:
    table = quick(scene(), {"network.tube_radius": [0.3e-3, 0.4]})
    assert [w.where for w in table.warnings] == ["network.tube_radius"]


def test_a_solver_can_be_sent_to_another_process() -> None:
    keys = swept_keys(scene(), {"network.tube_radius": "0.3 mm,0.4 mm"})
    solver = DesignSolver(scene(), keys, {(): 2})
    rows = [(0, (0.3e-3,))]
    assert pickle.loads(pickle.dumps(solver)).solve(rows) == solver.solve(rows)


def test_the_extreme_rows_are_verified() -> None:
    """A pressure below vacuum, which the numbers of a table do not show."""
    table = sweep(scene("input.start=5 kPa"), {"input.drop": [1e3, 2e3, 300e3]}, verify=2)
    largest, smallest = table.verified
    assert [largest.row, smallest.row] == [2, 0]
    assert (largest.validity, smallest.validity) == ("outside", "inside")
    assert any("below vacuum" in reason for reason in largest.reasons)
    for own in table.verified:
        assert own.estimated_tip_error_m is not None
        assert own.estimated_tip_error_m <= table.requested_m
        assert own.extremes_apart_m is not None
        assert own.extremes_apart_m <= 2 * table.requested_m


# -- folders ----------------------------------------------------------------------

RADII = {"network.tube_radius": [0.3e-3, 0.35e-3, 0.4e-3]}


def test_the_same_sweep_computes_no_row_twice(tmp_path: Path) -> None:
    first = quick(scene(), RADII, folder=tmp_path)
    again = quick(scene(), RADII, folder=tmp_path)
    assert (first.computed, again.computed) == (3, 0)
    assert again.results == first.results


def test_a_torn_line_is_computed_again(tmp_path: Path) -> None:
    first = quick(scene(), RADII, folder=tmp_path)
    kept = tmp_path / "sweep.rows.jsonl"
    kept.write_bytes(kept.read_bytes()[:-20])
    again = quick(scene(), RADII, folder=tmp_path)
    assert again.computed == 1
    assert again.results == first.results
    assert Counter(row for row, *_ in lines(tmp_path)) == {0: 1, 1: 1, 2: 1}


def test_a_spoilt_line_is_computed_again(tmp_path: Path) -> None:
    first = quick(scene(), RADII, folder=tmp_path)
    kept = tmp_path / "sweep.rows.jsonl"
    head, _, *rest = kept.read_bytes().splitlines(keepends=True)
    kept.write_bytes(b"".join([head, bytes(40), b"\n", *rest]))
    again = quick(scene(), RADII, folder=tmp_path)
    assert again.computed == 1
    assert again.results == first.results


@pytest.mark.parametrize(
    ("other", "over"),
    [(scene, {"network.tube_radius": [0.3e-3]}), (lambda: scene("fluid=water"), RADII)],
)
def test_another_sweep_in_the_folder_is_refused_by_name(
    other: Any, over: dict[str, Any], tmp_path: Path
) -> None:
    quick(scene(), RADII, folder=tmp_path)
    with pytest.raises(UsageError, match=r"another sweep: leg_4_air over network.tube_radius, 3"):
        quick(other(), over, folder=tmp_path)
    assert len(lines(tmp_path)) == 3
    assert quick(other(), over, folder=tmp_path, force=True).computed == len(
        over["network.tube_radius"]
    )


def test_an_interrupt_keeps_what_is_there(tmp_path: Path) -> None:
    def interrupt(fraction: float) -> None:
        if fraction > 0:
            signal.raise_signal(signal.SIGINT)

    # Rows are handed over after a moment: more than one may be done by then.
    table = quick(scene(), {"network.tube_radius": np.linspace(0.3e-3, 0.4e-3, 16)},
                  folder=tmp_path, workers=1, progress=interrupt)  # fmt: skip
    assert table.status == "interrupted"
    assert table.missing
    assert [found[0] for found in lines(tmp_path)] == sorted(table.results)


def test_killed_at_any_moment_it_goes_on(tmp_path: Path) -> None:
    spec = tmp_path / "leg.yaml"
    text = (CONFIGS / "leg_4_air.yaml").read_text()
    spec.write_text(text)
    words = [
        *(sys.executable, "-m", "viscodesign", "sweep", str(spec), "-o", str(tmp_path / "out")),
        *(
            "--over",
            "network.tube_radius=0.3 mm..0.5 mm:20",
            "--over",
            "input.start=5 kPa..9 kPa:6",
        ),
        *("--no-plots", "--json", "--workers", "2", "--verify", "0"),
        *(word for change in QUASI_STATIC for word in ("--set", change)),
    ]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    killed = subprocess.Popen(words, env=environment, stdout=subprocess.DEVNULL)
    kept = tmp_path / "out" / "sweep.rows.jsonl"
    while killed.poll() is None and not (kept.exists() and kept.read_bytes().count(b"\n") > 1):
        time.sleep(0.02)
    killed.kill()
    killed.wait()
    before = {row for row, *_ in lines(tmp_path / "out")}
    done = subprocess.run(words, env=environment, capture_output=True, text=True, check=True)
    document = json.loads(done.stdout)
    assert document["status"] == "complete"
    assert document["cost"]["computed"] == 120 - len(before) < 120
    assert sorted(row for row, *_ in lines(tmp_path / "out")) == list(range(120))


MANY = {"network.tube_radius": np.linspace(0.3e-3, 0.5e-3, 240)}


def test_killed_five_times_no_row_is_lost_or_computed_twice(tmp_path: Path) -> None:
    """At moments by chance: while it starts, solves, or writes; all processes at once."""
    chance, counts = np.random.default_rng(5), [0]
    for _ in range(5):
        if not (child := os.fork()):
            try:
                quick(scene(), MANY, folder=tmp_path, workers=2)
            finally:
                os._exit(0)
        time.sleep(chance.uniform(0.0, 0.6))
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        kept = tmp_path / "sweep.rows.jsonl"
        counts.append(kept.read_bytes().count(b"\n") if kept.exists() else 0)
    assert counts == sorted(counts)  # nothing that was kept is gone
    table = quick(scene(), MANY, folder=tmp_path, workers=2)
    assert table.status == "complete"
    assert table.computed == 240 - max(counts[-1] - 1, 0)
    assert sorted(row for row, *_ in lines(tmp_path)) == list(range(240))


def test_a_worker_that_is_killed_costs_its_chunk_until_the_next_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    solve = DesignSolver.solve

    def deadly(solver: DesignSolver, rows: list[Any], within_s: float) -> list[Any]:
        if any(row == 70 for row, _ in rows):
            os.kill(os.getpid(), signal.SIGKILL)
        return solve(solver, rows, within_s)

    with monkeypatch.context() as broken:
        broken.setattr(DesignSolver, "solve", deadly)
        table = quick(scene(), MANY, folder=tmp_path, workers=2)
    assert table.status == "incomplete"
    assert 70 in table.missing
    assert len(table.missing) <= 60  # a chunk is a quarter of the rows
    assert table.computed == 240 - len(table.missing)
    again = quick(scene(), MANY, folder=tmp_path, workers=2)
    assert (again.status, again.computed) == ("complete", len(table.missing))
    assert sorted(row for row, *_ in lines(tmp_path)) == list(range(240))


# -- what is refused --------------------------------------------------------------


@pytest.mark.parametrize(
    ("over", "options", "words"),
    [
        ({}, {}, "no key varies"),
        ([], {}, "no key varies"),
        ("network.tub_length=1 mm,2 mm", {}, "no such key; did you mean 'tube_length'"),
        ("network.tubes[R7-R8].length=1 mm,2 mm", {}, "no such tube"),
        ("name=a,b", {}, "cannot vary: it changes no number of a run"),
        ("pump.syringe_stroke=1 mm,2 mm", {}, "cannot vary: a run does not contain the pump"),
        ("fluid=whater,ayr", {}, "unknown fluid 'whater'"),
        ("bellows.count=5", {}, "5 is odd"),
        ("network.tube_radius=0.2 mm..0.4 mm", {}, "a grid needs the number of values"),
        ("network.tube_radius=0.2 mm..0.4 mm:3", {"sample": 5}, "without :3"),
        ("network.tube_radius=0.2 mm..0.4 mm", {"sample": 0}, "sample: must be from 1"),
        ("network.tubes[*].length=1 mm..2 mm:40", {}, "combinations are more than 1,000,000"),
        (
            ["network.tube_length=1 mm,2 mm", "network.tubes[R1-R2].length=1 mm,2 mm"],
            {},
            "overlaps with network.tube_length",
        ),
        ("network.tube_radius=1 mm", {"verify": -1}, "verify: must be a number of rows"),
        ("network.tube_radius=1 mm", {"workers": 0}, "workers: must be at least 1; got 0"),
    ],
)
def test_what_is_refused(over: Any, options: dict[str, Any], words: str) -> None:
    with pytest.raises((SpecError, UsageError), match=words):
        quick(scene(), over, **options)
