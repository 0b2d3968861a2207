"""Boards by name, and the computed ones behind `--board simulated`."""

from __future__ import annotations

from difflib import get_close_matches

from viscodesign.errors import UsageError
from viscodesign.plugins import members
from viscodesign.pump.ax.protocol import registers
from viscodesign.pump.boards.arbotix import Arbotix
from viscodesign.pump.boards.base import Board
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.bus.line import Line
from viscodesign.pump.drive import Drive
from viscodesign.pump.servo_motor import SERVOS
from viscodesign.pump.simulated.bench import AMBIENT, ClosedGas, Plant, SimulatedBench
from viscodesign.pump.simulated.device import DirectLine
from viscodesign.pump.simulated.pypose import PyPose
from viscodesign.pump.simulated.ros import Pins, Ros
from viscodesign.pump.simulated.servo import SimulatedServo
from viscodesign.scene.pump import PumpSpec

HIGHEST_REPORTED_V = 25.5
"""What the servo's one byte of voltage can say [V]."""


def boards() -> dict[str, type[Board]]:
    """Kinds of boards by the word after `--board`."""
    return members("viscodesign.pump.boards", Board)  # type: ignore[type-abstract]


def board_kind(name: str) -> type[Board]:
    """The kind of board with a name."""
    kinds = boards()
    if name not in kinds:
        close = get_close_matches(name, kinds, n=1)
        meant = f"; did you mean {close[0]!r}?" if close else ""
        raise UsageError(
            f"--board {name}: no such board{meant or '.'} There are: {', '.join(kinds)}"
        )
    return kinds[name]


class SimulatedArbotix(Arbotix):
    """A computed ArbotiX with PyPose: `--board simulated` for poses."""

    name = "simulated"
    simulated = True
    boot = 0.0

    def identify(self) -> str:
        return f"simulated, nothing real moves: {super().identify()}"


def servo_ids(pump: PumpSpec) -> list[int]:
    """Of the servos that a pump names, in the order of its inlets."""
    return [pump.servo_id] if isinstance(pump.servo_id, int) else list(pump.servo_id.values())


def simulated_line(
    pump: PumpSpec,
    clock: Clock,
    plant: Plant | None = None,
    ambient: float = AMBIENT,
    *,
    poses: bool = False,
) -> Line:
    """A line into a computed ArbotiX, and a pump behind it.

    Its firmware is that for ROS; with ``poses`` PyPose's. ``ambient``: absolute [Pa].
    """
    bench = simulated_bench(pump, plant, ambient)
    return DirectLine(PyPose(bench) if poses else Ros(bench, Pins(bench, ambient)), clock)


def simulated_bench(
    pump: PumpSpec, plant: Plant | None = None, ambient: float = AMBIENT
) -> SimulatedBench:
    """A calibrated pump with its plungers at home, in closed barrels where no plant is given."""
    model, ids = SERVOS[pump.servo].model, servo_ids(pump)
    drives = [Drive(pump) for _ in ids]
    servos = [SimulatedServo(servo, model, pump.home) for servo in ids]
    for servo in servos:
        servo.supply(min(pump.supply_voltage, HIGHEST_REPORTED_V))
        servo.set(registers.CW_LIMIT, pump.travel[0])
        servo.set(registers.CCW_LIMIT, pump.travel[1])
    return SimulatedBench(servos, drives, plant or ClosedGas(drives, ambient))
