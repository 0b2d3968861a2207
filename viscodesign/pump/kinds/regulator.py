"""`kind: regulator`: an electro-pneumatic regulator, which is told a pressure and keeps it."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import ClassVar

from viscodesign.errors import PumpError
from viscodesign.pump.boards.controller import Controller
from viscodesign.pump.boards.line_regulator import LineRegulator, SimulatedLineRegulator
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.kinds.base import Channels, PumpKind
from viscodesign.pump.kinds.connection import Connection
from viscodesign.pump.planning.demand import PumpDemand
from viscodesign.pump.planning.result import PumpPlan
from viscodesign.pump.play.axis import (
    AxisLimits,
    AxisState,
    FinalAxisState,
    FoundAxis,
    until_verified,
)
from viscodesign.pump.play.pump import Pump, Speeds, Steps
from viscodesign.pump.simulated.device import Device
from viscodesign.pump.simulated.plant import Plant
from viscodesign.pump.simulated.regulator import SimulatedRegulator
from viscodesign.scene.pumps.regulator import HIGHEST_SET_POINT, RegulatorSpec
from viscodesign.scene.scene import Scene
from viscodesign.storage.cached_property import cached_property

NOUN = "regulator"
AXIS = 1  # the only one: its line is from one device to one computer
APPROACH_TIME = 20.0  # from 0 to full scale on the way to a start or back [s]


def axis_limits(pump: RegulatorSpec) -> AxisLimits:
    """What the regulator of a spec can do; its highest target is the cap."""
    top, rest = pump.rate_limit / pump.step, pump.error * HIGHEST_SET_POINT
    return AxisLimits(
        step=pump.step,
        noun=NOUN,
        unit="steps",
        travel=(0, int(min(pump.full_scale, pump.max_pressure) / pump.step + 1e-9)),
        home=0,
        retreat_sign=-1,
        max_pressure=pump.max_pressure,
        top_speed=top,
        slowest_speed=0.0,
        lead_distance=pump.response_time * top,
        largest_lead=0.0,  # it corrects its own error
        approach_speed=HIGHEST_SET_POINT / APPROACH_TIME,
        settle_speed=HIGHEST_SET_POINT / APPROACH_TIME,
        following_error=pump.following_error * HIGHEST_SET_POINT,
        weakness="its supply pressure is too low, or something leaks behind it",
        dead_band=rest,
        settled_error=rest,
        travel_tolerance=HIGHEST_SET_POINT,  # what is measured is judged by the cap
        lowest_voltage=0.0,
        highest_temperature=float("inf"),
    )


class RegulatorPump(Pump):
    """One regulator behind the contract of a pump."""

    reading_share = 0.5  # sending takes about as long as reading
    board: LineRegulator

    @cached_property
    def limits(self) -> AxisLimits:
        return axis_limits(self.settings)

    def inspect(self) -> tuple[str, list[FoundAxis]]:
        """It as it is; in steps where no spec names its full scale."""
        identity, pump, state = self.board.identify(), self.settings, self._read()[AXIS]
        words = [
            f"{n} of {HIGHEST_SET_POINT}"
            if pump is None
            else f"{n * pump.step / 1e3:.2f} kPa gauge"
            for n in (state.goal, state.position)
        ]
        faults = []
        if pump is not None and state.position * pump.step > pump.max_pressure:
            faults = [
                f"regulator {AXIS} is at {words[1]}, above pump.max_pressure, "
                f"{pump.max_pressure / 1e3:g} kPa; vent it with `pump stop --release`"
            ]
        cells = {"id": f"{AXIS}", "set-point": words[0], "outlet": words[1]}
        document = {
            "id": AXIS,
            "set_point_steps": state.goal,
            "outlet_steps": state.position,
        }
        return identity, [FoundAxis(AXIS, cells, document, faults)]

    def arm(self, speed: float = 0.0) -> None:
        """Let it hold the pressure that it has, or its set-point where that is lower."""
        if speed > (most := self.limits.top_speed) * (1 + 1e-9):
            raise PumpError(f"{speed:.0f} steps/s requested; pump.rate_limit is {most:.0f} steps/s")
        here = min(self.board.outlet(), self.board.set_point(), self.limits.travel[1])
        self.goals = {AXIS: here}
        self.armed = True
        self.board.set(self.goals[AXIS])

    def _read(self) -> Mapping[int, AxisState]:
        before = self.clock.now()
        output, goal = self.board.outlet(), self.board.set_point()
        self.read_at = (before + self.clock.now()) / 2
        self.positions = {AXIS: output}
        # Of its supply it says nothing.
        return {AXIS: AxisState(True, goal, output, load=None, voltage=None, temperature=None)}

    def _send(self, goals: Steps, speeds: Speeds, paces: Speeds | None) -> None:
        self.board.set(goals[AXIS])

    def hold(self, *, in_place: bool = True) -> list[FinalAxisState]:
        if not self.armed:
            return [FinalAxisState(AXIS, True, "untouched: no set-point was sent", NOUN)]
        if in_place:
            with contextlib.suppress(PumpError):
                self.positions[AXIS] = self.board.outlet()
            # Never higher than before: what else presses at its outlet is not its set-point.
            self.goals[AXIS] = min(self.positions[AXIS], self.goals[AXIS])
        return hold(self.board, self.clock, self.goals[AXIS])

    def release(self) -> list[FinalAxisState]:
        self.armed = False
        return hold(self.board, self.clock, 0)


def hold(board: LineRegulator, clock: Clock, goal: int) -> list[FinalAxisState]:
    """Send a set-point [steps], and read back that it is held."""

    def attempt(axis: int) -> str:
        try:
            board.set(goal)
            held = board.set_point()
        except PumpError as error:
            raise PumpError(f"no hold could be verified: {error}") from None
        if held != goal:
            raise PumpError(f"was sent set-point {goal}, but holds {held}")
        if goal == 0:
            return "set to 0 kPa: it vents, verified"
        return f"holds {goal} of {HIGHEST_SET_POINT} steps, verified"

    return until_verified([AXIS], clock, NOUN, attempt)


class RegulatorDemand(PumpDemand):
    """What a plan asks of a regulator: the pressures themselves."""

    name: ClassVar[str] = "regulator"

    @property
    def axis(self) -> AxisLimits:
        return axis_limits(self.pump)

    @property
    def device(self) -> str:
        return f"a regulator of {self.pump.full_scale / 1e3:g} kPa full scale"

    @classmethod
    def faults(cls, scene: Scene) -> Iterator[tuple[str, str]]:
        if len(scene.inputs) > 1:
            yield (
                "pump.kind",
                f"a regulator drives one inlet, and this scene has {len(scene.inputs)}: its line "
                "is from one device to one computer",
            )
        if not scene.fluid.is_gas:
            yield "fluid", f"a regulator moves a gas; {scene.fluid.name} takes pump.kind: servo"


class RegulatorKind(PumpKind):
    """A regulator on a serial line of its own."""

    name = "regulator"
    noun = NOUN
    pump = RegulatorPump
    not_calibrated = (
        "a regulator has nothing to calibrate here: its zero and span are set at the device, and "
        "pump.full_scale states its range"
    )

    def boards(self) -> dict[str, type[Controller]]:
        return {LineRegulator.name: LineRegulator}

    def simulated_board(self, poses: bool) -> type[Controller]:
        return SimulatedLineRegulator

    def simulated_device(
        self,
        pump: RegulatorSpec,
        inlets: int,
        plant: Plant | None,
        ambient: float,
        *,
        poses: bool = False,
    ) -> Device:
        return SimulatedRegulator(pump, plant)

    def simulated_pump(self) -> RegulatorSpec:
        return RegulatorSpec(full_scale=100e3)

    def channels(self, pump: RegulatorSpec | None) -> Channels:
        unit, step = ("steps", 1) if pump is None else ("pa", pump.step)
        return {
            ("outlet", unit): lambda state, goal: state.position * step,
            ("set_point", unit): lambda state, goal: goal * step,
        }

    def own_gauge(self, link: Connection, axis: int) -> Callable[[], float] | None:
        """Its own reading of a moment ago: every look at it begins with one."""
        if link.pump is None:
            return None
        return lambda: float(link.ambient + link.board.output * link.pump.step)

    def answering(self, board: LineRegulator) -> list[int]:
        return [AXIS]

    def motion_rows(self, plan: PumpPlan, pump: RegulatorSpec) -> list[tuple[str, str]]:
        course, most = plan.achievable, axis_limits(pump).travel[1]
        low, high = course.pressure.min() / 1e3, course.pressure.max() / 1e3
        fastest, cap = plan.numbers[plan.inlets[0]]["fastest_change_pa_s"], pump.max_pressure / 1e3
        return [
            ("set-point", f"{course.steps.min():.0f} to {course.steps.max():.0f} of {most} steps"),
            ("pressure", f"{low:.2f} to {high:.2f} kPa gauge; stops above {cap:g} kPa"),
            ("change", f"up to {fastest / 1e3:.3g} of {pump.rate_limit / 1e3:g} kPa/s"),
        ]

    def stop(self, link: Connection, ids: Sequence[int], release: bool) -> list[FinalAxisState]:
        try:
            goal = 0 if release else min(link.board.outlet(), link.board.set_point())
        except PumpError:
            return []
        return hold(link.board, link.clock, goal)
