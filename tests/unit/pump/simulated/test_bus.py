"""The adapter on the bus, as bytes and moments."""

from __future__ import annotations

import math

import pytest

from tests.pumps import bench, stepped
from tests.rig.bus import BusAdapter
from viscodesign.errors import PumpError
from viscodesign.pump.ax.protocol import packets
from viscodesign.pump.simulated.device import DirectLine

PING = bytes.fromhex("ffff010201fb")


def test_a_ping_takes_its_bits_and_the_servos_return_delay() -> None:
    adapter = BusAdapter(bench(1), latency=0.0)
    adapter.feed(PING, 0.0)
    assert adapter.due() == pytest.approx(12 * 10 / 1e6 + 500e-6)
    assert adapter.take(0.0006) == b""
    assert adapter.take(0.0007) == bytes.fromhex("ffff010200fc")
    assert adapter.due() == math.inf


def test_a_packet_with_a_pause_in_it_is_dropped() -> None:
    adapter = BusAdapter(bench(1))
    adapter.feed(PING[:3], 0.0)
    adapter.feed(PING[3:], 0.2)
    assert adapter.take(1.0) == b""
    adapter.feed(PING[:3], 2.0)
    adapter.feed(PING[3:], 2.05)
    assert adapter.take(3.0) != b""


def test_a_line_waits_just_as_long_as_the_reply_takes() -> None:
    clock = stepped()
    line = DirectLine(BusAdapter(bench(1)), clock)
    line.write(packets.ping(1).encode())
    assert line.read(100, 1.0) == bytes.fromhex("ffff010200fc")
    assert clock.now() < 0.002
    assert line.read(100, 1.0) == b""
    assert clock.now() == 1.0


def test_a_closed_line_says_so() -> None:
    line = DirectLine(BusAdapter(bench(1)), stepped())
    line.close()
    line.close()
    with pytest.raises(PumpError, match="closed"):
        line.write(PING)
