"""Sequences on the computed board: loaded, approached, played, halted, and never left unsaid."""

from __future__ import annotations

import numpy as np
import pytest

from tests.pose_rig import PoseRig, swing
from tests.pumps import HOME
from tests.rig import faults
from viscodesign.errors import PumpError
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.poses.engine import FRAME, load_pose
from viscodesign.pump.poses.player import by_servo, playing_speed, split_at


@pytest.mark.parametrize("ids", [(1,), (1, 2)])
def test_the_board_plays_what_the_fit_says(ids: tuple[int, ...]) -> None:
    rig = PoseRig(ids)
    ending = rig.play()
    assert (ending.status, ending.reason) == ("complete", "played to its end")
    assert ending.verified
    # What the firmware sends its servos, frame by frame, is what was measured.
    instants = FRAME * np.arange(rig.fit.frames + 1)
    stated = np.stack([np.interp(instants, rig.fit.time, c) for c in rig.fit.played.T], -1)
    sent = np.array(rig.bench.goals)[-len(instants) :]
    assert sent.tolist() == np.rint(stated).astype(int).tolist()
    wanted = np.stack([rig.wanted.at(t) for t in instants])
    assert np.abs(sent - wanted).max() <= rig.fit.largest_error + 1e-9


def test_a_loop_goes_round_until_it_is_halted() -> None:
    rig = PoseRig(loop=True)
    rig.stop_at = 3.3 * rig.fit.duration
    ending = rig.play()
    assert (ending.status, ending.reason) == ("interrupted", "asked to stop (SIGINT)")
    assert ending.verified
    assert "cannot be interrupted" in rig.told[0]
    goals = np.array(rig.bench.goals)[:, 0]
    frames = rig.fit.frames
    assert goals[5 : 5 + frames].tolist() == goals[5 + frames : 5 + 2 * frames].tolist()
    assert len(goals) < 3.3 * frames + max(rig.fit.move_frames) + 3
    before = [servo.position for servo in rig.bench.servos]
    rig.clock.sleep(5.0)
    rig.line.drain()
    assert [servo.position for servo in rig.bench.servos] == pytest.approx(before, abs=2)


def test_a_halt_that_is_lost_is_sent_again() -> None:
    rig = PoseRig(loop=True)
    rig.begin()
    number = rig.line.device.requests  # type: ignore[attr-defined]
    # SIZE_POSE, a speed and its reading, a greeting, LOOP; then the halt.
    rig.line.device.faults.append(faults.LostRequest(number + 5))  # type: ignore[attr-defined]
    rig.stop_at = 1.0
    ending = rig.player.play()
    assert ending.status == "interrupted"
    assert ending.verified


def test_a_board_that_does_not_listen_is_reported_with_the_power_switch_as_remedy() -> None:
    rig = PoseRig(loop=True)
    rig.begin()
    rig.line.device.faults.append(  # type: ignore[attr-defined]
        faults.LostRequest(rig.line.device.requests + 5, times=10**6)  # type: ignore[attr-defined]
    )
    rig.stop_at = 1.0
    ending = rig.player.play()
    assert not ending.verified
    assert "playing or not responding; switch its power off" in ending.standing[0].words


def test_a_play_whose_answer_is_lost_is_not_sent_again_but_halted() -> None:
    rig = PoseRig(loop=True)
    rig.begin()
    number = rig.line.device.requests  # type: ignore[attr-defined]
    rig.line.device.faults.append(faults.LostReply(number + 4))  # type: ignore[attr-defined]
    ending = rig.player.play()
    assert ending.status == "stopped"
    assert "may have started" in ending.reason
    assert ending.verified
    # Half a second until nobody answers, then the move that it was in.
    assert len(rig.bench.goals) <= 0.6 / FRAME + max(rig.fit.move_frames)


@pytest.mark.parametrize("cut", range(1, 9))
def test_what_is_left_of_half_a_packet_starts_nothing_unseen(cut: int) -> None:
    rig = PoseRig()
    rig.begin()
    rig.line.write(load_pose(0, (300, 0)).encode()[:cut])
    rig.clock.sleep(0.01)
    ending = rig.player.play()
    assert ending.status in ("complete", "stopped")
    # Behind an id the next header is a length of 255, which hangs the firmware for good.
    assert ending.verified is (cut != 3)
    played = len(rig.bench.goals) > 0
    assert played == (ending.status == "complete")


def test_a_second_wish_to_stop_drops_the_torque_once_it_is_halted() -> None:
    rig = PoseRig(loop=True)
    rig.player.see = lambda elapsed: rig.wish.__dict__.update(times=2, first="SIGINT")
    ending = rig.play()
    assert ending.verified
    assert "torque is off" in ending.standing[0].words


def test_a_second_request_drops_the_torque_though_nobody_could_be_told_of_it() -> None:
    rig = PoseRig(loop=True)
    rig.stop_at = 1.0

    def broken(text: str) -> None:
        if "again" in text:
            rig.wish.times = 2
            raise RuntimeError("the window is closed")

    rig.player.tell = broken
    with pytest.raises(RuntimeError, match="window"):
        rig.play()
    assert not rig.bench.servos[0].get(registers.TORQUE_ENABLE)


def test_a_loop_is_halted_though_nobody_could_be_told_of_it() -> None:
    rig = PoseRig(loop=True)
    rig.stop_at = 1.0

    def broken(text: str) -> None:
        raise RuntimeError("the window is closed")

    rig.player.tell = broken
    with pytest.raises(RuntimeError, match="window"):
        rig.play()
    rig.clock.sleep(3.0)
    rig.device.take(rig.clock.now())
    frames = len(rig.bench.goals)
    rig.clock.sleep(3.0)
    rig.device.take(rig.clock.now())
    assert len(rig.bench.goals) == frames


def test_a_second_request_long_after_the_halt_drops_the_torque() -> None:
    rig = PoseRig(loop=True)
    rig.stop_at = 1.0
    sleep = rig.clock.sleep

    def slept(seconds: float) -> None:
        sleep(seconds)
        if "halting" in " ".join(rig.told) and rig.clock.now() > halted[0] + 1.5:
            rig.wish.times = 2

    halted = [np.inf]
    rig.player.tell = lambda text: (rig.told.append(text), halted.insert(0, rig.clock.now()))  # type: ignore[func-returns-value]
    rig.clock.sleep = slept  # type: ignore[method-assign]
    result = rig.play()
    assert result.status == "interrupted"
    assert result.verified
    assert "torque is off" in result.standing[0].words


@pytest.mark.parametrize("kind", [faults.LostReply, faults.CorruptReply, faults.CorruptRequest])
def test_one_fault_anywhere_ends_well_or_is_told(kind: type[faults.Fault]) -> None:
    for request in range(0, 6):
        rig = PoseRig()
        rig.begin()
        rig.line.device.faults.append(  # type: ignore[attr-defined]
            kind(rig.line.device.requests + request)  # type: ignore[attr-defined]
        )
        ending = rig.player.play()
        assert ending.verified, (request, ending)
        assert ending.status == "complete" or ending.reason


def test_a_pulled_cable_claims_no_hold() -> None:
    rig = PoseRig()
    rig.begin()
    rig.line.device.faults.append(  # type: ignore[attr-defined]
        faults.Unplugged(rig.line.device.requests + 2)  # type: ignore[attr-defined]
    )
    ending = rig.player.play()
    assert ending.status == "stopped"
    assert not ending.verified


def test_the_way_to_the_start_is_slow_and_torque_and_speed_are_limited() -> None:
    rig = PoseRig()
    rig.bench.servos[0].position = HOME + 100.0
    rig.pump.connect()
    rig.player.load()
    goals: list[tuple[float, int]] = []
    lead, _ = split_at(rig.wanted, 0.0)
    rig.player.approach(lead, lambda shown: goals.append((shown.time, rig.pump.goals[1])))
    times, counts = np.array(goals).T
    speeds = np.abs(np.diff(counts)) / np.diff(times)
    assert np.max(speeds) < 1.3 * 50
    assert rig.bench.servos[0].position == pytest.approx(HOME, abs=10)
    servo = rig.bench.servos[0]
    assert 0 < servo.get(registers.TORQUE_LIMIT) < 1023
    rig.player.play()
    assert 0 < playing_speed(rig.fit) < 200


def test_a_servo_with_the_phantoms_id_is_refused_before_anything_is_loaded() -> None:
    rig = PoseRig(on_bus=(1, 2))
    rig.pump.connect()
    with pytest.raises(PumpError, match="id 2, which must stay free"):
        rig.player.load()
    assert rig.device.engine.size == 0


def test_ids_have_to_count_from_one() -> None:
    with pytest.raises(PumpError, match="takes poses of the servos 1 to 2 only"):
        by_servo(swing((1, 3)))
    turned = by_servo(swing((2, 1)))
    assert turned.axes == (1, 2)
    assert turned.inlets == ("inlet1", "inlet2")


def test_a_lead_is_divided_from_the_rest() -> None:
    whole = swing()
    lead, rest = split_at(whole, 0.5)
    assert lead.time[-1] == 0.5
    assert rest.time[0] == 0.0
    assert rest.steps[0] == lead.steps[-1] == whole.at(0.5)
    assert rest.duration == pytest.approx(whole.duration - 0.5)
    none, all_of_it = split_at(whole, 0.0)
    assert none.time.tolist() == [0.0]
    assert np.array_equal(all_of_it.steps, whole.steps)


def test_a_plunger_that_did_not_follow_is_told() -> None:
    rig = PoseRig()
    rig.begin()
    servo = rig.bench.servos[0]
    original = servo.advance
    servo.advance = lambda seconds, load: None  # type: ignore[method-assign]
    # Blocked at a place that the profile does not end at.
    servo.position = 290.0
    ending = rig.player.play()
    servo.advance = original  # type: ignore[method-assign]
    assert (ending.status, ending.rule) == ("stopped", "following")
