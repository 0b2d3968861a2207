"""What can be said of a robot before anything is solved: every design by itself, and its stance."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from viscodesign.checks.check import Check, check
from viscodesign.checks.classify import classify
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Classification, Notice, documents, json_ready
from viscodesign.results.stand_study import Fall, StanceRow
from viscodesign.robot.build_robot import build_robot
from viscodesign.robot.robot_model import RobotModel
from viscodesign.robot.robot_ranges import robot_notices
from viscodesign.robot.stance import UnstableStanceError
from viscodesign.robot.stand import own_stance
from viscodesign.robot.vacuum import refuse_sources_in_vacuum
from viscodesign.robot.walk import start_state
from viscodesign.scene.robot_scene import RobotScene
from viscodesign.scene.scene import Scene


@dataclass(frozen=True)
class RobotCheck:
    """A robot by its designs: each as a single actuator with the input of its first leg."""

    name: str
    designs: dict[str, Check]
    legs: int
    weight_n: float
    sway_limit_n: float
    """Weight from which on it sways at the spec's gauge pressure; 0 where its feet slide."""
    warnings: tuple[Notice, ...] = ()
    """Warnings about the body, its legs and feet; each design has its own."""

    def document(self) -> dict[str, Any]:
        """As `check --json` prints it."""
        return {
            "name": self.name,
            "legs": self.legs,
            "weight_n": self.weight_n,
            "sway_limit_n": json_ready(self.sway_limit_n),
            "warnings": documents(self.warnings),
            "actuators": {name: found.document() for name, found in self.designs.items()},
        }


def check_robot(scene: RobotScene) -> RobotCheck:
    """Check a robot: its spec, how it stands, its start, and every design as a single actuator.

    Raises `SpecError` where its feet start inside the ground, or where a pressure is below vacuum.
    """
    refuse_sources_in_vacuum(scene)
    model = build_robot(scene)
    designs = {name: check(single) for name, single in single_actuators(scene).items()}
    own, fall = own_stance(scene)
    warnings = (*robot_notices(scene), *_stance_notices(scene, model, own, fall))
    return RobotCheck(scene.name, designs, model.count, own.weight_n, own.sway_limit_n, warnings)


def _stance_notices(
    scene: RobotScene, model: RobotModel, own: StanceRow, fall: Fall | None
) -> Iterator[Notice]:
    """What `stand` or `walk` will refuse: at the spec's gauge pressure, or at the start."""
    if fall is not None:
        yield Notice("no_stance", f"the robot {fall.how}: {fall.why}", "robot")
    elif not own.stands:
        yield Notice(
            "no_stance",
            f"the robot weighs {own.weight_n:.4g} N, and at {1e-3 * own.gauge_pressure_pa:.4g} kPa "
            f"gauge its legs bear {own.sway_limit_n:.4g} N: they give way sideways. Lower its "
            "payload or its pressure",
            "robot",
        )
    else:
        try:
            start_state(scene, model)
        except UnstableStanceError as error:
            yield Notice("no_stance", str(error), "inputs")


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
