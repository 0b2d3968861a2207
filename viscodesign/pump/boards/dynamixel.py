"""`--board dynamixel`: a USB adapter straight on the servos' bus, such as USB2Dynamixel or U2D2."""

from __future__ import annotations

from viscodesign.errors import PumpError
from viscodesign.pump.boards.bus import BusBoard
from viscodesign.pump.bus import packets, registers
from viscodesign.pump.bus.transactions import ARBOTIX, NoReplyError
from viscodesign.pump.servo_motor import model_title

TRIED = range(1, 17)
"""Ids that are asked where nobody said which servos there are."""
ARBOTIX_MODEL = 300


class Dynamixel(BusBoard):
    """The adapter itself says nothing: whether a servo answers tells that it is there."""

    name = "dynamixel"
    baud = 1_000_000
    streams = True
    has_pins = False

    def identify(self) -> str:
        self._refuse_arbotix()
        servos = self.servos or TRIED
        found = {servo: told for servo in servos if (told := self._servo(servo))}
        if not found:
            raise PumpError(
                f"no servo answers with id {', '.join(map(str, servos))}. Is the power on, and "
                f"is the bus at {self.baud} baud (--baud)? An ArbotiX in between needs --board "
                "arbotix or arbotix-ros"
            )
        return "adapter on the servos' bus; " + "; ".join(found.values())

    def _refuse_arbotix(self) -> None:
        """Firmwares of the ArbotiX speak to id 253, and a servo should not have it."""
        request = packets.read(ARBOTIX, registers.MODEL.address, 2)
        try:
            reply = self.wire.ask(request, 2, 0, tries=1)
        except NoReplyError:
            return
        model = int.from_bytes(reply.parameters, "little")
        if model in (0, ARBOTIX_MODEL):
            other = "arbotix-ros" if model else "arbotix"
            raise PumpError(f"an ArbotiX answers here, not a servo: use --board {other}")

    def _servo(self, servo: int) -> str:
        """Model and version of a servo, or nothing where it does not answer."""
        try:
            data = self.wire.ask(packets.read(servo, 0, 3), 3, tries=1).parameters
        except NoReplyError:
            return ""
        model = registers.MODEL.within(data, 0)
        kind = model_title(model)
        return f"servo {servo}: {kind}, firmware {registers.FIRMWARE.within(data, 0)}"
