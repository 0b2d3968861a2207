"""What can be said of a robot before anything is solved: every design by itself, and its stance."""

from __future__ import annotations

from typing import Any

from viscodesign.checks.check import Check, check
from viscodesign.checks.classify import classify
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Classification, Notice, documents
from viscodesign.robot.build_robot import build_robot
from viscodesign.robot.robot_ranges import robot_notices
from viscodesign.robot.vacuum import refuse_sources_in_vacuum
from viscodesign.scene.robot_scene import RobotScene
from viscodesign.scene.scene import Scene


@dataclass(frozen=True)
class RobotCheck:
    """A robot by its designs: each as a single actuator with the input of its first leg."""

    name: str
    designs: dict[str, Check]
    legs: int
    weight_n: float
    warnings: tuple[Notice, ...] = ()
    """Warnings about the body, its legs and feet; each design has its own."""

    def document(self) -> dict[str, Any]:
        """As `check --json` prints it."""
        return {
            "name": self.name,
            "legs": self.legs,
            "weight_n": self.weight_n,
            "warnings": documents(self.warnings),
            "actuators": {name: found.document() for name, found in self.designs.items()},
        }


def check_robot(scene: RobotScene) -> RobotCheck:
    """Check a robot: its spec, its start, and every design as a single actuator.

    Raises `SpecError` where its feet start inside the ground, or where a pressure is below vacuum.
    """
    refuse_sources_in_vacuum(scene)
    model = build_robot(scene)
    designs = {name: check(single) for name, single in single_actuators(scene).items()}
    warnings = tuple(robot_notices(scene))
    return RobotCheck(scene.name, designs, model.count, model.weight, warnings)


def classify_robot(scene: RobotScene) -> list[Classification]:
    """Timescales and quadrant of every design, each as a single actuator."""
    return [classify(single) for single in single_actuators(scene).values()]


def single_actuators(scene: RobotScene) -> dict[str, Scene]:
    """Every design by itself, hanging, with the input of the first leg that has it."""
    found: dict[str, Scene] = {}
    for leg in scene.robot.legs.values():
        if leg.actuator not in found:
            found[leg.actuator] = scene.single_scene(leg.actuator, leg.source)
    return found
