"""A whole rehearsal: streamed on a simulated AX-18A through the actuator's own model.

The servo has a dead band, a compliance and a motor; the line has its latency; the sensor eight
bits. What is recorded agrees with the plan within what both state.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pytest

from tests.scenes import CONFIGS
from viscodesign import load
from viscodesign.interrupt import StopRequest
from viscodesign.pump.ax.servo_pump import ServoPump
from viscodesign.pump.boards.arbotix_ros import Simulated
from viscodesign.pump.bus.clock import SteppedClock
from viscodesign.pump.kinds.servo import ServoKind
from viscodesign.pump.planning.plan import plan
from viscodesign.pump.planning.result import PumpPlan
from viscodesign.pump.planning.simulated_actuator import ActuatorPlant
from viscodesign.pump.play.stream import Stream
from viscodesign.pump.play.stream_result import StreamResult, TickReport
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.pump.sensors.pressure_sensors import board_sensor
from viscodesign.pump.simulated.device import DirectLine

RATE = 30.0
SENSOR_STEP = 1.0 / 256 / 0.002421 * 1e3
"""Resolution of the eight-bit sensor [Pa]: a reading is accurate to half of it."""


class Rehearsal(NamedTuple):
    plan: PumpPlan
    ending: StreamResult
    skipped: int
    time: np.ndarray
    """(T,) [s], from the scene's start on."""
    counts: np.ndarray
    pressure: np.ndarray
    """(T,) as the sensor reads it, gauge [Pa]."""
    tip: np.ndarray
    """(T, 2) [m]."""


@pytest.fixture(scope="module")
def rehearsal() -> Rehearsal:
    scene = load(CONFIGS / "leg_16_pump.yaml")
    assert scene.pump is not None
    planned = plan(scene)
    clock, plant = SteppedClock(), ActuatorPlant(scene)
    ambient = scene.ambient_pressure
    line = DirectLine(ServoKind().simulated_device(scene.pump, 1, plant, ambient), clock)
    board = Simulated(line, planned.axes)
    gauges = PressureReadings([board_sensor(board, 0)], ambient)
    pump = ServoPump(board, scene.pump, planned.axes, gauges, clock)
    rows: list[tuple[float, ...]] = []

    def see(shown: TickReport) -> None:
        pressure = shown.sample.pressure[0]
        assert pressure is not None
        position = shown.sample.axes[planned.axes[0]].position
        rows.append((shown.time, position, pressure, *plant.tip[:2]))

    course = planned.achievable
    pump.connect()
    gauges.zero()
    stream = Stream(
        pump, planned.profile(course), StopRequest(), see, rate=RATE, lead=course.lead_s
    )
    ending = stream.play()
    table = np.array([row for row in rows if row[0] >= 0.0])
    time, counts, pressure = table[:, 0], table[:, 1], table[:, 2]
    return Rehearsal(planned, ending, stream.ticks.skipped, time, counts, pressure, table[:, 3:5])


def test_a_feasible_plan_is_followed_within_a_count(rehearsal: Rehearsal) -> None:
    found = rehearsal.plan
    assert found.status == "complete"
    assert found.is_feasible
    assert not found.clipped
    assert all(v.severity == "ok" for v in found.verdicts)
    assert np.max(np.abs(found.achievable.steps - found.wanted.steps)) <= 0.5 + 1e-6
    assert found.error_m is not None
    one_count = 1e3 * found.numbers["inlet"]["kpa_per_count_fast"]
    pressure = found.achievable.pressure - found.wanted.pressure
    run = found.wanted.time >= found.wanted.lead_s
    assert np.max(np.abs(pressure[run])) <= one_count
    assert found.wanted.columns["plunger_m"][0, 0] == pytest.approx(0.0, abs=1e-5)
    profile = found.profile(found.achievable)
    assert profile.steps.shape == (len(profile.time), 1)
    assert profile.time[0] == 0.0
    assert np.all(np.diff(profile.time) > 0.0)


def test_the_profile_is_played_to_its_end(rehearsal: Rehearsal) -> None:
    assert rehearsal.ending.status == "complete"
    assert rehearsal.ending.verified
    assert rehearsal.skipped == 0
    assert rehearsal.time[-1] == pytest.approx(8.0, abs=1.5 / RATE)


def test_the_tip_follows_the_planned_path_within_the_requested_accuracy(
    rehearsal: Rehearsal,
) -> None:
    run = rehearsal.plan.achievable_run
    stated = run.accuracy.requested_m
    assert stated == pytest.approx(0.005 * 0.109)
    path = run.tip[:, :2]
    away = np.array([_distance(point, path) for point in rehearsal.tip])
    assert away.max() < stated  # 0.17 mm were found, of 0.55 mm
    assert np.ptp(rehearsal.tip[:, 0]) > 0.06  # and the path is long


def test_the_tip_is_on_time_within_a_tick(rehearsal: Rehearsal) -> None:
    run = rehearsal.plan.achievable_run
    when = rehearsal.time[:, None] + np.linspace(-1.0, 1.0, 21) / RATE
    moved = [np.interp(when, run.time, run.tip[:, k]) - rehearsal.tip[:, k, None] for k in range(2)]
    assert np.hypot(*moved).min(axis=1).max() < run.accuracy.requested_m
    at_once = [
        np.interp(rehearsal.time, run.time, run.tip[:, k]) - rehearsal.tip[:, k] for k in range(2)
    ]
    rms = float(np.sqrt(np.mean(np.square(at_once).sum(axis=0))))
    assert rms < run.accuracy.requested_m  # 0.16 mm were found


def test_the_sensor_reads_the_planned_pressure_within_its_steps_and_a_tick(
    rehearsal: Rehearsal,
) -> None:
    run = rehearsal.plan.achievable_run
    (planned,) = run.inlet_pressure.values()
    when = rehearsal.time[:, None] + np.linspace(-1.0, 1.0, 21) / RATE
    apart = np.abs(np.interp(when, run.time, planned) - rehearsal.pressure[:, None]).min(axis=1)
    assert apart.max() < SENSOR_STEP / 2 + 250.0  # 250 Pa: what the zeroing itself rounds off
    at_once = np.interp(rehearsal.time, run.time, planned) - rehearsal.pressure
    assert float(np.sqrt(np.mean(at_once**2))) < SENSOR_STEP / 2


def test_the_plunger_follows_the_plan(rehearsal: Rehearsal) -> None:
    course = rehearsal.plan.achievable
    wanted = np.interp(rehearsal.time, course.time - course.lead_s, course.steps[:, 0])
    apart = rehearsal.counts - wanted
    # The servo's controller alone would lag by up to 27 counts.
    assert float(np.sqrt(np.mean(apart**2))) < 3.0
    assert np.abs(apart).max() < 10.0


def _distance(point: np.ndarray, path: np.ndarray) -> float:
    """From a point to a broken line [m]."""
    start, way = path[:-1], np.diff(path, axis=0)
    length = np.maximum((way**2).sum(axis=1), 1e-30)
    share = np.clip(((point - start) * way).sum(axis=1) / length, 0.0, 1.0)
    return float(np.hypot(*(start + share[:, None] * way - point).T).min())
