"""Every safety rule of a streamed pump, provoked on the virtual device at many moments.

Whatever happens, at whatever request: no EEPROM cell is written, no speed register is 0, no goal
lies farther than one tick's travel, the last thing that each servo is told is to stand where it
is (or it is said that this could not be done), and then nothing moves any more.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from tests.pump_rig import RATE, TRAVEL, Rig, Sent
from viscodesign.errors import PumpError
from viscodesign.pump.ax.hold import HOLD_SPEED
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.protocol.packets import ErrorBits, Instruction
from viscodesign.pump.ax.servo_pump import APPROACH_SPEED
from viscodesign.pump.ax.torque_limit import NOTABLE, torque_limit
from viscodesign.pump.play.path import led_in
from viscodesign.pump.play.safety_rules import LOST
from viscodesign.pump.play.stream import SECOND_REQUEST_TIME, Stream
from viscodesign.pump.profile import Profile
from viscodesign.pump.sensors.pressure_sensors import SensorError
from viscodesign.pump.simulated.device import UnpluggedError

REQUESTS = 150
"""Of the rig's stream, connecting and arming not counted, roughly: see the first test."""
SAG = 15
"""Counts that a held plunger gives under pressure: its servo needs an error to push."""


def promises(rig: Rig, *, hold: bool = True) -> None:
    """What holds for every stream, whatever happened to it."""
    for sent in rig.tap.sent:
        assert sent.packet.code not in (
            Instruction.RESET,
            Instruction.REG_WRITE,
            Instruction.ACTION,
        )
        assert all(start >= registers.RAM for _, start, _ in sent.writes()), "EEPROM"
        assert 0 not in sent.register(registers.MOVING_SPEED).values(), "full speed"
    _steps_are_small(rig)
    before = rig.positions()
    if hold:
        _ends_in_a_hold(rig)
    rig.wait(5.0)
    moved = np.abs(np.subtract(rig.positions(), before)).max()
    assert moved <= (SAG if hold else rig.pump.reach + SAG), "moved after its end"


def _steps_are_small(rig: Rig) -> None:
    """Each goal within one tick's travel of the last one, or where the servo is."""
    last: dict[int, int] = {}
    for sent in rig.tap.sent:
        for servo, goal in sent.register(registers.GOAL_POSITION).items():
            step = abs(goal - last.get(servo, goal))
            assert abs(goal - sent.positions[servo]) <= rig.pump.reach + SAG
            assert step <= max(rig.pump.reach, SAG), f"goal {goal} from {last} at {sent}"
            assert TRAVEL[0] <= goal <= TRAVEL[1]
            last[servo] = goal


def _ends_in_a_hold(rig: Rig) -> None:
    """The last goal of every servo is where it was then, at the speed of a hold."""
    for servo in rig.ids:
        goals = [s for s in rig.tap.sent if servo in s.register(registers.GOAL_POSITION)]
        if not goals:
            assert not rig.pump.armed
            continue
        last = goals[-1]
        goal = last.register(registers.GOAL_POSITION)[servo]
        assert abs(goal - last.positions[servo]) <= SAG
        assert last.register(registers.MOVING_SPEED).get(servo, HOLD_SPEED) == HOLD_SPEED
        # What comes behind it are reads, or holds of other servos.
        behind = rig.tap.sent[rig.tap.sent.index(last) + 1 :]
        assert all(s.packet.code != Instruction.WRITE for s in behind)


def streamed(rig: Rig, happen: Callable[[int], None]) -> int:
    """Arm, then stream with something happening at each request, counted from there on."""
    rig.begin()
    before = len(rig.tap.sent)
    rig.tap.happen = lambda number: happen(number - before)
    return before


def test_a_stream_that_nothing_happens_to() -> None:
    rig = Rig((1, 2))
    before = streamed(rig, lambda number: None)
    ending = rig.play_armed()
    assert ending.status == "complete"
    assert ending.verified
    assert len(rig.tap.sent) - before > REQUESTS
    assert rig.stream is not None
    assert rig.stream.ticks.skipped == 0
    promises(rig)
    swing = [row.sample.axes[1].position for row in rig.rows if row.time >= 0]
    assert max(swing) - min(swing) > 70


def test_two_servos_go_in_one_packet() -> None:
    rig = Rig((1, 2))
    rig.play()
    end = rig.rows[-1].sample.time + 0.5 / RATE  # what settles behind it is not recorded
    moves = [s for s in rig.tap.sent if s.packet.code == Instruction.SYNC_WRITE and s.time < end]
    ticks = [s for s in moves if len(s.register(registers.GOAL_POSITION)) == 2]
    assert len(ticks) == len(rig.rows)


MOMENTS = range(1, 120, 4)


@pytest.mark.parametrize("ids", [(1,), (1, 2)])
def test_a_pulled_cable_is_told_and_no_hold_is_claimed(ids: tuple[int, ...]) -> None:
    for moment in range(1, 100, 3):
        rig = Rig(ids)

        def gone(data: bytes, now: float) -> None:
            raise UnpluggedError

        def happen(number: int, rig: Rig = rig, moment: int = moment) -> None:
            if number == moment:
                rig.adapter.feed = gone  # type: ignore[method-assign]

        streamed(rig, happen)
        ending = rig.play_armed()
        assert (ending.status, ending.rule) == ("stopped", "replies")
        assert "gone" in ending.reason
        assert not ending.verified
        assert all("no hold could be sent" in str(one) for one in ending.standing)
        # Nobody can tell the servo anything: it ends its tick, and stands by itself.
        promises(rig, hold=False)


@pytest.mark.parametrize("on_stop", ["hold", "release", "retract"])
def test_a_servo_that_falls_silent(on_stop: str) -> None:
    for moment in MOMENTS:
        rig = Rig((1, 2), on_stop=on_stop)  # type: ignore[arg-type]
        silent = [False]
        answer = rig.bench.answer

        def happen(number: int, moment: int = moment, silent: list[bool] = silent) -> None:
            silent[0] = silent[0] or number == moment

        def quiet(packet, now, answer=answer, silent=silent):  # type: ignore[no-untyped-def]
            return None if silent[0] and packet.id == 2 else answer(packet, now)

        rig.bench.answer = quiet  # type: ignore[method-assign]
        before = streamed(rig, happen)
        ending = rig.play_armed()
        assert (ending.status, ending.rule) == ("stopped", "replies")
        by_servo = {one.axis: one for one in ending.standing}
        assert _silence_until_hold(rig, before, moment) < 0.25 + 1.5 / RATE
        assert by_servo[1].verified  # the other one is held all the same
        assert not by_servo[2].verified
        if on_stop != "release":
            assert "unseen" in by_servo[2].words
            promises(rig)


def _silence_until_hold(rig: Rig, before: int, moment: int) -> float:
    """From the first request that servo 2 leaves unanswered to the hold of servo 1 [s]."""
    sent = rig.tap.sent[before:]
    asked = next(s.time for s in sent[moment - 1 :] if s.packet.id == 2)
    return next(
        s.time - asked
        for s in sent
        if s.time > asked and list(s.register(registers.GOAL_POSITION)) == [1]
    )


def test_one_lost_or_broken_reply_is_asked_again_and_nothing_stops() -> None:
    for broken in (lambda data: b"", lambda data: data[:-1] + bytes([data[-1] ^ 1])):
        for moment in MOMENTS:
            rig = Rig()
            streamed(rig, _change_one(rig, moment, broken))
            ending = rig.play_armed()
            assert ending.status == "complete", (moment, ending)
            promises(rig)


def _change_one(rig: Rig, moment: int, change: Callable[[bytes], bytes]) -> Callable[[int], None]:
    """Change what comes after one request, and after no other."""

    def happen(number: int) -> None:
        rig.tap.change = (
            (lambda data: change(data) if data else data) if number == moment else _as_is
        )

    return happen


def _as_is(data: bytes) -> bytes:
    return data


def test_nothing_but_noise_stops_the_pump() -> None:
    for moment in MOMENTS:
        rig = Rig()

        def happen(number: int, rig: Rig = rig, moment: int = moment) -> None:
            if number >= moment:
                rig.tap.change = lambda data: bytes(b ^ 0x15 for b in data)

        streamed(rig, happen)
        ending = rig.play_armed()
        assert (ending.status, ending.rule) == ("stopped", "replies")
        assert not ending.verified  # commands do arrive, but nothing says so
        promises(rig)


def at(moment: int, do: Callable[[], None]) -> Callable[[int], None]:
    """Do something once, at a request."""

    def happen(number: int) -> None:
        if number == moment:
            do()

    return happen


@pytest.mark.parametrize(
    ("rule", "trouble"),
    [
        ("pressure_cap", lambda rig: rig.press(26e3)),
        ("servo_alarm", lambda rig: rig.bench.servos[0].alarm(ErrorBits.OVERHEAT)),
        ("servo_alarm", lambda rig: rig.bench.supply(5.9)),
        ("low_battery", lambda rig: rig.bench.supply(9.8)),
        ("temperature", lambda rig: setattr(rig.bench.servos[0], "temperature", 74.0)),
        ("limit_switch", lambda rig: rig.pins.update(D2=True)),
        ("travel", lambda rig: setattr(rig.bench.servos[0], "position", 1010.0)),
        ("silence", lambda rig: rig.clock.sleep(0.4)),
    ],
)
def test_what_a_tick_reads_stops_the_pump(rule: str, trouble: Callable[[Rig], None]) -> None:
    switches = {"low": "D1", "high": "D2"}
    for moment in range(3, 90, 2):
        rig = Rig(settings={"limit_switches": switches}, pins={"D1": False, "D2": False})
        streamed(rig, at(moment, lambda rig=rig: trouble(rig)))  # type: ignore[misc]
        ending = rig.play_armed()
        assert (ending.status, ending.rule) == ("stopped", rule), (moment, ending)
        assert rig.pump.alarm is not None
        with pytest.raises(PumpError, match="locked by an alarm"):
            rig.pump.set_goals({1: rig.pump.goals[1] + 1}, {1: 10.0})
        if rule != "travel":  # there the plunger slipped: no goal is near it
            promises(rig, hold="shut itself off" not in str(ending.standing))


SWITCHES = {
    "left": {"low": "D1", "high": "D2"},
    "right": {"low": "D3", "high": "D4"},
}


@pytest.mark.parametrize("inlet", [0, 1])
@pytest.mark.parametrize(
    ("rule", "trouble"),
    [
        ("pressure_cap", lambda rig, inlet: rig.press(26e3, inlet)),
        ("limit_switch", lambda rig, inlet: rig.pins.update({f"D{2 + 2 * inlet}": True})),
    ],
)
def test_each_inlet_is_watched(rule: str, trouble: Callable[[Rig, int], None], inlet: int) -> None:
    for moment in range(3, 90, 5):
        pins = dict.fromkeys(("D1", "D2", "D3", "D4"), False)
        rig = Rig((1, 2), settings={"limit_switches": SWITCHES}, pins=pins)
        streamed(rig, at(moment, lambda rig=rig: trouble(rig, inlet)))  # type: ignore[misc]
        ending = rig.play_armed()
        assert (ending.status, ending.rule) == ("stopped", rule), (moment, ending)
        assert f"servo {rig.ids[inlet]}" in ending.reason
        promises(rig)


def test_an_overload_is_reported_and_the_torque_limit_is_not_restored() -> None:
    for moment in MOMENTS:
        rig = Rig()
        struck: list[int] = []

        def overload(number: int, rig: Rig = rig, moment: int = moment, struck=struck) -> None:  # type: ignore[no-untyped-def]
            if number >= moment and not struck and not sets_torque(rig):
                rig.bench.servos[0].alarm(ErrorBits.OVERLOAD)
                struck.append(len(rig.tap.sent))

        streamed(rig, overload)
        ending = rig.play_armed()
        assert (ending.status, ending.rule) == ("stopped", "servo_alarm")
        assert "overload" in ending.reason
        assert "shut itself off" in ending.standing[0].words
        sent = rig.tap.sent[struck[0] :]
        assert not any(s.register(registers.TORQUE_LIMIT) for s in sent)
        promises(rig, hold=False)


def sets_torque(rig: Rig) -> bool:
    """Whether what is about to be sent brings a torque limit along.

    An overload that strikes in just these milliseconds is one out of the blue: a servo shuts
    itself off after it has strained for long, and such a one is sent none (`test_pump_torque`).
    """
    return rig.tap.coming is not None and bool(rig.tap.coming.register(registers.TORQUE_LIMIT))


def test_a_servo_that_restarted_is_not_driven_on() -> None:
    for moment in MOMENTS:
        rig = Rig()

        def dip(rig: Rig = rig) -> None:
            rig.bench.supply(3.0)
            rig.bench.supply(11.1)

        streamed(rig, at(moment, dip))
        ending = rig.play_armed()
        assert ending.status == "stopped", moment
        assert ending.rule in ("command_lost", "following")
        promises(rig, hold=False)


def test_commands_that_are_lost_on_their_way() -> None:
    for moment in MOMENTS:
        rig = Rig()
        feed = rig.adapter.feed
        lose = [False]

        def partly(data: bytes, now: float, feed=feed, lose=lose) -> None:  # type: ignore[no-untyped-def]
            if not (lose[0] and data[4] == Instruction.SYNC_WRITE):
                feed(data, now)

        rig.adapter.feed = partly  # type: ignore[method-assign]
        streamed(rig, at(moment, lambda lose=lose: lose.__setitem__(0, True)))
        ending = rig.play_armed()
        assert (ending.status, ending.rule) == ("stopped", "command_lost"), (moment, ending)
        assert f"{LOST} times" in ending.reason


def test_a_plunger_that_cannot_follow() -> None:
    for moment in MOMENTS:
        rig = Rig(reading=lambda pressure: 2e3)  # so that the cap does not act first
        streamed(rig, at(moment, lambda rig=rig: rig.press(99e3)))
        limit = torque_limit(rig.spec, rig.profile().top_speed) + NOTABLE
        ending = rig.play_armed()
        assert ending.status == "stopped"
        assert ending.rule in ("following", "travel", "servo_alarm"), ending
        # The torque limit lets it be pressed back: that is what it is for.
        assert abs(rig.bench.servos[0].output) <= limit / 1023


@pytest.mark.parametrize("reading", [math.nan])
def test_a_sensor_that_gives_no_number(reading: float) -> None:
    for moment in MOMENTS:
        rig = Rig()
        streamed(rig, at(moment, lambda rig=rig: setattr(rig, "reading", lambda p: reading)))
        ending = rig.play_armed()
        assert (ending.status, ending.rule) == ("stopped", "pressure_cap")
        promises(rig)


def test_a_sensor_that_raises_stops_the_pump() -> None:
    def broken(pressure: float) -> float:
        raise SensorError("sensor open or shorted")

    for moment in MOMENTS:
        rig = Rig()
        streamed(rig, at(moment, lambda rig=rig: setattr(rig, "reading", broken)))
        ending = rig.play_armed()
        assert (ending.status, ending.rule) == ("stopped", "sensor")
        assert "sensor open or shorted" in ending.reason
        promises(rig)


@pytest.mark.parametrize("on_stop", ["hold", "release", "retract"])
def test_a_wish_to_stop_is_obeyed_within_a_tick(on_stop: str) -> None:
    for moment in MOMENTS:
        rig = Rig((1, 2), on_stop=on_stop)  # type: ignore[arg-type]
        before = streamed(rig, at(moment, lambda rig=rig: rig.request.note(2, None)))
        ending = rig.play_armed()
        assert (ending.status, ending.verified) == ("interrupted", True)
        assert "SIGINT" in ending.reason
        _hold_comes_soon(rig.tap.sent[before:], moment)
        if on_stop == "release":
            assert not any(s.get(registers.TORQUE_ENABLE) for s in rig.bench.servos)
        else:
            promises(rig)
        if on_stop == "retract":
            assert max(abs(p - 200) for p in rig.positions()) <= SAG


def _hold_comes_soon(sent: list[Sent], moment: int) -> None:
    """From the wish to the first hold: what is left of one tick, and within 100 ms."""
    holds = [
        k
        for k, one in enumerate(sent)
        if HOLD_SPEED in one.register(registers.MOVING_SPEED).values()
        and len(one.register(registers.GOAL_POSITION)) == 1
        and k >= moment - 1
    ]
    assert holds[0] - moment <= 5
    assert sent[holds[0]].time - sent[moment - 1].time < 0.05


class Opposed(Rig):
    """One plunger goes in while the other one is drawn out beyond home."""

    def profile(self) -> Profile:
        both = super().profile()
        swing = both.steps[:, 0] - both.steps[0, 0]
        signs = [(-1) ** k for k in range(len(self.ids))]
        counts = 200.0 + np.stack([sign * swing for sign in signs], axis=1)
        return replace(both, steps=counts)


@pytest.mark.parametrize("ids", [(1,), (1, 2)])
def test_after_overpressure_no_plunger_moves_inwards(ids: tuple[int, ...]) -> None:
    for moment in range(20, 80, 7):
        rig = Opposed(ids, on_stop="retract")
        streamed(rig, at(moment, lambda rig=rig: rig.press(26e3, 0)))  # type: ignore[misc]
        ending = rig.play_armed()
        assert (ending.rule, ending.retreat, ending.verified) == ("pressure_cap", "", True), moment
        stopped = next(row.sample for row in rig.rows if row.stop is not None)
        for servo, position in zip(ids, rig.positions(), strict=True):
            # Back to home, or where it was beyond; further in it never goes.
            assert position <= min(stopped.axes[servo].position + SAG, 200) + 1
        promises(rig)


def test_a_second_wish_drops_the_torque() -> None:
    for moment in MOMENTS:
        rig = Rig()

        def twice(rig: Rig = rig) -> None:
            rig.request.note(2, None)
            rig.request.note(2, None)

        streamed(rig, at(moment, twice))
        ending = rig.play_armed()
        assert ending.status == "interrupted"
        assert "torque is off, verified" in ending.standing[0].words
        assert not rig.bench.servos[0].get(registers.TORQUE_ENABLE)


def test_a_second_wish_drops_the_torque_though_nobody_could_be_told_of_it() -> None:
    rig = Rig()

    def broken(text: str) -> None:
        rig.request.note(2, None)
        raise RuntimeError("the window is closed")

    streamed(rig, at(40, lambda: rig.request.note(2, None)))
    stream = Stream(rig.pump, rig.profile(), rig.request, rig.see, rate=RATE, tell=broken)
    with pytest.raises(RuntimeError, match="window"):
        stream.play()
    assert "torque is off, verified" in stream.result.standing[0].words
    assert not rig.bench.servos[0].get(registers.TORQUE_ENABLE)


def test_a_second_wish_is_waited_for_though_nobody_could_be_told_of_it() -> None:
    rig = Rig()

    def broken(text: str) -> None:
        raise RuntimeError("the window is closed")

    streamed(rig, at(40, lambda: rig.request.note(2, None)))
    stream = Stream(rig.pump, rig.profile(), rig.request, rig.see, rate=RATE, tell=broken)
    with pytest.raises(RuntimeError, match="window"):
        stream.play()
    assert stream.result.verified
    assert rig.clock.now() - rig.rows[-1].sample.time > SECOND_REQUEST_TIME


@pytest.mark.parametrize("error", [RuntimeError("a bug"), KeyboardInterrupt(), OSError("disk")])
def test_an_exception_anywhere_in_the_loop_ends_in_a_hold(error: BaseException) -> None:
    for tick in range(1, 60, 3):
        rig = Rig((1, 2))

        def see(shown: object, rig: Rig = rig, tick: int = tick) -> None:
            rig.rows.append(shown)  # type: ignore[arg-type]
            if len(rig.rows) == tick:
                raise error

        rig.see = see
        rig.begin()
        with pytest.raises(type(error)):
            rig.play_armed()
        assert rig.stream is not None
        assert rig.stream.result.verified
        assert rig.stream.result.rule == "exception"
        promises(rig)


@pytest.mark.parametrize("stall", [0.05, 0.1, 0.2])
def test_late_ticks_are_skipped_and_not_made_up_for_in_a_burst(stall: float) -> None:
    for moment in range(1, 100, 3):
        rig = Rig()
        streamed(rig, at(moment, lambda rig=rig: rig.clock.sleep(stall)))
        ending = rig.play_armed()
        assert ending.status == "complete", (moment, ending)
        assert rig.stream is not None
        assert rig.stream.ticks.skipped >= int(stall * RATE) - 1
        duration = led_in(rig.profile(), {1: 200}, APPROACH_SPEED).duration
        moves = [
            s
            for s in rig.tap.sent
            if s.register(registers.GOAL_POSITION) and s.time <= rig.stream.ticks.start + duration
        ]
        assert len(moves) - 1 <= int(duration * RATE) + 1 - rig.stream.ticks.skipped
        promises(rig)


def test_arming_moves_nothing_and_limits_come_first() -> None:
    rig = Rig()
    rig.begin()
    assert rig.positions() == [200.0]
    order = [
        name
        for sent in rig.tap.sent
        for name in ("TORQUE_LIMIT", "MOVING_SPEED", "GOAL_POSITION", "TORQUE_ENABLE")
        if sent.register(getattr(registers, name))
    ]
    assert order == ["TORQUE_LIMIT", "MOVING_SPEED", "GOAL_POSITION", "TORQUE_ENABLE"]
    assert 0 < rig.bench.servos[0].get(registers.TORQUE_LIMIT) < 400


def test_connecting_writes_nothing_at_all() -> None:
    rig = Rig((1, 2))
    rig.pump.connect()
    assert all(s.packet.code in (Instruction.READ, Instruction.PING) for s in rig.tap.sent)


def test_whatever_fails_while_arming_nothing_moves() -> None:
    troubles: list[Callable[[Rig], None]] = [
        lambda rig: rig.bench.supply(5.9),
        lambda rig: rig.bench.servos[0].alarm(ErrorBits.OVERLOAD),
        lambda rig: setattr(rig.bench, "answer", lambda packet, now: None),
        lambda rig: rig.request.note(2, None),
    ]
    for trouble in troubles:
        for moment in range(1, 12):
            rig = Rig()
            rig.pump.connect()
            before, struck = len(rig.tap.sent), []

            def happen(
                number: int, rig=rig, do=trouble, due=before + moment, struck=struck
            ) -> None:  # type: ignore[no-untyped-def]
                if number >= due and not struck and not sets_torque(rig):
                    do(rig)
                    struck.append(number)

            rig.tap.happen = happen
            ending = rig.play_armed()
            assert struck
            assert ending.status in ("stopped", "interrupted")
            assert len(rig.rows) <= 2
            rig.wait(2.0)
            assert rig.positions() == pytest.approx([200.0], abs=2 * rig.pump.reach)


def test_arming_again_does_not_rewrite_an_equal_torque_limit() -> None:
    """It may have strained against it until now; the write could give back what it let go."""
    rig = Rig()
    rig.begin()
    before = len(rig.tap.sent)
    rig.tap.happen = at(before + 2, lambda: rig.bench.servos[0].alarm(ErrorBits.OVERLOAD))
    with pytest.raises(PumpError, match="overload"):
        rig.pump.arm()
    assert not any(s.register(registers.TORQUE_LIMIT) for s in rig.tap.sent[before:])
