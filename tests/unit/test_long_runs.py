"""Runs of many outputs: the same numbers block by block, and a memory that does not grow."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from tests.scenes import CONFIGS, leg, problem_of
from tests.unit.storage.test_disk_arrays import Full
from viscodesign import Trajectory, simulate
from viscodesign.errors import SpecError
from viscodesign.postprocess.outputs import MARGIN_EDGES, read_outputs
from viscodesign.report.run_folder import write_run
from viscodesign.scene.run import MAX_SHAPES

ONE_WAY = "effects={pressure_distribution: on, others: off}"
UNIFORM = "effects=off"
INERTIA = "effects={pressure_distribution: on, inertia: on, damping: on, others: off}"
GAS = "effects={pressure_distribution: on, gas_compressibility: on, others: off}"
SQUARE = "input={kind: square, high: 10 kPa, low: 5 kPa, frequency: 3 Hz}"
SINE = "input={kind: sine, amplitude: 10 kPa, frequency: 3 Hz}"
SHORT = ("bellows.count=4", "run={duration: 1 s, output_interval: 1 ms}")


def arrays(run: Trajectory) -> dict[str, np.ndarray]:
    return {n: v for n, v in {**run.arrays, "arc": run.arc}.items() if v.size}


def in_small_blocks(monkeypatch: pytest.MonkeyPatch) -> None:
    """Everything on the disk, in blocks that are far smaller than a short run."""
    for place, value in (
        ("postprocess.outputs.BLOCK_NUMBERS", 0),
        ("postprocess.outputs.DISK_ROWS", 1200),
        ("storage.disk_arrays.ArrayStore.__init__.__defaults__", (None, 0)),
    ):
        monkeypatch.setattr(f"viscodesign.{place}", value)


@pytest.mark.parametrize("effects", [ONE_WAY, UNIFORM, INERTIA, GAS])
def test_blocks_on_the_disk_give_the_same_run(
    effects: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    scene = leg(*SHORT, SINE, effects)
    whole = simulate(scene, verify=False)
    in_small_blocks(monkeypatch)
    parted = simulate(scene, verify=False, scratch=tmp_path)
    assert not list(tmp_path.iterdir())
    assert not parted.pressure.flags.writeable  # it is on the disk
    for name, values in arrays(whole).items():
        scale = max(float(np.max(np.abs(values))), 1e-300)
        assert arrays(parted)[name] == pytest.approx(values, rel=0, abs=1e-12 * scale), name
    assert parted.warnings == whole.warnings
    found, wanted = parted.invariants, whole.invariants
    assert found.volume_imbalance_rel == pytest.approx(wanted.volume_imbalance_rel, abs=1e-14)
    assert found.energy_imbalance_rel == pytest.approx(wanted.energy_imbalance_rel, rel=1e-6)
    files = [write_run(run, tmp_path / run_name, plots=False) for run_name, run in
             (("whole", whole), ("parted", parted))]  # fmt: skip
    if effects != UNIFORM:  # flows of splines differ by round-off
        assert [f.read_bytes() for f in files[0][:2]] == [f.read_bytes() for f in files[1][:2]]


def test_a_failure_is_found_in_whichever_block_it_lies(monkeypatch: pytest.MonkeyPatch) -> None:
    pressed = "input={kind: table, rows: [[0, 0], [0.4, 0], [1, -400 kPa]]}"
    scene = leg(SHORT[1], pressed, "effects={others: off}")
    whole = simulate(scene, verify=False)
    in_small_blocks(monkeypatch)
    parted = simulate(scene, verify=False)
    assert whole.status == parted.status == "failed"
    assert parted.failure == whole.failure
    assert np.array_equal(parted.time, whole.time)


def test_blocks_overlap_by_a_margin_and_own_every_edge_once() -> None:
    from viscodesign.solve.statics import equilibrium
    from viscodesign.solve.transient import integrate

    problem = problem_of(leg(*SHORT, SQUARE, ONE_WAY))
    solution = integrate(problem, equilibrium(problem, 0.0, problem.schedule.initial_piece), 1e-4)
    parts = list(read_outputs(problem, solution, at_once=300))
    owned = [k for part in parts for k in range(part.begin, part.end)]
    assert owned == list(range(solution.reached))
    assert parts[1].first == 300 - MARGIN_EDGES
    assert len(parts[1].time) == 300 + 2 * MARGIN_EDGES


def test_a_full_disk_ends_a_run_that_keeps_what_it_has(monkeypatch: pytest.MonkeyPatch) -> None:
    scene = leg(*SHORT, SINE, ONE_WAY)
    in_small_blocks(monkeypatch)
    disks = iter([Full(10**7)] * 4 + [Full(20_000)] + [Full(10**7)] * 50)
    monkeypatch.setattr(
        "viscodesign.storage.disk_arrays.tempfile.TemporaryFile", lambda **_: next(disks)()
    )
    run = simulate(scene, verify=False)
    assert run.status == "failed"
    assert "no space for the arrays of the run" in (run.failure or "")
    assert 0 < len(run.time) < 1001
    assert len(run.shape) == len(run.time) == len(run.tip) == len(run.pressure)


# -- what is written ---------------------------------------------------------


def test_shapes_of_a_long_run_are_thinned_with_a_notice() -> None:
    run = simulate(leg(*SHORT, SINE, UNIFORM, "run.shape_every=300"), verify=False)
    assert list(run.shape_rows) == [0, 300, 600, 900, 1000]
    assert len(run.shape) == 5
    assert run.shape[:, -1] == pytest.approx(run.tip[run.shape_rows, :2], abs=0)
    assert len(run.shape_frame()) == 5 * len(run.arc)
    (notice,) = (n for n in run.warnings if n.code == "thinned_shapes")
    assert "5 of 1001 output times" in notice.message


def test_the_usual_run_keeps_every_shape() -> None:
    assert leg("run={duration: 400 s}").run.shape_stride == 1
    assert leg("run={duration: 1e5 s}").run.shape_stride == 5_000_000 // MAX_SHAPES
    assert leg("run={duration: 1e5 s, shape_every: 1}").run.shape_stride == 1


def test_an_input_with_more_corners_than_steps_is_refused_before_solving() -> None:
    square = "input={kind: square, high: 1 kPa, low: 0, frequency: 2 Hz}"
    scene = leg(square, "run={duration: 1e5 s, output_interval: 1 s, max_steps: 100000}")
    with pytest.raises(SpecError, match=r"run.max_steps: .* 399999 corners .* 2.5e\+04 s"):
        simulate(scene)


def test_a_hundred_hertz_for_a_day_is_refused_by_its_number() -> None:
    square = "input={kind: square, high: 1 kPa, low: 0, frequency: 100 Hz}"
    with pytest.raises(SpecError, match=r"input: 1e\+07 periods .* 250000 are allowed"):
        leg(square, "run={duration: 1e5 s, output_interval: 1 s}")


# -- memory ------------------------------------------------------------------

PEAK = """
import resource, sys
from viscodesign.cli.main import main
status = main(sys.argv[1:])
print(status, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss)
"""


def peak_mb(outputs: int, folder: Path) -> float:
    """Largest memory of a process that runs the command [MB]."""
    words = ["simulate", str(CONFIGS / "leg_16_straight_air.yaml"), "-q", "-o", str(folder)]
    words += ["--no-verify", "--no-plots"]
    interval = 1e4 / outputs
    for key in (
        ONE_WAY,
        "fluid={name: own, viscosity: 1e-3, density: 1.2}",
        "input={kind: sine, amplitude: 10 kPa, frequency: 0.01 Hz}",
        f"run={{duration: 1e4 s, output_interval: {interval!r}, shape_every: {outputs // 50}}}",
    ):
        words += ["--set", key]
    done = subprocess.run(
        [sys.executable, "-c", PEAK, *words], check=True, capture_output=True, text=True
    )
    status, kilobytes = done.stdout.split()
    assert status == "0", done.stderr
    return int(kilobytes) / 1024


def test_ten_times_the_outputs_take_no_more_memory(tmp_path: Path) -> None:
    """What they hold, 16 bellows' pressures, volumes, flows and unknowns, would take 100 MB."""
    few, many = (peak_mb(outputs, tmp_path) for outputs in (10_000, 100_000))
    assert many < few + 30
