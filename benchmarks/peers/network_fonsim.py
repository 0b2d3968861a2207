"""The network by FONSim, used as its authors would for these equations.

- A bellow is a `LinearAccumulator` (pressure linear in volume), a tube a `CircularTube`.
- FONSim's tube turns turbulent above Re = 2300, which the published pulse exceeds, and
  which nobody else solves here. Re is 4 rho Q/(pi d mu), the laminar loss mu L Q: a fluid
  a thousand times as viscous in tubes a thousandth as long, and light, has the same loss
  and stays laminar. So everyone solves the same equations.
- The fluid is `IdealIncompressible` in both cases. FONSim's air is compressible: another
  model, which is left out.
- Accumulators begin at the inlet's first pressure, p = k (V - V_0) + p_0 with p_0 that
  pressure, so that the start is in equilibrium. FONSim's pressures are absolute.
- `tustin`, its trapezoidal rule, of second order; the default is backward Euler. Steps
  are fixed, or adapted by its own test of the curvature.
- Values at the output times are read from the steps by cubic splines.

A step that does not converge is only printed by FONSim; here it ends the run.
"""

from __future__ import annotations

import contextlib
import io
from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any, ClassVar

import network
import numpy as np
from scipy.interpolate import CubicSpline

ATMOSPHERE = 101_325.0
"""[Pa]"""
SHORTER = 1000.0
"""By how much tubes are shortened and the fluid thickened."""
DENSITY = 1.0
"""Of the fluid [kg/m3]; it cancels, but for the Reynolds number."""


class Fonsim(ABC):
    """The chain in FONSim's components."""

    name: ClassVar[str]

    def __init__(self, case: network.NetworkCase) -> None:
        self.case = case

    @abstractmethod
    def settings(self) -> list[dict[str, Any]]:
        """Coarse to fine."""

    @abstractmethod
    def options(self, setting: dict[str, Any]) -> dict[str, Any]:
        """What a setting means to its `Simulation`."""

    def prepare(self, setting: dict[str, Any]) -> Callable[[], np.ndarray]:
        """Build the system once; a simulation starts from its initial values every time."""
        with contextlib.redirect_stdout(io.StringIO()):
            import fonsim

        system, bellows = chain(fonsim, self.case.fluid)
        options = {"duration": network.DURATION, "verbose": 0} | self.options(setting)
        simulation = fonsim.Simulation(system, **options)

        def run() -> np.ndarray:
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                simulation.run()
            if "failed to converge" in said.getvalue():
                raise RuntimeError(said.getvalue().strip().splitlines()[-1])
            absolute = np.column_stack([bellow.get("pressure") for bellow in bellows])
            return np.asarray(CubicSpline(simulation.times, absolute)(self.case.times)) - ATMOSPHERE

        return run


def chain(fonsim: Any, fluid: str) -> tuple[Any, list[Any]]:
    """The system, and its bellows along the chain."""
    viscosity = network.VISCOSITIES[fluid] * SHORTER
    liquid = fonsim.fluid.IdealIncompressible(name=fluid, rho=DENSITY, mu=viscosity)
    system = fonsim.System()
    inlet = fonsim.PressureSource(
        "inlet", fluid=liquid, pressure=lambda t: network.inlet_pressure(t) + ATMOSPHERE
    )
    system.add(inlet)
    bellows, before = [], "inlet"
    for k in range(1, network.BELLOWS + 1):
        tube = fonsim.CircularTube(
            f"tube{k}",
            fluid=liquid,
            length=network.TUBE_LENGTH / SHORTER,
            diameter=2 * network.TUBE_RADIUS,
        )
        bellow = fonsim.LinearAccumulator(
            f"bellow{k}",
            fluid=liquid,
            k=1 / network.COMPLIANCE,
            p0=network.inlet_pressure(0.0) + ATMOSPHERE,
            v0=network.REST_VOLUME,
        )
        system.add(tube, bellow)
        system.connect((f"tube{k}", "a"), (before, "a"))
        system.connect((f"tube{k}", "b"), (f"bellow{k}", "a"))
        before = f"bellow{k}"
        bellows.append(bellow)
    return system, bellows


class FixedStep(Fonsim):
    """Trapezoidal rule at a fixed step."""

    name = "FONSim (fixed step)"

    def settings(self) -> list[dict[str, Any]]:
        return [{"step_s": step} for step in (0.1, 0.05, 0.025, 0.01, 0.005)]

    def options(self, setting: dict[str, Any]) -> dict[str, Any]:
        return {
            "step": setting["step_s"],
            "discretization": "tustin",
            "relative_solving_tolerance": 1e-4,
        }


class AdaptiveStep(Fonsim):
    """Trapezoidal rule, steps adapted between limits by its relative tolerance."""

    name = "FONSim (adaptive step)"

    def settings(self) -> list[dict[str, Any]]:
        return [{"relative_tolerance": rtol} for rtol in (1.0, 0.3, 0.1, 0.03, 0.01)]

    def options(self, setting: dict[str, Any]) -> dict[str, Any]:
        return {
            "step": (1e-4, 0.2),
            "discretization": "tustin",
            "relative_solving_tolerance": setting["relative_tolerance"],
        }
