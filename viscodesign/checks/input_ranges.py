"""What the times and sizes of an input are beside the run and the actuator that it drives.

As in `plausible_ranges`, the bounds are our choice: they catch slips of prefix and unit.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator

from viscodesign.checks.numbers_at_keys import numbers_at
from viscodesign.checks.plausible_ranges import ANY, SYRINGES, PlausibleRange
from viscodesign.checks.written_numbers import written
from viscodesign.scene.scene import Scene

MIN_SHOWN_CYCLES = 0.02
"""Part of a period that a run shows at least."""
OUTPUTS_PER_CYCLE = 2.0
"""Outputs that a period has at least, or no table and no picture shows it."""
LONGEST_SHARE, SHORTEST_SHARE = 20.0, 0.05
"""Bounds of the parts of a motion, as shares of the run and of the time between outputs."""
OWN_SWING = 200.0
"""Ratio, either way, of a stated transient time to the swing of the profile itself."""
CUT_TRANSITION = 0.25
"""Part of a transition that a run may begin before its centre, or it begins in the middle of it."""
PULSES = "pulses that last"
RUN = "such a run shows"
SHOWN = "from a fiftieth of a cycle in the run to two outputs in each cycle"
PARTS = "from a twentieth of the time between outputs to twenty runs"
TIMES = (1e-3, 1e3, 1e-6, 1e6)


def input_ranges(scene: Scene) -> Iterator[PlausibleRange]:
    """Ranges of the keys that inputs have, whatever their kinds."""
    duration, interval = scene.run.duration, _between_outputs(scene)
    longest, shortest = duration / MIN_SHOWN_CYCLES, OUTPUTS_PER_CYCLE * interval
    for key, unit, low, high in (
        ("frequency", "Hz", 1 / longest, 1 / shortest),
        ("period", "s", shortest, longest),
    ):
        yield PlausibleRange(f"inputs.*.{key}", unit, low, high, SHOWN, TIMES, whose=RUN)
    bounds = SHORTEST_SHARE * interval, LONGEST_SHARE * duration
    yield PlausibleRange("inputs.*.transition", "s", *bounds, PARTS, TIMES, whose=RUN)
    yield PlausibleRange("inputs.*.duty", "", 5e-3, 1.0 - 5e-3, PULSES, (1e-2, 1e2), whose=RUN)
    for inlet in scene.inputs:
        for _, transition in numbers_at(scene, f"inputs.{inlet}.transition"):
            for name in ("fall_time", "rise_time"):
                yield _centre(f"inputs.{inlet}.{name}", transition, duration)
    for name in ("rise", "hold", "fall", "rest"):
        key = f"inputs.*.{name}"
        yield PlausibleRange(key, "s", *bounds, PARTS, TIMES, or_none=True, whose=RUN)
    yield from _transient_times(scene)
    yield from _syringes(scene)


def _centre(key: str, transition: float, duration: float) -> PlausibleRange:
    """The range of a transition's centre: the run shows the greater part of it."""
    first, end = CUT_TRANSITION * transition, written(duration, "s")
    words = f"must lie within the run, which ends at {end}"
    if first < duration:
        words += f", and not before {written(first, 's')} (a quarter of the transition)"
    else:
        words += f" and is too short for a transition of {written(transition, 's')}"
    return PlausibleRange(key, "s", first, duration, "", TIMES, requirement=words)


def _between_outputs(scene: Scene) -> float:
    """Shortest time between outputs [s]; that of the run where there is one output."""
    run = scene.run
    if run.output_times is None:
        return min(run.output_interval, run.duration)
    times = run.output_times
    return min((b - a for a, b in itertools.pairwise(times)), default=run.duration)


def _transient_times(scene: Scene) -> Iterator[PlausibleRange]:
    for name, source in scene.inputs.items():
        own = source.swing_time_within(scene.run.duration)
        if 0.0 < own < math.inf:
            yield PlausibleRange(
                f"inputs.{name}.transient_time",
                "s",
                own / OWN_SWING,
                own * OWN_SWING,
                f"{OWN_SWING:g} times the {own:.3g} s of the profile itself, either way",
                TIMES,
                whose="belongs to this profile",
            )


def _syringes(scene: Scene) -> Iterator[PlausibleRange]:
    for name, source in scene.inputs.items():
        if source.gives_pressure:
            continue
        for key, low, high in (("diameter", 4e-4, 0.15), ("start", 1e-3, 0.5)):
            where = f"inputs.{name}.{key}"
            yield PlausibleRange(where, "m", low, high, SYRINGES, (1e-3, 1e3), (0.0, 1e6))
        for key, most in (("dead_volume", 5e-4), ("cushion", 5e-5)):
            where, slips = f"inputs.{name}.{key}", (1e-3, 1e-6, 1e3)
            yield PlausibleRange(where, "m^3", 2e-9, most, SYRINGES, slips, ANY, or_none=True)
