"""What derivatives and batches of compiled scenes cost.

    python benchmarks/derivatives.py            # measure, then report
    python benchmarks/derivatives.py --report   # report existing results

CPU times of one process, the smallest of several rounds; in every round all calls of a scene take
turns, at values that no call had before.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

os.environ |= {"OPENBLAS_NUM_THREADS": "1"}  # before numpy

import numpy as np
from peers.machine import cpu
from rounds import Record, measure_and_report

from viscodesign import __version__, compile, load, simulate
from viscodesign.compiled.function import CompiledFunction
from viscodesign.compiled.problem_at import problem_at
from viscodesign.solve.solvers.rodas_native import NativeSteps

HERE = Path(__file__).parent
CONFIGS = HERE.parent / "configs"
RESULTS = HERE / "results" / "derivatives.jsonl"
ROUNDS = 7
BATCH = 64
TIP = ("tip_x_m", "tip_z_m")
TUBES, RADIUS = "network.tubes[*].length", "network.tube_radius"
QUASI_STATIC = "leg without inertia or loads"
PULSE = ("input.start", "input.drop", "input.fall_time", "input.rise_time", "input.transition")
SCENES: dict[str, tuple[str, tuple[str, ...], tuple[str, ...]]] = {
    "leg, 1 number": ("leg_16_straight_air", (), (RADIUS,)),
    "leg, 22 numbers": ("leg_16_straight_air", (), (TUBES, RADIUS, *PULSE)),
    "leg with all that `auto` includes": ("leg_16_straight_air_auto", (), (TUBES, RADIUS)),
    QUASI_STATIC: (
        "leg_16_straight_air",
        ("effects={pressure_distribution: on, others: off}",),
        (TUBES, RADIUS),
    ),
    "tree of 8 bellows pairs": ("branched_tree", (), ("network.tubes[*].radius",)),
    "leg on its limit cycle, 1 Hz": (
        "leg_16_straight_air",
        (
            "input={kind: sine, amplitude: 20 kPa, frequency: 1 Hz}",
            "run={duration: 2 s, output_interval: 20 ms, start: periodic}",
        ),
        (RADIUS, "input.frequency"),
    ),
    "equilibria": ("steady_left_auto", (), ("actuator.youngs_modulus",)),
}
"""Config, changed keys, free keys."""
PROFILED = "leg, 1 number"
PARTS = (
    "numbers of the problem from the free ones, and the problem",
    "equilibrium at the start",
    "steps in native code",
    "consistent unknowns where stretches begin",
    "outputs, and what ends a run",
)
CHANGE = 1e-3
TIGHT = 1e-9
"""Of a number, and of the steps, where derivatives are compared with differences."""


def main() -> None:
    """Measure and report."""
    measure_and_report(__doc__, ROUNDS, RESULTS, SCENES, measure, report)


def measure(name: str, rounds: int) -> Record:
    """One scene."""
    config, changes, free = SCENES[name]
    path = CONFIGS / f"{config}.yaml"
    scene = load(path, list(changes))
    began = time.process_time()
    function = compile(scene, free, TIP)
    made = time.process_time() - began
    weights = {column: np.ones(len(function.times)) for column in TIP}
    function.vjp(None, weights)
    function.jacobian()
    spent: dict[str, list[float]] = {}
    for k in range(rounds):

        def fresh(call: int, k: int = k) -> np.ndarray:
            return function.values * (1 + 1e-7 * (10 * k + call + 1))

        rows = [fresh(0) * (1 + 1e-9 * j) for j in range(BATCH)]
        place = list(SCENES).index(name)  # no scene solves what another one has
        length = f"network.tube_radius={0.325 * (1 + 1e-5 * k + 1e-6 * place)} mm"
        calls: dict[str, Callable[[], Any]] = {
            "simulate": lambda length=length: simulate(
                load(path, [*changes, length]), verify=False
            ),
            "value": lambda: function(fresh(1)),
            "gradient": lambda: function.vjp(fresh(2), weights),
            "jacobian": lambda: function.jacobian(fresh(3)),
            "batch": lambda rows=rows: function.batch(rows),
        }
        for label, call in calls.items():
            began = time.process_time()
            call()
            spent.setdefault(label, []).append(time.process_time() - began)
    return {
        "parts": _parts(function) if name == PROFILED else {},
        "scene": name,
        "version": __version__,
        "cpu": cpu(),
        "free": len(function.names),
        "compile_s": made,
        **{f"{label}_s": min(times) for label, times in spent.items()},
        "apart": _apart(scene, free),
    }


def _parts(function: CompiledFunction) -> dict[str, float]:
    """CPU time of the parts of one value [s], the least of several."""
    motion, numbers, found = function._motion, function._numbers, dict[str, float]()
    for k in range(1, 21):
        ends, given = [time.process_time()], function.values * (1 + 1e-7 * k)
        numbers.check(given)
        own = numbers.at(given)
        problem = problem_at(motion._problem, motion.times, own)
        steps = NativeSteps(problem, motion._tolerance)
        ends.append(time.process_time())
        start = motion._start(problem, own).start
        ends.append(time.process_time())
        taken = (start, own.stops, own.pieces, motion.times)
        run = motion._stretches.over(steps, *taken, recorded=False)
        ends.append(time.process_time())
        for j, stop in enumerate(own.stops[:-1]):
            motion._stretches.begin(steps, run.end, (float(stop), own.pieces[j]))
        ends.append(time.process_time())
        motion.reading(problem, motion.times, own, run.columns)
        ends.append(time.process_time())
        spent = np.diff(ends)
        spent[2] -= spent[3]  # the beginnings are part of the stretches
        for part, each in zip(PARTS, spent, strict=True):
            found[part] = min(float(each), found.get(part, np.inf))
    return found


def _apart(scene: Any, free: tuple[str, ...]) -> float:
    """Largest distance of a slope of the tip from a difference, over the largest slope."""
    tight = compile(scene, free, TIP, tolerance=TIGHT)
    found: list[float] = []
    slopes = tight.jacobian()
    for k in range(min(len(tight.names), 3)):
        difference = _difference(tight, k)
        largest = max(np.max(np.abs(slopes[column][:, k])) for column in TIP)
        found += [
            float(np.max(np.abs(difference[column] - slopes[column][:, k])) / largest)
            for column in TIP
        ]
    return max(found)


def _difference(function: CompiledFunction, k: int) -> dict[str, np.ndarray]:
    """By one number, of fourth order."""
    change = np.zeros(len(function.names))
    change[k] = CHANGE * function.values[k]
    near, far = (
        (function(function.values + n * change), function(function.values - n * change))
        for n in (1, 2)
    )
    return {
        column: (8 * (near[0][column] - near[1][column]) - far[0][column] + far[1][column])
        / (12 * change[k])
        for column in TIP
    }


def report(records: list[Record]) -> list[str]:
    """The page."""
    first = records[0]
    lines = [
        "# Derivatives and batches of compiled scenes",
        "",
        f"viscodesign {first['version']}, {first['cpu']}, one thread unless said; "
        "`python benchmarks/derivatives.py`.",
        "",
        "CPU time in milliseconds, the smallest of several rounds in which all calls take turns at",
        "values that are new to them. `simulate` is another radius loaded anew, not verified; a",
        "value is one call of the compiled function; the last two columns of times are a value and",
        "its gradient by all free numbers (one adjoint solution), and a value and the whole",
        "Jacobian of the tip's path. Distance: of slopes from differences of fourth order, both at",
        f"a tolerance of {TIGHT:g}, over the largest slope.",
        "",
        "| scene | free | compile | simulate | value | with gradient | with Jacobian | distance |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for r in records:
        value = r["value_s"]
        lines.append(
            f"| {r['scene']} | {r['free']} | {1e3 * r['compile_s']:.0f} | "
            f"{1e3 * r['simulate_s']:.1f} | {1e3 * value:.2f} | {1e3 * r['gradient_s']:.2f} "
            f"({r['gradient_s'] / value:.1f} values) | {1e3 * r['jacobian_s']:.1f} "
            f"({r['jacobian_s'] / value:.1f}) | {r['apart']:.0e} |"
        )
    lines += [
        "",
        f"Batches of {BATCH} rows, tip path out:",
        "",
        "| scene | rows a second of CPU |",
        "|---|---|",
    ]
    lines += [f"| {r['scene']} | {BATCH / r['batch_s']:.0f} |" for r in records]
    return [*lines, "", *EXPLAINED, "", *_profile(records), "", *_aims(records)]


def _profile(records: list[Record]) -> list[str]:
    """Where the time of one row goes."""
    parts = next(r["parts"] for r in records if r["parts"])
    whole = sum(parts.values())
    return [
        "Where one value of the leg goes (least of 20):",
        "",
        "| part | CPU time | share |",
        "|---|---|---|",
        *(f"| {n} | {1e3 * s:.2f} ms | {100 * s / whole:.0f} % |" for n, s in parts.items()),
    ]


def _aims(records: list[Record]) -> list[str]:
    """What was aimed at."""
    lines = ["| aim | reached | |", "|---|---|---|"]
    for scene, most in GRADIENT_AIMS.items():
        r = next(r for r in records if r["scene"] == scene)
        ratio = r["gradient_s"] / r["value_s"]
        met = "met" if ratio <= most else "missed"
        lines.append(
            f"| value and gradient, {scene}: at most {most:g} values | {ratio:.2f} | {met} |"
        )
    for scene in (PROFILED, QUASI_STATIC):
        r = next(r for r in records if r["scene"] == scene)
        for most, way, rate in (
            (ROWS_AIM, "one by one", 1.0 / r["value_s"]),
            (ROWS_TOGETHER_AIM, f"in batches of {BATCH}", BATCH / r["batch_s"]),
        ):
            met = "met" if rate >= most else "missed"
            lines.append(f"| {most} rows a second and core, {scene}, {way} | {rate:.0f} | {met} |")
    return [*lines, "", *MISSED]


GRADIENT_AIMS = {"leg, 22 numbers": 3.0, QUASI_STATIC: 2.0}
ROWS_AIM, ROWS_TOGETHER_AIM = 500, 1500
MISSED = [
    "One by one a row records its steps for derivatives, and some hundred calls of Python and",
    "NumPy surround its steps. In a batch all rows share these calls, and what is left are steps",
    "and outputs in native code: the motion of a rod with inertia ends there. On a limit cycle,",
    "and without inertia under loads, rows are solved one by one. On a limit cycle a value solves",
    "many periods, and its derivatives one more along every state.",
]
EXPLAINED = [
    "A gradient costs the same for any number of free numbers. A Jacobian takes eight of them at",
    "once along the recorded steps; for a path of many points by few numbers it is the cheaper",
    "way to least squares, for one number of many it is the gradient.",
]


if __name__ == "__main__":
    main()
