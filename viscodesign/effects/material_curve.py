"""Material curve: measured laws of a bellow in the place of the linear ones."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import ClassVar, Self

import numpy as np

from viscodesign.effects.base import Effect, Trait
from viscodesign.effects.catalogue import names_with, traits_of
from viscodesign.errors import Fault
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.bellow_wall import MeasuredWall, SnappingWall
from viscodesign.model.system import System
from viscodesign.physics.curves import PiecewiseCubic
from viscodesign.physics.snapping import SnapCurves
from viscodesign.postprocess.motion_limits import Limit, Peak
from viscodesign.references import LiteratureReference
from viscodesign.results.findings import Notice
from viscodesign.scene.bellows import falls, first_peak, snaps
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
            },
        ),
    )
    keys: ClassVar[tuple[str, ...]] = ("bellows.curve",)

    curves: tuple[PiecewiseCubic, ...]
    """Volume beyond rest, curvature and stretch against gauge pressure; none without a curve."""
    snap: SnapCurves | None = None
    """In their place where the pressure falls."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        curve = quantities.scene.bellows.curve
        if curve is None:
            return cls(())
        rows = np.array(curve.rows, dtype=float)
        section = quantities.body.section_length
        if falls(curve.rows or ()):
            baseline = quantities.scene.gauge_pressure
            return cls((), SnapCurves.through(rows, quantities.bellow.length, section, baseline))
        factors = (quantities.bellow.length, 1 / section, 1 / section)
        found = tuple(
            PiecewiseCubic.monotone(rows[:, 0], rows[:, k + 1]).zeroed().scaled(factor)
            for k, factor in enumerate(factors)
        )
        return cls(found)

    def present(self, quantities: SceneQuantities) -> bool:
        return bool(self.curves) or self.snap is not None

    def weight(self, quantities: SceneQuantities) -> float:
        low, high = quantities.lowest_pressure, quantities.highest_pressure
        pressure = np.linspace(min(low, 0.0), max(high, 0.0), 101)
        law = quantities.bellow
        linear = (law.compliance, law.curvature_per_pressure, law.stretch_per_pressure)
        found = []
        for slope, measured in zip(linear, self.wall(pressure), strict=True):
            straight = slope * pressure
            size = float(np.ptp(straight)) or 1.0
            found.append(float(np.max(np.abs(measured - straight))) / size)
        return max(found)

    def reason(self, quantities: SceneQuantities) -> str:
        if self.snap is not None:
            return "the measured curve replaces the linear coefficients and snaps through"
        if not self.curves:
            return "no curve is given (bellows.curve)"
        return "the measured curve replaces the linear coefficients"

    def wall(self, pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Volume beyond rest, curvature and stretch at gauge pressures, any shape."""
        if self.snap is not None:
            return self.snap.loaded(pressure)
        volume, curvature, stretch = (curve(pressure) for curve in self.curves)
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
        rows = _rows(quantities)
        if falls(rows) and quantities.scene.effects.mode(self.name) != "off":
            yield Notice(
                "snapping_curve",
                f"bellows.curve makes a bellow snap through at {first_peak(rows) / 1e3:.4g} kPa "
                "gauge: identical bellows then swell one after another, in an order that small "
                "differences decide",
                "bellows.curve",
            )

    def limits(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Limit]:
        """The measured range; without a curve, what a linear law can be trusted for."""
        names, law = quantities.graph.bellows, quantities.bellow

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
        pressures = [row[0] for row in _rows(quantities)]
        low, high = min(pressures), max(pressures)  # a curve may fall in between

        def extrapolated(peak: Peak) -> Notice:
            name = names[peak.column % len(names)]
            reached = high + peak.value if peak.column < len(names) else low - peak.value
            return Notice(
                "extrapolated_curve",
                f"{name} reaches {reached / 1e3:.4g} kPa gauge, outside the measured range of "
                f"{low / 1e3:.4g} to {high / 1e3:.4g} kPa: the curve is extrapolated linearly",
                name,
                peak.time_s,
            )

        yield Limit(
            lambda b: np.concatenate([b.pressure - high, low - b.pressure], axis=1),
            0.0,
            extrapolated,
        )

    def join(self, system: System) -> None:
        rest = system.parameter("rest_volume", system.bellow.rest_volume)
        if self.snap is not None:
            wall = SnappingWall(rest, self.snap.pressure, self.snap.curvature, self.snap.stretch)
            system.let_snap(wall, self.snap.filled)
            return
        system.wall = MeasuredWall(rest, *self.curves)


def _rows(quantities: SceneQuantities) -> Sequence[tuple[float, ...]]:
    """Rows of the measured curve, pressure first; none without one."""
    curve = quantities.scene.bellows.curve
    return (curve.rows or ()) if curve is not None else ()
