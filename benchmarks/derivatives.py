"""What derivatives and batches of compiled scenes cost.

    python benchmarks/derivatives.py            # measure, then report
    python benchmarks/derivatives.py --report   # report existing results

CPU times of one process, the smallest of several rounds; in every round all calls of a scene take
turns, at values that no call had before.
"""

from __future__ import annotations

import argparse
import json
import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

os.environ |= {"OPENBLAS_NUM_THREADS": "1"}  # before numpy

import numpy as np
from peers.machine import cpu

from viscodesign import __version__, compile, load, simulate
from viscodesign.compiled.function import CompiledFunction

HERE = Path(__file__).parent
CONFIGS = HERE.parent / "configs"
RESULTS = HERE / "results" / "derivatives.jsonl"
ROUNDS = 7
BATCH, WORKERS = 24, 2
TIP = ("tip_x_m", "tip_z_m")
TUBES, RADIUS = "network.tubes[*].length", "network.tube_radius"
PULSE = ("input.start", "input.drop", "input.fall_time", "input.rise_time", "input.transition")
SCENES: dict[str, tuple[str, tuple[str, ...], tuple[str, ...]]] = {
    "leg, 1 number": ("leg_16_straight_air", (), (RADIUS,)),
    "leg, 22 numbers": ("leg_16_straight_air", (), (TUBES, RADIUS, *PULSE)),
    "leg with all that `auto` includes": ("leg_16_straight_air_auto", (), (TUBES, RADIUS)),
    "leg without inertia or loads": (
        "leg_16_straight_air",
        ("effects={pressure_distribution: on, others: off}",),
        (TUBES, RADIUS),
    ),
    "tree of 8 bellows pairs": ("branched_tree", (), ("network.tubes[*].radius",)),
    "equilibria": ("steady_left_auto", (), ("actuator.youngs_modulus",)),
}
"""Config, changed keys, free keys."""
CHANGE = 1e-3
TIGHT = 1e-9
"""Of a number, and of the steps, where derivatives are compared with differences."""
Record = dict[str, Any]


def main() -> None:
    """Measure and report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=ROUNDS)
    parser.add_argument("--report", action="store_true", help="only report")
    given = parser.parse_args()
    if not given.report:
        lines = [measure(name, given.rounds) for name in SCENES]
        RESULTS.write_text("".join(json.dumps(line) + "\n" for line in lines))
    records = [json.loads(line) for line in RESULTS.read_text().splitlines()]
    RESULTS.with_suffix(".md").write_text("\n".join(report(records)) + "\n")


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
        length = f"network.tube_radius={0.325 * (1 + 1e-5 * k)} mm"
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
        began = time.perf_counter()
        function.batch([row * (1 + 1e-10) for row in rows], workers=WORKERS)
        spent.setdefault("wall of a batch in threads", []).append(time.perf_counter() - began)
    return {
        "scene": name,
        "version": __version__,
        "cpu": cpu(),
        "free": len(function.names),
        "compile_s": made,
        **{f"{label}_s": min(times) for label, times in spent.items()},
        "apart": _apart(scene, free),
    }


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
        f"| scene | rows a second of CPU | rows a second in {WORKERS} threads |",
        "|---|---|---|",
    ]
    for r in records:
        threads = BATCH / r["wall of a batch in threads_s"]
        lines.append(f"| {r['scene']} | {BATCH / r['batch_s']:.0f} | {threads:.0f} |")
    return [*lines, *EXPLAINED]


EXPLAINED = [
    "",
    "A gradient costs the same for any number of free numbers. A Jacobian takes eight of them at",
    "once along the recorded steps; for a path of many points by few numbers it is the cheaper",
    "way to least squares, for one number of many it is the gradient.",
]


if __name__ == "__main__":
    main()
