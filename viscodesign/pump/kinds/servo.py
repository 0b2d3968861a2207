"""`kind: servo`: a syringe whose plunger a Dynamixel AX servo moves by rack and pinion."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import ClassVar

from viscodesign.errors import UsageError
from viscodesign.plugins import members
from viscodesign.pump.ax.hold import NOUN, stop_all
from viscodesign.pump.ax.servo_demand import AxDemand
from viscodesign.pump.ax.servo_drive import ServoDrive
from viscodesign.pump.ax.servo_pump import ServoPump
from viscodesign.pump.ax.torque_limit import share_of_stall, stalling_pressure, torque_limit
from viscodesign.pump.boards.arbotix import SimulatedArbotix
from viscodesign.pump.boards.arbotix_ros import Simulated
from viscodesign.pump.boards.base import Board
from viscodesign.pump.kinds.base import Channels, PumpKind
from viscodesign.pump.kinds.connection import Connection
from viscodesign.pump.kinds.servo_calibration import calibrate, calibration_steps
from viscodesign.pump.planning.result import PumpPlan
from viscodesign.pump.play.axis import FinalAxisState
from viscodesign.pump.plunger.plunger_numbers import range_rows
from viscodesign.pump.poses.upload import PoseUpload
from viscodesign.pump.simulated.bench import ClosedGas, SimulatedBench
from viscodesign.pump.simulated.device import Device
from viscodesign.pump.simulated.plant import AMBIENT, Plant
from viscodesign.pump.simulated.pypose import PyPose
from viscodesign.pump.simulated.ros import Pins, Ros
from viscodesign.pump.simulated.servo import SimulatedServo
from viscodesign.scene.per_inlet import each
from viscodesign.scene.pumps.base import SensorSpec
from viscodesign.scene.pumps.servo import ServoPumpSpec
from viscodesign.scene.pumps.servo_motor import SERVOS
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import copied

SCANNED_IDS = range(1, 9)
"""Servo ids that are tried where no spec names them."""
BOARD_CHANNELS = 8  # analog inputs of a board
HIGHEST_REPORTED_V = 25.5
"""What the servo's one byte of voltage can say [V]."""


CHANNELS: Channels = {
    ("position", "counts"): lambda state, goal: state.position,
    ("goal", "counts"): lambda state, goal: goal,
    ("load", "rel"): lambda state, goal: state.load,
    ("voltage", "v"): lambda state, goal: state.voltage,
    ("temperature", "degc"): lambda state, goal: state.temperature,
}


class ServoDemand(AxDemand):
    """What a plan asks of a servo and its plunger."""

    name: ClassVar[str] = "servo"


class ServoKind(PumpKind):
    """A syringe with a servo, on a bus of such servos."""

    name = "servo"
    order: ClassVar[int] = 0
    noun = NOUN
    pump = ServoPump
    poses = PoseUpload
    no_reply = (
        "A move that the PyPose firmware plays cannot be interrupted: the halt acts when it is "
        "over, up to 32 s later. Until then nothing answers, and only switching the power off "
        "stops it."
    )

    def boards(self) -> Mapping[str, type[Board]]:
        found = members("viscodesign.pump.boards", Board)  # type: ignore[type-abstract]
        return {name: board for name, board in found.items() if not board.simulated}

    def simulated_board(self, poses: bool) -> type[Board]:
        return SimulatedArbotix if poses else Simulated

    def simulated_device(
        self,
        pump: ServoPumpSpec,
        inlets: int,
        plant: Plant | None,
        ambient: float,
        *,
        poses: bool = False,
    ) -> Device:
        """A simulated ArbotiX: with the firmware for ROS, or with PyPose's."""
        bench = simulated_bench(pump, plant, ambient, inlets)
        return PyPose(bench) if poses else Ros(bench, Pins(bench, ambient))

    def simulated_pump(self) -> ServoPumpSpec:
        given = {"syringe_diameter": "34.9 mm", "sensor": {"channel": 0}}
        return ServoPumpSpec.model_validate(given)

    def with_sensors(self, scene: Scene, *, simulated: bool, without: bool) -> Scene:
        """The scene with a sensor at every inlet, or with those that the user does without removed.

        A simulated board has them all. ``without``: where only some inlets have a sensor, these
        are still read; where all have one, none is. Raises `UsageError` where a real board would
        move a plunger whose pressure is not monitored.
        """
        inlets, pump = tuple(scene.inputs), scene.pump
        assert pump is not None, "sensors belong to a pump"
        sensors = each(pump.sensor, len(inlets))
        blind = [name for name, sensor in zip(inlets, sensors, strict=True) if sensor is None]
        if (0 < len(blind) < len(inlets)) if without else not blind:
            return scene
        if not (without or simulated):
            raise UsageError(_without_sensor(blind, inlets))
        # The first inlet's own sensor, if there is one; the others on free channels.
        own = [sensor for sensor in sensors if sensor is not None]
        free = set(range(BOARD_CHANNELS)) - {sensor.channel for sensor in own}
        every = [*own, *(SensorSpec(channel=channel) for channel in sorted(free))]
        chosen = None if without else dict(zip(inlets, every, strict=False))
        return copied(scene, {"pump": copied(pump, {"sensor": chosen})})

    def channels(self, pump: ServoPumpSpec | None) -> Channels:
        return CHANNELS

    def answering(self, board: Board) -> list[int]:
        return [servo for servo in SCANNED_IDS if board.answers(servo)]

    def motion_rows(self, plan: PumpPlan, pump: ServoPumpSpec) -> list[tuple[str, str]]:
        course = plan.achievable
        stall, speed = (course.columns[f"{name}_share"].max() for name in ("stall", "speed"))
        slow, fast = (torque_limit(pump, speed) for speed in (0.0, plan.profile(course).top_speed))
        at_rest, moving = (stalling_pressure(pump, limit) / 1e3 for limit in (slow, fast))
        plunger, (_, pressure) = range_rows(course, pump, course.steps, plan.unit)
        return [
            plunger,
            ("pressure", f"{pressure}; stops above {pump.max_pressure / 1e3:g} kPa"),
            (
                "torque",
                f"up to {stall:.0%} of stall; limited to "
                f"{share_of_stall(slow):.0%} at rest (holds at most {at_rest:.0f} kPa) and "
                f"{share_of_stall(fast):.0%} at top speed ({moving:.0f} kPa)",
            ),
            ("speed", f"up to {speed:.0%} of the speed left at that torque"),
        ]

    def stop(self, link: Connection, ids: Sequence[int], release: bool) -> list[FinalAxisState]:
        return stop_all(link.board, list(ids or SCANNED_IDS), link.clock, release=release)

    calibrate = staticmethod(calibrate)
    calibration_steps = staticmethod(calibration_steps)


def simulated_bench(
    pump: ServoPumpSpec, plant: Plant | None = None, ambient: float = AMBIENT, inlets: int = 1
) -> SimulatedBench:
    """A calibrated pump with its plungers at home, in closed barrels where no plant is given."""
    model, ids = SERVOS[pump.servo].model, pump.axes(inlets)
    drives = [ServoDrive(pump) for _ in ids]
    servos = [SimulatedServo(servo, model, pump.home) for servo in ids]
    for servo in servos:
        servo.limit_angles(*pump.travel)
    bench = SimulatedBench(servos, drives, plant or ClosedGas(drives, ambient))
    bench.supply(min(pump.supply_voltage, HIGHEST_REPORTED_V))
    return bench


def _without_sensor(blind: list[str], inlets: tuple[str, ...]) -> str:
    """What to do about inlets that no software would keep below the cap."""
    missing, example = "the spec names no pressure sensor", "{channel: 0}"
    if len(inlets) > 1:
        missing += f" for {' and '.join(blind)}"
        channels = ", ".join(f"{name}: {{channel: {k}}}" for k, name in enumerate(inlets))
        example = f"{{{channels}}}"
    return (
        f"{missing}, so the pressure cap could not be enforced: add pump.sensor, like "
        f"`sensor: {example}`, or use --without-sensor (without_sensor=True in "
        "Python) and rely on the servo's torque limit"
    )
