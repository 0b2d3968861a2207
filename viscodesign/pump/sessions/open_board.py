"""From the name of a board to one that answers."""

from __future__ import annotations

from difflib import get_close_matches

from viscodesign.errors import UsageError
from viscodesign.plugins import members
from viscodesign.pump.boards.arbotix import Arbotix
from viscodesign.pump.boards.base import Board
from viscodesign.pump.bus import registers
from viscodesign.pump.bus.byte_log import ByteLog, LoggedLine
from viscodesign.pump.bus.clock import Clock, WallClock
from viscodesign.pump.bus.line import Line
from viscodesign.pump.bus.serial_line import SerialLine
from viscodesign.pump.drive import Drive
from viscodesign.pump.simulated.bench import SimulatedBench
from viscodesign.pump.simulated.direct_line import DirectLine
from viscodesign.pump.simulated.pins import Pins
from viscodesign.pump.simulated.plant import AMBIENT, ClosedGas, Plant
from viscodesign.pump.simulated.pypose import PyPose
from viscodesign.pump.simulated.ros import Ros
from viscodesign.pump.simulated.servo import SimulatedServo
from viscodesign.scene.pump import PumpSpec

MODEL_NUMBERS = {"ax12a": 12, "ax18a": 18}
"""Of the servos that `pump.servo` names."""


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
        raise UsageError(f"--board {name}: no such board{meant} There are: {', '.join(kinds)}")
    return kinds[name]


def open_board(
    name: str,
    port: str | None,
    baud: int | None,
    log: ByteLog,
    clock: Clock | None = None,
    pump: PumpSpec | None = None,
    plant: Plant | None = None,
    ambient: float = AMBIENT,
    *,
    poses: bool = False,
) -> Board:
    """A board behind its port, booted; moves nothing and asks nothing yet.

    ``plant`` is what the plungers of a simulated board press into, a closed barrel where none
    is given; ``ambient`` the absolute pressure around its sensor [Pa]. ``poses``: a simulated
    board that plays poses by itself. Whoever opens a board closes its line.
    """
    kind = board_kind(name)
    _check_port(kind, port, baud)
    clock = clock or WallClock()
    servos = servo_ids(pump)
    if not kind.simulated:
        line: Line = SerialLine(str(port), baud or kind.baud, clock)
    elif pump is None:
        raise UsageError("--board simulated needs the `pump:` section of a spec")
    elif poses:
        kind = SimulatedArbotix
        line = DirectLine(PyPose(simulated_bench(pump, plant, ambient)), clock)
    else:
        line = simulated_line(pump, clock, plant, ambient)
    log.event("opened", board=name, port=port, baud=baud or kind.baud, simulated=kind.simulated)
    board = kind(LoggedLine(line, log), servos)
    clock.sleep(kind.boot)
    board.line.drain()
    return board


class SimulatedArbotix(Arbotix):
    """A computed ArbotiX with PyPose: `--board simulated` for poses."""

    name = "simulated"
    simulated = True
    boot = 0.0

    def identify(self) -> str:
        return f"simulated, nothing real moves: {super().identify()}"


def servo_ids(pump: PumpSpec | None) -> list[int]:
    """Of the servos that a pump names, in the order of its inlets."""
    if pump is None:
        return []
    return [pump.servo_id] if isinstance(pump.servo_id, int) else list(pump.servo_id.values())


def simulated_line(
    pump: PumpSpec, clock: Clock, plant: Plant | None = None, ambient: float = AMBIENT
) -> Line:
    """A line into a computed ArbotiX with the firmware for ROS, and a pump behind it."""
    bench = simulated_bench(pump, plant, ambient)
    return DirectLine(Ros(bench, Pins(bench, ambient)), clock)


def simulated_bench(
    pump: PumpSpec, plant: Plant | None = None, ambient: float = AMBIENT
) -> SimulatedBench:
    """A calibrated pump with its plungers at home, in closed barrels where no plant is given."""
    drives = [Drive(pump) for _ in servo_ids(pump)]
    servos = [
        SimulatedServo(servo, MODEL_NUMBERS[pump.servo], pump.home) for servo in servo_ids(pump)
    ]
    for servo in servos:
        servo.supply(min(pump.supply_voltage, HIGHEST_REPORTED_V))
        servo.set(registers.CW_LIMIT, pump.travel[0])
        servo.set(registers.CCW_LIMIT, pump.travel[1])
    return SimulatedBench(servos, drives, plant or ClosedGas(drives, ambient))


def _check_port(kind: type[Board], port: str | None, baud: int | None) -> None:
    if kind.simulated and (port is not None or baud is not None):
        raise UsageError("--board simulated has no --port and no --baud: nothing real moves")
    if not kind.simulated and port is None:
        raise UsageError(
            f"--board {kind.name} needs --port, such as /dev/ttyUSB0; "
            "`viscodesign pump ports` lists those there are"
        )
    if baud is not None and baud <= 0:
        raise UsageError(f"--baud {baud}; give bits a second, such as {kind.baud}")
