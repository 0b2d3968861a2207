"""What the page holds, without a browser: sizes, what is left out, what is read back."""

from __future__ import annotations

import json
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.scenes import CONFIGS
from tests.trajectories import made_run
from viscodesign import load, simulate
from viscodesign.cli.main import main
from viscodesign.report.page.page import page_bytes
from viscodesign.report.page.page_data import page_data
from viscodesign.report.page.shown_rows import shapes_near
from viscodesign.report.run_folder import write_run


def _cycles(time: np.ndarray) -> np.ndarray:
    return 2e4 + 5e4 * np.sin(2 * np.pi * 0.7 * time)


def data_of(run: Any) -> dict[str, Any]:
    return page_data(run)


def test_the_page_of_a_leg_is_small() -> None:
    run = made_run()
    assert len(run.time) == 401
    assert len(page_bytes(run)) < 0.5e6


def test_the_page_of_many_bellows_is_small_and_says_what_it_left_out() -> None:
    run = made_run(bellows=1024, lag=1e-6)
    assert len(page_bytes(run)) < 2e6
    notes = " ".join(data_of(run)["notes"])
    for words in ("of 401 output times are shown, every 3rd", "32 of 1,024 tubes"):
        assert words in notes


def test_a_long_run_of_fast_cycles_is_shown_at_its_end() -> None:
    cycle = made_run(time=np.linspace(0, 10, 101)[:-1], inlet=_cycles)
    many = {name: np.concatenate([values] * 1000) for name, values in cycle.arrays.items()}
    run = cycle.with_arrays(**{**many, "time": np.linspace(0, 1e4, 100_001)[:-1]})
    note = data_of(run)["notes"][0]
    assert "1,500 of 100,000 output times are shown, the last, from t = 9850 s" in note
    assert len(page_bytes(run)) < 1.5e6


def test_a_long_slow_run_is_shown_whole() -> None:
    slow = made_run(time=np.linspace(0, 1e5, 4001), inlet=lambda t: _cycles(t / 4e4), bellows=2)
    assert "every 3rd" in data_of(slow)["notes"][0]


def test_shapes_that_are_stored_now_and_then_are_those_nearest() -> None:
    rare = made_run(shape_every=10).with_arrays(shape=made_run().shape[::10])
    near = shapes_near(rare, np.array([0, 4, 6, 14, 396, 400]))
    assert near.tolist() == [0, 0, 1, 1, 40, 40]
    assert "41 of 401" in " ".join(data_of(rare)["notes"])


@pytest.mark.parametrize("config", ["antagonistic_two_inlets", "branched_tree"])
def test_a_folder_gives_the_page_of_its_run(config: str, tmp_path: Path) -> None:
    changes = ("run.duration=0.1 s", "effects={others: off, pressure_distribution: on}")
    run = simulate(load(CONFIGS / f"{config}.yaml", changes), verify=False)
    write_run(run, tmp_path, plots=False)
    page = tmp_path / "report.html"
    before = page.read_bytes()
    assert main(["report", str(tmp_path), "-q"]) == 0
    marks = (b'"write_s"', b'"total_s"')  # the page was part of what was written
    parts = [_without(text, marks) for text in (before, page.read_bytes())]
    assert parts[0] == parts[1]
    assert main(["report", str(tmp_path), "-q", "-o", str(tmp_path / "a" / "b")]) == 0
    assert (tmp_path / "a" / "b" / "report.html").read_bytes() == page.read_bytes()


def _without(page: bytes, keys: tuple[bytes, ...]) -> dict[str, Any]:
    text = page.split(b'id="run">')[1].split(b"</script>")[0]
    data: dict[str, Any] = json.loads(text)
    for key in keys:
        data["summary"]["cost"].pop(json.loads(key))
    return data


def test_a_folder_that_holds_no_run_is_refused(tmp_path: Path) -> None:
    assert main(["report", str(tmp_path), "-q"]) == 2
    assert list(tmp_path.iterdir()) == []


def test_a_page_needs_no_drawing_library(tmp_path: Path) -> None:
    text = (CONFIGS / "leg_16_straight_air.yaml").read_text()
    write_run(made_run(spec_text=text), tmp_path, plots=False, report=False)
    code = (
        "import sys; from viscodesign.cli.main import main\n"
        f"assert main(['report', {str(tmp_path)!r}, '-q']) == 0\n"
        "print(sorted({'matplotlib', 'pandas', 'casadi', 'PIL'} & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "[]\n"


def test_the_page_lets_nothing_run_but_its_own() -> None:
    page = page_bytes(made_run(failure="</script><b>")).decode()
    assert "default-src 'none'; script-src 'sha256-" in page
    assert "unsafe" not in page
    assert page.count("</script>") == 2
    for outside in ("http://", "https://", "//cdn", "@import", "url("):
        assert outside not in page.replace("http://www.w3.org/2000/svg", "").replace(
            "url(#pressures)", ""
        )


@pytest.mark.parametrize("rows", [401, 0])
def test_what_was_taken_out_of_a_recording_is_told_first(rows: int) -> None:
    told = "input: 200 rows of trace.csv; noise of 250 Pa was smoothed"
    run = replace(made_run(), notes=(told,))
    if not rows:
        run = run.with_arrays(**{name: values[:0] for name, values in run.arrays.items()})
    assert data_of(run)["notes"][0] == told
    assert told in page_bytes(run).decode()
