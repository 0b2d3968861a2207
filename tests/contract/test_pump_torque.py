"""The guard that works when everything else is dead: the torque that each servo is allowed.

It follows the plan tick by tick: a fast stretch does not loosen it for a slow one. And it is
never written to a servo that shut itself off, or may be about to, since that would revive it.
"""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from tests.pump_rig import RATE, Rig
from tests.rig.bus import BusAdapter
from tests.thorough import ALL
from viscodesign.interrupt import StopRequest
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.protocol.packets import ErrorBits
from viscodesign.pump.ax.servo_pump import ServoPump
from viscodesign.pump.ax.torque_limit import NOTABLE, torque_limit
from viscodesign.pump.boards.base import Board
from viscodesign.pump.boards.dynamixel import Dynamixel
from viscodesign.pump.bus.clock import SteppedClock
from viscodesign.pump.kinds.servo import simulated_bench
from viscodesign.pump.play.stream import Stream
from viscodesign.pump.profile import AROUND, Profile
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.pump.simulated.device import DirectLine
from viscodesign.scene.pumps.servo import ServoPumpSpec as Settings

CAP = 25e3
"""Gauge [Pa]."""


class Once(Dynamixel):
    """A board whose moves bring no torque limits: one for all speeds, set before it moves."""

    limits_torque = False


def blocked(kind: type[Board], fast: float, slow: float) -> float:
    """Highest pressure [Pa] in a closed barrel that nothing measures.

    Once in and out at a speed, then in at another [counts/s], on and on.
    """
    spec = Settings.model_validate(
        {"syringe_diameter": 0.0349, "filled_length": 0.06, "dead_volume": 0, "max_pressure": CAP}
    )
    bench, clock = simulated_bench(spec), SteppedClock()
    board = kind(DirectLine(BusAdapter(bench), clock), [1])
    pump = ServoPump(board, spec, [1], PressureReadings([None], 101_325.0), clock)
    time = np.cumsum([0.0, 80 / fast, 80 / fast, 0.5, 600 / slow])
    counts = np.array([[200.0], [280.0], [200.0], [200.0], [800.0]])
    profile = Profile(("inlet",), (1,), time, counts, np.zeros((5, 1)))
    seen = [0.0]
    pump.connect()
    ending = Stream(
        pump, profile, StopRequest(), lambda _: seen.append(float(bench.pressures[0])), rate=RATE
    ).play()
    assert ending.rule in ("following", "servo_alarm")
    return max(seen)


@pytest.mark.parametrize(
    ("fast", "slow", "before", "now"),
    [
        # kPa that were found; the cap in software would be 25.
        (900, 20, 98.4, 31.1),
        (600, 20, 75.4, 31.1),
        (300, 20, 52.3, 31.1),
        (900, 100, 98.3, 37.8),
        (100, 100, 36.4, 37.4),
    ],
)
def test_a_blocked_outlet_gets_no_more_torque_than_the_present_speed_needs(
    fast: float, slow: float, before: float, now: float
) -> None:
    assert blocked(Once, fast, slow) / 1e3 == pytest.approx(before, abs=1.0)
    assert blocked(Dynamixel, fast, slow) / 1e3 == pytest.approx(now, abs=1.0)


class Varied(Rig):
    """Slow, fast, slow, fast: the limits have to change."""

    def profile(self) -> Profile:
        time = np.cumsum([0.0, 3.0, 0.4, 3.0, 0.4])
        counts = np.repeat([[200.0], [240.0], [400.0], [440.0], [600.0]], len(self.ids), axis=1)
        names = tuple(f"inlet{k}" for k in self.ids)
        return Profile(names, tuple(self.ids), time, counts, np.full(counts.shape, 2e3))


@pytest.mark.parametrize("ids", [(1,), (1, 2)])
def test_each_tick_allows_little_more_torque_than_the_plan_needs(ids: tuple[int, ...]) -> None:
    rig = Varied(ids)
    assert rig.play().status == "complete"
    assert rig.stream is not None
    profile = rig.profile()
    speeds = np.diff(profile.steps[:, 0]) / np.diff(profile.time)
    behind = 2.0 / RATE
    for row, follower in pairwise(rig.rows):
        near = (profile.time[1:] > row.time - AROUND + behind) & (
            profile.time[:-1] < row.time + AROUND - behind
        )
        if row.time < 0.0 or not near.any():
            continue
        wide = (profile.time[1:] > row.time - AROUND - behind) & (
            profile.time[:-1] < row.time + AROUND + behind
        )
        for state in follower.sample.axes.values():
            assert state.torque_limit >= torque_limit(rig.spec, speeds[near].max())
            assert state.torque_limit <= torque_limit(rig.spec, speeds[wide].max()) + NOTABLE


def test_limits_are_written_only_where_they_change() -> None:
    rig = Varied((1, 2))
    rig.begin()
    before = len(rig.tap.sent)
    rig.play_armed()
    end = rig.rows[-1].sample.time
    written = [s for s in rig.tap.sent[before:] if s.sets_limit_of() and s.time < end]
    # Slow, as on the way to it; fast; slow; fast. Each a byte at a time, in ticks that follow.
    changes = [[written[0]]]
    for one, other in pairwise(written):
        if other.time - one.time > 1.5 / RATE:
            changes.append([])
        changes[-1].append(other)
    assert len(changes) == 4
    assert all(len(change) <= 2 for change in changes)
    assert all(s.sets_limit_of() == {1, 2} for s in written)
    together = [s for s in written if s.register(registers.TORQUE_LIMIT)]
    assert all(set(s.register(registers.GOAL_POSITION)) == {1, 2} for s in together)


def jammed(rig: Rig, servo: int, moment: float) -> None:
    """From a moment of its stream on a plunger moves no more, whatever its servo gives."""
    stuck = rig.bench.servos[servo]
    start = rig.clock.now()
    free = stuck._limited

    def limited(speed: float, seconds: float) -> float:
        return 0.0 if rig.clock.now() - start >= moment else free(speed, seconds)

    stuck._limited = limited  # type: ignore[method-assign]


@pytest.mark.parametrize("ids", [(1,), (1, 2)])
def test_a_servo_that_shuts_itself_off_is_never_revived(ids: tuple[int, ...]) -> None:
    """It does so at all moments about those at which limits are written."""
    shut = 0
    for moment in np.arange(0.2, 3.6, 0.02 if ALL else 0.06):
        rig = Varied(ids)
        off: list[int] = []

        def happen(number: int, rig: Rig = rig, off: list[int] = off) -> None:
            if rig.bench.servos[0].alarms & ErrorBits.OVERLOAD:
                off.append(number)

        rig.begin()
        jammed(rig, 0, float(moment))
        rig.tap.happen = happen
        ending = rig.play_armed()
        assert ending.rule in ("servo_alarm", "following")
        if not off:
            continue
        shut += 1
        sent = rig.tap.sent[off[0] - 1 :]
        assert not any(1 in s.sets_limit_of() for s in sent)
        assert rig.bench.servos[0].get(registers.TORQUE_LIMIT) == 0
        assert "shut itself off" in ending.standing[0].words
    assert shut > (50 if ALL else 16)


def test_a_saturated_servo_keeps_its_limit_while_that_of_the_other_follows_the_plan() -> None:
    rig = Varied((1, 2))
    rig.begin()
    before = len(rig.tap.sent)
    jammed(rig, 0, 2.0)
    rig.bench.servos[0].set(registers.SHUTDOWN, 0)  # so that it strains on
    rig.play_armed()
    sent = rig.tap.sent[before:]
    written = [s.sets_limit_of() for s in sent]
    apart = written.index({2})
    assert 1 in sent[apart - 1].register(registers.GOAL_POSITION)  # in another packet
    assert not any(1 in limits for limits in written[apart:])
