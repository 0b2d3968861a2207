"""A spec of any kind as a function of free numbers: `compile`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import overload

from viscodesign.compiled.function import CompiledFunction
from viscodesign.compiled.several import CompiledActuators
from viscodesign.errors import SpecError
from viscodesign.robot.compiled_robot import CompiledRobot
from viscodesign.scene.robot_scene import RobotScene
from viscodesign.scene.scene import Scene
from viscodesign.scene.several_scene import SeveralScene


@overload
def compile(
    scene: Scene,
    free: Sequence[str],
    outputs: Sequence[str],
    *,
    tolerance: float | None = None,
    edges_per_section: int | None = None,
) -> CompiledFunction: ...


@overload
def compile(
    scene: SeveralScene,
    free: Sequence[str],
    outputs: Sequence[str],
    *,
    tolerance: float | None = None,
    edges_per_section: int | None = None,
) -> CompiledActuators: ...


@overload
def compile(scene: RobotScene, free: Sequence[str], outputs: Sequence[str]) -> CompiledRobot: ...


def compile(
    scene: Scene | SeveralScene | RobotScene,
    free: Sequence[str],
    outputs: Sequence[str],
    *,
    tolerance: float | None = None,
    edges_per_section: int | None = None,
) -> CompiledFunction | CompiledActuators | CompiledRobot:
    """The outputs of a scene as a function of free numbers, in native code where that can be had.

    ``free``: keys of the spec, such as ``network.tube_radius``; ``network.tubes[*].length`` is one
    number a tube. ``outputs``: columns of `trajectory.csv`, and names of metrics. The function is
    solved at the scene's accuracy, as `simulate(scene, verify=False)` does; ``tolerance`` of the
    steps and ``edges_per_section`` of the mesh, where these are not to follow from the accuracy.

    Further outputs: the ends of the sections, counted from the clamp (``m1_x_m``), and what an
    inlet has delivered (``inflow_m3``).

    Of several actuators, the keys and the outputs of one have its name before them:
    ``actuators.left.network.tube_radius``, ``left.tip_x_m``, ``left.loop_area_m2``. Metrics of
    those that share fluid are of the whole run.

    Of a robot, outputs are those of its stance (``height_m``, ``LF.normal_force_n``) and of its
    gait (``advance_per_cycle_m``); see `CompiledRobot`.

    Raises `SpecError` for keys that cannot be free and for outputs that do not exist.
    """
    if isinstance(scene, RobotScene):
        if tolerance is not None or edges_per_section is not None:
            raise SpecError.plain(
                "tolerance, edges_per_section: a robot has none; its accuracy is that of its spec"
            )
        return CompiledRobot(scene, free, outputs)
    if isinstance(scene, SeveralScene):
        return CompiledActuators(scene, free, outputs, tolerance, edges_per_section)
    return CompiledFunction(scene, free, outputs, tolerance, edges_per_section)
