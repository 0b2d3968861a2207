"""`pump stream` on the simulated board: asked for, labelled, recorded, and ended rightly."""

from __future__ import annotations

import json
from pathlib import Path

import pandas as pd
import pytest

from tests.plans import planned_once
from viscodesign.cli import confirm as _confirm
from viscodesign.pump.play import link_rate
from viscodesign.pump.play.axis import Sample
from viscodesign.pump.play.link_rate import RoundTrip
from viscodesign.pump.play.stream_result import RecordingError
from viscodesign.pump.sessions.record_file import Record

from .conftest import CONFIGS, Call

SPEC = CONFIGS / "leg_16_pump.yaml"
TWO = CONFIGS / "antagonistic_two_inlets.yaml"
PUMP = [
    *("--set", "pump.syringe_diameter=34.9 mm", "--set", "pump.home=500"),
    *("--set", "pump.servo_id={right: 2, left: 1}"),
]
SENSORS = ["--set", "pump.sensor={right: {channel: 1}, left: {channel: 0}}"]
SHORT = [
    *("--set", "input={kind: sine, amplitude: 4 kPa, frequency: 0.5 Hz}"),
    *("--set", "run.duration=2 s", "--pace", "max"),
]


@pytest.fixture(autouse=True)
def plans(monkeypatch: pytest.MonkeyPatch) -> None:
    """Most tests stream the same plan."""
    monkeypatch.setattr("viscodesign.pump.sessions.streaming.plan_pump", planned_once)


def test_a_simulated_stream_is_recorded_and_labelled(call: Call, tmp_path: Path) -> None:
    told = call("pump", "stream", SPEC, *SHORT, "--yes", "-o", tmp_path / "run", "--json")
    assert told.status == 0, told.err
    document = json.loads(told.out)
    assert (document["status"], document["hold_verified"]) == ("complete", True)
    assert "[simulated]" in told.err
    assert "stops above 25 kPa" in told.err
    table = pd.read_csv(tmp_path / "run" / "record.csv")
    assert list(table.columns)[:5] == [
        "time_s", "tip_x_m", "tip_z_m", "tip_angle_rad", "inlet_pressure_pa",
    ]  # fmt: skip
    assert table["time_s"].iloc[-1] == pytest.approx(2.0, abs=0.05)
    assert table["time_s"].is_monotonic_increasing
    beside = json.loads((tmp_path / "run" / "record.json").read_text())
    assert (beside["status"], beside["partial"], beside["simulated"]) == ("complete", False, True)
    assert beside["ticks"]["skipped_ticks"] == 0
    log = [json.loads(line) for line in (tmp_path / "run" / "log.jsonl").read_text().splitlines()]
    kinds = {entry["kind"] for entry in log}
    assert {"opened", "found", "tx", "rx", "tick", "ended", "closed"} <= kinds
    assert log[0]["simulated"] is True


def test_without_a_terminal_or_yes_nothing_moves(call: Call, tmp_path: Path) -> None:
    told = call("pump", "stream", SPEC, *SHORT, "-o", tmp_path / "run")
    assert told.status == 2
    assert "--yes" in told.err
    assert "plunger" in told.err  # the plan was shown
    assert not (tmp_path / "run").exists()


def test_a_refused_confirmation_moves_nothing(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(_confirm.sys.stdin, "isatty", lambda: True)
    monkeypatch.setattr(_confirm, "_agreed", lambda question: False)
    told = call("pump", "stream", SPEC, *SHORT, "-o", tmp_path / "run")
    assert told.status == 2
    assert "nothing moved" in told.err


def test_a_record_of_a_real_pump_is_not_replaced(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    words = ["pump", "stream", SPEC, *SHORT, "--yes", "--json"]
    assert call(*words).status == 0
    assert call(*words).status == 0  # a simulated one of the same spec is
    (folder,) = Path("runs").iterdir()
    beside = folder / "record.json"
    beside.write_text(beside.read_text().replace('"simulated": true', '"simulated": false'))
    before = beside.read_bytes()
    refused = call(*words, "-o", folder)
    assert refused.status == 2
    assert "--force" in refused.err
    other = call(*words)
    assert other.status == 0
    assert f"this one is in {folder}-2" in other.err
    assert beside.read_bytes() == before
    assert call(*words, "-o", folder, "--force").status == 0
    assert json.loads(beside.read_text())["simulated"] is True


def test_another_spec_of_the_same_name_keeps_the_first_record(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    words = ["pump", "stream", SPEC, *SHORT, "--yes"]
    assert call(*words).status == 0
    assert call(*words, "--set", "run.duration=1 s").status == 0
    assert len(list(Path("runs").iterdir())) == 2


def test_a_dry_run_prints_packets_and_leaves_no_file(call: Call, tmp_path: Path) -> None:
    words = ["pump", "stream", SPEC, *SHORT[:-2], "--board", "dynamixel"]
    told = call(*words, "--dry-run", "-o", tmp_path / "run")
    assert told.status == 0, told.err
    assert told.out.startswith("[dry run]")
    assert "FF FF 01 05 03 22" in told.out  # the torque limit comes first
    assert "FF FF FE 09 83 1E 04 01" in told.out
    document = json.loads(call(*words, "--dry-run", "--json").out)
    assert document == {"status": "dry run", "lines": told.out.splitlines()}
    assert not (tmp_path / "run").exists()


def test_what_the_pump_cannot_do_is_refused_or_clipped(call: Call, tmp_path: Path) -> None:
    high = [*SHORT, "--set", "pump.max_pressure=3 kPa gauge", "-o", tmp_path / "run", "--yes"]
    told = call("pump", "stream", SPEC, *high)
    assert told.status == 4
    assert "--achievable" in told.err
    assert not (tmp_path / "run").exists()


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["--board", "arbotx"], "did you mean"),
        (["--board", "arbotix", "--port", "x"], "pump upload"),
        (["--rate", "5"], "10 to 100 Hz"),
        (["--on-stop", "sit"], "hold, release, retract"),
        (["--board", "dynamixel"], "needs a port"),
        (["--board", "dynamixel", "--port", "x", "--pace", "10"], "only the simulated"),
        (["--port", "x"], "nothing real moves"),
        (["--pace", "fast"], "or max"),
        (
            ["--board", "dynamixel", "--port", "x", "--set", "pump.sensor=null"],
            "--without-sensor",
        ),
    ],
)
def test_wrong_options_are_refused_before_planning(
    call: Call, tmp_path: Path, words: list[str], told: str
) -> None:
    outcome = call("pump", "stream", SPEC, "-o", tmp_path / "run", *words)
    assert outcome.status == 2, outcome.err
    assert told in outcome.err


def test_a_broken_rule_exits_with_4_and_keeps_a_partial_record(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from viscodesign.pump.ax import servo_pump, servo_state

    monkeypatch.setattr(servo_pump, "HIGHEST_TEMPERATURE", 25.0)
    monkeypatch.setattr(servo_state, "HIGHEST_TEMPERATURE", 99.0)
    told = call("pump", "stream", SPEC, *SHORT, "--yes", "-o", tmp_path / "run")
    assert told.status == 4
    assert "STOPPED: temperature" in told.err
    assert "verified" in told.err
    beside = json.loads((tmp_path / "run" / "record.json").read_text())
    assert (beside["status"], beside["partial"], beside["rule"]) == ("stopped", True, "temperature")


def test_a_full_disk_is_an_end_of_its_own(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    add = Record.add

    def fill_up(record: Record, moment: float, sample: Sample) -> None:
        if record.rows > 20:
            raise RecordingError("cannot write record.csv: No space left on device")
        add(record, moment, sample)

    monkeypatch.setattr(Record, "add", fill_up)
    told = call("pump", "stream", SPEC, *SHORT, "--yes", "-o", tmp_path / "run")
    assert told.status == 4
    assert "STOPPED: cannot write record.csv: No space left" in told.err
    assert "verified" in told.err
    beside = json.loads((tmp_path / "run" / "record.json").read_text())
    assert (beside["status"], beside["partial"], beside["rule"]) == ("stopped", True, "record")


# -- two inlets -----------------------------------------------------------------------------


@pytest.mark.parametrize("sensors", [SENSORS, []])
def test_each_inlets_pressure_is_measured_and_recorded(
    call: Call, tmp_path: Path, sensors: list[str]
) -> None:
    words = [*PUMP, *sensors, "--set", "run.duration=2 s", "--pace", "max", "--yes"]
    told = call("pump", "stream", TWO, *words, "-o", tmp_path / "run", "--json")
    assert told.status == 0, told.err
    assert "left: -0.23 kPa at rest" in told.err
    assert "right: -0.23 kPa at rest" in told.err
    table = pd.read_csv(tmp_path / "run" / "record.csv")
    table = table[table["time_s"] > 0]
    for inlet, other in (("left", "right"), ("right", "left")):
        measured, wanted = (table[f"{kind}_pressure_{inlet}_pa"] for kind in ("inlet", "wanted"))
        # Of eight bits, 1.6 kPa apart.
        assert (measured - wanted).abs().max() < 1.3e3
        assert (measured - table[f"wanted_pressure_{other}_pa"]).abs().max() > 5e3


ONE_SENSOR = ["--set", "pump.sensor={channel: 0}"]
REAL = ["--board", "dynamixel", "--port", "x"]


@pytest.mark.parametrize(
    ("sensors", "blind"), [([], "for left and right"), (ONE_SENSOR, "for right,")]
)
def test_a_real_board_with_an_unmonitored_inlet_is_refused(
    call: Call, tmp_path: Path, sensors: list[str], blind: str
) -> None:
    told = call("pump", "stream", TWO, *PUMP, *sensors, *REAL, "-o", tmp_path / "run")
    assert told.status == 2
    assert blind in told.err
    assert "sensor: {left: {channel: 0}, right: {channel: 1}}" in told.err
    assert "--without-sensor" in told.err
    assert not (tmp_path / "run").exists()


def test_going_without_one_sensor_keeps_the_others() -> None:
    from viscodesign import load
    from viscodesign.pump.kinds.servo import ServoKind

    words = [word for word in PUMP if word != "--set"]
    some = load(TWO, [*words, ONE_SENSOR[1]])
    assert ServoKind().with_sensors(some, simulated=False, without=True) is some
    every = load(TWO, [*words, SENSORS[1]])
    assert ServoKind().with_sensors(every, simulated=False, without=False) is every
    without = ServoKind().with_sensors(every, simulated=False, without=True).pump
    assert without is not None
    assert without.sensor is None


def test_a_slow_adapter_is_reported_before_anything_moves(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from viscodesign.pump.sessions.connection import BoardAddress

    monkeypatch.setattr(BoardAddress, "hints", ["/dev/x latency timer is 16 ms"])
    told = call("pump", "stream", SPEC, *SHORT, "-o", tmp_path / "run")
    assert told.status == 2
    assert "/dev/x latency timer is 16 ms" in told.err


# -- slow links -----------------------------------------------------------------------------


def slow_link(monkeypatch: pytest.MonkeyPatch, seconds: float) -> None:
    measured = RoundTrip(seconds, seconds)
    monkeypatch.setattr(link_rate, "measure_round_trip", lambda read, clock: measured)


def test_a_slow_link_lowers_the_rate_with_a_notice(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    slow_link(monkeypatch, 0.04)
    told = call("pump", "stream", SPEC, *SHORT, "--yes", "-o", tmp_path / "run")
    assert told.status == 0, told.err
    assert "rate lowered from 30 to 20 Hz" in told.err
    assert "s at 20 Hz" in told.err
    beside = json.loads((tmp_path / "run" / "record.json").read_text())
    assert beside["ticks"]["rate_hz"] == pytest.approx(20.0)


def test_a_link_that_is_too_slow_is_refused_before_anything_moves(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    slow_link(monkeypatch, 0.1)
    told = call("pump", "stream", SPEC, *SHORT, "--yes", "-o", tmp_path / "run")
    assert told.status == 4
    assert "reading the pump once takes 100 ms" in told.err
    assert f"every byte of this attempt is in {tmp_path / 'run' / 'log.jsonl'}" in told.err
    assert [file.name for file in (tmp_path / "run").iterdir()] == ["log.jsonl"]


def test_a_supply_that_harms_the_servo_is_refused_even_where_less_is_accepted(
    call: Call, tmp_path: Path
) -> None:
    words = ["--set", "pump.supply_voltage=25.6 V", "--achievable", "--yes"]
    told = call("pump", "stream", SPEC, *SHORT, *words, "-o", tmp_path / "run")
    assert told.status == 4
    assert "AX-18A is made for 9 to 12 V" in told.err
    assert not (tmp_path / "run").exists()
