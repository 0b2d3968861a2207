"""The rod by SoRoMoX (JAX): one strain-based segment with Legendre polynomials.

Its variable-strain model (GVS) with bending and stretch alone: no shear, and a rotary
inertia that is a thousandth of a round rod's of the same EI/EA. A uniform intrinsic
curvature k is a generalised force, EI k L on the constant part of the bending strain.
Integrated by the tool's own `rollout_to`, compiled as a whole, with diffrax's explicit
Tsit5 or its implicit Kvaerno5 under an adaptive step; `prepare` compiles.
"""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np
import rod

ROTARY = 1e-3
"""Rotary inertia over that of a round rod with the same EI/EA."""
MOST_STEPS = 4_000_000
LADDER = [(1, 0, 1e-2), (1, 0, 1e-3), (2, 0, 1e-3), (3, 0, 1e-4), (3, 1, 1e-4), (4, 2, 1e-5)]
HEAVY = [(1, 1, 1e-3), (2, 1, 1e-3), (3, 1, 1e-4), (4, 2, 1e-5)]
"""Degree of the bending strain, terms of the stretch and relative tolerance. Few, as each
takes a quarter of a minute to compile, and Kvaerno5 a whole one."""


class Soromox(ABC):
    """One of diffrax's solvers."""

    name: ClassVar[str]

    def __init__(self, case: rod.RodCase) -> None:
        self.case = case

    def settings(self) -> list[dict[str, Any]]:
        """Degrees and tolerances, coarse to fine; under 100 g it must stretch."""
        ladder = HEAVY if self.case.name == "release_heavy" else LADDER
        keys = ("degree", "stretch_terms", "rtol")
        return [dict(zip(keys, setting, strict=True)) for setting in ladder]

    @abstractmethod
    def solver(self, diffrax: Any) -> Any:
        """The solver."""

    def prepare(self, setting: dict[str, Any]) -> Callable[[], np.ndarray]:
        """Assemble and compile."""
        import jax

        jax.config.update("jax_enable_x64", True)
        import diffrax
        import jax.numpy as jnp
        from soromox.systems import SystemState

        case = self.case
        robot = _robot(setting["degree"], setting["stretch_terms"], case.gravity)
        count = robot.num_velocities
        # The bending strain's constant part is the first coordinate.
        push = jnp.zeros(count).at[0].set(rod.BENDING_STIFFNESS * rod.LENGTH)
        size = 1.0 if case.scale == rod.LENGTH else case.scale / rod.LENGTH
        control = diffrax.PIDController(rtol=setting["rtol"], atol=setting["rtol"] * size)

        def curvature(t: Any) -> Any:
            swing = 1 - jnp.cos(2 * math.pi * t / case.period)
            return rod.CURVATURE * swing / 2

        def environment(state: Any) -> tuple[Any, None]:
            return push * curvature(state.t), None

        @jax.jit
        def solve(y: Any) -> Any:
            found = robot.rollout_to(
                SystemState(t=jnp.array(0.0), y=y),
                environment_model=environment if case.gravity == 0.0 else None,
                t1=case.duration,
                solver_dt=1e-5,
                save_ts=jnp.asarray(case.times),
                solver=self.solver(diffrax),
                stepsize_controller=control,
                max_steps=MOST_STEPS,
            )
            tip = jnp.array(rod.LENGTH)
            poses = jax.vmap(lambda q: robot.forward_kinematics(q, tip))(found.y[:, :count])
            return poses[:, :3, 3]

        start = jnp.zeros(2 * count)
        compiled = solve.lower(start).compile()

        def run() -> np.ndarray:
            # The rod lies along the world's z and bends towards y.
            return np.asarray(compiled(start))[:, [1, 2]]

        return run


def _robot(degree: int, terms: int, gravity: float) -> Any:
    """A cantilever with bending about its z and stretch along its x."""
    import jax.numpy as jnp
    from soromox.systems import GVS, GVSSegment, JointSpec, LinkSpec, StrainBasisSpec

    ratio = rod.BENDING_STIFFNESS / rod.EXTENSION_STIFFNESS
    radius = 2 * math.sqrt(ratio * ROTARY)
    # In the coordinates: Legendre polynomials from 0 to 1 are orthogonal.
    bending = [rod.BENDING_STIFFNESS * rod.LENGTH / (2 * k + 1) for k in range(degree + 1)]
    stretch = [rod.EXTENSION_STIFFNESS * rod.LENGTH / (2 * k + 1) for k in range(terms)]
    stiffness = jnp.diag(jnp.array(bending + stretch))
    link = LinkSpec.circular(
        length=rod.LENGTH,
        density=rod.MASS_PER_LENGTH / (math.pi * radius**2),
        radius=radius,
        stiffness=stiffness,
        damping=jnp.zeros_like(stiffness),
        reference_strain=[0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
    )
    strains = ["kappa_z", "sigma_x"] if terms else ["kappa_z"]
    degrees = [0, 0, degree, max(terms - 1, 0), 0, 0]
    basis = StrainBasisSpec("legendre", strains, degrees)
    segment = GVSSegment(link, JointSpec(type="fixed"), basis, num_gauss_points=degree + 6)
    return GVS.from_segments([segment], gravity=jnp.array([0.0, gravity, 0.0]))


class Explicit(Soromox):
    """Tsit5, the tool's default, with an adaptive step."""

    name = "SoRoMoX 0.5 (Tsit5)"

    def solver(self, diffrax: Any) -> Any:
        return diffrax.Tsit5()


class Implicit(Soromox):
    """Kvaerno5, for stiff motion."""

    name = "SoRoMoX 0.5 (Kvaerno5)"

    def solver(self, diffrax: Any) -> Any:
        return diffrax.Kvaerno5()
