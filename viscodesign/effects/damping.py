"""Material damping: the elastomer loses work when it is strained."""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar, Self

from viscodesign.effects.base import Effect, Trait
from viscodesign.errors import Fault
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.scene_number import Numbers, mean_of
from viscodesign.model.system import System
from viscodesign.physics.timescales import LARGEST_TIME_RATIO


@dataclass(frozen=True, eq=False)
class Damping(Effect):
    """Kelvin-Voigt on the total strain rates, proportional to stiffness.

    An assumption of this model, not of the paper. A bending mode of angular
    frequency w has the damping ratio damping_time w / 2.
    """

    name: ClassVar[str] = "damping"
    order: ClassVar[int] = 40
    # Without it a rod with inertia would ring for ever, and its steps become no cheaper.
    free_with: ClassVar[str] = "inertia"
    formula: ClassVar[str] = "t_v / t_s"
    traits: ClassVar[frozenset[Trait]] = frozenset({Trait.ROD_DAMPING})
    validity: ClassVar[str] = "A loss that grows with frequency; 1 ms is a guess for silicone."
    source: ClassVar[str] = "The Kelvin-Voigt model; the paper has no damping."
    keys: ClassVar[tuple[str, ...]] = ("actuator.damping_time",)

    times: Numbers
    """Retardation time, one for all sections or of each (S,) [s]."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        return cls(quantities.scene.sections.each("damping_time"))

    @property
    def damping_time(self) -> float:
        """The retardation time; where sections differ, the mean [s]."""
        found: float = mean_of(self.times)
        return found

    def present(self, quantities: SceneQuantities) -> bool:
        return self.damping_time > 0.0

    def weight(self, quantities: SceneQuantities) -> float:
        return self.damping_time / quantities.scales.t_s

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.present(quantities):
            return "actuator.damping_time is zero"
        words = "retardation time is" if self.times is self.damping_time else "times have the mean"
        return f"the Kelvin-Voigt {words} {self.damping_time:.3g} s"

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(damping_time=self.damping_time)

    def numeric_faults(self, quantities: SceneQuantities) -> Iterator[Fault]:
        share = self.damping_time / quantities.scene.run.duration
        if not share < LARGEST_TIME_RATIO:
            yield Fault(
                f"{self.damping_time:.3g} s is {share:.2g} times run.duration, too far "
                "apart for double precision",
                "actuator.damping_time",
            )

    def join(self, system: System) -> None:
        time = system.of_sections("damping_time", self.times)
        for power in system.rod.dissipation_powers(time):
            system.dissipation_power += power
