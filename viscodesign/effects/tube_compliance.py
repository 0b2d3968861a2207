"""Tube compliance: tubes hold fluid of their own, in soft walls or as a gas."""

from __future__ import annotations

from collections import defaultdict
from typing import ClassVar, Self

from viscodesign.effects.base import Effect, Trait
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.fluid import Incompressible
from viscodesign.model.graph import Tube
from viscodesign.model.system import System
from viscodesign.physics import tube
from viscodesign.scene.network import TubeWall


@dataclass(frozen=True, eq=False)
class TubeCompliance(Effect):
    """What tubes and feed lines store, half at each of their ends.

    A soft wall expands under pressure; a compressible gas stores volume however stiff the
    wall.
    """

    name: ClassVar[str] = "tube_compliance"
    order: ClassVar[int] = 15
    formula: ClassVar[str] = "storage of all tubes / storage of all bellows"
    needs: ClassVar[tuple[str, ...]] = ("pressure_distribution",)
    considers: ClassVar[str] = "gas_compressibility"
    traits: ClassVar[frozenset[Trait]] = frozenset({Trait.TUBE_STORAGE})
    validity: ClassVar[str] = (
        "Small strain of the wall; tubes short against a pressure wave, so that their storage "
        "may be lumped at their ends."
    )
    source: ClassVar[str] = "Lame's thick-walled tube in plane strain; ideal gas."
    keys: ClassVar[tuple[str, ...]] = ("network.tube_wall", "network.feed_line")

    wall: TubeWall | None
    gas_yields: bool
    tubes: tuple[Tube, ...]
    absolute: float
    """Polytropic exponent times the absolute pressure at which the gas is linearised [Pa]."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        scene = quantities.scene
        yields = scene.fluid.is_gas and scene.effects.mode(cls.considers) != "off"
        absolute = scene.ambient_pressure + scene.gauge_pressure
        return cls(
            scene.network.tube_wall,
            yields,
            quantities.graph.tubes,
            absolute * scene.fluid.polytropic_exponent,
        )

    def present(self, quantities: SceneQuantities) -> bool:
        return bool(self.tubes) and (self.wall is not None or self.gas_yields)

    def _wall_stores(self, t: Tube) -> float:
        """Volume per pressure of a tube's wall [m3/Pa]."""
        wall = self.wall
        if wall is None:
            return 0.0
        return tube.wall_compliance(
            wall.youngs_modulus, wall.poissons_ratio, wall.thickness, t.length, t.radius
        )

    def _stores(self, t: Tube) -> float:
        """The same with the compliance of its gas."""
        own = tube.inner_volume(t.length, t.radius) / self.absolute if self.gas_yields else 0.0
        return self._wall_stores(t) + own

    def weight(self, quantities: SceneQuantities) -> float:
        bellows = len(quantities.graph.bellows) * quantities.bellow.compliance
        return sum(self._stores(t) for t in self.tubes) / bellows

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.present(quantities):
            return "the tubes are rigid (no network.tube_wall) and their fluid is incompressible"
        return f"the tubes store {100 * self.weight(quantities):.3g} % of what the bellows store"

    def estimate_term(self) -> EstimateTerm:
        at: defaultdict[str, float] = defaultdict(float)
        for t in self.tubes:
            for end in (t.start, t.end):
                at[end] += self._stores(t) / 2
        return EstimateTerm(storage=tuple(sorted(at.items())))

    def node_storage(self, node: str, compressible: bool) -> tuple[float, float]:
        own = [t for t in self.tubes for end in (t.start, t.end) if end == node]
        volume = sum(tube.inner_volume(t.length, t.radius) / 2 for t in own)
        return volume if compressible else 0.0, sum(self._wall_stores(t) / 2 for t in own)

    def join(self, system: System) -> None:
        yields = not isinstance(system.fluid, Incompressible)
        for t in self.tubes:
            if self.wall is None and not yields:
                continue  # a stiff tube full of a fluid that does not yield
            store = system.parameter(f"tube_storage.{t.name}", self._wall_stores(t))
            volume = tube.inner_volume(t.length, t.radius) if yields else 0.0
            held = system.parameter(f"tube_volume.{t.name}", volume)
            for end in (t.start, t.end):
                system.store(end, held / 2, store / 2)
