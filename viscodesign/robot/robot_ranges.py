"""What the numbers of a robot are: usual ranges, as `checks.plausible_ranges` has of actuators.

Bounds are our choice: they catch slips of prefix and unit and judge no design.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from viscodesign.checks.input_ranges import RUN
from viscodesign.checks.plausibility import outside, unusual
from viscodesign.checks.plausible_ranges import ANY, KELVIN_VOIGT, PlausibleRange
from viscodesign.results.findings import Notice
from viscodesign.robot.stated_speed import STEPS
from viscodesign.scene.robot_scene import RobotScene

ROBOTS = "robots of the size of insects to ones that carry people"
RUBBER = "polished surfaces (0.02) to soft rubber (3)"
_LENGTH = (1e-3, 1e3, 1e-6)
_MASS = (1e-3, 1e3)


def _length(key: str, low: float, high: float) -> PlausibleRange:
    """The range of a place or a size of either sign, or of none."""
    return PlausibleRange(
        f"robot.{key}", "m", low, high, ROBOTS, _LENGTH, ANY, either_sign=True, or_none=True
    )


def _mass(key: str, low: float, high: float) -> PlausibleRange:
    return PlausibleRange(f"robot.{key}", "kg", low, high, ROBOTS, _MASS, or_none=True)


RANGES = (
    _mass("mass", 1e-3, 300.0),
    _mass("payload", 1e-4, 300.0),
    _mass("foot.mass", 1e-5, 20.0),
    _length("body_length", 5e-3, 5.0),
    _length("hip_height", 2e-3, 5.0),
    _length("foot.radius", 2e-4, 0.3),
    *(_length(f"centre_of_mass.{name}", 1e-4, 2.0) for name in ("x", "y", "below_hips")),
    *(_length(f"legs.*.{name}", 1e-3, 3.0) for name in "xy"),
    PlausibleRange("robot.foot.friction", "", 0.02, 3.0, RUBBER, (1e-2,), or_none=True),
    PlausibleRange(
        "robot.damping_time", "s", 2e-6, 0.3, KELVIN_VOIGT, (1e-3, 1e-6, 1e3), or_none=True
    ),
    PlausibleRange("robot.pump.volume", "m^3", 1e-8, 1e-2, ROBOTS, (1e-3, 1e-6, 1e3)),
    PlausibleRange("robot.pump.stroke_time", "s", 1e-3, 1e3, ROBOTS, (1e-3, 1e3)),
)


def robot_notices(scene: RobotScene) -> Iterator[Notice]:
    """One warning for each number of the body, its legs and feet that is hardly meant."""
    own = (replace(found, whose="such robots have") for found in RANGES)
    for found, value in outside(scene, (*own, _delays(scene))):
        yield unusual(found, value)
    yield from _undamped(scene)


def _undamped(scene: RobotScene) -> Iterator[Notice]:
    """Damping by which `walk` states no speed, however small its steps."""
    damping = scene.robot.damping_time
    if scene.period is not None and damping < STEPS.least_damping(scene.period):
        yield Notice(
            "no_speed",
            f"{1e3 * damping:.3g} ms is less than the damping of the smallest steps of `walk`, "
            "which will state no speed. State the damping of the legs, on which the speed depends",
            "robot.damping_time",
        )


def _delays(scene: RobotScene) -> PlausibleRange:
    """The range of delays, where an input is another one, later."""
    run = scene.run
    least = 0.05 * min(run.output_interval, run.duration)
    words = "from a twentieth of the time between outputs to the end of the run"
    slips = (1e-3, 1e3)
    found = PlausibleRange("inputs.*.delay", "s", least, run.duration, words, slips, ANY)
    return replace(found, or_none=True, whose=RUN)
