"""What does `effects: auto` cost and promise, against everything on?

    python benchmarks/auto_study.py            # run missing scenes of both draws, then report
    python benchmarks/auto_study.py --report   # report existing results

Scenes over the plane of timescales and scenes that ring, each solved by `simulate` with chosen
effects and with everything on, both verified. The reference has everything on, half the edges of
the finer mesh and a hundredth of its tolerance. Costs are CPU times of a second run in the same
process, with the choice remembered and made anew. The page is computed from the lines of JSON.
"""

from __future__ import annotations

import resource
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import ringing_draw
import scene_draw
from auto_report import write_report
from scene_runs import Record, forget_choices, loaded, options, run_all, say

HERE = Path(__file__).parent
RESULTS = HERE / "results" / "auto_study.jsonl"
SEED = 61616
LIMIT, CPU_LIMIT = 900.0, 120
"""Wall and CPU time of one scene [s]."""
DRAWS = (scene_draw.draw, ringing_draw.draw)
"""Scenes of even and of odd index."""
EVERYTHING = ("effects={others: on}",)


def main() -> None:
    """Run and report."""
    parser = options(__doc__.splitlines()[0], LIMIT, RESULTS)
    parser.set_defaults(seed=SEED, scenes=60)
    given = parser.parse_args()
    if given.only is not None:
        resource.setrlimit(resource.RLIMIT_CPU, (CPU_LIMIT, CPU_LIMIT))
        say(study(given.seed, given.only))
        return
    if not given.report:
        run_all(given, __file__)
    write_report(given.output, given.seed)


def study(seed: int, index: int) -> Iterator[Record]:
    """The line of one scene."""
    spec = DRAWS[index % 2](seed, index // 2)
    auto, everything = (_solved(loaded(spec, more)) for more in ((), EVERYTHING))
    tips = [found.pop("tip") for found in (auto, everything)]
    finest = _finer(loaded(spec, EVERYTHING), everything)
    if finest is not None:
        auto["true_m"], everything["true_m"] = (_distance(tip, finest) for tip in tips)
    yield {
        "kind": "scene",
        "index": index,
        "name": spec["name"],
        "auto": auto,
        "all": everything,
        "is_quasi_static": auto["rod"] != "dynamic rod",
    }


def _solved(scene: Any) -> Record:
    from viscodesign import simulate
    from viscodesign.effects.select import select_effects
    from viscodesign.estimate.scene_quantities import SceneQuantities

    first_s, _ = _cpu(lambda: simulate(scene))
    forget_choices()
    choose_s, _ = _cpu(lambda: select_effects(SceneQuantities(scene)))
    again_s, run = min((_cpu(lambda: simulate(scene)) for _ in range(2)), key=lambda p: p[0])
    return {
        "first_s": first_s,
        "choose_s": choose_s,
        "again_s": again_s,
        "status": run.status,
        "failure": run.failure,
        "requested_m": run.accuracy.requested_m,
        "stated_m": run.accuracy.estimated_tip_error_m,
        "taken": [v.name for v in run.effects if v.taken],
        "repeated": len(run.ladder),
        "rod": run.settings["rod"],
        "settings": {k: run.settings[k] for k in ("edges_per_section", "tolerance", "solver")},
        "tip": run.tip[:, :2],
    }


def _cpu(work: Callable[[], Any]) -> tuple[float, Any]:
    began = time.process_time()
    found = work()
    return time.process_time() - began, found


def _finer(scene: Any, run: Record) -> np.ndarray | None:
    """Tip (T, 2) of the reference; None where a run or the reference has no end."""
    from viscodesign.effects.select import select_effects
    from viscodesign.estimate.scene_quantities import SceneQuantities
    from viscodesign.simulation.build_problem import suggest_settings
    from viscodesign.simulation.solve_once import solve

    if run["stated_m"] is None:
        return None
    quantities = SceneQuantities(scene)
    effects = select_effects(quantities).effects
    settings = replace(
        suggest_settings(quantities, effects),
        edges_per_section=2 * run["settings"]["edges_per_section"],
        tolerance=max(run["settings"]["tolerance"] / 100, 1e-11),
    )
    found = solve(quantities, effects, settings)
    return found.motion.tip[:, :2] if found.is_complete else None


def _distance(one: np.ndarray, other: np.ndarray) -> float:
    both = min(len(one), len(other))
    return float(np.max(np.hypot(*(one[:both] - other[:both]).T)))


if __name__ == "__main__":
    main()
