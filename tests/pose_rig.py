"""An ArbotiX with PyPose on the bench, and all that went over its wire."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from tests.pumps import HOME, bench, pump, stepped
from tests.rig.faults import Fault, Faulty
from viscodesign.interrupt import StopRequest
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.ax.protocol.packets import Instruction, Packet
from viscodesign.pump.ax.servo_pump import ServoPump
from viscodesign.pump.boards.arbotix import Arbotix
from viscodesign.pump.play.stream_result import StreamResult
from viscodesign.pump.poses.fit import PoseFit, fit_poses
from viscodesign.pump.poses.player import PosePlayer, split_at
from viscodesign.pump.profile import Profile
from viscodesign.pump.sensors.pressure_readings import PressureReadings
from viscodesign.pump.simulated.bench import SimulatedBench
from viscodesign.pump.simulated.device import DirectLine
from viscodesign.pump.simulated.pypose import PyPose

TRAVEL = (100, 1000)


def swing(ids: Sequence[int] = (1,), duration: float = 1.98, amplitude: float = 40.0) -> Profile:
    """One cycle about a place beside home."""
    time = np.linspace(0.0, duration, 61)
    counts = HOME + amplitude - amplitude * np.cos(2 * np.pi * time / duration)
    columns = np.stack([counts for _ in ids], -1)
    names = tuple(f"inlet{k}" for k in ids)
    return Profile(names, tuple(ids), time, columns, 0.0 * columns)


class Watched(SimulatedBench):
    """Keeps the goals that all servos were sent at once: one row a frame."""

    def __init__(self, inner: SimulatedBench) -> None:
        self.__dict__ |= inner.__dict__
        self.goals: list[list[int]] = []

    def answer(self, packet: Packet, now: float) -> Any:
        if packet.code == Instruction.SYNC_WRITE:
            given = packet.parameters[2:]
            each = [given[k + 1] + 256 * given[k + 2] for k in range(0, len(given), 3)]
            self.goals.append(each[: len(self.servos)])
        return super().answer(packet, now)


@dataclass
class PoseRig:
    """Connected and loaded by the one who uses it."""

    ids: Sequence[int] = (1,)
    loop: bool = False
    on_bus: Sequence[int] | None = None
    """Servos that are there; those of the profile if nothing is said."""
    trouble: Sequence[Fault] = ()
    profile: Profile | None = None
    told: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.clock = stepped()
        self.bench = Watched(bench(*(self.on_bus or self.ids)))
        for servo in self.bench.servos:
            servo.supply(11.1)
            servo.set(registers.CW_LIMIT, TRAVEL[0])
            servo.set(registers.CCW_LIMIT, TRAVEL[1])
        self.device = PyPose(self.bench)
        self.line = DirectLine(Faulty(self.device, self.trouble), self.clock)
        self.board = Arbotix(self.line, self.ids)
        self.pump = ServoPump(
            self.board,
            pump(travel=TRAVEL, sensor=None),
            self.ids,
            PressureReadings([None] * len(self.ids), 101_325.0),
            self.clock,
        )
        self.wish = StopRequest()
        self.wanted = self.profile or swing(self.ids)
        self.fit: PoseFit = fit_poses(self.wanted, loop=self.loop)
        self.player = PosePlayer(
            self.pump, self.board, self.fit, self.wish, self.told.append, self.see
        )
        self.stop_at = np.inf
        """Time of playing at which Ctrl-C comes [s]."""

    def see(self, elapsed: float) -> None:
        if elapsed >= self.stop_at:
            self.wish.times, self.wish.first = 1, "SIGINT"

    def begin(self) -> None:
        """Connected, loaded and at the start."""
        self.pump.connect()
        self.player.load()
        ending = self.player.approach(split_at(self.wanted, 0.0)[0])
        assert ending.status == "complete", ending.reason
        self.bench.goals.clear()

    def play(self) -> StreamResult:
        """All of it."""
        self.begin()
        return self.player.play()
