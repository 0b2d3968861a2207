"""What the band of the coefficients costs, beside the run that it belongs to.

    python benchmarks/uncertainty_cost.py            # measure, then report
    python benchmarks/uncertainty_cost.py --report   # report existing results

CPU times of one process, the smallest of several rounds; in every round a scene has another tube
radius, which neither its run nor its band had before, so that only formulas are known. Bands are
those of `uncertainty: typical`, and are compared with bands by smaller steps.
"""

from __future__ import annotations

import os
import time
from pathlib import Path

os.environ |= {"OPENBLAS_NUM_THREADS": "1"}  # before numpy

import numpy as np
from peers.machine import cpu
from rounds import Record, measure_and_report

from viscodesign import __version__, load, simulate
from viscodesign.compiled.outputs import TIP_COLUMNS
from viscodesign.results.coefficient_band import CoefficientBand
from viscodesign.scene.scene import Scene
from viscodesign.studies.coefficient_band import coefficient_band
from viscodesign.studies.differentiable import differentiable
from viscodesign.studies.stated_uncertainty import StatedDeviation, stated_deviations

HERE = Path(__file__).parent
CONFIGS = HERE.parent / "configs"
RESULTS = HERE / "results" / "uncertainty_cost.jsonl"
ROUNDS = 5
TIGHT = 1e-7
"""Tolerance of the steps of the bands that others are compared with."""
SCENES = {
    "leg": "leg, air",
    "leg_16_straight_air_auto": "leg weightless, air",
    "leg_16_straight_water_auto": "leg weightless, water",
    "syringe_water": "syringe, water",
    "leg_16_gauge_minus_2kpa_auto": "leg below ambient pressure, air",
    "leg_16_pump": "leg on a pump, air",
    "steady_left_auto": "equilibria",
}
"""By the names of their configs."""


def main() -> None:
    """Measure and report."""
    measure_and_report(__doc__, ROUNDS, RESULTS, SCENES, measure, report)


def measure(config: str, rounds: int) -> Record:
    """One scene."""
    path, own = CONFIGS / f"{config}.yaml", load(CONFIGS / f"{config}.yaml")
    radius, spent = own.network.tube_radius, list[tuple[float, float]]()
    assert radius is not None, "every scene has one"
    for k in range(rounds + 1):
        changed = f"network.tube_radius={radius * (1 + 1e-5 * k)!r} m"
        scene = load(path, [changed, "uncertainty=typical"])
        began = time.process_time()
        run = simulate(scene, uncertainty=False)
        solved = time.process_time()
        stated = stated_deviations(scene)
        band = coefficient_band(scene, run, stated)
        spent.append((solved - began, time.process_time() - solved))
        assert isinstance(band, CoefficientBand), band
    effects = frozenset(verdict.name for verdict in run.effects if verdict.taken)
    return {
        "config": config,
        "version": __version__,
        "cpu": cpu(),
        "numbers": len(band.numbers),
        "run_s": min(own for own, _ in spent[1:]),
        "band_s": min(own for _, own in spent[1:]),
        "half_width_m": band.half_width_m,
        "apart": _apart(scene, stated, effects, band),
    }


def _apart(
    scene: Scene,
    stated: dict[str, StatedDeviation],
    effects: frozenset[str],
    band: CoefficientBand,
) -> float:
    """Largest distance from the deviations by small steps, over the largest of these."""
    function, _ = differentiable(
        scene, list(stated), TIP_COLUMNS, by_percent=False, tolerance=TIGHT, effects=effects
    )
    spread = np.array([stated[name].deviation for name in function.names])
    slopes = function.jacobian()
    exact = np.array([np.linalg.norm(slopes[name] * spread, axis=1) for name in TIP_COLUMNS]).T
    return float(np.max(np.abs(band.deviation - exact)) / np.max(exact))


def report(records: list[Record]) -> list[str]:
    """The page."""
    first = records[0]
    lines = [
        "# What the band of the coefficients costs",
        "",
        f"viscodesign {first['version']}, {first['cpu']}, one thread; "
        "`python benchmarks/uncertainty_cost.py`.",
        "",
        "CPU time in milliseconds, the smallest of several rounds, each with a tube radius that is",
        "new: the run with its error estimated, without a band; the band of `uncertainty: typical`",
        "alone; and its part of the run, which is to be at most 1. *Change*: largest distance of a",
        f"deviation of x or z from that by steps of the tolerance {TIGHT:g}, over the largest.",
        "",
        "| config | scene | numbers | run | band | band over run | half-width | change |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for r in records:
        lines.append(
            f"| {r['config']} | {SCENES[r['config']]} | {r['numbers']} | "
            f"{1e3 * r['run_s']:.0f} | {1e3 * r['band_s']:.0f} | {r['band_s'] / r['run_s']:.2f} | "
            f"{1e3 * r['half_width_m']:.3g} mm | {100 * r['apart']:.2g} % |"
        )
    return lines


if __name__ == "__main__":
    main()
