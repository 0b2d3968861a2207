"""Hard cases that random scenes found; see `tests/fuzz`."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tests.hard.case import Case, Finding, Judge, at_most, true
from tests.scenes import leg
from viscodesign import Trajectory, simulate

LEFT_ITS_FLOOR = (
    "actuator={length: 106 mm, height: 44.1 mm, width: 25.5 mm, youngs_modulus: 6.64 MPa, density: 9170, "
    "solid_fraction: 0.483, extension_factor: 0.0977, bending_factor: 1.53}",
    "bellows={count: 8, height: 6.28 mm, width: 20.3 mm, length: 32.4 mm, area_per_pressure: 1.25e-8, "
    "angle_per_pressure: -3.84, extension_per_pressure: 0.0593, area_per_force: 3.38e-8, "
    "area_per_moment: 2.92e-6, collapse_fraction: 0.1}",
    "network={layout: straight, tube_radius: 0.184 mm, tube_length: 12.7 mm}",
    "fluid={name: own, viscosity: 1.79e-9, density: 24.8, gas_constant: 515}",
    "temperature=280 K",
    "loads={gravity: {tilt: 216 deg}, payload: 115 g}",
    "accuracy=7.7e-4",
    "effects=auto",
    "run={duration: 33.7 ms, output_interval: 1.35 ms, start: equilibrium}",
    "input={kind: trapezoid, low: -37.5 kPa, high: 64.4 kPa, rise: 0.394 ms, hold: 0, "
    "fall: 0.985 ms, rest: 0.394 ms}",
)
"""A thin gas fills collapsed bellows, which a linear estimate takes to be a hundred times softer."""


HEAVY_INSIDE = (
    "effects={fluid_mass: on, gravity: on, others: off}",
    "fluid=water",
    "actuator.density=0.1",
    "actuator.length=0.8 m",
    "loads.gravity={tilt: 10 deg, acceleration: 300}",
    "input={kind: constant, value: 2 kPa}",
    "run={duration: 1 s, output_interval: 0.5 s, start: equilibrium}",
)
BLOWN_THROUGH = (
    "bellows.count=4",
    "input=null",
    "network={layout: custom, tube_length: 40 mm, tube_radius: 0.3 mm, tubes: [{from: a, to: R1}, "
    "{from: R1, to: R2}, {from: R2, to: L2}, {from: L2, to: L1}, {from: L1, to: b}]}",
    "inputs={a: {kind: constant, value: 20 kPa}, b: {kind: constant, value: -20 kPa}}",
    "fluid=air",
    "run={duration: 1 s, output_interval: 0.5 s, start: equilibrium}",
    "effects=auto",
)


def _as_at(accuracy: str, *changes: str) -> Judge:
    """Compared with the same scene at another accuracy: no farther apart than both stated errors."""

    def judge(run: Trajectory) -> Iterator[Finding]:
        other = simulate(leg(*changes, f"accuracy={accuracy}"))
        apart = np.hypot(*(other.tip - run.tip)[:, :2].T).max()
        stated = sum(r.accuracy.estimated_tip_error_m or 0.0 for r in (run, other))
        yield at_most(f"tip's distance at an accuracy of {accuracy}", apart, stated)

    return judge


def _all_losses_in(run: Trajectory) -> Iterator[Finding]:
    """Compared with the same scene with `flow_regime` switched on."""
    asked = simulate(leg(*LEFT_ITS_FLOOR, "effects={others: auto, flow_regime: on}"))
    apart = np.hypot(*(asked.tip - run.tip)[:, :2].T).max()
    stated = (run.accuracy.estimated_tip_error_m or 0.0) + (
        asked.accuracy.estimated_tip_error_m or 0.0
    )
    yield at_most("tip's distance with flow_regime on", apart, stated)
    yield true("flow_regime is taken", "flow_regime" in {v.name for v in run.effects if v.taken})


CASES: tuple[Case, ...] = (
    Case(
        "F1",
        "endless steps, few allowed",
        "fails soon, and names the step limit",
        (
            "input={kind: sine, amplitude: 20 kPa, frequency: 0.3 Hz}",
            "run={duration: 26000 s, output_interval: 1000 s, start: rest, max_steps: 1000}",
        ),
        ending="failed",
        says=("the limit of 1000 steps was reached", "run.max_steps"),
    ),
    Case(
        "F2",
        "a network beyond double precision, too slow to represent",
        "refused, naming the tubes",
        (
            "network={layout: straight, tube_radius: 0.3 mm, tube_length: 40 mm, changes: {R1-R2: {radius: 1 um}, inlet-R1: {radius: 100 mm}}}",
        ),
        ending="refused",
        says=("tube R1-R2", "inlet-R1"),
    ),
    Case(
        "F3",
        "a rod that would turn a hundred times around",
        "refused for the angle, not built for minutes",
        ("bellows.angle_per_pressure=9403", "effects.others=auto"),
        ending="refused",
        says=("bellows.angle_per_pressure", "rad"),
    ),
    Case(
        "F4",
        "an output time just before a corner of the input",
        "complete",
        (
            "input={kind: table, rows: [[0, 0], [0.1, 1e4], [0.1000000001, -1e4], [0.2, 0]]}",
            "run={duration: 0.3 s, output_times: [0.09999999999, 0.1, 0.2]}",
            "effects=auto",
            "accuracy=2 %",
        ),
        converges=False,
    ),
    Case(
        "F5",
        "a weight of 80,000 EI/l2, few steps allowed",
        "the search for its equilibrium has a limit, too",
        (
            "loads.gravity={tilt: 5.7}",
            "actuator.density=1e9",
            "bellows.count=4",
            "effects={gravity: on, others: off}",
            "run={duration: 0.5 s, output_interval: 0.1 s, max_steps: 400}",
        ),
        ending="refused",
        says=("the limit of 400 steps was reached", "of the loads", "run.max_steps"),
    ),
    Case(
        "F6",
        "fast flow out of collapsed bellows, whose loss a linear estimate misses",
        "the run detects it and includes the loss",
        LEFT_ITS_FLOOR,
        judge=_all_losses_in,
    ),
    Case(
        "F7",
        "an input that swings a thousand times faster than the rod it hardly moves",
        "complete, its work integrated as accurately as its motion",
        (
            "effects={others: off, inertia: on, feedback: on}",
            "bellows.area_per_moment=2e-5",
            "loads.gravity={tilt: 60 deg}",
            "run={duration: 15 us, output_times: [14 us, 15 us], start: rest}",
            "input={kind: sine, amplitude: -5 kPa, mean: -4 kPa, frequency: 63 kHz, phase: 73 deg, transient_time: 16 us}",
        ),
    ),
    Case(
        "F8",
        "a pulse of a microsecond between outputs that are seconds apart",
        "complete, its work included",
        (
            "effects={others: off}",
            "run={duration: 10 s, output_times: [1 ms, 5 s]}",
            "input={kind: double_sigmoid, start: 2 kPa, drop: 3 kPa, fall_time: 0.9 ms, rise_time: 2 ms, transition: 1 us}",
        ),
    ),
    Case(
        "F9",
        "a light rod with much heavier fluid, at an accuracy of a few percent",
        "stretched by its fluid as far as at a tenth of a percent",
        (*HEAVY_INSIDE, "accuracy=4 %"),
        judge=_as_at("0.1 %", *HEAVY_INSIDE),
    ),
    Case(
        "F10",
        "a steady flow of gas from one inlet to another",
        "at high accuracy its compressibility is included, at low accuracy it is part of the stated error",
        (*BLOWN_THROUGH, "accuracy=3 %"),
        judge=_as_at("0.05 %", *BLOWN_THROUGH),
    ),
)
