"""The regulator's line: what is sent, and which replies count."""

from __future__ import annotations

import pytest

from tests.regulator_rig import RegulatorRig
from viscodesign.errors import PumpError
from viscodesign.pump.boards.line_regulator import LineRegulator
from viscodesign.pump.bus.clock import SteppedClock
from viscodesign.pump.bus.line import Line


class Script(Line):
    """Answers each line that is sent by the next of some replies; some seconds later."""

    def __init__(self, *replies: tuple[bytes, float]) -> None:
        self.clock = SteppedClock()
        self.replies = list(replies)
        self.coming: list[tuple[float, bytes]] = []
        self.sent: list[bytes] = []

    def write(self, data: bytes) -> None:
        self.sent.append(data)
        reply, seconds = self.replies.pop(0)
        self.coming.append((self.clock.now() + seconds, reply))

    def read(self, most: int, deadline: float) -> bytes:
        if not self.coming or self.coming[0][0] > deadline:
            self.clock.sleep_until(deadline)
            return b""
        moment, data = self.coming.pop(0)
        self.clock.sleep_until(moment)
        return data

    def drain(self) -> bytes:
        came = [data for moment, data in self.coming if moment <= self.clock.now()]
        del self.coming[: len(came)]
        return b"".join(came)

    def close(self) -> None:
        """Nothing to release."""


def test_the_commands_are_those_of_the_device() -> None:
    line = Script((b"17\r\n", 0.01), (b"20\r\n", 0.01), (b"255\r\n", 0.01))
    board = LineRegulator(line)
    assert (board.outlet(), board.set_point()) == (17, 20)
    board.set(255)
    assert line.sent == [b"MON\r\n", b"REQ\r\n", b"SET 255\r\n"]
    assert [board.sets(sent) for sent in line.sent] == [False, False, True]
    assert board.shown(line.sent[2]) == "SET 255"


@pytest.mark.parametrize(
    "reply", [b"UNKNOWN COMMAND\r\n", b"OUT OF RANGE\r\n", b"1024\r\n", b"-3\r\n"]
)
def test_what_is_no_number_of_steps_is_no_reply(reply: bytes) -> None:
    with pytest.raises(PumpError, match=r"the regulator answers .* to MON"):
        LineRegulator(Script((reply, 0.01), (reply, 0.01))).outlet()


def test_a_set_point_that_is_not_repeated_is_an_error() -> None:
    with pytest.raises(PumpError, match="was sent SET 30 and repeats 3"):
        LineRegulator(Script((b"3\r\n", 0.01))).set(30)


@pytest.mark.parametrize("step", [-1, 1024])
def test_a_set_point_out_of_range_is_never_sent(step: int) -> None:
    line = Script()
    with pytest.raises(PumpError, match="takes 0 to 1023"):
        LineRegulator(line).set(step)
    assert line.sent == []


def test_a_late_reply_is_not_taken_for_the_next_one() -> None:
    """Replies carry no id: what was asked first must not answer what is asked then."""
    line = Script((b"111\r\n", 0.08), (b"222\r\n", 0.01), (b"333\r\n", 0.01))
    board = LineRegulator(line)
    assert board.outlet() == 222
    assert board.set_point() == 333


def test_half_a_reply_is_none() -> None:
    line = Script((b"51", 0.01), (b"512\r\n", 0.01))
    assert LineRegulator(line).outlet() == 512


def test_one_that_is_gone_is_reported_before_a_silence_is_too_long() -> None:
    rig = RegulatorRig()
    rig.device.deaf = True
    with pytest.raises(PumpError, match="does not answer MON"):
        rig.board.outlet()
    assert rig.clock.now() < 0.25


def test_the_simulated_device_follows_with_its_time_constant() -> None:
    rig = RegulatorRig()
    rig.device.advance(0.0)
    assert rig.device.answer("SET 500") == "500"
    rig.device.advance(rig.spec.response_time)
    goal = 500 * rig.spec.step
    assert rig.device.pressure == pytest.approx(goal * 0.6321, rel=1e-3)
    assert rig.device.answer("SET 2000") == "OUT OF RANGE"
    assert rig.device.answer("HELLO") == "UNKNOWN COMMAND"
    assert rig.device.set_point == 500
