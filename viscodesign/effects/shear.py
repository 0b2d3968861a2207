"""Shear: cross sections turn against the axis where a transverse force acts."""

from __future__ import annotations

import math
from typing import Any, ClassVar, Self

import numpy as np

from viscodesign.effects.base import Effect
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.scene_number import Numbers, mean_of
from viscodesign.model.system import System
from viscodesign.physics import beam
from viscodesign.references import LiteratureReference
from viscodesign.scene.scene import Scene

EVEN_LOAD = 4.0
"""Deflection of a cantilever's tip under an even load by shear, q l^2/(2 kappa G A), over that by
bending, q l^4/(8 EI), times kappa G A l^2/EI."""
FIRST_MODE = 3.5160**2 / (math.pi / 2) ** 2
"""Squared frequency of the first bending mode over that of the first mode of shear alone, times
kappa G A l^2/EI. By Dunkerley, that mode takes so much longer, squared."""
UNSHEARABLE = 300.0
"""Shear stiffness over what the accuracy asks for under a load of EI/l^2: a stiffer rod only makes
its equations harder to solve. Under ten times that load a thirtieth of the accuracy is lost."""
UNDAMPED_SHEAR = 10.0
"""Factor on it where nothing damps the higher modes, which shear slows more than the first."""


@dataclass(frozen=True, eq=False)
class Shear(Effect):
    """Shear strain of the rod, Q/(kappa G A); off: cross sections stay perpendicular to the axis.

    With `rotary_inertia` it is Timoshenko's beam, for large deflections the rod of Simo and
    Reissner. An unloaded actuator has no transverse forces, whatever its pressures.
    """

    name: ClassVar[str] = "shear"
    order: ClassVar[int] = 3  # before everything that says something of the rod
    formula: ClassVar[str] = "4 E I / (kappa G A l^2), solid: E h_s^2 / (3 kappa G l^2)"
    validity: ClassVar[str] = (
        "A shear stiffness that is constant along the actuator; cross sections stay plane. "
        "Bellows make it a guess that actuator.shear_factor replaces."
    )
    source: ClassVar[str] = "Timoshenko's beam; Reissner (1972) for large deflections."
    references: ClassVar[tuple[LiteratureReference, ...]] = (
        LiteratureReference(
            "reissner1972",
            "article",
            {
                "author": "Reissner, Eric",
                "title": "On one-dimensional finite-strain beam theory: the plane problem",
                "journal": "Journal of Applied Mathematics and Physics (ZAMP)",
                "volume": "23",
                "year": "1972",
            },
        ),
    )
    keys: ClassVar[tuple[str, ...]] = ("actuator.shear_factor", "actuator.height")
    own_rule: ClassVar[str] = (
        "Only a spec that names it has it, whatever `others` says: `effects.shear: on` includes "
        "it, `auto` weighs it."
    )

    stiffnesses: Numbers
    """kappa G A, one for all sections or of each (S,) [N]."""
    bending_stiffness: float
    """EI [N m2]."""

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        own = quantities.scene.sections
        modulus, height, width = (own.each(n) for n in ("youngs_modulus", "height", "width"))
        stiffness: Any = beam.shear_stiffness(modulus, height, width, _factors(quantities.scene))
        if own.blocked is not None:
            stiffness = np.where(own.blocked, np.inf, stiffness)
        most = UNSHEARABLE / quantities.accuracy * quantities.bending_force
        return cls(np.minimum(stiffness, most), quantities.body.bending_stiffness)

    @property
    def stiffness(self) -> float:
        """kappa G A; where sections differ, of a uniform rod that shears as much [N]."""
        found: float = 1 / mean_of(1 / self.stiffnesses)
        return found if isinstance(self.stiffnesses, np.ndarray) else self.stiffnesses

    def present(self, quantities: SceneQuantities) -> bool:
        """Only where a spec names it, whatever `others` says.

        Stiffnesses in bending are mostly those of a loaded cantilever, as the paper's is, and
        contain shear then.
        """
        return self.name in quantities.scene.effects.modes

    def _softness(self, length: float) -> float:
        """EI/(kappa G A l^2) [1]; ``length`` l [m]."""
        return self.bending_stiffness / (self.stiffness * length**2)

    def weight(self, quantities: SceneQuantities) -> float:
        return EVEN_LOAD * self._softness(quantities.body.length)

    def reason(self, quantities: SceneQuantities) -> str:
        share = (
            f"shear adds {100 * self.weight(quantities):.2g} % to the deflection by an even load"
        )
        if self.present(quantities):
            return share
        return f"the spec does not name it (effects.{self.name}: auto weighs it); {share}"

    def modal_mass(self, length: float, is_damped: bool) -> float:
        """Mass that would slow the first bending mode as shear does, relative [1]."""
        share = FIRST_MODE * (1.0 if is_damped else UNDAMPED_SHEAR)
        return share * self._softness(length)

    def estimate_term(self) -> EstimateTerm:
        return EstimateTerm(shear_compliance=1 / self.stiffness, modal_mass=self.modal_mass)

    def join(self, system: System) -> None:
        system.let_shear(system.of_sections("shear.stiffness", self.stiffnesses))


def _factors(scene: Scene) -> Any:
    """Factor of the stiffness in shear, one for all sections or (S,): as in tension if absent."""
    own, usual = scene.sections.each("shear_factor"), scene.sections.each("extension_factor")
    if isinstance(own, np.ndarray) and scene.actuator.shear_factor is None:
        each = zip(own, np.broadcast_to(usual, own.shape), strict=True)
        return np.array([tension if shear is None else shear for shear, tension in each])
    return usual if own is None else own
