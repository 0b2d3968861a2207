"""A port, its faults, and their remedies; on pseudo-terminals."""

from __future__ import annotations

import os
import subprocess
import termios
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
import serial

from tests.pumps import bench
from tests.rig.bus import BusAdapter
from tests.rig.pty import PtyServer
from viscodesign.errors import PumpError
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.boards.arbotix_ros import ArbotixRos
from viscodesign.pump.boards.base import Goal
from viscodesign.pump.boards.dynamixel import Dynamixel
from viscodesign.pump.bus.clock import WallClock
from viscodesign.pump.bus.ports import latency_hint, ports
from viscodesign.pump.bus.serial_line import SerialLine, users_of
from viscodesign.pump.simulated.ros import Ros

PATIENCE = 1.0
"""For the thread that serves the port, on a busy machine [s]."""


@pytest.fixture
def server() -> Iterator[PtyServer]:
    served = PtyServer(BusAdapter(bench(1)), WallClock())
    yield served
    served.close()


def test_a_board_speaks_through_a_port(server: PtyServer) -> None:
    line = SerialLine(server.port, 1_000_000)
    board = Dynamixel(line, [1])
    board.patience = PATIENCE
    assert board.identify() == "adapter on the servos' bus; servo 1: AX-18A, firmware 24"
    board.move({1: Goal(300, 200)})
    assert board.read(1, 30, 4) == bytes([44, 1, 200, 0])
    line.close()
    line.close()


def test_a_firmware_speaks_through_a_port() -> None:
    with PtyServer(Ros(bench(1)), WallClock()) as served:
        line = SerialLine(served.port, 115_200)
        board = ArbotixRos(line, [1])
        board.patience = PATIENCE
        assert "firmware for ROS" in board.identify()
        board.set(1, registers.TORQUE_LIMIT, 400)
        line.close()


def test_a_pulled_cable_is_an_error_of_the_pump_whatever_is_being_done(server: PtyServer) -> None:
    line = SerialLine(server.port, 1_000_000)
    server.close()
    for action in (
        lambda: line.write(b"x" * 10),
        lambda: line.read(10, line.clock.now() + 0.1),
        lambda: line.drain(),
    ):
        with pytest.raises(PumpError, match="the port is gone"):
            action()


def test_nothing_comes_until_the_deadline(server: PtyServer) -> None:
    line = SerialLine(server.port, 1_000_000)
    start = line.clock.now()
    assert line.read(10, start + 0.03) == b""
    assert line.clock.now() >= start + 0.03
    line.close()


def test_a_port_has_one_owner(server: PtyServer) -> None:
    line = SerialLine(server.port, 1_000_000)
    with pytest.raises(PumpError, match="in use by another program"):
        SerialLine(server.port, 1_000_000)
    line.close()


def test_missing_and_wrong_ports_say_what_to_do(tmp_path: Path) -> None:
    with pytest.raises(PumpError, match="no such port; `viscodesign pump ports`"):
        SerialLine(str(tmp_path / "ttyNone"), 115200)
    file = tmp_path / "file"
    file.touch()
    with pytest.raises(PumpError, match="not a serial port"):
        SerialLine(str(file), 115200)


def test_a_speed_that_cannot_be(server: PtyServer) -> None:
    with pytest.raises(PumpError, match="-1 baud is not a speed"):
        SerialLine(server.port, -1)


def test_permission_names_the_group(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(self: serial.Serial) -> None:
        raise serial.SerialException(13, "could not open port")

    monkeypatch.setattr(serial.Serial, "open", refuse)
    with pytest.raises(PumpError, match="dialout"):
        SerialLine("/dev/ttyUSB0", 115200)


def test_a_port_that_takes_no_bytes(server: PtyServer, monkeypatch: pytest.MonkeyPatch) -> None:
    def hang(self: serial.Serial, data: bytes) -> int:
        raise serial.SerialTimeoutException("Write timeout")

    line = SerialLine(server.port, 115200)
    monkeypatch.setattr(serial.Serial, "write", hang)
    with pytest.raises(PumpError, match="write timed out"):
        line.write(b"x")
    line.close()


def test_it_is_opened_once_and_at_its_speed(
    server: PtyServer, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened = []
    real = os.open

    def count(path: str, *args: int) -> int:
        if path == server.port:
            opened.append(path)
        return real(path, *args)

    monkeypatch.setattr(os, "open", count)
    line = SerialLine(server.port, 115200)
    line.write(b"\x00")
    line.close()
    assert len(opened) == 1


def test_closing_does_not_let_go_of_dtr(server: PtyServer) -> None:
    SerialLine(server.port, 115200).close()
    again = os.open(server.port, os.O_RDWR | os.O_NOCTTY)
    assert not termios.tcgetattr(again)[2] & termios.HUPCL
    os.close(again)


def test_who_holds_a_port_is_told_but_not_ourselves(server: PtyServer) -> None:
    assert users_of(server.port) == []
    with subprocess.Popen(["cat", server.port], stdout=subprocess.DEVNULL) as other:
        try:
            until = time.monotonic() + 10.0
            while not users_of(server.port) and time.monotonic() < until:
                time.sleep(0.02)
            assert users_of(server.port) == [f"cat (process {other.pid})"]
        finally:
            other.kill()


def test_a_slow_adapter_is_told_how_to_be_quick(tmp_path: Path) -> None:
    timer = tmp_path / "ttyUSB0" / "latency_timer"
    timer.parent.mkdir()
    timer.write_text("16\n")
    assert "16 ms" in latency_hint("/dev/ttyUSB0", tmp_path)
    timer.write_text("1\n")
    assert latency_hint("/dev/ttyUSB0", tmp_path) == ""
    assert latency_hint("/dev/ttyACM0", tmp_path) == ""


def test_ports_are_listed() -> None:
    assert all(port.name for port in ports())
