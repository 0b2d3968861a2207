"""`fluid: silicone oil 1000 cSt`."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from viscodesign.scene.fluids.base import FluidProperties, NamedFluid
from viscodesign.scene.spec_part import invalid_at

AT = 298.15
"""Temperature at which oils are graded, 25 degC [K]."""
MIN_GRADE, MAX_GRADE = 20.0, 100_000.0
GRADES = (20.0, 50.0, 100.0, 350.0, 1e3, 1e4, 1e5)
DENSITIES = (950.0, 960.0, 965.0, 970.0, 971.0, 974.0, 977.0)
"""At 25 degC, by grade [kg/m3]."""
EXPANSION = 9.6e-4
"""Expansion of volume with temperature [1/K]."""


class SiliconeOil(NamedFluid):
    """Poly(dimethylsiloxane) with methyl ends, by its kinematic viscosity at 25 degC.

    Viscosity follows log10(nu/nu_25) = 763.1/T - 2.559, T in K: Kuo, Poly(dimethylsiloxane), in
    Polymer Data Handbook, Oxford 1999; of one grade to another it differs by about 10 % at the
    ends of the range. Density and expansion are typical of makers' tables, within 1 %. The bulk
    modulus depends on the grade; give a custom fluid where a syringe is the input.
    """

    name: ClassVar[str] = "silicone oil"
    other_names: ClassVar[tuple[str, ...]] = ("pdms", "silicone", "dimethicone", "silicon oil")
    graded_like: ClassVar[str] = "silicone oil 1000 cSt"
    min_temperature: ClassVar[float] = 248.15
    max_temperature: ClassVar[float] = 373.15
    has_stiffness: ClassVar[bool] = False

    @classmethod
    def properties(cls, temperature: float, pressure: float, fraction: float) -> FluidProperties:
        del pressure, fraction
        if not MIN_GRADE <= cls.grade <= MAX_GRADE:
            raise invalid_at(
                "name",
                f"silicone oils are known from {MIN_GRADE:g} to {MAX_GRADE:g} cSt; got "
                f"{cls.grade:g} cSt. Give viscosity and density instead",
            )
        kinematic = cls.grade * 1e-6 * 10 ** (763.1 * (1 / temperature - 1 / AT))
        graded = float(np.interp(np.log(cls.grade), np.log(GRADES), DENSITIES))
        density = graded / (1 + EXPANSION * (temperature - AT))
        return FluidProperties(f"{cls.name} {cls.grade:g} cSt", kinematic * density, density)
