"""Syringes in the place of pressure sources: what a barrel stores, and the work of its plunger."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field

import casadi as ca

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.fluid import FluidLaw, Gas, Liquid
from viscodesign.model.scene_number import SCENE_NUMBER

SX = ca.SX


@dataclass(frozen=True)
class SyringeParameters:
    """A closed vessel with a plunger, in the place of a source of pressure."""

    full_volume: float = field(metadata=SCENE_NUMBER)
    """Volume in front of the plunger at its start [m3]."""
    bulk_modulus: float | None = field(metadata=SCENE_NUMBER)
    """Bulk modulus of a liquid [Pa]; None for a gas, which follows ``exponent``."""
    exponent: float = 1.0
    cushion: float = field(default=0.0, metadata=SCENE_NUMBER)
    """Gas beside a liquid, of the full volume, at the baseline pressure [m3]."""


class SyringeSymbols:
    """One syringe: pressure and plunger as symbols, and the barrel's laws.

    The barrel's fluid is always compressible, since the plunger's position is given. Where the
    network's fluid is not (``is_stiff``), the barrel has a law of its own.
    """

    def __init__(
        self,
        name: str,
        given: SyringeParameters,
        pushed_value: SX,
        baseline: SX,
        ambient: SX,
        parameter: Callable[[str, float], SX],
    ) -> None:
        self.pressure = SX.sym(f"pressure_{name}")
        self.pushed = SX.sym(f"pushed_{name}")
        """Volume that the plunger has pushed out, a symbol [m3]."""
        self.pushed_value = pushed_value
        """The same as a formula of the time [m3]."""
        self._ambient = ambient
        self._full_volume = parameter(f"syringe.{name}", given.full_volume)
        # The gas keeps the liquid's temperature.
        self._cushion_gas = Gas(ambient, 1.0)
        self._cushion_amount: SX | None = None
        """Gas beside the barrel's liquid, as volume at ambient density [m3]."""
        if given.cushion:
            volume = parameter(f"syringe.{name}.cushion", given.cushion)
            self._cushion_amount = volume * self._cushion_gas.density(baseline)
        self._fluid: FluidLaw = Gas(ambient, given.exponent)
        if given.bulk_modulus is not None:
            modulus = parameter(f"syringe.{name}.bulk_modulus", given.bulk_modulus)
            self._fluid = Liquid(modulus)

    def volume(self, is_stiff: bool) -> SX:
        """Volume in front of the plunger [m3]; of a stiff network's fluid, at ambient density."""
        if not is_stiff:
            return self._space()
        return self._space() * self._fluid.density(self.pressure)

    def plunger_pressure(self, is_stiff: bool) -> SX:
        """Work per volume that the plunger pushes out [Pa]."""
        return self._fluid.density_integral(self.pressure) if is_stiff else self.pressure

    def energies(self, is_stiff: bool) -> tuple[SX, SX]:
        """Energy stored by the barrel's own fluid, and by its cushion [J].

        The first is zero where the network's law covers it.
        """
        return self._fluid_energy() if is_stiff else SX(0), self._cushion_energy(is_stiff)

    def _space(self) -> SX:
        """Volume of fluid in front of the plunger [m3]."""
        return self._full_volume - self.pushed - self._cushion_volume()

    def _cushion_volume(self) -> SX:
        if self._cushion_amount is None:
            return SX(0)
        return self._cushion_amount / self._cushion_gas.density(self.pressure)

    def _fluid_energy(self) -> SX:
        law, pressure = self._fluid, self.pressure
        return self._space() * (pressure * law.density(pressure) - law.density_integral(pressure))

    def _cushion_energy(self, is_stiff: bool) -> SX:
        """Minus the integral of the plunger's work per volume over the gas's volume, by parts."""
        amount, pressure = self._cushion_amount, self.pressure
        if amount is None:
            return SX(0)
        work = self._cushion_gas.specific_work(pressure)
        stored = amount * work - self._cushion_volume() * self.plunger_pressure(is_stiff)
        if is_stiff:
            # The plunger's work per volume is p + p2/(2 K): the liquid is compressed as well.
            assert isinstance(self._fluid, Liquid), "a gas has no cushion"
            modulus = self._fluid.bulk_modulus
            stored += amount * self._ambient * (pressure - work) / modulus
        return stored
