"""The free numbers of a robot's spec."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from viscodesign.compiled.free_keys import FreeActuatorNumbers
from viscodesign.scene.robot_scene import LEG_INLET, RobotScene


class RobotKeys(FreeActuatorNumbers[RobotScene]):
    """The free numbers of a robot: ``robot.legs.LF.lean``, ``actuators.leg.bellows.height``.

    As of `FreeActuatorNumbers`.
    """

    def validated(self, values: Sequence[float] | np.ndarray) -> RobotScene:
        """The robot with other values, validated like a loaded one."""
        from viscodesign.loading import checked_robot

        return checked_robot(self.with_values([float(value) for value in values]))

    def _inlets_of(self, actuator: str) -> tuple[str, ...]:
        del actuator
        return (LEG_INLET,)
