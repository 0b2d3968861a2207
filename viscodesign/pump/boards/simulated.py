"""`--board simulated`: a computed pump that speaks the same bytes."""

from __future__ import annotations

from viscodesign.pump.boards.arbotix import Arbotix
from viscodesign.pump.boards.arbotix_ros import ArbotixRos


class Simulated(ArbotixRos):
    """A computed ArbotiX with the firmware for ROS, and a pump behind it."""

    name = "simulated"
    simulated = True
    boot = 0.0

    def identify(self) -> str:
        return f"simulated, nothing real moves: {super().identify()}"


class SimulatedArbotix(Arbotix):
    """A computed ArbotiX with PyPose, which plays poses."""

    simulated = True
    boot = 0.0

    def identify(self) -> str:
        return f"simulated, nothing real moves: {super().identify()}"
