"""The statics of a robot: `stand`."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from scipy.optimize import brentq

from viscodesign.errors import UsageError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.stand_study import CrouchRow, Fall, StanceRow, StandStudy
from viscodesign.robot.build_robot import build_robot, with_mass
from viscodesign.robot.falls import slide, tip_over
from viscodesign.robot.leg_network import barrel_volume
from viscodesign.robot.stance import Stance, UnstableStanceError, stance
from viscodesign.robot.tip_stiffness import tip_stiffness
from viscodesign.scene.robot_scene import RobotScene


@dataclass(frozen=True)
class StandRules:
    """Pressures, payloads and heights of a study, and how closely a limit is sought."""

    gauges: int = 8
    """Rows of the table by gauge pressure, from 0 up."""
    gauge_range: float = 2.0
    """Largest gauge pressure of the table, over the spec's."""
    least_largest_gauge: float = 140e3
    """The paper's "140 kPa", if it were gauge [Pa]."""
    payloads: tuple[float, ...] = (0.0, 0.25, 0.5, 0.75)
    """Payloads, as shares of the weight from which on it sways, beyond the robot's own."""
    height_ratios: tuple[float, ...] = (0.95, 0.93, 0.9, 0.85)
    lowest_gauge: float = -0.8
    """Gauge pressure of the deepest crouch, over the ambient pressure."""
    weight_growth: float = 1.25
    weight_range: float = 1e3
    """Least and largest weight that are tried, over the robot's own."""
    near_growth: float = 1.004
    """Of the first step away from a weight that other limits point to."""
    sway_rel_tol: float = 1e-3
    """Width of the range in which the limit is, over it; its middle is stated."""


RULES = StandRules()


def stand(scene: RobotScene, *, height_ratios: Sequence[float] = RULES.height_ratios) -> StandStudy:
    """How a robot stands: its height, its sway limit, its stiffness, and what a crouch takes.

    ``height_ratios``: heights of the legs in a crouch, over that at the spec's gauge pressure.
    Raises `SpecError`, and `UsageError` for ratios that are none.
    """
    if wrong := [ratio for ratio in height_ratios if not 0.0 < ratio < 1.0]:
        raise UsageError(f"crouch: a height ratio is above 0 and below 1; got {wrong[0]:g}")
    statics = _Statics(scene)
    own = statics.own()
    largest = max(RULES.gauge_range * scene.gauge_pressure, RULES.least_largest_gauge)
    room = max(own.sway_limit_n - statics.weight(0.0), 0.0) / statics.gravity
    crouch, pump = statics.crouches(own, height_ratios)
    return StandStudy(
        name=scene.name,
        own=own,
        by_gauge=statics.rows(
            np.linspace(0.0, largest, RULES.gauges).tolist(), scene.robot.payload
        ),
        by_payload=tuple(
            statics.row(scene.gauge_pressure, share * room) for share in RULES.payloads
        ),
        crouch=crouch,
        pump=pump,
        fall=None if own.stands else statics.fall(),
    )


def own_stance(scene: RobotScene) -> tuple[StanceRow, Fall | None]:
    """How a robot stands at its spec's gauge pressure and payload, and how it falls otherwise.

    No fall where it stands, or sways under its weight.
    """
    statics = _Statics(scene)
    own = statics.own()
    return own, None if own.stands else statics.fall()


class _Statics:
    """Stances of one robot."""

    def __init__(self, scene: RobotScene) -> None:
        self.scene, self.model = scene, build_robot(scene)
        self.gravity = math.hypot(*self.model.gravity)
        self._slide = slide(self.model)
        self._limits: dict[float, float] = {}
        self._stable: dict[float, dict[float, Stance]] = {}
        """Stances by gauge pressure and weight: heavier ones are found faster from them."""

    def fall(self) -> Fall | None:
        """How the robot falls at its own pressure, if not by its weight."""
        pressures = np.full(len(self.model.source_names), self.scene.gauge_pressure)
        return self._slide or tip_over(self.model, pressures)

    def own(self) -> StanceRow:
        """The row of the spec's gauge pressure and payload."""
        return self.row(self.scene.gauge_pressure, self.scene.robot.payload)

    def weight(self, payload: float) -> float:
        """Weight of robot and payload [N]."""
        return (self.scene.robot.mass + payload) * self.gravity

    def at(self, gauge: float, weight: float) -> Stance:
        """The stance with a weight [N] at one gauge pressure [Pa] of all sources."""
        model = with_mass(self.model, weight / self.gravity)
        pressures = np.full(len(model.source_names), gauge)
        stable = self._stable.setdefault(gauge, {})
        if weight in stable:
            return stable[weight]
        lighter = max((known for known in stable if known <= weight), default=None)
        found = stance(model, pressures, None if lighter is None else stable[lighter])
        if found.is_stable:
            stable[weight] = found
        return found

    def rows(self, gauges: Sequence[float], payload: float) -> tuple[StanceRow, ...]:
        """Rows by gauge pressure, found from the spec's own outward."""
        outward = sorted(gauges, key=lambda gauge: abs(gauge - self.scene.gauge_pressure))
        found = {gauge: self.row(gauge, payload) for gauge in outward}
        return tuple(found[gauge] for gauge in gauges)

    def row(self, gauge: float, payload: float) -> StanceRow:
        """A row of a table."""
        weight = self.weight(payload)
        if gauge not in self._limits:
            self._limits[gauge] = self._sway_limit(gauge)
        limit = self._limits[gauge]
        height = pitch = roll = stiffness = math.nan
        if weight < limit:
            found = self.at(gauge, weight)
            height = _height(found)
            pitch, roll = (float(angle) for angle in found.place[2:4])
            stiffness = tip_stiffness(found)
        return StanceRow(gauge, payload, weight, height, pitch, roll, limit, stiffness)

    def _sway_limit(self, gauge: float) -> float:
        """Weight from which on the robot sways; 0 of one that slides [N].

        From where the limits found so far point to, both ways until the limit lies between two
        weights, and then by halves: where contacts change, stiffness does not fall to zero.
        """
        if self._slide is not None:
            return 0.0
        own = self.model.weight
        guess, growth = self._pointed_to(gauge), RULES.weight_growth
        if guess:
            growth = RULES.near_growth
        low = high = guess or own
        if self._bears(gauge, low):
            while self._bears(gauge, high := low * growth):
                low, growth = high, min(growth**2, RULES.weight_growth)
                if high > RULES.weight_range * own:
                    return math.inf
        else:
            while not self._bears(gauge, low := high / growth):
                high, growth = low, min(growth**2, RULES.weight_growth)
                if low < self._feet_weight() or low < own / RULES.weight_range:
                    return 0.0
        while high - low > RULES.sway_rel_tol * low:
            middle = (low + high) / 2
            low, high = (middle, high) if self._bears(gauge, middle) else (low, middle)
        return (low + high) / 2

    def _bears(self, gauge: float, weight: float) -> bool:
        """Whether the legs bear a weight [N] at a gauge pressure [Pa]."""
        try:
            return self.at(gauge, weight).is_stable
        except UnstableStanceError:
            return False

    def _pointed_to(self, gauge: float) -> float:
        """The limit at a gauge pressure by those at the nearest ones; 0 where there is none [N]."""
        near = sorted(self._limits, key=lambda known: abs(known - gauge))[:2]
        known = [self._limits[own] for own in near]
        if not all(0.0 < limit < math.inf for limit in known):
            return 0.0
        if len(near) < 2:
            return known[0] if near else 0.0
        share = (gauge - near[0]) / (near[1] - near[0])
        return float(known[0] * (known[1] / known[0]) ** share)

    def _feet_weight(self) -> float:
        return self.model.count * self.model.feet.mass * self.gravity

    def crouches(
        self, own: StanceRow, ratios: Sequence[float]
    ) -> tuple[tuple[CrouchRow, ...], str]:
        """The crouches, and the source whose legs need the largest barrel."""
        sources = self.model.source_names
        if not own.stands:
            return (), sources[0]
        full = _contents(self.at(own.gauge_pressure_pa, own.weight_n))
        pump = int(np.argmax(full[1]))
        rows = tuple(self._crouch(own, ratio, full[:, pump], pump) for ratio in ratios)
        return rows, sources[pump]

    def _leg_height(self, height: float) -> float:
        """From the hips to the centres of the feet [m]."""
        return height - self.model.feet.radius

    def _crouch(self, own: StanceRow, ratio: float, full: np.ndarray, pump: int) -> CrouchRow:
        full_height = self._leg_height(own.height_m)

        def excess(gauge: float) -> float:
            return self._leg_height(_height(self.at(gauge, own.weight_n))) - ratio * full_height

        lowest = RULES.lowest_gauge * self.scene.ambient_pressure
        try:
            gauge = float(brentq(excess, lowest, own.gauge_pressure_pa, xtol=1e-2))
            drawn = full - _contents(self.at(gauge, own.weight_n))[:, pump]
        except (ValueError, UnstableStanceError):  # no change of sign: it stays above
            reason = self._too_deep(own, lowest)
            return CrouchRow(ratio, math.nan, math.nan, math.nan, reason)
        fluid = self.model.groups[0].functions.design.fluid
        barrel = float(barrel_volume(fluid, drawn[1], gauge))
        return CrouchRow(ratio, gauge, float(drawn[0]), barrel)

    def _too_deep(self, own: StanceRow, lowest: float) -> str:
        """Why a crouch is not reached down to a gauge pressure [Pa]."""
        if lowest >= own.gauge_pressure_pa:
            return f"the robot is at {1e-3 * own.gauge_pressure_pa:.3g} kPa gauge already"
        try:
            least = self._leg_height(_height(self.at(lowest, own.weight_n)))
        except UnstableStanceError:
            return f"at {1e-3 * lowest:.3g} kPa gauge the robot does not stand"
        share = 1e2 * least / self._leg_height(own.height_m)
        return f"at {1e-3 * lowest:.3g} kPa gauge, the lowest tried, the legs keep {share:.3g} %"


def _height(found: Stance) -> float:
    return float(np.mean(found.model.hip_heights(found.place)))


def _contents(found: Stance) -> np.ndarray:
    """What the legs of every source hold (2, sources): as volume, and at ambient density [m3]."""
    held = np.zeros((2, len(found.model.source_names)))
    for group, legs in zip(found.model.groups, found.legs, strict=True):
        own = group.functions.design
        content = legs.content[:, : own.bellows]
        volume = barrel_volume(own.fluid, content, legs.pressure[:, : own.bellows])
        for row, amounts in enumerate((volume, content)):
            np.add.at(held[row], group.sources, amounts.sum(axis=1))
    return held
