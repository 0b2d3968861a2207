"""Commands at a board: what they say, what they write, and what they leave alone."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pandas as pd
import pytest

from tests.pumps import bench
from tests.rig.bus import BusAdapter
from tests.rig.pty import PtyServer
from viscodesign.cli import confirm as _confirm
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.bus.clock import WallClock
from viscodesign.pump.simulated.bench import SimulatedBench

from .conftest import CONFIGS, Call

SPEC = CONFIGS / "leg_16_pump.yaml"


@dataclass
class Port:
    """Two servos on an adapter, behind a port."""

    bench: SimulatedBench
    server: PtyServer

    @property
    def words(self) -> list[str]:
        return ["--board", "dynamixel", "--port", self.server.port]

    def get(self, register: registers.Register, servo: int = 0) -> int:
        with self.server.lock:
            return self.bench.servos[servo].get(register)

    def eeprom(self) -> list[bytes]:
        with self.server.lock:
            return [bytes(servo.memory[: registers.RAM]) for servo in self.bench.servos]


@pytest.fixture
def port() -> Iterator[Port]:
    pump = bench(1, 2)
    for servo in pump.servos:
        servo.supply(11.1)
    with PtyServer(BusAdapter(pump), WallClock()) as server:
        yield Port(pump, server)


def test_ports_lists_what_there_is(call: Call, monkeypatch: pytest.MonkeyPatch) -> None:
    from viscodesign.pump.bus import ports

    found = [ports.Port("/dev/ttyX", "adapter", "maker", "1", "latency timer is 16 ms")]
    monkeypatch.setattr(ports, "ports", lambda: found)
    told = call("pump", "ports")
    assert told.status == 0
    assert "/dev/ttyX" in told.out
    assert "/dev/ttyX latency timer is 16 ms" in told.out
    assert json.loads(call("pump", "ports", "--json").out)["ports"][0]["name"] == "/dev/ttyX"
    monkeypatch.setattr(ports, "ports", list)
    assert "no serial ports" in call("pump", "ports").out


def test_status_reads_all_and_writes_nothing(call: Call, port: Port) -> None:
    before = port.eeprom()
    told = call("pump", "status", *port.words)
    assert told.status == 0, told.err
    assert told.out.count("AX-18A") >= 2
    assert "11.1 V" in told.out
    assert port.eeprom() == before
    assert not port.get(registers.TORQUE_ENABLE)


def test_status_against_a_spec_says_what_is_not_calibrated(call: Call, port: Port) -> None:
    told = call("pump", "status", SPEC, *port.words, "--set", "pump.sensor=null", "--json")
    assert told.status == 4
    document = json.loads(told.out)
    assert document["simulated"] is False
    assert document["servos"][0]["limits_counts"] == [0, 1023]
    assert "pump calibrate" in told.err
    assert document["objections"]


def test_status_of_the_simulated_pump(call: Call) -> None:
    told = call("pump", "status")
    assert told.status == 0
    assert told.out.startswith("[simulated] ")
    assert "kPa gauge" in told.out


def test_status_says_how_to_speed_up_a_slow_adapter(
    call: Call, port: Port, monkeypatch: pytest.MonkeyPatch
) -> None:
    from viscodesign.pump.bus import ports

    monkeypatch.setattr(ports, "latency_hint", lambda name: "latency timer is 16 ms")
    told = call("pump", "status", *port.words)
    assert f"{port.server.port} latency timer is 16 ms" in told.out
    document = json.loads(call("pump", "status", *port.words, "--json").out)
    assert document["hints"] == [f"{port.server.port} latency timer is 16 ms"]
    assert json.loads(call("pump", "status", "--json").out)["hints"] == []


def test_status_names_the_inlet_of_each_pressure_and_switch(call: Call) -> None:
    words = [
        *("--set", "pump.syringe_diameter=34.9 mm", "--set", "pump.home=500"),
        *("--set", "pump.servo_id={right: 2, left: 1}"),
        *("--set", "pump.sensor={left: {channel: 0}, right: {channel: 1}}"),
        *("--set", "pump.limit_switches.left={low: D1, high: D2}"),
        *("--set", "pump.limit_switches.right={low: D3, high: D4}"),
    ]
    told = call("pump", "status", CONFIGS / "antagonistic_two_inlets.yaml", *words)
    assert told.status == 0, told.err
    assert "pressure of left  -0.23 kPa gauge" in told.out
    assert "pressure of right  -0.23 kPa gauge" in told.out
    assert "pressed" not in told.out


def test_record_reads_only(call: Call, port: Port, tmp_path: Path) -> None:
    path = tmp_path / "rest.csv"
    told = call("pump", "record", *port.words, "-o", path, "--duration", "0.3", "--json")
    assert told.status == 0, told.err
    table = pd.read_csv(path)
    assert {"time_s", "position_servo1_counts", "position_servo2_counts"} <= set(table.columns)
    assert len(table) == json.loads(told.out)["rows"] > 3
    assert not port.get(registers.TORQUE_ENABLE)
    beside = json.loads(path.with_suffix(".json").read_text())
    assert (beside["status"], beside["simulated"]) == ("complete", False)


def test_record_of_the_simulated_pump_without_waiting(call: Call, tmp_path: Path) -> None:
    path = tmp_path / "rest.csv"
    told = call("pump", "record", "-o", path, "--duration", "60", "--pace", "max")
    assert told.status == 0, told.err
    assert told.out.startswith("[simulated] ")
    table = pd.read_csv(path)
    assert table["time_s"].iloc[-1] == pytest.approx(60.0, abs=0.05)
    assert table["inlet_pressure_pa"].abs().max() < 2e3


def test_record_without_waiting_needs_a_duration(call: Call, tmp_path: Path) -> None:
    told = call("pump", "record", "-o", tmp_path / "a.csv", "--pace", "max")
    assert told.status == 2
    assert "--duration" in told.err


@pytest.mark.parametrize("release", [False, True])
def test_stop_holds_or_releases_what_moves(call: Call, port: Port, release: bool) -> None:
    with port.server.lock:
        servo = port.bench.servos[0]
        servo.set(registers.MOVING_SPEED, 20)
        servo.set(registers.GOAL_POSITION, 900)
        servo.set(registers.TORQUE_ENABLE, 1)
    told = call("pump", "stop", *port.words, *(["--release"] if release else []))
    assert told.status == 0, told.err
    assert "verified" in told.out
    assert port.get(registers.TORQUE_ENABLE) == (0 if release else 1)
    if not release:
        assert "servo 2: torque is off" in told.out
        assert port.get(registers.GOAL_POSITION) < 400
        assert not port.get(registers.TORQUE_ENABLE, servo=1)  # never switched on


def test_stop_says_when_no_servo_answers(call: Call, port: Port) -> None:
    with port.server.lock:
        port.bench.supply(0.0)
    told = call("pump", "stop", *port.words, "--id", "1")
    assert told.status == 4
    assert "nothing could be verified" in told.err
    assert "power off" in told.err


def test_stop_needs_no_spec_but_a_board(call: Call) -> None:
    assert call("pump", "stop").status == 2
    told = call("pump", "stop", "--board", "simulated")
    assert told.status == 0
    assert "nothing to stop" in told.out


ONE = ["--set", "pump.sensor=null"]


def test_calibrate_writes_only_what_differs(call: Call, port: Port) -> None:
    words = ["pump", "calibrate", SPEC, *port.words, "--keep", "--yes", *ONE]
    told = call(*words)
    assert told.status == 0, told.err
    assert "clockwise angle limit 0 -> 100" in told.err
    assert told.out == "pump:\n  home: 500\n  travel: [100, 1000]\n"
    assert port.get(registers.CW_LIMIT) == 100
    assert port.get(registers.CCW_LIMIT) == 1000
    before = port.eeprom()
    again = call(*words)
    assert "nothing is written" in again.err
    assert port.eeprom() == before
    assert before[1] == bytes(bench(2).servos[0].memory[: registers.RAM])  # the other servo


def test_calibrate_asks_before_each_write(
    call: Call, port: Port, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(_confirm.sys.stdin, "isatty", lambda: True)
    answers = iter([True, False])
    monkeypatch.setattr(_confirm, "_agreed", lambda question: next(answers))
    told = call("pump", "calibrate", SPEC, *port.words, "--keep", *ONE)
    assert told.status == 2
    assert "aborted; nothing moved" in told.err
    assert port.get(registers.CW_LIMIT) == 100
    assert port.get(registers.CCW_LIMIT) == 1023


def test_calibrate_without_a_terminal_writes_nothing(call: Call, port: Port) -> None:
    before = port.eeprom()
    for words in (["--keep"], []):
        told = call("pump", "calibrate", SPEC, *port.words, *words, *ONE)
        assert told.status == 2, told.err
        assert "terminal" in told.err
    assert port.eeprom() == before


def test_calibrate_renames_a_servo(call: Call, port: Port) -> None:
    words = ["pump", "calibrate", SPEC, *port.words, "--keep", "--yes", *ONE]
    told = call(*words, "--rename", "2=5", "--set", "pump.servo_id=5")
    assert told.status == 0, told.err
    assert port.get(registers.ID, servo=1) == 5
    taken = call(*words, "--rename", "5=1")
    assert taken.status == 4
    assert "two would answer" in taken.err


def test_calibrate_puts_lines_into_the_spec(call: Call, port: Port, tmp_path: Path) -> None:
    spec = tmp_path / "leg.yaml"
    spec.write_text(SPEC.read_text())
    words = ["pump", "calibrate", spec, *port.words, "--keep", "--yes", "--write", *ONE]
    told = call(*words, "--set", "pump.home=321", "--set", "pump.travel=[120, 980]")
    assert told.status == 0, told.err
    assert "  home: 321" in spec.read_text()
    assert "  travel: [120, 980]" in spec.read_text()
    assert len(spec.read_text().splitlines()) == len(SPEC.read_text().splitlines())
    assert call("check", spec).status == 0


def test_a_dry_run_opens_no_port(call: Call) -> None:
    words: list[Any] = ["pump", "calibrate", SPEC, "--board", "dynamixel", "--port", "/dev/none"]
    told = call(*words, "--dry-run")
    assert told.status == 0
    assert told.out.startswith("[dry run]")
