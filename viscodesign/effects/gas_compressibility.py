"""Gas compressibility: a gas yields, in the bellows and along the tubes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, Self

from viscodesign.effects.base import Effect
from viscodesign.estimate.estimate import Sketch
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.fluid import Gas
from viscodesign.model.system import System
from viscodesign.physics import gas


@dataclass(frozen=True)
class GasCompressibility(Effect):
    """The gas's mass is conserved, not its volume.

    Its density follows the absolute pressure, (rho/rho_0)^n = P/P_0; a tube carries
    mass by the integral of density over pressure. Amounts and flows are told as
    volume at ambient density.
    """

    name: ClassVar[str] = "gas_compressibility"
    order: ClassVar[int] = 14
    formula: ClassVar[str] = "V_0 / (n_poly p_abs C)"
    validity: ClassVar[str] = (
        "A polytropic ideal gas of constant viscosity, far from choking (Mach number below 0.3)."
    )
    source: ClassVar[str] = "Ideal gas; Hagen-Poiseuille for each slice of a tube."
    keys: ClassVar[tuple[str, ...]] = (
        "fluid.gas_constant",
        "fluid.polytropic_exponent",
        "ambient_pressure",
    )

    is_gas: bool
    exponent: float

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        fluid = quantities.scene.fluid
        return cls(fluid.is_gas, fluid.polytropic_exponent)

    def present(self, quantities: SceneQuantities) -> bool:
        return self.is_gas

    def weight(self, quantities: SceneQuantities) -> float:
        law, scene = quantities.bellow, quantities.scene
        absolute = scene.ambient_pressure + scene.gauge_pressure
        return gas.gas_compliance(law.rest_volume, absolute, self.exponent) / law.compliance

    def reason(self, quantities: SceneQuantities) -> str:
        if not self.is_gas:
            return f"{quantities.scene.fluid.name} is a liquid (no gas constant)"
        return (
            f"the gas in a bellow stores {100 * self.weight(quantities):.3g} % of what its wall "
            "stores"
        )

    def sketch(self, sketch: Sketch) -> Sketch:
        return sketch.with_(gas_exponent=self.exponent)

    def join(self, system: System) -> None:
        system.fluid = Gas(system.ambient, self.exponent)
