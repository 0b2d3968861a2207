"""Is the stated error right? Drawn scenes, each compared with a converged reference.

    python benchmarks/error_study.py --references   # compute missing references
    python benchmarks/error_study.py                # run missing scenes, compare, report
    python benchmarks/error_study.py --sharpen      # refine references where errors are small
    python benchmarks/error_study.py --report       # report existing results

A reference has all effects on and is refined until two successive solutions agree, first to a
fraction of the requested accuracy and, with --sharpen, to a fraction of the stated error. It is
compared with `simulate(scene)` as a user calls it. The report (Markdown and a figure) is computed
from the result lines only.
"""

from __future__ import annotations

import argparse
import json
import platform
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import asdict, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from error_report import CONVERGED, write_report
from scene_runs import Record, drawn, options, read, run_all, say

if TYPE_CHECKING:
    from viscodesign.simulation.build_problem import Settings
    from viscodesign.simulation.solve_once import Run

HERE = Path(__file__).parent
RESULTS = HERE / "results" / "error_study.jsonl"
REFERENCES = HERE / ".references"
EVERYTHING = ("effects={others: on}",)
AGREED = 0.01
"""Distance of two solutions in a row, relative to the accuracy asked for, that ends refinement."""
LIMIT, REFERENCE_LIMIT = 120.0, 240.0
"""Time limit of one scene [s]."""
UNKNOWN = {"true_m": None, "true_at_s": None, "reference_m": None}
FINEST = 1e-12
"""Tolerance below which solutions are dominated by rounding errors."""


def main() -> None:
    """Run and report."""
    parser = options(__doc__.splitlines()[0], LIMIT, RESULTS)
    parser.add_argument("--references", action="store_true", help="compute the references")
    parser.add_argument(
        "--sharpen", action="store_true", help="refine references that are too coarse"
    )
    parser.add_argument("--plain", action="store_true", help="without verification, cost only")
    parser.add_argument("--folder", type=Path, default=REFERENCES, help="folder of the references")
    given = parser.parse_args()
    if given.references or given.sharpen:
        make_references(given)
    elif given.plain:
        say([plain(given.seed, given.only)])
    elif given.only is not None:
        say(study(given.seed, given.only, given.folder))
    else:
        if not given.report:
            run_all(given, __file__, ("--folder", str(given.folder)))
            compare(given.output, given.folder)
        write_report(given.output, given.seed)


def make_references(given: argparse.Namespace) -> None:
    """Compute one, or all missing ones; results of a stopped process are kept."""
    if given.only is not None:
        stated = _stated(given.output) if given.sharpen else {}
        say(refine(given.seed, given.only, given.folder, stated.get(given.only)))
        return
    step = "sharpen" if given.sharpen else "references"
    more = (f"--{step}", "--folder", str(given.folder), "--output", str(given.output))
    given.output = given.folder / f"{step}.jsonl"
    if given.timeout == LIMIT:  # none was given
        given.timeout = REFERENCE_LIMIT
    run_all(given, __file__, more)


def _stated(results: Path) -> dict[int, float]:
    """Stated error by scene [m]."""
    runs = (r for r in read(results) if r["kind"] == "run")
    return {r["index"]: e for r in runs if (e := r["estimated_tip_error_m"]) is not None}


def reference_path(folder: Path, index: int) -> Path:
    """File of one scene's reference."""
    return folder / f"scene_{index}.npz"


def run_path(folder: Path, index: int) -> Path:
    """File of the tip that is compared with it."""
    return folder / f"run_{index}.npz"


def refine(seed: int, index: int, folder: Path, stated_m: float | None) -> Iterator[Record]:
    """Solve with all effects and refine until two successive solutions agree."""
    from viscodesign.effects.select import select_effects
    from viscodesign.estimate.scene_quantities import SceneQuantities
    from viscodesign.simulation.build_problem import suggest_settings
    from viscodesign.simulation.solve_once import solve

    quantities = SceneQuantities(drawn(seed, index, EVERYTHING))
    selection = select_effects(quantities)
    requested_m = quantities.accuracy * quantities.body.length
    wanted_m = AGREED * requested_m if stated_m is None else CONVERGED * stated_m
    settings, tip = suggest_settings(quantities, selection.effects), None
    path = reference_path(folder, index)
    if path.exists():
        settings, tip, moved_m = _kept(path)
        if moved_m <= wanted_m:
            return
        settings = _finer(settings)
    while settings.tolerance > FINEST:
        run = solve(quantities, selection.effects, settings)
        moved_m = None if tip is None else distance(tip, run.motion.tip)
        yield {
            "kind": "level",
            "index": index,
            **asdict(settings),
            "spent_s": run.spent_s,
            "moved": None if moved_m is None else moved_m / requested_m,
            "failure": None if run.is_complete else str(run.motion.failure),
        }
        if not run.is_complete:
            return
        if moved_m is not None:
            _keep(path, run, convergence_m=moved_m)
            if moved_m <= wanted_m:
                return
        settings, tip = _finer(settings), run.motion.tip


def _finer(settings: Settings) -> Settings:
    return replace(
        settings,
        edges_per_section=2 * settings.edges_per_section,
        tolerance=settings.tolerance / 10,
    )


def distance(one: np.ndarray, other: np.ndarray) -> float:
    """Largest distance of two tips (T, 3) over their common times [m]."""
    return float(_apart(one, other).max())


def _apart(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    both = min(len(one), len(other))
    difference = one[:both, :2] - other[:both, :2]
    return np.asarray(np.hypot(difference[:, 0], difference[:, 1]))


def _keep(path: Path, run: Run, **more: float) -> None:
    """Write a solution, completely or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_suffix(".part.npz")
    settings = json.dumps(asdict(run.settings))
    np.savez(partial, time=run.motion.time, tip=run.motion.tip, settings=settings, **more)
    partial.replace(path)


def _kept(path: Path) -> tuple[Settings, np.ndarray, float]:
    """Settings and tip of a reference, and how far the last refinement moved it [m]."""
    from viscodesign.simulation.build_problem import Settings

    with np.load(path) as kept:
        settings = Settings(**json.loads(str(kept["settings"])))
        return settings, kept["tip"], float(kept["convergence_m"])


def study(seed: int, index: int, folder: Path) -> Iterator[Record]:
    """Result lines of one scene: stated and true error, and cost with and without verification."""
    from viscodesign import simulate

    folder.mkdir(parents=True, exist_ok=True)
    scene = drawn(seed, index)
    began = time.perf_counter()
    run = simulate(scene)
    wall_s = time.perf_counter() - began
    np.savez(run_path(folder, index), time=run.time, tip=run.tip)
    yield {
        "kind": "run",
        "index": index,
        "length_m": run.length,
        "made_with": made_with(),
        **_facts(scene, run),
        **asdict(run.accuracy),
        **UNKNOWN,
        "status": run.status,
        "failure": run.failure,
        "wall_s": wall_s,
        "cost": asdict(run.cost),
        "taken": [v.name for v in run.effects if v.taken],
        "settings": dict(run.settings),
    }
    # In its own process, where nothing has been built yet.
    command = [sys.executable, __file__, "--plain", "--only", str(index), "--seed", str(seed)]
    said = subprocess.run(command, capture_output=True, text=True, check=True, timeout=LIMIT)
    yield json.loads(said.stdout)


def made_with() -> str:
    """Versions of the software."""
    import casadi
    import scipy

    from viscodesign import __version__

    return (
        f"Python {platform.python_version()}, {platform.machine()}, viscodesign {__version__}, "
        f"casadi {casadi.__version__}, scipy {scipy.__version__}"
    )


def plain(seed: int, index: int) -> Record:
    """Cost of the first solution only."""
    from viscodesign import simulate

    scene = drawn(seed, index)
    began = time.perf_counter()
    run = simulate(scene, verify=False)
    wall_s = time.perf_counter() - began
    return {"kind": "plain", "index": index, "wall_s": wall_s, "cost": asdict(run.cost)}


def _facts(scene: Any, run: Any) -> Record:
    return {
        "quadrant": run.classification.quadrant,
        "fluid": scene.fluid.name,
        "bellows": scene.bellows.count,
    }


def compare(results: Path, folder: Path) -> None:
    """Write the distance from the current reference into the line of every run."""
    records = read(results)
    for record in records:
        if record["kind"] == "run":
            record.update(_compared(folder, record["index"]) or {})
    partial = results.with_suffix(".part")
    partial.write_text("".join(json.dumps(record) + "\n" for record in records))
    partial.replace(results)


def _compared(folder: Path, index: int) -> Record | None:
    """Largest distance from the reference, its time, and the uncertainty of the reference [m]."""
    paths = run_path(folder, index), reference_path(folder, index)
    if not all(path.exists() for path in paths):
        return None
    with np.load(paths[0]) as run, np.load(paths[1]) as reference:
        both = min(len(run["time"]), len(reference["time"]))
        if not np.allclose(run["time"][:both], reference["time"][:both], rtol=1e-9):
            raise ValueError(f"{paths[1]} has other output times than {paths[0]}")
        apart = _apart(run["tip"], reference["tip"])
        return {
            "true_m": float(apart.max()),
            "true_at_s": float(run["time"][apart.argmax()]),
            "reference_m": float(reference["convergence_m"]),
        }


if __name__ == "__main__":
    main()
