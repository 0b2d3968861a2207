"""What a pressure profile asks of the axis at one inlet, and what the axis makes of it."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, ClassVar

import numpy as np

from viscodesign.effects.base import Trait
from viscodesign.effects.catalogue import every_effect, traits_of
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.planning.limits import CAP, LOWER, PRESSURE_LIMITS, Limits, Steps
from viscodesign.pump.planning.result import Panel, PumpCourse
from viscodesign.pump.play.axis import AxisLimits
from viscodesign.results.findings import Notice
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.inputs.table import TableInput
from viscodesign.scene.scene import Scene
from viscodesign.storage.cached_property import cached_property


@dataclass(frozen=True)
class FeedLine:
    """What the tubes hold at an inlet."""

    volume: float = 0.0  # [m3]
    compliance: float = 0.0  # [m3/Pa]
    compressible: bool = False  # whether its fluid has a density of its own, like the network's


def feed_line_at(scene: Scene, inlet: str, active: frozenset[str]) -> FeedLine:
    """The lines of an inlet in a model with these effects, to all actuators that it feeds."""
    compressible = Trait.COMPRESSIBLE_FLUID in traits_of(active)
    effects = every_effect(SceneQuantities(scene))
    stored = [effects[name].node_storage(inlet, compressible) for name in sorted(active)]
    volume, compliance = sum(v for v, _ in stored), sum(c for _, c in stored)
    return FeedLine(fed_by_each(scene) * volume, fed_by_each(scene) * compliance, compressible)


def fed_by_each(scene: Scene) -> int:
    """Equal actuators that each inlet of the scene's pump feeds."""
    return 1 if scene.pump is None else scene.pump.feeds


@dataclass(frozen=True)
class PumpDemand(ABC):
    """One inlet's axis over T times; arrays (T,) or, between the times, (T - 1,).

    What stands here is that of an axis that sets the pressure itself; an axis of another
    principle overrides what differs. Positions are in SI: [Pa] gauge here, [m] of a plunger.
    """

    limits: ClassVar[Limits] = PRESSURE_LIMITS
    stepwise: ClassVar[Steps] = ((LOWER, ("range", "rate")), (CAP, ("cap",)))
    """Changes that are tried one upon the other, each against its limits."""

    scene: Scene
    pump: Any  # the section of its kind
    inlet: str
    line: FeedLine
    time: np.ndarray  # from the start of the lead-in [s]
    lead_s: float
    pressure: np.ndarray  # gauge [Pa]
    given: np.ndarray  # to the network since it was filled [m3 at ambient density]
    stated_position: np.ndarray | None = None  # None: follows from pressure and given

    @property
    @abstractmethod
    def axis(self) -> AxisLimits:
        """What the axis can do, and may."""

    @property
    @abstractmethod
    def device(self) -> str:
        """What drives the axis, in words."""

    @classmethod
    def faults(cls, scene: Scene) -> Iterator[tuple[str, str]]:
        """Keys of a scene that keep it from being planned, each with what to correct."""
        return iter(())

    @cached_property
    def position(self) -> np.ndarray:
        """Positions of the axis (T,)."""
        return self.pressure if self.stated_position is None else self.stated_position

    @cached_property
    def steps(self) -> np.ndarray:
        """Targets of the axis (T,), not rounded."""
        return self.axis.home - self.axis.retreat_sign * self.position / self.axis.step

    @cached_property
    def rates(self) -> np.ndarray:
        """Changes of the pressure in size, in each interval (T - 1,) [Pa/s]."""
        return np.asarray(np.abs(np.diff(self.pressure) / np.diff(self.time)))

    @property
    def made_pressures(self) -> tuple[float, float]:
        """Lowest and highest gauge pressure that the axis can make [Pa]."""
        low, high = sorted(self._position_at(step) for step in self.axis.travel)
        return low, high

    @property
    def bounds(self) -> tuple[float, float]:
        """Lowest and highest gauge pressure that it may make [Pa]."""
        low, high = self.made_pressures
        return low, min(high, self.pump.max_pressure)

    def _position_at(self, step: Any) -> Any:
        return self.axis.retreat_sign * (self.axis.home - step) * self.axis.step

    def path(self, pressure: np.ndarray) -> np.ndarray:
        """Positions (T,) after its targets, as far as travel and speed allow.

        ``pressure`` (T,): at the inlet meanwhile, gauge [Pa].
        """
        goals: np.ndarray = self._position_at(np.clip(np.round(self.steps), *self.axis.travel))
        path = np.empty_like(goals)
        path[0] = goals[0]
        reach = self._reach(pressure)
        for k, goal in enumerate(goals[1:]):
            way = goal - path[k]
            most = reach[1.0 if way > 0.0 else -1.0][k]
            path[k + 1] = path[k] + np.clip(way, -most, most)
        return path

    def _reach(self, pressure: np.ndarray) -> Mapping[float, np.ndarray]:
        """Longest way in each interval (T - 1,), by the sign of its direction."""
        most = self.axis.top_speed * self.axis.step * np.diff(self.time)
        return {1.0: most, -1.0: most}

    def approach_time(self, speed_share: float) -> float:
        """From home to the first position, at a share of the speed that is left [s]."""
        speed = speed_share * self.axis.top_speed * self.axis.step
        return abs(float(self.position[0])) / speed

    def source(self, time: np.ndarray, path: np.ndarray) -> Input:
        """The input of a scene whose axis takes these positions (T,)."""
        above = path - self.scene.gauge_pressure
        rows = tuple(zip(time.tolist(), above.tolist(), strict=True))
        return TableInput(kind="table", rows=rows)

    def input_value(self, position: float) -> float:
        """Value of that input with the axis at a position."""
        return position - self.scene.gauge_pressure

    def possible(self, position: float) -> float:
        """The nearest position that the axis can have."""
        return position

    def columns(self) -> dict[str, np.ndarray]:
        """What a table shows of the axis (T,), in order, under names with units."""
        return {
            "pressure_pa": self.pressure,
            "given_m3": self.given,
            "flow_m3_s": self.flow(self.given),
            "steps": self.steps,
        }

    def flow(self, volume: np.ndarray) -> np.ndarray:
        """A volume's (T,) rate from each time on [m3/s]; 0 from the last."""
        return np.append(np.diff(volume) / np.diff(self.time), 0.0)

    def numbers(self) -> dict[str, float]:
        """What the axis is and what the plan takes of it, under names with units."""
        low, high = self.made_pressures
        return {
            "step_pa": self.axis.step,
            "lowest_made_pressure_pa_gauge": low,
            "highest_made_pressure_pa_gauge": high,
            "highest_pressure_pa_gauge": float(self.pressure.max()),
            "lowest_pressure_pa_gauge": float(self.pressure.min()),
            "fastest_change_pa_s": float(np.max(self.rates)),
            "lead_in_s": self.lead_s,
        }

    def words(self) -> dict[str, str]:
        """The same for people: sentences by their headings."""
        n = self.numbers()
        low, high = (n[f"{end}_pressure_pa_gauge"] / 1e3 for end in ("lowest", "highest"))
        return {
            "drive": f"{self.device}, for the inlet '{self.inlet}'",
            "steps": f"{n['step_pa']:.3g} Pa",
            "needs": f"{low:.4g} to {high:.4g} kPa gauge, changing by up to "
            f"{n['fastest_change_pa_s'] / 1e3:.3g} kPa/s",
            "lead-in": f"{self.lead_s:.3g} s from home to the pressure of the start",
        }

    @classmethod
    def limit_numbers(cls, demands: Sequence[Any]) -> dict[str, float]:
        """Limits that apply to all inlets, under names with units."""
        low, high = demands[0].made_pressures
        return {
            "cap_pa_gauge": demands[0].pump.max_pressure,
            "lowest_made_pressure_pa_gauge": low,
            "highest_made_pressure_pa_gauge": high,
        }

    @classmethod
    def notices(cls, demands: Sequence[Any]) -> Iterator[Notice]:
        """Warnings that belong to the plan as a whole."""
        return iter(())

    @classmethod
    def panels(cls, demands: Sequence[Any]) -> tuple[Panel, ...]:
        """What a picture of the plan shows against time."""
        cap = (("cap", demands[0].pump.max_pressure / 1e3),)
        return (
            Panel("pressure\n[kPa gauge]", "pressure_pa", 1e-3, cap, np.inf),
            Panel("set-point\n[steps]", "steps", 1.0),
            Panel("flow into the\nnetwork [mL/s]", "flow_m3_s", 1e6),
        )


def course_of(demands: Sequence[PumpDemand]) -> PumpCourse:
    """What is asked at all inlets, as one course."""
    first, each = demands[0], [demand.columns() for demand in demands]
    return PumpCourse(
        time=first.time,
        lead_s=first.lead_s,
        pressure=np.stack([demand.pressure for demand in demands], axis=1),
        steps=np.stack([demand.steps for demand in demands], axis=1),
        columns={name: np.stack([own[name] for own in each], axis=1) for name in each[0]},
    )
