"""A board by its name, and what is missing."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.pumps import bench
from tests.rig.bus import BusAdapter
from tests.rig.pty import PtyServer
from tests.scenes import leg
from viscodesign.errors import PumpError, SpecError, UsageError
from viscodesign.pump.boards.dynamixel import Dynamixel
from viscodesign.pump.bus.clock import WallClock
from viscodesign.pump.sessions.board_names import boards
from viscodesign.pump.sessions.connection import BoardAddress, connected

SCENE = leg("pump.sensor=null", config="leg_16_pump")


def test_the_catalogue_is_the_folder() -> None:
    assert {"dynamixel", "arbotix-ros", "simulated"} <= set(boards())


def test_the_simulated_board_opens_without_a_port() -> None:
    with connected(BoardAddress("simulated", pace="max")) as link:
        assert link.board.identify().startswith("simulated, nothing real moves")


@pytest.mark.parametrize(
    ("name", "port", "baud", "words"),
    [
        ("dynamixl", None, None, "did you mean 'dynamixel'"),
        ("dynamixel", None, None, "needs a port"),
        ("simulated", "/dev/ttyUSB0", None, "has no port"),
        ("simulated", None, 9600, "no baud rate"),
        ("dynamixel", "/dev/ttyUSB0", 0, "baud rate must be above 0"),
    ],
)
def test_missing_and_superfluous_options_are_refused(
    name: str, port: str | None, baud: int | None, words: str
) -> None:
    with pytest.raises(UsageError, match=words), connected(BoardAddress(name, port, baud), SCENE):
        pass


def test_the_simulated_board_needs_a_pump() -> None:
    with pytest.raises(SpecError, match="pump:"), connected(BoardAddress("simulated"), leg()):
        pass


def test_a_board_on_a_port(tmp_path: Path) -> None:
    with PtyServer(BusAdapter(bench(1)), WallClock()) as server:
        address = BoardAddress("dynamixel", server.port, log=tmp_path / "log.jsonl")
        with connected(address, SCENE) as link:
            assert isinstance(link.board, Dynamixel)
            link.board.patience = 1.0
            assert "AX-18A" in link.board.identify()
        with pytest.raises(PumpError):
            link.board.read(1, 0, 2)
    text = (tmp_path / "log.jsonl").read_text()
    assert '"kind": "opened"' in text
    assert "ff ff 01 04 02 00 03" in text


def test_a_supply_beyond_the_register_does_not_crash() -> None:
    scene = leg("pump.supply_voltage=230 V", config="leg_16_pump")
    with connected(BoardAddress("simulated", pace="max"), scene) as link:
        assert link.board.identify().startswith("simulated")
