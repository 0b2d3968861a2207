"""What a stream does about trouble that is not its axes' fault, judged by the packets on the wire.

It catches up or ends by name when it is late, leaves no plunger above the pressure cap, revives
no servo that shut itself off, and hears a second stop request at any time.
"""

from __future__ import annotations

import numpy as np
import pytest

from tests.pump_rig import RATE, TRAVEL, Rig
from tests.rig.bus import BusAdapter
from viscodesign.interrupt import StopRequest
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.protocol.packets import ErrorBits
from viscodesign.pump.ax.servo_pump import ServoPump
from viscodesign.pump.ax.torque_limit import NOTABLE, torque_limit
from viscodesign.pump.boards.dynamixel import Dynamixel
from viscodesign.pump.bus.clock import SteppedClock
from viscodesign.pump.kinds.servo import simulated_bench
from viscodesign.pump.play.stream import Stream
from viscodesign.pump.play.stream_result import RecordingError, StreamResult
from viscodesign.pump.profile import Profile
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.pump.simulated.device import DirectLine
from viscodesign.scene.pumps.servo import ServoPumpSpec


class Ramp(Rig):
    """In at a steady speed, as fast at its end as at its start."""

    speed = 150.0

    def profile(self) -> Profile:
        time = np.array([0.0, 2.0])
        counts = np.array([[200.0], [200.0 + 2.0 * self.speed]])
        return Profile(("inlet",), (1,), time, counts, np.full((2, 1), 2e3))


def stalled(rig: Rig, moments: dict[int, float]) -> None:
    """The host sleeps before some of its requests [s]."""
    before = len(rig.tap.sent)
    rig.tap.happen = lambda number: rig.clock.sleep(moments.get(number - before, 0.0))


@pytest.mark.parametrize("stall", [0.05, 0.1, 0.2])
def test_a_late_tick_catches_up_even_on_a_steady_ramp(stall: float) -> None:
    for moment in (11, 20, 33):
        rig = Ramp()
        rig.begin()
        stalled(rig, {moment: stall})
        result = rig.play_armed()
        assert result.status == "complete"
        late = [row for row in rig.rows if row.time > 1.5 and row.time < 1.95]
        wanted = [200.0 + Ramp.speed * row.time for row in late]
        positions = [row.sample.axes[1].position for row in late]
        assert np.abs(np.subtract(positions, wanted)).max() < 2.5


def test_a_stream_that_cannot_keep_up_ends_by_name() -> None:
    rig = Ramp()
    rig.begin()
    before = len(rig.tap.sent)
    # Every tick takes three and a half of its periods: too long for what catching up may take.
    rig.tap.happen = lambda number: rig.clock.sleep(3.5 / RATE if number % 2 == 0 else 0.0)
    result = rig.play_armed()
    assert (result.status, result.rule) == ("stopped", "behind_profile")
    assert "ticks behind" in result.reason
    assert result.verified
    assert len(rig.tap.sent) - before < 100


def test_the_bound_on_lag_is_an_option() -> None:
    rig = Ramp()
    rig.max_lag = 100.0
    rig.begin()
    rig.tap.happen = lambda number: rig.clock.sleep(3.5 / RATE if number % 2 == 0 else 0.0)
    assert rig.play_armed().status == "complete"


@pytest.mark.parametrize("pressure", [2e3, 12e3, 20e3])
@pytest.mark.parametrize("speed", [20.0, 150.0, 350.0])
def test_a_completed_run_ends_within_a_count_of_its_last_target(
    speed: float, pressure: float
) -> None:
    rig = Ramp(pressure=pressure, reading=lambda p: p)
    rig.speed = speed  # type: ignore[misc]
    result = rig.play()
    assert result.status == "complete"
    rig.wait(3.0)
    assert rig.bench.servos[0].position == pytest.approx(200.0 + 2.0 * speed, abs=1.0)


def test_a_run_that_never_gets_to_its_last_target_is_not_complete() -> None:
    rig = Ramp()
    rig.begin()
    servo = rig.bench.servos[0]
    free = servo._limited
    servo._limited = lambda speed, dt: free(speed, dt) if servo.position < 490.0 else 0.0  # type: ignore[method-assign]
    result = rig.play_armed()
    assert result.status == "stopped"
    assert result.rule in ("not_reached", "following", "servo_alarm")


def blocked(speed: float, cap: float, on_stop: str = "hold") -> tuple[StreamResult, float, int]:
    """Against a closed outlet: how it ended, the pressure 5 s later, and the torque limit then."""
    spec = ServoPumpSpec.model_validate(
        {"syringe_diameter": 0.0349, "filled_length": 0.06, "dead_volume": 0, "max_pressure": cap}
    )
    bench, clock = simulated_bench(spec), SteppedClock()
    board = Dynamixel(DirectLine(BusAdapter(bench), clock), [1])
    sensor = PressureReadings([lambda: 101_325.0 + float(bench.pressures[0])], 101_325.0)
    pump = ServoPump(board, spec, [1], sensor, clock)
    time = np.array([0.0, 600.0 / speed])
    profile = Profile(("inlet",), (1,), time, np.array([[200.0], [800.0]]), np.zeros((2, 1)))
    pump.connect()
    result = Stream(
        pump,
        profile,
        StopRequest(),
        lambda report: None,
        rate=RATE,
        on_stop=on_stop,  # type: ignore[arg-type]
    ).play()
    clock.sleep(5.0)
    bench.advance(clock.now())
    limit = bench.servos[0].get(registers.TORQUE_LIMIT)
    assert limit <= torque_limit(spec) + NOTABLE
    return result, float(bench.pressures[0]), limit


@pytest.mark.parametrize("speed", [50.0, 300.0, 900.0])
def test_after_the_pressure_cap_no_plunger_is_held_above_it(speed: float) -> None:
    result, pressure, _ = blocked(speed, 25e3)
    assert (result.status, result.rule, result.retreat) == ("stopped", "pressure_cap", "")
    assert result.verified
    assert 0.0 < pressure <= 25e3  # only as far as it takes


def test_a_retreat_that_is_asked_for_goes_all_the_way() -> None:
    result, pressure, _ = blocked(300.0, 25e3, "retract")
    assert (result.rule, result.retreat) == ("pressure_cap", "")
    assert abs(pressure) < 2e3


def test_pressure_that_no_retreat_lowers_is_told() -> None:
    rig = Rig()
    rig.begin()
    before = len(rig.tap.sent)
    rig.tap.happen = lambda number: rig.press(26e3) if number == before + 60 else None
    result = rig.play_armed()
    assert result.rule == "pressure_cap"
    assert "still above the cap" in result.retreat
    assert result.verified


@pytest.mark.parametrize("stall", [0.2, 0.4])
def test_a_stall_of_the_host_is_never_blamed_on_the_sensor(stall: float) -> None:
    class Steep(Ramp):
        def profile(self) -> Profile:
            time = np.linspace(0.0, 2.0, 41)
            counts = 200.0 + Ramp.speed * time[:, None]
            return Profile(("inlet",), (1,), time, counts, 40e3 * time[:, None] / 2.0)

    rules = set()
    for moment in range(12, 60, 5):
        rig = Steep(settings={"max_pressure": 60e3})
        # The sensor tells what the plunger does, in steps of the board's converter.
        rig.reading = lambda p, rig=rig: (  # type: ignore[misc]
            1600.0 * round((rig.bench.servos[0].position - 200.0) / 300.0 * 40e3 / 1600.0)
        )
        rig.begin()
        stalled(rig, {moment: stall})
        result = rig.play_armed()
        rules.add(result.rule)
    assert rules == ({""} if stall < 0.25 else {"silence"})


class Varied(Rig):
    """Slow, fast, slow, fast: torque limits have to change."""

    def profile(self) -> Profile:
        time = np.cumsum([0.0, 1.0, 0.4, 1.0, 0.4])
        counts = np.array([[200.0], [213.0], [373.0], [386.0], [546.0]])
        return Profile(("inlet",), (1,), time, counts, np.full(counts.shape, 2e3))


def test_a_servo_that_shuts_itself_off_is_never_revived_silently() -> None:
    """At every request of a stream, those that bring torque limits among them."""
    undisturbed = Varied()
    undisturbed.begin()
    before = len(undisturbed.tap.sent)
    undisturbed.play_armed()
    changing = [k for k, sent in enumerate(undisturbed.tap.sent[before:]) if sent.sets_limit_of()]
    assert len(changing) >= 4
    end = undisturbed.rows[-1].sample.time
    ticking = sum(sent.time < end for sent in undisturbed.tap.sent[before:])
    for moment in sorted({*changing, *range(0, 150, 10)}):
        rig = Varied()
        rig.begin()
        first = len(rig.tap.sent)
        servo = rig.bench.servos[0]

        def strike(number: int, rig: Rig = rig, due: int = first + moment + 1) -> None:
            if number == due:
                rig.bench.servos[0].alarm(ErrorBits.OVERLOAD)

        rig.tap.happen = strike
        result = rig.play_armed()
        if moment < ticking:  # what happens after the last tick is told by the final state
            assert (result.status, result.rule) == ("stopped", "servo_alarm"), (moment, result)
        assert "shut itself off" in result.standing[0].words, moment
        assert servo.get(registers.TORQUE_LIMIT) == 0


@pytest.mark.parametrize("later", [0.05, 0.5, 2.0])
def test_a_second_request_drops_the_torque_long_after_the_hold(later: float) -> None:
    rig = Rig()
    rig.begin()
    asked: list[float] = []

    def happen(number: int) -> None:
        if number == 60:
            rig.request.note(2, None)
            asked.append(rig.clock.now())

    sleep = rig.clock.sleep

    def slept(seconds: float) -> None:
        sleep(seconds)
        if asked and rig.clock.now() > asked[0] + later and rig.request.times == 1:
            rig.request.note(2, None)

    rig.tap.happen = happen
    rig.clock.sleep = slept  # type: ignore[method-assign]
    result = rig.play_armed()
    assert result.status == "interrupted"
    assert not rig.bench.servos[0].get(registers.TORQUE_ENABLE)
    assert "torque is off, verified" in result.standing[0].words


def test_a_second_request_interrupts_a_retreat() -> None:
    rig = Rig(on_stop="retract")
    rig.begin()
    before = len(rig.tap.sent)
    rig.tap.happen = lambda number: (
        rig.request.note(2, None) if number in (before + 80, before + 110) else None
    )
    assert rig.play_armed().status == "interrupted"
    assert not rig.bench.servos[0].get(registers.TORQUE_ENABLE)


def test_a_record_that_cannot_be_written_ends_a_stream_with_its_own_reason() -> None:
    for tick in range(1, 60, 7):
        rig = Rig()

        def see(report: object, rig: Rig = rig, tick: int = tick) -> None:
            rig.rows.append(report)  # type: ignore[arg-type]
            if len(rig.rows) == tick:
                raise RecordingError("record.csv: no space left on device")

        rig.see = see
        rig.begin()
        result = rig.play_armed()
        assert (result.status, result.rule, result.verified) == ("stopped", "record", True)
        assert "no space left" in result.reason
        assert TRAVEL[0] <= rig.positions()[0] <= TRAVEL[1]
