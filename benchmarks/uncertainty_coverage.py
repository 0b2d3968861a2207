"""Does the band that coefficients give the tip hold the truth as often as it says?

    python benchmarks/uncertainty_coverage.py

For some scenes with `uncertainty: typical`, a hundred actuators are drawn from what is assumed of
their numbers, and each is solved. Counted is how often its tip lies within the 95 % band about
that of the scene, at all output times, in x and in z. Draws are Sobol's, normal, so that the
fraction itself hardly depends on the sample. Writes `benchmarks/results/uncertainty_coverage.md`.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from scipy.stats import norm, qmc

from viscodesign import load, simulate
from viscodesign.compiled.function import CompiledFunction
from viscodesign.results.coefficient_band import COVERAGE_FACTOR
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.scene import Scene

ROOT = Path(__file__).parent.parent
SCENES = ("leg", "leg_4_air", "leg_16_gauge_plus_2kpa", "horizontal_payload", "steady_left_auto")
SPREADS = {
    "typical": "uncertainty=typical",
    "well known": "uncertainty={actuator.youngs_modulus: 3 %, bellows.angle_per_pressure: 3 %, "
    "bellows.area_per_pressure: 3 %, network.tube_radius: 1 %}",
}
ACTUATORS = 128
"""A power of two, for Sobol's sequence."""
STILL_M = 1e-6
"""Standard deviation below which the tip does not move by its coefficients [m]."""


def coverage(scene: Scene, run: Trajectory, actuators: int, seed: int = 0) -> tuple[float, int]:
    """Fraction of actuators, times and coordinates within the band, and how many had no motion."""
    band = run.uncertainty
    assert band is not None
    modes = {f"effects.{v.name}": "on" if v.taken else "off" for v in run.effects}
    pinned = scene.replace({**modes, "effects.others": "off"})
    numbers = band.numbers
    function = CompiledFunction(pinned, [n.key for n in numbers], ("tip_x_m", "tip_z_m"))
    deviation = {n.key: n.deviation for n in numbers}
    spread = np.array([deviation[name] for name in function.names])
    draws = qmc.Sobol(len(spread), seed=np.random.default_rng(seed)).random(actuators)
    rows = function.values + spread * norm.ppf(np.clip(draws, 1e-6, 1 - 1e-6))
    found = function.batch(rows)
    tips = np.stack([found["tip_x_m"], found["tip_z_m"]], axis=2)
    solved = np.isfinite(tips).all(axis=(1, 2))
    inside = np.abs(tips[solved] - run.tip[:, :2]) <= COVERAGE_FACTOR * band.deviation
    return float(inside[:, band.deviation > STILL_M].mean()), int((~solved).sum())


def table() -> list[str]:
    """Rows of the results."""
    rows = []
    for name in SCENES:
        for words, spread in SPREADS.items():
            scene = load(ROOT / "configs" / f"{name}.yaml", [spread])
            run = simulate(scene, verify=False)
            assert run.uncertainty is not None, run.warnings
            inside, failed = coverage(scene, run, ACTUATORS)
            half = 1e3 * run.uncertainty.half_width_m
            rows.append(
                f"| {name} | {words} | {half:.3g} | {100 * half / 1e3 / run.length:.2g} | "
                f"{100 * inside:.1f} | {failed} |"
            )
            print(rows[-1], flush=True)
    return rows


HEAD = """# How often the band of the coefficients holds the truth

Made by `python benchmarks/uncertainty_coverage.py`: {count} actuators for each scene, drawn from
the stated deviations. The band is of the first order in the deviations, so that it holds less where
it is wide. Actuators without motion have a number below zero, which a deviation of 50 %
(`actuator.damping_time`) gives a few.

| scene | numbers | half-width [mm] | of the length [%] | within the 95 % band [%] | no motion |
| --- | --- | --- | --- | --- | --- |
"""

if __name__ == "__main__":
    text = HEAD.format(count=ACTUATORS) + "\n".join(table()) + "\n"
    (ROOT / "benchmarks" / "results" / "uncertainty_coverage.md").write_text(text)
