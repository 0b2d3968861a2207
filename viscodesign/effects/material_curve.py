"""Material curve: measured laws of a bellow in the place of the linear ones."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import ClassVar, Self

import casadi as ca
import numpy as np

from viscodesign.effects.base import Effect, Trait
from viscodesign.effects.catalogue import names_with, traits_of
from viscodesign.errors import Fault
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.bellow_wall import MeasuredWall, OwnWalls, SnappingWall
from viscodesign.model.system import System
from viscodesign.physics.pressure_curves import PressureCurves
from viscodesign.physics.snapping import SnapCurves
from viscodesign.postprocess.motion_limits import Limit, Peak
from viscodesign.references import LiteratureReference
from viscodesign.results.findings import Notice
from viscodesign.scene.bellow_curve import falls, first_peak
from viscodesign.scene.bellow_numbers import moving_bellows
from viscodesign.scene.bellows import snaps
from viscodesign.solve.obstacles import Obstacle

LINEAR_WALL_VOLUME = 7**0.5
"""Volume of a bellow, of that at rest, from which no linear law can be trusted: there even a thin
sphere of a neo-Hookean elastomer, whose pressure goes as 1/s - 1/s^7 with its stretch s, has
passed its peak, at s^6 = 7."""


@dataclass(frozen=True, eq=False)
class MaterialCurve(Effect):
    """Area, angle and extension of one bellow against its pressure, as measured.

    Monotone cubics through the rows, straight beyond them; zero at zero gauge. The angle
    and the extension are those of a section when one of its bellows, the left one, has
    the pressure and the other none; the two bellows of a section add. Where the pressure
    falls from row to row the cubics are functions of the area, and the bellow snaps.
    """

    name: ClassVar[str] = "material_curve"
    order: ClassVar[int] = 12
    formula: ClassVar[str] = "largest departure from the linear law over the range / its swing"
    traits: ClassVar[frozenset[Trait]] = frozenset({Trait.LIMITED_EMPTYING})
    remedies: ClassVar[Mapping[Obstacle, str]] = {
        Obstacle.EMPTY_BELLOW: f"set effects.{name} to auto"
    }
    validity: ClassVar[str] = "Within the measured range; beyond it a warning is given."
    source: ClassVar[str] = "Interpolation by Fritsch and Butland (1984)."
    references: ClassVar[tuple[LiteratureReference, ...]] = (
        LiteratureReference(
            "fritsch1984",
            "article",
            {
                "author": "Fritsch, F. N. and Butland, J.",
                "title": "A Method for Constructing Local Monotone Piecewise Cubic Interpolants",
                "journal": "SIAM Journal on Scientific and Statistical Computing",
                "volume": "5",
                "number": "2",
                "pages": "300--304",
                "year": "1984",
                "doi": "10.1137/0905021",
            },
        ),
    )
    keys: ClassVar[tuple[str, ...]] = ("bellows.curve",)

    laws: tuple[PressureCurves | SnapCurves, ...]
    """One for all bellows, or one of each in the graph's order; none without a curve."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        scene = quantities.scene
        section = scene.sections.of_bellows(quantities.body.section_lengths)
        curves, length = scene.bellows.curves, quantities.bellows.length
        if not curves:
            return cls(())
        moved, snap = moving_bellows(scene), snaps(scene.bellows)
        count = max(len(curves), *map(np.size, (length, moved, section)))
        lengths, moves, sections = (own * np.ones(count) for own in (length, moved, section))
        each = curves * (count // len(curves))
        laws: list[PressureCurves | SnapCurves] = []
        for curve, own, moves_section, reach in zip(each, lengths, moves, sections, strict=True):
            # Pressures that strain no section are spread over an endless one.
            spread = reach / moves_section if moves_section else np.inf
            rows = np.array(curve.rows, dtype=float)
            if snap:
                laws.append(SnapCurves.through(rows, own, spread, scene.gauge_pressure))
            else:
                laws.append(PressureCurves.through(rows, own, spread))
        return cls(tuple(laws))

    @property
    def snap(self) -> bool:
        """Whether the laws are functions of a bellow's swelling."""
        return any(isinstance(law, SnapCurves) for law in self.laws)

    def present(self, quantities: SceneQuantities) -> bool:
        return bool(self.laws)

    def weight(self, quantities: SceneQuantities) -> float:
        low, high = quantities.lowest_pressure, quantities.highest_pressure
        pressure = np.linspace(min(low, 0.0), max(high, 0.0), 101)
        law = quantities.bellows if len(self.laws) > 1 else quantities.bellow
        found = [0.0]
        for k, name in enumerate(("compliance", "curvature_per_pressure", "stretch_per_pressure")):
            slopes = np.broadcast_to(getattr(law, name), len(self.laws))
            for slope, own in zip(slopes, self.laws, strict=True):
                straight = slope * pressure
                size = float(np.ptp(straight)) or 1.0
                found.append(float(np.max(np.abs(own.loaded(pressure)[k] - straight))) / size)
        return max(found)

    def reason(self, quantities: SceneQuantities) -> str:
        if self.snap:
            return "the measured curve replaces the linear coefficients and snaps through"
        if not self.laws:
            return "no curve is given (bellows.curve)"
        return "the measured curve replaces the linear coefficients"

    def wall(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Volume beyond rest, curvature and stretch at gauge pressures, any shape."""
        if len(self.laws) == 1:
            return self.laws[0].loaded(pressure)
        columns = np.moveaxis(pressure, -1, 0)
        each = (law.loaded(own) for law, own in zip(self.laws, columns, strict=True))
        volume, curvature, stretch = (np.stack(own, axis=-1) for own in zip(*each, strict=True))
        return volume, curvature, stretch

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(wall=self.wall)

    def refusals(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Fault]:
        distributed = Trait.DISTRIBUTED_PRESSURE
        if self.name not in active or distributed in traits_of(active):
            return
        if snaps(quantities.scene.bellows):
            remedy = " or ".join(f"effects.{name}" for name in names_with(distributed))
            yield Fault(
                "between some rows the pressure falls as the bellow swells: it snaps through, at a "
                f"speed that only flow in the tubes limits. Set {remedy} to on or auto.",
                "bellows.curve",
            )

    def warnings(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Notice]:
        falling = [rows for rows in _curves(quantities) if falls(rows)]
        if falling and quantities.scene.effects.mode(self.name) != "off":
            peak = min(first_peak(rows) for rows in falling)
            yield Notice(
                "snapping_curve",
                f"bellows.curve makes a bellow snap through at {peak / 1e3:.4g} kPa "
                "gauge: identical bellows then swell one after another, in an order that small "
                "differences decide",
                "bellows.curve",
            )

    def limits(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Limit]:
        """The measured range; without a curve, what a linear law can be trusted for."""
        names, law = quantities.graph.bellows, quantities.bellows

        def swollen(peak: Peak) -> Notice:
            return Notice(
                "large_volume",
                f"{names[peak.column]} swells to {peak.value:.3g} times its rest volume: beyond "
                f"about {LINEAR_WALL_VOLUME:.2g} times, an elastomer's wall softens; give a "
                "measured curve (bellows.curve)",
                names[peak.column],
                peak.time_s,
            )

        if self.name not in active:
            yield Limit(lambda b: b.volume / law.rest_volume, LINEAR_WALL_VOLUME, swollen)
            return
        # A curve may fall in between.
        ranges = [(min(r)[0], max(r)[0]) for r in _curves(quantities)]
        lows, highs = np.broadcast_to(np.array(ranges), (len(names), 2)).T

        def extrapolated(peak: Peak) -> Notice:
            k = peak.column % len(names)
            name, low, high = names[k], lows[k], highs[k]
            reached = high + peak.value if peak.column < len(names) else low - peak.value
            return Notice(
                "extrapolated_curve",
                f"{name} reaches {reached / 1e3:.4g} kPa gauge, outside the measured range of "
                f"{low / 1e3:.4g} to {high / 1e3:.4g} kPa: the curve is extrapolated linearly",
                name,
                peak.time_s,
            )

        yield Limit(
            lambda b: np.concatenate([b.pressure - highs, lows - b.pressure], axis=1),
            0.0,
            extrapolated,
        )

    def join(self, system: System) -> None:
        rest = system.of_bellows("rest_volume", system.bellows.rest_volume)
        wall = self._walls(system, rest)
        if isinstance(wall, MeasuredWall) or not self.snap:
            system.wall = wall
            return
        filled = [law.filled for law in self.laws if isinstance(law, SnapCurves)]
        system.let_snap(wall, np.array(filled) if len(filled) > 1 else filled[0])

    def _walls(self, system: System, rest: ca.SX) -> MeasuredWall | SnappingWall | OwnWalls:
        """The law of all bellows, or a law of its own for each; ``rest``: one volume or (B,)."""
        if len(self.laws) == 1:
            return _wall(self.laws[0], rest)
        own = dict(zip(system.graph.bellows, self.laws, strict=True))
        each = ca.vertsplit(ca.repmat(rest, len(own) // rest.numel(), 1))
        walls = (_wall(own[name], v) for name, v in zip(system.pressure, each, strict=True))
        return OwnWalls(tuple(walls))


def _wall(law: PressureCurves | SnapCurves, rest_volume: ca.SX) -> MeasuredWall | SnappingWall:
    if isinstance(law, SnapCurves):
        return SnappingWall(rest_volume, law.pressure, law.curvature, law.stretch)
    return MeasuredWall(rest_volume, law.volume, law.curvature, law.stretch)


def _curves(quantities: SceneQuantities) -> list[Sequence[tuple[float, ...]]]:
    """Rows of the measured curves, pressure first."""
    return [curve.rows or () for curve in quantities.scene.bellows.curves]
