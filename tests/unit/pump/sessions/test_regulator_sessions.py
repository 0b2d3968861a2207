"""Whole sessions with a pressure regulator, through the commands' own functions."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from tests.rig.pty import PtyServer
from tests.scenes import leg
from viscodesign import pump
from viscodesign.pump.bus.clock import WallClock
from viscodesign.pump.simulated.regulator import SimulatedRegulator
from viscodesign.scene.pumps.regulator import HIGHEST_SET_POINT, RegulatorSpec
from viscodesign.scene.scene import Scene


@pytest.fixture(scope="module")
def scene() -> Scene:
    """A slow sine of small pressures on a small leg."""
    return leg(
        "input={kind: sine, amplitude: 2 kPa, mean: 4 kPa, frequency: 0.5 Hz}",
        "run={duration: 2 s, output_interval: 50 ms}",
        "effects={inertia: off, damping: off}",
        config="leg_16_regulator",
    )


def test_a_plan_is_streamed_and_the_record_agrees_with_it(scene: Scene, tmp_path: Path) -> None:
    report = pump.stream(scene, tmp_path, pump.BoardAddress(pace="max"))
    assert report.status == "complete"
    document = report.document()
    assert document["regulators"][0]["verified"]
    # The set-point leads by the response time; what its curvature leaves is w^2 tau^2 of 2 kPa.
    assert document["measured_against_plan"]["rms_pa"] < 600.0
    record = json.loads((tmp_path / "record.json").read_text())
    assert record["columns"][:3] == ["time_s", "tip_x_m", "tip_z_m"]
    assert record["calibration"] == {"home_steps": 0, "travel_steps": [0, 255]}
    log = [json.loads(line) for line in (tmp_path / "log.jsonl").read_text().splitlines()]
    sent = [bytes.fromhex(entry["hex"].replace(" ", "")) for entry in log if entry["kind"] == "tx"]
    assert {data.split()[0] for data in sent} == {b"MON", b"REQ", b"SET"}
    steps = [int(data.split()[1]) for data in sent if data.startswith(b"SET")]
    assert max(steps) * 100e3 / HIGHEST_SET_POINT <= 25e3


def test_a_rehearsal_shows_what_would_be_sent(scene: Scene) -> None:
    found = pump.rehearse(scene, pump.BoardAddress("regulator"))
    assert "SET " in found.text
    assert "played to its end" in found.text


def regulator(pressure: float, set_point: int) -> SimulatedRegulator:
    device = SimulatedRegulator(RegulatorSpec(full_scale=100e3, response_time=0.05))
    device.pressure, device.set_point = pressure, set_point
    return device


@pytest.mark.parametrize(("release", "expected"), [(False, 51), (True, 0)])
def test_a_regulator_is_stopped_without_a_spec(release: bool, expected: int) -> None:
    there = regulator(5e3, 51)
    with PtyServer(there, WallClock()) as served:
        (left,) = pump.stop(pump.BoardAddress("regulator", served.port), release=release)
    assert left.verified
    assert there.set_point == expected


def test_the_status_of_one_above_the_cap_says_what_to_do(scene: Scene) -> None:
    there = regulator(40e3, 409)
    with PtyServer(there, WallClock()) as served:
        found: Any = pump.status(pump.BoardAddress("regulator", served.port), scene)
    assert found.pressure[0] == pytest.approx(40e3, abs=100.0)
    (reason,) = found.objections
    assert "above pump.max_pressure, 25 kPa; vent it with `pump stop --release`" in reason


def test_what_answers_is_recorded_without_a_spec(tmp_path: Path) -> None:
    there = regulator(5e3, 51)
    with PtyServer(there, WallClock()) as served:
        at = pump.BoardAddress("regulator", served.port)
        report = pump.record(tmp_path / "rest.csv", at, rate=10.0, duration=0.15)
    assert report.identity == "a regulator, whose set-point is 51 of 1023"
    head, first, *_ = (tmp_path / "rest.csv").read_text().splitlines()
    assert head == "time_s,inlet_pressure_pa,wanted_pressure_pa,outlet_steps,set_point_steps"
    assert first.split(",")[1:] == ["", "", "51", "51"]
