"""Faults strike when they are told to, and no more often."""

from __future__ import annotations

import pytest

from tests.pumps import bench
from tests.rig import faults
from tests.rig.bus import BusAdapter
from tests.rig.faults import Fault, Faulty
from viscodesign.pump.ax.protocol import packets
from viscodesign.pump.simulated.device import UnpluggedError

PING = packets.ping(1).encode()
PONG = bytes.fromhex("ffff010200fc")


def heard_with(*trouble: Fault) -> list[bytes]:
    """What comes back from pings that are a second apart."""
    device = Faulty(BusAdapter(bench(1)), trouble)
    heard = []
    for k in range(4):
        device.feed(PING, float(k))
        heard.append(device.take(k + 0.01) + device.take(k + 0.5))
    return heard


@pytest.mark.parametrize("kind", [faults.LostRequest, faults.LostReply])
def test_lost(kind: type[Fault]) -> None:
    assert heard_with(kind(1)) == [PONG, b"", PONG, PONG]
    assert heard_with(kind(1, times=2)) == [PONG, b"", b"", PONG]
    assert heard_with(kind(moment=1.5)) == [PONG, PONG, b"", PONG]


def test_late_comes_with_the_next() -> None:
    assert heard_with(faults.LateReply(1, delay=0.7)) == [PONG, b"", PONG + PONG, PONG]


def test_corrupt_turns_one_bit() -> None:
    (first, second, *_) = heard_with(faults.CorruptReply(1, bit=16))
    assert first == PONG
    assert second == bytes.fromhex("ffff000200fc")
    assert heard_with(faults.CorruptRequest(0, bit=16))[0] == b""


def test_foreign_bytes_come_before() -> None:
    assert heard_with(faults.ForeignBytes(0, data=b"abc"))[0] == b"abc" + PONG


def test_unplugged_is_for_ever() -> None:
    device = Faulty(BusAdapter(bench(1)), [faults.Unplugged(1)])
    device.feed(PING, 0.0)
    with pytest.raises(UnpluggedError):
        device.feed(PING, 1.0)
    with pytest.raises(UnpluggedError):
        device.take(2.0)


def test_a_mishap_happens_to_the_pump_itself() -> None:
    pump = bench(1)
    device = Faulty(BusAdapter(pump), [faults.Mishap(1, happen=lambda: pump.supply(5.5))])
    device.feed(PING, 0.0)
    assert device.take(0.5) == PONG
    device.feed(PING, 1.0)
    assert device.take(1.5) == bytes.fromhex("ffff010201fb")
