"""A board by its name, and what is missing."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.pumps import bench, pump, stepped
from tests.rig.bus import BusAdapter
from tests.rig.pty import PtyServer
from viscodesign.errors import PumpError, UsageError
from viscodesign.pump.boards.dynamixel import Dynamixel
from viscodesign.pump.bus.byte_log import ByteLog
from viscodesign.pump.bus.clock import WallClock
from viscodesign.pump.sessions.open_board import boards, open_board

NO_LOG = ByteLog(None, print)


def test_the_catalogue_is_the_folder() -> None:
    assert {"dynamixel", "arbotix-ros", "simulated"} <= set(boards())


def test_the_simulated_board_opens_without_a_port() -> None:
    board = open_board("simulated", None, None, NO_LOG, stepped(), pump())
    assert board.identify().startswith("simulated, nothing real moves")
    board.line.close()


@pytest.mark.parametrize(
    ("name", "port", "baud", "words"),
    [
        ("dynamixl", None, None, "did you mean 'dynamixel'"),
        ("dynamixel", None, None, "needs --port"),
        ("simulated", "/dev/ttyUSB0", None, "has no --port"),
        ("simulated", None, 9600, "no --baud"),
        ("dynamixel", "/dev/ttyUSB0", 0, "--baud 0"),
    ],
)
def test_missing_and_superfluous_options_are_refused(
    name: str, port: str | None, baud: int | None, words: str
) -> None:
    with pytest.raises(UsageError, match=words):
        open_board(name, port, baud, NO_LOG, stepped(), pump())


def test_the_simulated_board_needs_a_pump() -> None:
    with pytest.raises(UsageError, match="pump:"):
        open_board("simulated", None, None, NO_LOG, stepped())


def test_a_board_on_a_port(tmp_path: Path) -> None:
    log = ByteLog(tmp_path / "log.jsonl", print)
    with PtyServer(BusAdapter(bench(1)), WallClock()) as server:
        board = open_board("dynamixel", server.port, None, log, None, pump())
        assert isinstance(board, Dynamixel)
        board.wire.patience = 1.0
        assert "AX-18A" in board.identify()
        board.line.close()
        with pytest.raises(PumpError):
            board.read(1, 0, 2)
    text = (tmp_path / "log.jsonl").read_text()
    assert '"kind": "opened"' in text
    assert "ff ff 01 04 02 00 03" in text


def test_a_supply_beyond_the_register_does_not_crash() -> None:
    board = open_board("simulated", None, None, NO_LOG, stepped(), pump(supply_voltage=230.0))
    assert board.identify().startswith("simulated")
    board.line.close()
