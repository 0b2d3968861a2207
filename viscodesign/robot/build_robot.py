"""From the spec of a robot to its numbers."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from viscodesign.errors import Fault, SpecError
from viscodesign.robot.leg_design import leg_design
from viscodesign.robot.leg_equations import leg_functions
from viscodesign.robot.robot_model import Feet, LegGroup, RigidBody, RobotModel
from viscodesign.robot.stance import set_down
from viscodesign.robot.vacuum import refuse_baseline_in_vacuum
from viscodesign.scene.loads import STANDARD_GRAVITY
from viscodesign.scene.robot import Robot, RobotLeg
from viscodesign.scene.robot_scene import RobotScene

MIN_WIDTH_RATIO = 0.1
"""Width of a body whose hips stand in line, relative to its length."""


def build_robot(scene: RobotScene) -> RobotModel:
    """The numbers of a robot.

    Raises `SpecError` where its feet start inside the ground, or its baseline is below vacuum.
    """
    refuse_baseline_in_vacuum(scene)
    robot = scene.robot
    names = tuple(robot.legs)
    slope = robot.ground.slope
    return _checked(
        scene,
        RobotModel(
            body=_body(robot),
            feet=Feet(robot.foot.mass, robot.foot.radius, robot.foot.friction),
            groups=tuple(
                _group(scene, actuator, names)
                for actuator in dict.fromkeys(leg.actuator for leg in robot.legs.values())
            ),
            leg_names=names,
            source_names=tuple(scene.sources),
            damping_time=robot.damping_time,
            gravity=(
                -STANDARD_GRAVITY * math.sin(slope),
                STANDARD_GRAVITY * math.cos(slope),
            ),
        ),
    )


def with_mass(model: RobotModel, mass: float) -> RobotModel:
    """The robot with another mass of everything [kg]; what it gains sits at its centre of mass."""
    body = replace(model.body, mass=mass - model.count * model.feet.mass)
    return replace(model, body=body)


def start_pressures(scene: RobotScene) -> np.ndarray:
    """Gauge pressure of every source at the start [Pa]."""
    values = [float(source.values(np.zeros(1))[0]) for source in scene.sources.values()]
    return scene.gauge_pressure + np.array(values)


def body_masses(robot: Robot) -> tuple[float, float]:
    """Mass of all but the feet, with the payload and without it [kg]."""
    bare = robot.mass - len(robot.legs) * robot.foot.mass
    return bare + robot.payload, bare


def _body(robot: Robot) -> RigidBody:
    """An even slab between the hips, with the payload at its centre of mass."""
    loaded, mass = body_masses(robot)
    across = [leg.y for leg in robot.legs.values()]
    width = max(max(across) - min(across), MIN_WIDTH_RATIO * robot.body_length)
    return RigidBody(loaded, mass * robot.body_length**2 / 12, mass * width**2 / 12)


def _group(scene: RobotScene, actuator: str, names: tuple[str, ...]) -> LegGroup:
    robot, sources = scene.robot, tuple(scene.sources)
    own = [k for k, name in enumerate(names) if robot.legs[name].actuator == actuator]
    legs = [robot.legs[names[k]] for k in own]
    design = leg_design(scene.leg_scene(actuator))
    return LegGroup(
        leg_functions(design),
        np.array(own),
        np.array([mount_of(robot, leg) for leg in legs]),
        np.array([sources.index(leg.source) for leg in legs]),
    )


def mount_of(robot: Robot, leg: RobotLeg) -> list[float]:
    """Hip from the centre of mass, tilt and lean."""
    centre = robot.centre_of_mass
    return [leg.x - centre.x, leg.y - centre.y, -centre.below_hips, leg.tilt, leg.lean]


def _checked(scene: RobotScene, model: RobotModel) -> RobotModel:
    """The robot, its feet out of the ground at the start."""
    height = scene.robot.hip_height
    if height is None:
        return model
    place, _ = set_down(model, start_pressures(scene))
    reach = float(np.mean(model.hip_heights(place)))
    if height < reach:
        message = (
            f"{1e3 * height:.4g} mm puts the feet {1e3 * (reach - height):.3g} mm into the "
            f"ground at the start; use at least {1e3 * reach:.4g} mm, or remove it"
        )
        raise SpecError([Fault(message, "robot.hip_height", scene.source.file)])
    return model
