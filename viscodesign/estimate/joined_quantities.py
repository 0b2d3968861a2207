"""The numbers of actuators that share fluid: those of the one that each term moves most."""

from __future__ import annotations

from collections.abc import Callable

from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.lazy_dataclass import dataclass
from viscodesign.physics import beam
from viscodesign.results.findings import Scales
from viscodesign.scene.scene import Scene
from viscodesign.storage.cached_property import cached_property


def quantities_of(scene: Scene) -> SceneQuantities:
    """The quantities of a scene, of one actuator or of several that share fluid."""
    is_joined = isinstance(scene, Scene) and scene.members
    return JoinedQuantities(scene) if is_joined else SceneQuantities(scene)


@dataclass(frozen=True, eq=False)
class JoinedQuantities(SceneQuantities):
    """Loads and turns are the largest of any actuator, so that no effect is taken for too small."""

    @cached_property
    def members(self) -> list[SceneQuantities]:
        """Each actuator by itself."""
        return [SceneQuantities(own) for own in self.scene.members.values()]

    def _largest(self, of: Callable[[SceneQuantities], float]) -> float:
        return max(of(own) for own in self.members)

    @property
    def requested_m(self) -> float:
        """The accuracy of the shortest, which then holds of all [m]."""
        return self.accuracy * min(self.body.lengths)

    @cached_property
    def scales(self) -> Scales:
        """The four characteristic times, those of the slowest rod."""
        found = super().scales
        slowest = max(
            beam.elastic_inertial_time(own.mass_per_length, own.length, own.bending_stiffness)
            for own in self.body.members
        )
        return Scales(t_s=slowest, t_f=found.t_f, t_i=found.t_i, t_net=found.t_net)

    @property
    def tip_force(self) -> float:
        return self._largest(lambda own: own.tip_force)

    @property
    def solid_mass(self) -> float:
        return self._largest(lambda own: own.solid_mass)

    @property
    def carried_mass(self) -> float:
        return self._largest(lambda own: own.carried_mass)

    @property
    def acceleration(self) -> float:
        return self._largest(lambda own: own.acceleration)

    @property
    def bending_force(self) -> float:
        """Scale of forces of the softest [N]."""
        return min(own.bending_force for own in self.members)

    @property
    def largest_turn(self) -> float:
        turns = self.bellows.curvature_per_pressure * self.scene.sections.of_bellows(
            self.body.section_lengths
        )
        return self.pressure_range * float(abs(turns).max())

    @property
    def _largest_drop(self) -> float:
        return self._largest(lambda own: own._largest_drop)
