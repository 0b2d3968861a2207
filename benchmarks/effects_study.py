"""Does `effects: auto` choose well? A hundred scenes, each against everything on.

    python benchmarks/effects_study.py            # run what is missing, then report
    python benchmarks/effects_study.py --report   # report what is there

Every scene runs in a process of its own, with a limit on its time. Results go to one
line of JSON each as they come; a second call goes on where the first ended. The
report (Markdown and a figure) is computed from these lines alone.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import yaml
from effects_report import Record, read, write_report

HERE = Path(__file__).parent
RESULTS = HERE / "results" / "effects_study.jsonl"
FINER = 20
"""By how much the tolerance is cut where two tips are compared."""
REPEATS = 3
"""Costs are the least of so many runs."""


def main() -> None:
    """Run and report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--scenes", type=int, default=100)
    parser.add_argument("--seed", type=int, default=2026)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--timeout", type=float, default=180.0, help="seconds for one scene")
    parser.add_argument("--only", type=int, help="run one scene here, and print its lines")
    parser.add_argument("--report", action="store_true", help="run nothing")
    parser.add_argument("--output", type=Path, default=RESULTS)
    given = parser.parse_args()
    if given.only is not None:
        for record in study(given.seed, given.only):
            print(json.dumps(record), flush=True)
        return
    if not given.report:
        run_all(given)
    write_report(given.output)


def run_all(given: argparse.Namespace) -> None:
    """Run the scenes that have no line yet."""
    given.output.parent.mkdir(parents=True, exist_ok=True)
    done = {r["index"] for r in read(given.output) if r["kind"] == "end"}
    wanted = [k for k in range(given.scenes) if k not in done]
    with ThreadPoolExecutor(given.jobs) as pool, given.output.open("a") as file:
        for lines in pool.map(lambda k: _in_process(given, k), wanted):
            file.write(lines)
            file.flush()


def _in_process(given: argparse.Namespace, index: int) -> str:
    """One scene's lines; what a killed process had said is kept."""
    command = [sys.executable, __file__, "--only", str(index), "--seed", str(given.seed)]
    began = time.monotonic()
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=given.timeout)
        said, note = done.stdout, "" if done.returncode == 0 else done.stderr[-300:]
    except subprocess.TimeoutExpired as late:
        said = late.stdout.decode() if isinstance(late.stdout, bytes) else late.stdout or ""
        note = f"stopped after {given.timeout:g} s"
    whole = [line for line in said.splitlines() if line.endswith("}")]
    end = {"kind": "end", "index": index, "wall_s": time.monotonic() - began, "note": note}
    print(f"{index}: {end['wall_s']:.1f} s {note}", flush=True)
    return "\n".join([*whole, json.dumps(end)]) + "\n"


def study(seed: int, index: int) -> Iterator[Record]:
    """Lines of one scene: cost of both, distance of their tips, and every effect's proof."""
    from scene_draw import draw

    from viscodesign import load, simulate

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.yaml"
        path.write_text(yaml.safe_dump(draw(seed, index)))
        scenes = {"auto": load(path), "all": load(path, ["effects={others: on}"])}
    costs = {name: _cost(scene) for name, scene in scenes.items()}
    yield {"kind": "cost", "index": index, **_facts(scenes["auto"]), **costs}
    finer = scenes["auto"].accuracy / 40 / FINER
    auto, every = (simulate(scene, verify=False, tolerance=finer) for scene in scenes.values())
    both = min(len(auto.tip), len(every.tip))
    apart = np.hypot(*(auto.tip[:both, :2] - every.tip[:both, :2]).T)
    yield {
        "kind": "choice",
        "index": index,
        "distance_over_accuracy": float(np.max(apart)) / auto.accuracy.requested_m,
        "status": [auto.status, every.status],
        "failure": [auto.failure, every.failure],
        "taken": [v.name for v in auto.effects if v.taken],
    }
    proven = simulate(scenes["auto"], verify=False, prove=True)
    budget = proven.accuracy.requested_m
    for proof in proven.proof:
        yield {
            "kind": "proof",
            "index": index,
            "effect": proof.name,
            "taken": proof.taken,
            "estimated": proof.estimated_m / budget,
            "measured": None if proof.measured_m is None else proof.measured_m / budget,
            "note": proof.note,
        }


def _facts(scene: Any) -> Record:
    from viscodesign import classify

    found = classify(scene)
    return {
        "quadrant": found.quadrant,
        "fluid": scene.fluid.name,
        "layout": scene.network.layout,
        "bellows": scene.bellows.count,
        "ratios": [found.scales.ratios["ts_over_tf"], found.scales.ratios["ts_over_ti"]],
    }


def _cost(scene: Any) -> Record:
    """Wall times of choosing, building and solving at the scene's own accuracy [s]."""
    from viscodesign.build import suggest_settings
    from viscodesign.effects.conditions import Conditions
    from viscodesign.effects.select import select_effects
    from viscodesign.solving import solve

    best: Record = {}
    for _ in range(REPEATS):
        conditions = Conditions(scene)
        began = time.perf_counter()
        selection = select_effects(conditions)
        chosen = time.perf_counter() - began
        run = solve(conditions, selection.effects, suggest_settings(conditions))
        now = {"choose_s": chosen, "build_s": run.build_s, "solve_s": run.solve_s}
        best = {key: min(value, best.get(key, value)) for key, value in now.items()}
    equations = run.problem.equations
    unknowns = equations.states.count + equations.algebraics.count
    return {**best, "unknowns": unknowns, "steps": run.solution.work.steps}


if __name__ == "__main__":
    main()
