"""The rod by MuJoCo: a chain of rigid links with sprung hinges.

MuJoCo's cable is such a chain too, and neither stretches. In the cycles and under 1 g this
is not to be seen beside the chain's own error; under 100 g the rod's stretch matters, and
the chain comes to another motion however fine it is.
Links of length h turn at their ends against EI/h; at the clamp half a link's curvature
lies before the hinge, so there the spring is 2 EI/h. A uniform intrinsic curvature k is
the couple EI k on every hinge (in the place of a rest angle that moves), by motors.

As an expert would: `mujoco.rollout`, which steps in C with all motor commands given
beforehand, contacts off, positions from the joint angles at the output times alone.
"""

from __future__ import annotations

from abc import ABC
from collections.abc import Callable
from typing import Any, ClassVar

import numpy as np
import rod

DAMPING = 0.6
"""Time of the hinges' damping over the step; below a half, the steps would blow up."""


class MuJoCo(ABC):
    """One of its integrators."""

    name: ClassVar[str]
    integrator: ClassVar[str]
    ladders: ClassVar[dict[str, tuple[tuple[int, float], ...]]]
    """Links and step [s], about the largest stable one, for each case."""
    damped: ClassVar[tuple[str, ...]] = ()
    """Cases with damping in the hinges."""

    def __init__(self, case: rod.RodCase) -> None:
        self.case = case

    def settings(self) -> list[dict[str, Any]]:
        """Links and steps, coarse to fine."""
        damping = DAMPING if self.case.name in self.damped else 0.0
        ladder = self.ladders[self.case.name]
        return [{"links": n, "step_s": h, "damping_s": damping * h} for n, h in ladder]

    def prepare(self, setting: dict[str, Any]) -> Callable[[], np.ndarray]:
        """Compile the model and lay out the motors' commands."""
        import mujoco
        from mujoco import rollout

        case, links, step = self.case, setting["links"], setting["step_s"]
        model = mujoco.MjModel.from_xml_string(self.xml(**setting))
        data = mujoco.MjData(model)
        state = np.zeros(mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS))
        steps, every = round(case.duration / step), round(case.times[1] / step)
        middles = (np.arange(steps) + 0.5) * step
        couple = rod.BENDING_STIFFNESS * np.array([case.curvature(t) for t in middles])
        control = np.repeat(couple[:, None], links, axis=1) if case.gravity == 0.0 else None

        def run() -> np.ndarray:
            found, _ = rollout.rollout(model, data, state, control, nstep=steps)
            angles = found[0, every - 1 :: every, 1 : 1 + links]
            return np.vstack([[0.0, rod.LENGTH], tips(angles)])

        return run

    def xml(self, links: int, step_s: float, damping_s: float) -> str:
        """The model: +z of the rod is MuJoCo's z, hinges turn about y."""
        case, h = self.case, rod.LENGTH / links
        mass = rod.MASS_PER_LENGTH * h
        about = mass * h**2 / 12
        body = ""
        for k in reversed(range(links)):
            stiffness = rod.BENDING_STIFFNESS / h * (2 if k == 0 else 1)
            spring = f'stiffness="{stiffness}" damping="{damping_s * stiffness}"'
            body = (
                f'<body pos="0 0 {h if k else 0}"><joint name="j{k}" type="hinge" axis="0 1 0" '
                f'{spring}/><inertial pos="0 0 {h / 2}" mass="{mass}" '
                f'diaginertia="{about} {about} {about}"/>{body}</body>'
            )
        motors = "".join(f'<motor joint="j{k}"/>' for k in range(links))
        return (
            f'<mujoco><option timestep="{step_s}" gravity="{case.gravity} 0 0" '
            f'integrator="{self.integrator}"><flag contact="disable" constraint="disable"/>'
            f"</option><worldbody>{body}</worldbody>"
            + (f"<actuator>{motors}</actuator>" if case.gravity == 0.0 else "")
            + "</mujoco>"
        )


def tips(angles: np.ndarray) -> np.ndarray:
    """Tips (T, 2) [m] of chains with joint angles (T, n) [rad]."""
    turned, h = np.cumsum(angles, axis=1), rod.LENGTH / angles.shape[1]
    return h * np.stack([np.sum(np.sin(turned), axis=1), np.sum(np.cos(turned), axis=1)], axis=1)


UNDAMPED = ((2, 1e-3), (3, 1e-3), (4, 5e-4), (6, 2e-4), (8, 1e-4), (12, 5e-5), (16, 2e-5))
RELEASED = ((8, 1e-4), (16, 2e-5), (24, 1e-5), (32, 5e-6), (48, 2e-6))
SLOW = ((3, 2.5e-2), (4, 1e-2), (6, 1e-2), (8, 5e-3), (12, 2.5e-3), (24, 1e-3), (32, 5e-4))


class ChainImplicit(MuJoCo):
    """Semi-implicit Euler steps with implicit damping, MuJoCo's own recommendation.

    The slow cycle hardly knows inertia. There an expert adds damping, which MuJoCo takes
    implicitly and which lets steps be far larger; the others are undamped.
    """

    name = "MuJoCo 4.0 (chain, implicitfast)"
    integrator = "implicitfast"
    ladders: ClassVar = {
        "cycle_fast": UNDAMPED,
        "cycle_slow": SLOW,
        "release": RELEASED,
        "release_heavy": RELEASED,
    }
    damped = ("cycle_slow",)


class ChainRungeKutta(MuJoCo):
    """Explicit, of order 4, its step held down by the stiffest mode."""

    name = "MuJoCo 4.0 (chain, RK4)"
    integrator = "RK4"
    ladders: ClassVar = {
        "cycle_fast": UNDAMPED,
        "cycle_slow": UNDAMPED,
        "release": RELEASED,
        "release_heavy": RELEASED,
    }
