"""Another principle of pump: a regulator that is told a pressure, and a device that is one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

from viscodesign.errors import PumpError
from viscodesign.pump.bus.clock import Clock
from viscodesign.pump.play.axis import AxisLimits, AxisState, FinalAxisState
from viscodesign.pump.play.pump import Pump
from viscodesign.pump.sensors.pressure_readings import PressureReadings

AMBIENT = 101_325.0
LIMITS = AxisLimits(
    step=100.0,
    noun="regulator",
    unit="hPa",
    weakness="the supply is too low",
    dead_band=1.0,
    settled_error=0.5,
    travel=(-100, 400),
    home=0,
    retreat_sign=-1,
    max_pressure=25e3,
    top_speed=2000.0,
    slowest_speed=1.0,
    lead_distance=0.0,
    largest_lead=40.0,
    approach_speed=50.0,
    settle_speed=45.0,
    following_error=60.0,
    travel_tolerance=5,
    lowest_voltage=10.0,
    highest_temperature=70.0,
)


@dataclass
class SimulatedRegulator:
    """Its pressure follows its target at the speed it is told, if it is powered."""

    clock: Clock
    pressure: float = 0.0
    """Gauge [Pa]."""
    offset: float = 0.0
    """What else presses at its outlet [Pa]."""
    target: float = 0.0
    """[Pa]"""
    speed: float = 0.0
    """[Pa/s]"""
    powered: bool = False
    plugged: bool = True
    moment: float = field(default=0.0)
    commands: list[float] = field(default_factory=list)

    def advance(self) -> None:
        if not self.plugged:
            raise PumpError("the regulator does not answer: is its cable plugged in?")
        passed, self.moment = self.clock.now() - self.moment, self.clock.now()
        if self.powered:
            most = self.speed * passed
            self.pressure += min(max(self.target - self.pressure, -most), most)

    def command(self, target: float, speed: float) -> None:
        self.advance()
        self.commands.append(target)
        self.target, self.speed = target, speed

    def measured(self) -> float:
        self.advance()
        return AMBIENT + self.pressure + self.offset


class RegulatorPump(Pump):
    """One regulator as a pump: a step is 100 Pa."""

    def __init__(self, device: SimulatedRegulator, clock: Clock) -> None:
        gauges = PressureReadings([device.measured], AMBIENT)
        super().__init__((1,), LIMITS, gauges, dict, clock)
        self.device = device

    def arm(self, speed: float = 0.0) -> None:
        if speed > self.limits.top_speed:
            raise PumpError("the regulator is not that fast")
        self._command(self._position())
        self.device.powered = self.armed = True

    def _position(self) -> int:
        self.device.advance()
        return round(self.device.pressure / self.limits.step)

    def _command(self, step: int, speed: float = 20.0) -> None:
        self.device.command(step * self.limits.step, speed * self.limits.step)
        self.goals[1] = step

    def _read(self) -> Mapping[int, AxisState]:
        self.positions[1] = self._position()
        self.read_at = self.clock.now()
        goal = round(self.device.target / self.limits.step)
        return {1: AxisState(self.device.powered, goal, self.positions[1], 0.0, 12.0, 25.0)}

    def _send(
        self,
        goals: Mapping[int, int],
        speeds: Mapping[int, float],
        paces: Mapping[int, float] | None,
    ) -> None:
        self._command(goals[1], speeds[1])

    def hold(self, *, in_place: bool = True) -> list[FinalAxisState]:
        left = FinalAxisState(1, True, "untouched")
        if self.armed:
            try:
                self._command(self._position() if in_place else self.goals[1])
            except PumpError as error:
                return [replace(left, verified=False, words=f"no hold could be sent: {error}")]
            left = FinalAxisState(1, True, f"holds {self.device.target / 1e3:g} kPa")
        return [left]

    def release(self) -> list[FinalAxisState]:
        self.device.powered = self.armed = False
        return [FinalAxisState(1, True, "vented")]
