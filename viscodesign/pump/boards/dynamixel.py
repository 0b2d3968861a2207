"""`--board dynamixel`: a USB adapter straight on the servos' bus, such as USB2Dynamixel or U2D2."""

from __future__ import annotations

from viscodesign.errors import PumpError
from viscodesign.pump.ax.protocol import packets, registers
from viscodesign.pump.ax.protocol.transactions import ARBOTIX, ROS_MODEL, NoReplyError
from viscodesign.pump.boards.base import Board
from viscodesign.scene.pumps.servo_motor import model_title

SCANNED_IDS = range(1, 17)  # ids that are asked where no servos are named


class Dynamixel(Board):
    """The adapter itself is silent; a servo that answers shows that it is there."""

    name = "dynamixel"
    baud = 1_000_000

    def _identity(self) -> str:
        self._refuse_arbotix()
        servos = self.axes or SCANNED_IDS
        found = [words for servo in servos if (words := self._describe(servo))]
        if not found:
            raise PumpError(
                f"no servo answers with id {', '.join(map(str, servos))}. Is the power on, and "
                f"is the bus at {self.baud} baud? An ArbotiX in between needs the board "
                "arbotix or arbotix-ros"
            )
        return "adapter on the servos' bus; " + "; ".join(found)

    def _refuse_arbotix(self) -> None:
        """Firmwares of the ArbotiX answer to id 253, which a servo should not have."""
        request = packets.read(ARBOTIX, registers.MODEL.address, 2)
        try:
            reply = self.ask(request, 2, 0, tries=1)
        except NoReplyError:
            return
        model = int.from_bytes(reply.parameters, "little")
        if model in (0, ROS_MODEL):
            other = "arbotix-ros" if model else "arbotix"
            raise PumpError(f"an ArbotiX answers here, not a servo: use the board {other}")

    def _describe(self, servo: int) -> str:
        """Model and version of a servo; empty where it does not answer."""
        try:
            data = self.ask(packets.read(servo, 0, 3), 3, tries=1).parameters
        except NoReplyError:
            return ""
        kind = model_title(registers.MODEL.within(data, 0))
        return f"servo {servo}: {kind}, firmware {registers.FIRMWARE.within(data, 0)}"
