"""Does `effects: auto` select well? Drawn scenes, each compared with all effects on.

    python benchmarks/effects_study.py            # run missing scenes, then report
    python benchmarks/effects_study.py --report   # report existing results

Every scene runs in its own process with a time limit. Each result is written as one line of
JSON when it is ready; a second call resumes. The report (Markdown and a figure) is computed
from these lines only.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from effects_report import Record, write_report
from scene_runs import drawn, forget_choices, options, run_all, say

HERE = Path(__file__).parent
RESULTS = HERE / "results" / "effects_study.jsonl"
FINER = 20
"""Factor by which the tolerance is reduced where two tips are compared."""
REPEATS = 3
"""Costs are the minimum of this many runs."""
LIMIT = 180.0
"""Time limit of one scene [s]."""


def main() -> None:
    """Run and report."""
    given = options(__doc__.splitlines()[0], LIMIT, RESULTS).parse_args()
    if given.only is not None:
        say(study(given.seed, given.only))
        return
    if not given.report:
        run_all(given, __file__)
    write_report(given.output, given.seed)


def study(seed: int, index: int) -> Iterator[Record]:
    """Result lines of one scene: both costs, the distance of the tips, and every ablation."""
    from viscodesign import simulate

    scenes = {"auto": drawn(seed, index), "all": drawn(seed, index, ["effects={others: on}"])}
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
    for ablation in proven.proof:
        yield {
            "kind": "proof",
            "index": index,
            "effect": ablation.name,
            "taken": ablation.taken,
            "estimated": ablation.estimated_m / budget,
            "measured": None if ablation.measured_m is None else ablation.measured_m / budget,
            "note": ablation.note,
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
    """Wall times of selecting, building and solving at the scene's own accuracy [s]."""
    from viscodesign.effects.select import select_effects
    from viscodesign.estimate.scene_quantities import SceneQuantities
    from viscodesign.simulation.build_problem import suggest_settings
    from viscodesign.simulation.solve_once import solve

    best: Record = {}
    for _ in range(REPEATS):
        forget_choices()
        quantities = SceneQuantities(scene)
        began = time.perf_counter()
        selection = select_effects(quantities)
        chosen = time.perf_counter() - began
        settings = suggest_settings(quantities, selection.effects)
        run = solve(quantities, selection.effects, settings)
        now = {"choose_s": chosen, "build_s": run.build_s, "solve_s": run.solve_s}
        best = {key: min(value, best.get(key, value)) for key, value in now.items()}
    equations = run.problem.equations
    unknowns = equations.states.count + equations.algebraics.count
    return {**best, "unknowns": unknowns, "steps": run.solution.work.steps}


if __name__ == "__main__":
    main()
