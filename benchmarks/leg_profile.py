"""Profile of the CPU time of a simulation of the published leg (8 s).

    python benchmarks/leg_profile.py            # measure, then report
    python benchmarks/leg_profile.py --report   # report existing results

Every round has a process of its own that does, step by step and once, what
`viscodesign simulate configs/leg_16_straight_air.yaml` does, then what changed scenes cost; the
page tells the least of the rounds, which a busy machine disturbs least. The unloaded quasi-static
leg is measured beside it, over many cycles.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict
from pathlib import Path
from typing import Any

from peers.machine import cpu

HERE = Path(__file__).parent
SCENE = HERE.parent / "configs" / "leg_16_straight_air.yaml"
RESULTS = HERE / "results" / "leg_profile.jsonl"
ROUNDS = 7
CYCLES, FREQUENCY = 100, 0.5
"""Of the quasi-static leg: periods of its sine, and their frequency [Hz]."""
QUASI_STATIC = (
    "effects={pressure_distribution: on, others: off}",
    f"input={{kind: sine, mean: 0 kPa, amplitude: 20 kPa, frequency: {FREQUENCY} Hz}}",
    f"run={{duration: {CYCLES / FREQUENCY}, output_interval: 0.05}}",
    "accuracy=0.01 %",
)
REPEATED = 5
CHANGES = {
    "another tube length": "network.tube_length={0}.5 cm",
    "another pulse": "input.fall_time=0.5{0} s",
}
PLAIN, VERIFIED = "simulate again, not verified", "simulate again, verified"
PICTURES = "pictures, the first time in a process"
COMMAND = "the whole command, cold, without pictures"
BEGUN = "{}, effects known: up to the first step"
COMPILED = "another pulse, compiled: up to the first step"
AIMS = {
    VERIFIED: 0.03,
    COMMAND: 0.5,
    PICTURES: 0.35,
    BEGUN.format("another tube length"): 5e-3,
    COMPILED: 1e-3,
}
"""What was aimed at [s]."""
Record = dict[str, Any]


def main() -> None:
    """Measure and report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=ROUNDS)
    parser.add_argument("--report", action="store_true", help="only report")
    parser.add_argument("--one", action="store_true", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.one:
        print(json.dumps(measure()))
        return
    if not given.report:
        lines = [_in_process() for _ in range(given.rounds)]
        RESULTS.write_text("".join(json.dumps(line) + "\n" for line in lines))
    write_report([json.loads(line) for line in RESULTS.read_text().splitlines()])


def _in_process() -> Record:
    """One round."""
    alone = os.environ | {"OPENBLAS_NUM_THREADS": "1"}
    command = [sys.executable, __file__, "--one"]
    done = subprocess.run(command, capture_output=True, text=True, check=True, env=alone)
    found: Record = json.loads(done.stdout.splitlines()[-1])
    return found


class Watch:
    """CPU times by name [s]: the least where a name was measured more than once."""

    def __init__(self) -> None:
        self.spent: dict[str, float] = {}

    @contextmanager
    def __call__(self, name: str) -> Iterator[None]:
        began = time.process_time()
        yield
        spent = time.process_time() - began
        self.spent[name] = min(spent, self.spent.get(name, spent))


def measure() -> Record:
    """All timings of one round."""
    watch = Watch()
    with watch("import"):
        from viscodesign import load, simulate
        from viscodesign.effects.select import select_effects
        from viscodesign.estimate.scene_quantities import SceneQuantities
        from viscodesign.postprocess.motion import read_motion
        from viscodesign.report.run_folder import write_run
        from viscodesign.simulation.build_problem import build, suggest_settings
        from viscodesign.solve.solvers.base import Work
        from viscodesign.solve.solvers.rosenbrock import Rosenbrock
        from viscodesign.solve.statics import equilibrium
        from viscodesign.solve.transient import integrate
    with watch("read and validate the spec"):
        scene = load(SCENE)
    with watch("weigh all effects"):
        quantities = SceneQuantities(scene)
        selection = select_effects(quantities)
    settings = suggest_settings(quantities, selection.effects)
    with watch("formulas, derivatives"):
        problem = build(quantities, selection.effects, settings)
    with watch("equilibrium at the start"):
        start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    with watch("local terms, kernels from the cache"):
        solver = Rosenbrock(problem, settings.tolerance)
    count, work = len(problem.schedule.edges) - 1, Work()
    solver(start, 0, count, Work())
    with watch("steps through time"):
        solver(start, 0, count, work)
    solution = integrate(problem, start, settings.tolerance)
    with watch("read outputs and balances"):
        read_motion(problem, solution)
    for _ in range(REPEATED):
        with watch(PLAIN):
            simulate(scene, verify=False)
        with watch(VERIFIED):
            run = simulate(scene)
    for k in range(1, REPEATED + 1):
        for name, changes in CHANGES.items():
            change = changes.format(k)
            with watch(f"{name}: load, choose effects, solve, not verified"):
                simulate(load(SCENE, [change]), verify=False)
            other = SceneQuantities(load(SCENE, [change, f"accuracy={0.5 + 1e-6 * k} %"]))
            with watch(BEGUN.format(name)):
                _begin(other, selection.effects, settings)
    _begin_compiled(scene, watch)
    with tempfile.TemporaryDirectory() as folder:
        with watch("tables, summary, spec"):
            write_run(run, Path(folder), plots=False)
        with watch(PICTURES):
            write_run(run, Path(folder), plots=True)
    watch.spent[PICTURES] -= watch.spent["tables, summary, spec"]
    watch.spent[COMMAND] = _command()
    return {
        "parts": watch.spent,
        "counts": {
            "steps": work.steps,
            "residual": work.residual_calls,
            "jacobian": work.jacobian_calls,
            "unknowns": problem.unknowns,
        },
        "settings": asdict(settings),
        "quasi_static": quasi_static(),
        "machine": {"python": platform.python_version(), "cpu": cpu()},
    }


def _begin(quantities: Any, effects: Any, settings: Any) -> None:
    """All that comes before the first step."""
    from viscodesign.simulation.build_problem import build
    from viscodesign.solve.solvers.rosenbrock import Rosenbrock
    from viscodesign.solve.statics import equilibrium

    problem = build(quantities, effects, settings)
    start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    Rosenbrock(problem, settings.tolerance).consistent(start, 0.0, problem.schedule.pieces[0])


def _begin_compiled(scene: Any, watch: Watch) -> None:
    """The same by a compiled function whose pulse is free."""
    from viscodesign import compile
    from viscodesign.compiled.problem_at import problem_at
    from viscodesign.solve.solvers.rodas_native import NativeSteps

    function = compile(scene, ["input.fall_time"], ["tip_x_m"])
    function()
    motion, numbers = function._motion, function._numbers
    for k in range(1, REPEATED + 1):
        with watch(COMPILED):
            found = numbers.at(function.values * (1 + 1e-3 * k))
            problem = problem_at(motion._problem, motion.times, found)
            motion.begin(NativeSteps(problem, motion._tolerance), found)


def _command() -> float:
    """CPU time of the whole command without pictures, in a process of its own [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with tempfile.TemporaryDirectory() as folder:
        words = ["simulate", str(SCENE), "--no-plots", "-q", "-o", folder]
        subprocess.run([sys.executable, "-m", "viscodesign", *words], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def quasi_static() -> Record:
    """The unloaded leg on arcs: time and true error over its cycles."""
    from viscodesign import load
    from viscodesign.effects.select import select_effects
    from viscodesign.estimate.scene_quantities import SceneQuantities
    from viscodesign.simulation.build_problem import Settings, suggest_settings
    from viscodesign.simulation.solve_once import solve, tip_difference

    scene = load(SCENE, QUASI_STATIC)
    quantities = SceneQuantities(scene)
    effects = select_effects(quantities).effects
    settings = suggest_settings(quantities, effects)
    run, watch = solve(quantities, effects, settings), Watch()
    again = SceneQuantities(scene)
    with watch("all"):
        solve(again, effects, settings)
    sure = solve(quantities, effects, Settings(settings.edges_per_section, 1e-11))
    return {
        "ms_per_cycle": 1e3 * watch.spent["all"] / CYCLES,
        "error": tip_difference(run.motion, sure.motion) / quantities.body.length,
        "tolerance": settings.tolerance,
    }


WHY = [
    "Why aims are missed. Verified: three solutions, of which the steps in native code are 45 %, "
    "three times as many as one solution has, with twice the edges in the last; outputs, shapes "
    "and balances 20 %, consistent unknowns where stretches begin 9 %, the rest is Python around "
    "them. Up to the first step: the structure of the scene is recognised by walking through all "
    "of its terms (a third), its numbers are settled, and the equilibrium is followed from the "
    "unloaded shape; a compiled function, which knows its structure, does without the first two. "
    "The command: imports are half of it, those of CasADi and NumPy most of these. "
    "Pictures: half is importing matplotlib, a quarter drawing, the rest layout and files.",
]


# -- the page -------------------------------------------------------------------------------


def write_report(rounds: list[Record]) -> None:
    """`leg_profile.md` beside the result lines."""
    last = rounds[-1]
    parts = {name: min(r["parts"][name] for r in rounds) for name in last["parts"]}
    stepping = parts["steps through time"]
    counts, settings, still = last["counts"], last["settings"], last["quasi_static"]
    per_cycle = min(r["quasi_static"]["ms_per_cycle"] for r in rounds)
    lines = [
        "# Time profile of the leg",
        "",
        "`configs/leg_16_straight_air.yaml`, 8 s, at its own accuracy of 0.5 %. CPU time, least of "
        f"{len(rounds)} fresh processes, one thread, Python {last['machine']['python']}, "
        f"{last['machine']['cpu']}. Regenerate with `python benchmarks/leg_profile.py`.",
        "",
        "| part | CPU time | aim |",
        "|---|---|---|",
        *(f"| {name} | {_ms(seconds)} | {_aim(name)} |" for name, seconds in parts.items()),
        "",
        *WHY,
        "",
        "## Steps through time",
        "",
        f"The first solution: Rodas5P in native code at a tolerance of {settings['tolerance']:g}, "
        f"edges a section: {settings['edges_per_section']}; {counts['unknowns']} unknowns beside "
        f"sums and integrals, {counts['steps']} steps tried, {counts['residual']} residuals, "
        f"{counts['jacobian']} Jacobians: {1e6 * stepping / counts['steps']:.0f} us a step.",
        "",
        "## The unloaded quasi-static leg",
        "",
        f"Pressure distribution alone, a sine of {FREQUENCY:g} Hz, {CYCLES} cycles with 40 outputs "
        f"each, asked for 0.01 %: **{per_cycle:.2f} ms a simulated cycle**, building and reading "
        f"of outputs included; true tip error {100 * still['error']:.1g} % of the length against a "
        f"tolerance of 1e-11 (used: {still['tolerance']:g}).",
        "",
    ]
    RESULTS.with_suffix(".md").write_text("\n".join(lines))


def _aim(name: str) -> str:
    return _ms(AIMS[name]) if name in AIMS else ""


def _ms(seconds: float) -> str:
    return f"{1e3 * seconds:.3g} ms"


if __name__ == "__main__":
    main()
