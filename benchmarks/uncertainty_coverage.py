"""Does the band that coefficients give the tip hold the truth as often as it says?

    python benchmarks/uncertainty_coverage.py

For some scenes and two sets of deviations, actuators are drawn from what is stated of their
numbers, each at random and by itself, and each is solved. Counted are actuators whose tip, at the
time that the band is stated for and in its direction, is within the half-width that is printed;
then tips at all times, in x and in z; and actuators that are within the band of x and z all the
way. Numbers are normal; positive ones that are known to no better than a fifth have a normal
logarithm. Writes `benchmarks/results/uncertainty_coverage.md`.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

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
ACTUATORS, FIRST = 400, 100
"""Actuators that are drawn, and those of them that are counted by themselves as well."""
LOGARITHMIC_FROM = 0.2
"""Deviation, relative to the value, from which on the logarithm is normal."""
STILL_M = 1e-6
"""Standard deviation below which the tip does not move by its coefficients [m]."""


@dataclass(frozen=True)
class Coverage:
    """Parts of actuators, or of their tips, within the 95 % band."""

    first: float
    """Of the first hundred actuators, at the stated time."""
    stated: float
    """Of all."""
    pooled: float
    """Of all times and coordinates."""
    whole: float
    """Actuators that are within it at all times in both."""
    failed: int
    """Actuators without motion."""


def drawn(values: np.ndarray, spread: np.ndarray, count: int, seed: int = 0) -> np.ndarray:
    """Numbers (count, k) of actuators about values with deviations (k,)."""
    steps = np.random.default_rng(seed).normal(size=(count, len(values)))
    is_wide = spread >= LOGARITHMIC_FROM * values
    ratio = np.where(is_wide, spread / np.where(values > 0.0, values, 1.0), 0.0)
    return np.where(
        is_wide & (values > 0.0), values * np.exp(ratio * steps), values + spread * steps
    )


def coverage(scene: Scene, run: Trajectory) -> Coverage:
    """How often the band of a run holds actuators that are drawn from what it says."""
    band = run.uncertainty
    assert band is not None
    modes = {f"effects.{v.name}": "on" if v.taken else "off" for v in run.effects}
    pinned = scene.replace({**modes, "effects.others": "off"})
    function = CompiledFunction(pinned, [n.key for n in band.numbers], ("tip_x_m", "tip_z_m"))
    deviation = {n.key: n.deviation for n in band.numbers}
    spread = np.array([deviation[name] for name in function.names])
    found = function.batch(drawn(function.values, spread, ACTUATORS))
    apart = np.stack([found["tip_x_m"], found["tip_z_m"]], axis=2) - run.tip[:, :2]
    solved = np.isfinite(apart).all(axis=(1, 2))
    sizes, directions = band.axes
    row = band.worst_row
    along = np.abs(apart[:, row] @ directions[row, :, 1]) <= COVERAGE_FACTOR * sizes[row, 1]
    inside = np.abs(apart[solved]) <= COVERAGE_FACTOR * band.deviation
    inside = inside[:, band.deviation > STILL_M]
    return Coverage(
        first=float(along[:FIRST][solved[:FIRST]].mean()),
        stated=float(along[solved].mean()),
        pooled=float(inside.mean()),
        whole=float(inside.all(axis=1).mean()),
        failed=int((~solved).sum()),
    )


def table() -> list[str]:
    """Rows of the results."""
    rows = []
    for name in SCENES:
        for words, spread in SPREADS.items():
            scene = load(ROOT / "configs" / f"{name}.yaml", [spread])
            run = simulate(scene, verify=False)
            assert run.uncertainty is not None, run.warnings
            own = coverage(scene, run)
            half = 1e3 * run.uncertainty.half_width_m
            parts = " | ".join(
                f"{100 * part:.1f}" for part in (own.first, own.stated, own.pooled, own.whole)
            )
            rows.append(
                f"| {name} | {words} | {half:.3g} | {100 * half / 1e3 / run.length:.2g} | "
                f"{parts} | {own.failed} |"
            )
            print(rows[-1], flush=True)
    return rows


HEAD = """# How often the band of the coefficients holds the truth

Made by `python benchmarks/uncertainty_coverage.py`: {count} actuators for each scene, drawn at
random from the stated deviations; positive numbers known to no better than a fifth have a normal
logarithm. The band is of the first order in the deviations, so that it holds less where it is wide.
Half-widths are in mm, all else in %. *First {first}* and *all*: actuators whose tip is within the
printed half-width, at its time and in its direction; chance makes +-2.2 % of a hundred, +-1.1 % of
all. *All times*: tips of all times, in x and in z. *Whole way*: actuators that are within the
band of x and of z at every time, which the band does not promise.

| scene | numbers | half-width | of length | first {first} | all | all times | whole way | no run |
| --- | --- | --- | --- | --- | --- | --- | --- | --- |
"""

if __name__ == "__main__":
    text = HEAD.format(count=ACTUATORS, first=FIRST) + "\n".join(table()) + "\n"
    (ROOT / "benchmarks" / "results" / "uncertainty_coverage.md").write_text(text)
