"""How the cost of viscodesign grows with the size of the problem.

    python benchmarks/growth.py            # measure what is missing, then report
    python benchmarks/growth.py --again    # measure all of it anew
    python benchmarks/growth.py --report   # report existing results

Five families, each from configs/leg_16_straight_air.yaml, at its accuracy of 0.5 %:

- `bellows_arcs`: 4 to 1024 bellows, the network on a quasi-static, unloaded rod of arcs;
- `bellows_dynamic`: the same with inertia, damping, feedback and gravity, an edge a
  section but sixteen at least;
- `edges`: 16 bellows, dynamic with gravity, 8 to 512 edges;
- `duration_arcs`, `duration_dynamic`: 16 bellows under a sine of 0.5 Hz, 1 to 1000 s.

More bellows are a finer division of the same actuator: its length, its total turn and
extension at a pressure, its total tube length, storage and rest volume stay. So angle,
extension, area per pressure, per force and per moment, a bellow's width and a tube's
length go with 16/count, and the network's slowest time is nearly the same at any count.

Every point has a process of its own, so that its peak memory is its own and nothing is
kept from another. It solves the scene once to fill what is kept between solutions, which
is told as cold, and then again, as often as patience allows; the fastest is told as warm.
Times are of the CPU, but for the limit of a point.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
SCENE = HERE.parent / "configs" / "leg_16_straight_air.yaml"
RESULTS = HERE / "results" / "growth.jsonl"
TIME_LIMIT = 240.0
"""Wall time of one point [s]."""
WARM_RUNS, PATIENCE = 3, 20.0
"""Maximum number of warm solutions, and the time after which none is started [s]."""
MIN_EDGES = 16
Record = dict[str, Any]

ARCS = "effects={pressure_distribution: on, others: off}"
DYNAMIC = (
    "effects={pressure_distribution: on, inertia: on, damping: on, feedback: on, gravity: on, "
    "others: off}"
)
SINE = "input={kind: sine, mean: 0 kPa, amplitude: 20 kPa, frequency: 0.5 Hz}"
DURATIONS = [1, 3, 10, 30, 100, 300, 1000]
FAMILIES: dict[str, list[int]] = {
    "bellows_arcs": [4, 16, 64, 128, 256, 512, 1024],
    "bellows_dynamic": [4, 16, 64, 128, 256, 512, 1024],
    "edges": [8, 16, 32, 64, 128, 256, 512],
    "duration_arcs": DURATIONS,
    "duration_dynamic": DURATIONS,
}


def main() -> None:
    """Measure and report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--report", action="store_true", help="only report")
    parser.add_argument("--again", action="store_true", help="also measure what is there")
    parser.add_argument(
        "--only", nargs=2, metavar=("FAMILY", "SIZE"), help="one point, in this process"
    )
    parser.add_argument("--families", nargs="*", default=list(FAMILIES), choices=list(FAMILIES))
    parser.add_argument("--largest", type=int, default=10**9, help="skip larger sizes")
    parser.add_argument(
        "--timeout", type=float, default=TIME_LIMIT, help="time limit of one point in seconds"
    )
    parser.add_argument("--output", type=Path, default=RESULTS)
    given = parser.parse_args()
    if given.only:
        print(json.dumps(measure(given.only[0], int(given.only[1]))))
        return
    if not given.report:
        measure_all(given)
    from growth_report import write_report

    write_report(given.output)


def measure_all(given: argparse.Namespace) -> None:
    """Measure the points without a line; after one that exceeds the limit, no larger one."""
    given.output.parent.mkdir(parents=True, exist_ok=True)
    lines = given.output.read_text().splitlines() if given.output.exists() else []
    done = {(r["family"], r["size"]): r for r in map(json.loads, lines)}
    if given.again:
        done = {point: r for point, r in done.items() if point[0] not in given.families}
    for family in given.families:
        for size in (s for s in FAMILIES[family] if s <= given.largest):
            if (family, size) not in done:
                done[family, size] = record = _in_process(family, size, given.timeout)
                fresh = given.output.with_suffix(".part")
                fresh.write_text("".join(json.dumps(r) + "\n" for r in done.values()))
                fresh.replace(given.output)
                print(_told(record), flush=True)
            if done[family, size]["note"]:
                break


def _told(record: Record) -> str:
    point = f"{record['family']} {record['size']}: "
    if record["note"]:
        return point + str(record["note"])
    return point + f"solve {record['solve_s']:.3g} s, build {record['build_s']:.3g} s"


def _in_process(family: str, size: int, limit: float) -> Record:
    """One point in its own process."""
    command = [sys.executable, __file__, "--only", family, str(size)]
    alone = os.environ | {"OPENBLAS_NUM_THREADS": "1"}
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=limit, env=alone)
    except subprocess.TimeoutExpired:
        return {"family": family, "size": size, "note": f"stopped after {limit:g} s"}
    if done.returncode != 0:
        last = done.stderr.strip().splitlines()[-1:] or [f"return code {done.returncode}"]
        return {"family": family, "size": size, "note": f"failed: {last[0][:200]}"}
    found: Record = json.loads(done.stdout.splitlines()[-1])
    return found


def overrides(family: str, size: int) -> tuple[list[str], int]:
    """Overrides of the published leg for a point, and its edges per section."""
    dynamic = family not in ("bellows_arcs", "duration_arcs")
    changes = [DYNAMIC, "loads={gravity: on}"] if dynamic else [ARCS]
    if family.startswith("duration"):
        changes += [SINE, f"run={{duration: {size}, output_interval: 0.05}}"]
        return changes, MIN_EDGES // 8
    if family == "edges":
        return changes, size // 8
    share = 16 / size
    changes += [
        f"bellows.count={size}",
        f"bellows.width={0.012 * share!r}",
        f"bellows.area_per_pressure={3.413e-9 * share!r}",
        f"bellows.angle_per_pressure={10.266 * share!r}",
        f"bellows.extension_per_pressure={0.047 * share!r}",
        f"bellows.area_per_force={3.0e-7 * share!r}",
        f"bellows.area_per_moment={1.2e-6 * share!r}",
        f"network.tube_length={0.0375 * share!r}",
    ]
    return changes, max(1, MIN_EDGES // (size // 2))


def measure(family: str, size: int) -> Record:
    """Solve one point: cold, then warm."""
    from dataclasses import replace

    from viscodesign import load
    from viscodesign.effects.select import select_effects
    from viscodesign.estimate.scene_quantities import SceneQuantities
    from viscodesign.simulation.build_problem import suggest_settings

    changes, edges = overrides(family, size)
    spent = time.process_time()
    scene = load(SCENE, changes)
    quantities = SceneQuantities(scene)
    effects = select_effects(quantities).effects
    chosen, limit = time.process_time() - spent, time.perf_counter() + PATIENCE
    settings = replace(suggest_settings(quantities, effects), edges_per_section=edges)
    runs = [_Timed(scene, effects, settings)]
    while len(runs) <= WARM_RUNS and (len(runs) == 1 or time.perf_counter() < limit):
        # Another scene of this structure, since equations are cached with their scene.
        runs.append(_Timed(scene, effects, settings))
    last, warm = runs[-1].run, runs[1:]
    equations = last.problem.equations
    return {
        "family": family,
        "size": size,
        "note": "" if last.is_complete else f"failed: {last.motion.failure}",
        "solve_s": min(run.solve_s for run in warm),
        "build_s": min(run.build_s for run in warm),
        "cold_s": runs[0].build_s + runs[0].solve_s,
        "choose_s": chosen,
        "peak_memory_mb": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
        "steps": last.solution.work.steps,
        "unknowns": equations.states.count + equations.algebraics.count,
        "solver": last.solution.solver,
        "tolerance": settings.tolerance,
        "edges_per_section": edges,
        "t_net_s": quantities.scales.t_net,
    }


class _Timed:
    """A problem built and solved, and the CPU time of both [s]."""

    def __init__(self, scene: Any, effects: Any, settings: Any) -> None:
        from viscodesign.estimate.scene_quantities import SceneQuantities
        from viscodesign.simulation.solve_once import Workspace, solve

        quantities, workspace = SceneQuantities(scene), Workspace()
        began = time.process_time()
        workspace.problems.problem(quantities, effects, settings)
        built = time.process_time()
        self.run = solve(quantities, effects, settings, workspace=workspace)
        assert len(self.run.motion.shape)
        assert self.run.motion.invariants
        self.build_s, self.solve_s = built - began, time.process_time() - built


if __name__ == "__main__":
    main()
