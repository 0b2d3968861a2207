"""`--board simulated`: nothing but numbers, and the same bytes."""

from __future__ import annotations

from viscodesign.pump.boards.arbotix_ros import ArbotixRos


class Simulated(ArbotixRos):
    """A computed ArbotiX with a computed servo, syringe, sensor and switches behind it.

    It speaks the bytes of the real one with the firmware for ROS, so all that speaks to that
    is used as it is.
    """

    name = "simulated"
    simulated = True
    boot = 0.0

    def identify(self) -> str:
        return f"simulated, nothing real moves: {super().identify()}"
