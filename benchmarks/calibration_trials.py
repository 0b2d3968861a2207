"""Do fitted intervals hold the truth? Trials with synthetic recordings of known numbers.

    python benchmarks/calibration_trials.py --kind plain --trials 100
    python benchmarks/calibration_trials.py --kind gross     # 2 % of the samples grossly wrong
    python benchmarks/calibration_trials.py --kind late      # the markers' clock 37 ms late
    python benchmarks/calibration_trials.py --kind table     # an input that the spec does not have
    python benchmarks/calibration_trials.py --report         # report existing results

Each trial draws the true numbers about those of the spec, by up to 40 %, solves the scene with them
on a mesh that no fit uses, adds noise as instruments have it, and fits the spec to that. A trial is
one line of results; trials that are there are not run again.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

from viscodesign import compile, fit, load
from viscodesign.scene.scene import Scene

HERE = Path(__file__).parent
CONFIG = HERE.parent / "configs" / "leg_16_crossed_air.yaml"
RESULTS = HERE / "results" / "calibration_trials.jsonl"
REPORT = HERE / "results" / "calibration_trials.md"
KEYS = (
    "bellows.area_per_pressure",
    "bellows.angle_per_pressure",
    "bellows.extension_per_pressure",
    "bellows.area_per_force",
    "bellows.area_per_moment",
    "fluid.viscosity",
    "actuator.damping_time",
)
SCENE = (
    "input={kind: double_sigmoid, start: 20 kPa, drop: 45 kPa, fall_time: 0.5 s, rise_time: 4 s, "
    "transition: 0.1 s}",
    "loads={payload: 200 g}",
    "run={duration: 6 s, output_interval: 50 ms}",
    "effects={pressure_distribution: on, inertia: on, feedback: on, damping: on, gravity: on, "
    "others: off}",
    "fluid={name: standard air, viscosity: 1.79e-5 Pa*s, density: 1.225 kg/m^3}",
)
SLOW = "input.transition=0.6 s"
"""Of the input that the spec does not have: steps between rows would hide a faster one."""
LARGEST_RATIO = 0.35
"""Largest logarithm of a true number over that of the spec."""
MARKER_SD, PRESSURE_SD, VOLUME_SD = 0.5e-3, 100.0, 0.2e-6
"""Noise [m], [Pa], [m3]."""
GROSS_SHARE, GROSS_SIZE = 0.02, 0.03
"""Of markers: share of the samples, and how far they are off [m]."""
LATE_S = 0.037
TRUE_EDGES, TRUE_TOLERANCE = 8, 1e-6
KINDS = ("plain", "gross", "late", "table")


def main() -> None:
    """Run the trials that are missing, and report."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--kind", choices=KINDS, default="plain")
    parser.add_argument("--trials", type=int, default=100)
    parser.add_argument("--report", action="store_true", help="only report what is there")
    parser.add_argument("--results", type=Path, default=RESULTS)
    given = parser.parse_args()
    if not given.report:
        run(given.kind, given.trials, given.results)
    records = read(given.results)
    text = report(records)
    print(text)
    if given.results == RESULTS:
        REPORT.write_text(text, encoding="utf-8")


def run(kind: str, trials: int, results: Path) -> None:
    """Run the trials of a kind that have no result yet."""
    done = {(own["kind"], own["trial"]) for own in read(results)}
    scene = load(CONFIG, SCENE)
    true = scene.replace({"input.transition": 0.6}) if kind == "table" else scene
    spec = (
        scene.replace({"input": {"kind": "constant", "value": 2e4}}) if kind == "table" else scene
    )
    sections = scene.bellows.count // 2
    markers = [f"m{k}_{axis}_m" for k in range(1, sections + 1) for axis in "xz"]
    late = LATE_S if kind == "late" else 0.0
    motion = compile(
        _shifted(true, late),
        KEYS,
        [*markers, "inlet_pressure_pa", "inflow_m3"],
        tolerance=TRUE_TOLERANCE,
        edges_per_section=TRUE_EDGES,
    )
    for trial in range(trials):
        if (kind, trial) in done:
            continue
        record = one(kind, trial, spec, motion, markers)
        with results.open("a", encoding="utf-8") as file:
            file.write(json.dumps(record) + "\n")
        print(f"{kind} {trial}: {record['inside']} in {record['cpu_s']:.1f} s", file=sys.stderr)


def _shifted(scene: Scene, late: float) -> Scene:
    """The scene with output times that markers see ``late`` [s] beside those of the pressure."""
    times = np.arange(0, round(scene.run.duration / scene.run.output_interval) + 1)
    times = times * scene.run.output_interval
    every = np.unique(np.concatenate([times, np.maximum(times - late, 0.0)]).round(9))
    return scene.replace({"run": {"duration": scene.run.duration, "output_times": every.tolist()}})


def one(kind: str, trial: int, spec: Scene, motion: Any, markers: list[str]) -> dict[str, Any]:
    """One trial: truth, recording, fit."""
    chance = np.random.default_rng([KINDS.index(kind), trial])
    ratios = np.exp(chance.uniform(-LARGEST_RATIO, LARGEST_RATIO, len(KEYS)))
    truth = dict(zip(KEYS, (motion.values * ratios).tolist(), strict=True))
    found = motion(truth)
    late = LATE_S if kind == "late" else 0.0
    times = np.arange(0, round(spec.run.duration / 0.05) + 1) * 0.05
    on_time = np.searchsorted(motion.times, times.round(9) - 1e-10)
    delayed = np.searchsorted(motion.times, np.maximum(times - late, 0.0).round(9) - 1e-10)
    rows = len(times)
    columns = {
        "time_s": times,
        "inlet_pressure_pa": found["inlet_pressure_pa"][on_time]
        + PRESSURE_SD * chance.standard_normal(rows),
        "syringe_volume_m3": found["inflow_m3"][on_time]
        - found["inflow_m3"][0]
        + VOLUME_SD * chance.standard_normal(rows),
    }
    for name in markers:
        columns[name] = found[name][delayed] + MARKER_SD * chance.standard_normal(rows)
        if kind == "gross":
            slips = chance.random(rows) < GROSS_SHARE
            columns[name] += slips * chance.uniform(-GROSS_SIZE, GROSS_SIZE, rows)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "data.csv"
        header = ",".join(columns)
        np.savetxt(file, np.column_stack(list(columns.values())), "%.9g", ",", header=header,
                   comments="")  # fmt: skip
        began = time.process_time()
        fitted = fit(spec, file, next_experiment=False)
        cpu = time.process_time() - began
    numbers = {own.key: [own.value, own.low, own.high] for own in fitted.numbers}
    inside = [
        (low is None or low <= truth[key]) and (high is None or truth[key] <= high)
        for key, (_, low, high) in numbers.items()
    ]
    return {
        "kind": kind,
        "trial": trial,
        "truth": truth,
        "found": numbers,
        "inside": sum(inside),
        "clock_s": fitted.runs[0].clock_offset_s,
        "gross": fitted.runs[0].gross,
        "chi2_per_dof": fitted.chi2_per_dof,
        "cpu_s": cpu,
    }


# -- the report -------------------------------------------------------------------


def read(results: Path) -> list[dict[str, Any]]:
    """Results that are there."""
    if not results.exists():
        return []
    return [json.loads(line) for line in results.read_text(encoding="utf-8").splitlines()]


def report(records: list[dict[str, Any]]) -> str:
    """The results as Markdown."""
    text = [
        "# Do fitted intervals hold the truth?",
        "",
        "Synthetic recordings of a crossed leg of 16 bellows (a pulse of 0.1 s, 200 g at the tip; "
        "8 markers with 0.5 mm, inlet pressure with 0.1 kPa, syringe volume with 0.2 mL of noise; "
        "121 rows), fitted by seven numbers. Bias: mean error over the mean half width of the "
        "intervals; an interval without an end counts as holding the truth and has no width. "
        "Made by `benchmarks/calibration_trials.py`.",
    ]
    for kind in KINDS:
        own = [record for record in records if record["kind"] == kind]
        if own:
            text += ["", *_section(kind, own)]
    return "\n".join([*text, ""])


def _section(kind: str, records: list[dict[str, Any]]) -> list[str]:
    inside = sum(record["inside"] for record in records)
    count = len(records) * len(KEYS)
    cpu = np.array([record["cpu_s"] for record in records])
    text = [
        f"## {kind}: {len(records)} trials, {100 * inside / count:.1f} % of {count} intervals "
        "hold the truth",
        "",
        f"CPU time of a fit: median {np.median(cpu):.1f} s, longest {cpu.max():.1f} s.",
    ]
    lost = [record for record in records if record["inside"] < len(KEYS) / 2]
    if lost:
        others = 100 * (inside - sum(r["inside"] for r in lost)) / (count - len(lost) * len(KEYS))
        named = ", ".join(str(record["trial"]) for record in lost)
        text.append(
            f"Fits that hold fewer than half of their numbers: {len(lost)} (trials {named}); "
            f"of the others' intervals {others:.1f} % hold the truth."
        )
    if kind == "late":
        apart = np.array([record["clock_s"] for record in records]) - LATE_S
        text.append(
            f"Lateness of {1e3 * LATE_S:g} ms found to {1e3 * np.std(apart):.2f} ms "
            f"(standard deviation), bias {1e3 * np.mean(apart):.2f} ms."
        )
    text += ["", "| number | held | median half width | bias |", "| --- | --- | --- | --- |"]
    for key in KEYS:
        held, errors, widths = [], [], []
        for record in records:
            value, low, high = record["found"][key]
            truth = record["truth"][key]
            held.append((low is None or low <= truth) and (high is None or truth <= high))
            if low is not None and high is not None:
                errors.append((value - truth) / truth)
                widths.append((high - low) / 2 / truth)
        bias = np.mean(errors) / np.mean(widths)
        text.append(
            f"| `{key}` | {100 * np.mean(held):.0f} % | {100 * np.median(widths):.2g} % | "
            f"{bias:+.2f} |"
        )
    return text


if __name__ == "__main__":
    main()
