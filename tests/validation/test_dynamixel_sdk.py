"""ROBOTIS' own library talks to the simulated servos and finds what ours finds."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from tests.pumps import HOME, bench
from tests.rig.bus import BusAdapter
from tests.rig.pty import PtyServer
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.protocol.packets import ErrorBits
from viscodesign.pump.boards.dynamixel import Dynamixel
from viscodesign.pump.bus.clock import WallClock
from viscodesign.pump.bus.serial_line import SerialLine

sdk: Any = pytest.importorskip("dynamixel_sdk")

WELL = 0
TIMEOUT = -3001


@pytest.fixture(autouse=True)
def patient(monkeypatch: pytest.MonkeyPatch) -> None:
    """It gives up after two latencies, 34 ms, which a busy machine takes now and then."""
    monkeypatch.setattr("dynamixel_sdk.port_handler.LATENCY_TIMER", 1000)


@pytest.fixture
def server() -> Iterator[PtyServer]:
    with PtyServer(BusAdapter(bench(1, 2)), WallClock()) as served:
        yield served


@pytest.fixture
def port(server: PtyServer) -> Iterator[Any]:
    opened = sdk.PortHandler(server.port)
    assert opened.setBaudRate(1_000_000)
    yield opened
    opened.closePort()


def test_it_finds_the_servos_and_their_model(port: Any) -> None:
    protocol = sdk.PacketHandler(1.0)
    for servo in (1, 2):
        assert protocol.ping(port, servo) == (18, WELL, 0)
    assert protocol.ping(port, 3)[1] == TIMEOUT


def test_registers_agree_in_both_directions(port: Any, server: PtyServer) -> None:
    protocol = sdk.PacketHandler(1.0)
    for register in registers.TABLE:
        read = protocol.read1ByteTxRx if register.size == 1 else protocol.read2ByteTxRx
        value, result, error = read(port, 1, register.address)
        assert (result, error) == (WELL, 0), register.name
        with server.lock:
            assert value == server.device.bench.servos[0].get(register), register.name
    assert protocol.write2ByteTxRx(port, 1, 34, 500) == (WELL, 0)
    assert protocol.write1ByteTxRx(port, 2, 25, 1) == (WELL, 0)
    assert protocol.read2ByteTxRx(port, 1, 34) == (500, WELL, 0)
    assert protocol.read1ByteTxRx(port, 2, 25) == (1, WELL, 0)


def test_what_it_writes_we_read_and_vice_versa(server: PtyServer) -> None:
    protocol = sdk.PacketHandler(1.0)
    theirs = sdk.PortHandler(server.port)
    assert theirs.setBaudRate(1_000_000)
    group = sdk.GroupSyncWrite(theirs, protocol, 30, 4)
    assert group.addParam(1, [44, 1, 100, 0])
    assert group.addParam(2, [144, 1, 200, 0])
    assert group.txPacket() == WELL
    assert protocol.read2ByteTxRx(theirs, 2, 30) == (400, WELL, 0)
    theirs.closePort()
    line = SerialLine(server.port, 1_000_000)
    board = Dynamixel(line, [1, 2])
    assert board.read(1, 30, 4) == bytes([44, 1, 100, 0])
    board.set(1, registers.PUNCH, 40)
    line.close()
    assert theirs.setBaudRate(1_000_000)
    assert protocol.read2ByteTxRx(theirs, 1, 48) == (40, WELL, 0)
    theirs.closePort()


def test_error_bits_are_reported(port: Any, server: PtyServer) -> None:
    protocol = sdk.PacketHandler(1.0)
    with server.lock:
        server.device.bench.servos[0].alarm(ErrorBits.OVERLOAD)
    value, result, error = protocol.read2ByteTxRx(port, 1, 36)
    assert (value, result, error) == (HOME, WELL, ErrorBits.OVERLOAD)
    assert "Overload" in protocol.getRxPacketError(error)
    result, error = protocol.write2ByteTxRx(port, 2, 30, 2000)
    assert (result, error) == (WELL, ErrorBits.RANGE)
