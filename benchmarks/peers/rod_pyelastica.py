"""The rod by PyElastica: explicit position Verlet, with a clamp that is where it should be.

PyElastica's one-end clamp fixes the first node and the direction of the first element.
That element is then rigid and the rod begins to bend half an element late, an error of
first order. Here the rod begins half an element before the clamp, so that the fixed
element's middle, where its direction holds, is the clamp. Of this element only the half
beyond the clamp may stretch, so its extension and shear stiffness are doubled. Both are
of second order, as the rest of the method is.

Shear and rotary inertia cannot be left out, and PyElastica is unstable, at any step, where
shear is much stiffer than stretch. Stretch hardly matters but under 100 g, so elsewhere both
get `firmness` f times EA, and the rotary inertia is m EI/(f EA): errors by either fall with
1/f, the step with 1/f too; f is swept with the mesh. Under 100 g the stretch must stay. With
shear as stiff, or less, or more, and at a tenth of the stable step, the rod first strays by
5 to 20 % of its length and then blows up within 0.1 s; `release_heavy` is left out.
A uniform intrinsic curvature k is the couple EI k on the last element (the same energy).
The step is the largest stable one by the frequencies of a single element, or less.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
import rod

MARGIN = 0.85
"""Step over the largest stable one."""
CYCLES = [(4, 1.0), (6, 1.0), (6, 2.0), (8, 4.0), (12, 8.0), (16, 16.0), (24, 32.0)]
RELEASES = [(6, 8.0), (8, 32.0), (12, 64.0), (16, 128.0), (24, 256.0), (32, 512.0)]
"""Elements and firmness, refined together."""


class Verlet:
    """Position Verlet, PyElastica's own."""

    name = "PyElastica 1.0 (corrected clamp)"

    def __init__(self, case: rod.RodCase) -> None:
        self.case = case

    def settings(self) -> list[dict[str, Any]]:
        """Elements and firmness, coarse to fine."""
        ladder = CYCLES if self.case.gravity == 0.0 else RELEASES
        return [{"elements": n, "firmness": f} for n, f in ladder]

    def prepare(self, setting: dict[str, Any]) -> Callable[[], np.ndarray]:
        """Assemble; what changes in a run is kept, to be put back before the next."""
        import elastica

        case, count, firmness = self.case, setting["elements"], setting["firmness"]
        beam = _beam(elastica, count, firmness)
        simulator = _simulator(elastica, beam, case)
        stepper = elastica.PositionVerlet()
        start = {key: getattr(beam, key).copy() for key in CHANGING}
        interval = float(case.times[1])
        per_output = math.ceil(interval / (MARGIN * stable_step(count, firmness)))
        step = interval / per_output

        def run() -> np.ndarray:
            for key, value in start.items():
                getattr(beam, key)[...] = value
            time, found = np.float64(0.0), [beam.position_collection[[0, 2], -1].copy()]
            for _ in case.times[1:]:
                for _ in range(per_output):
                    time = stepper.step(simulator, time, step)
                found.append(beam.position_collection[[0, 2], -1].copy())
            return np.array(found)

        run_briefly(stepper, simulator, step)
        return run


CHANGING = (
    "position_collection",
    "velocity_collection",
    "director_collection",
    "omega_collection",
    "acceleration_collection",
    "alpha_collection",
)


def run_briefly(stepper: Any, simulator: Any, step: float) -> None:
    """One step, which compiles what is not yet compiled."""
    stepper.step(simulator, np.float64(0.0), step)


def stable_step(count: int, firmness: float) -> float:
    """Twice the inverse of the highest frequency of stretch, shear or bending [s]."""
    h = rod.LENGTH / (count - 0.5)
    mass, rotary = rod.MASS_PER_LENGTH, rod.MASS_PER_LENGTH * _ratio() / firmness
    shear = firmness * rod.EXTENSION_STIFFNESS
    stretch = 4 * shear / (mass * h**2)
    turn = (shear + 4 * rod.BENDING_STIFFNESS / h**2) / rotary
    return 2 / math.sqrt(stretch + turn)


def _ratio() -> float:
    return rod.BENDING_STIFFNESS / rod.EXTENSION_STIFFNESS


def _beam(elastica: Any, count: int, firmness: float) -> Any:
    """A straight rod from half an element before the clamp, its stiffnesses put in."""
    h = rod.LENGTH / (count - 0.5)
    radius = 2 * math.sqrt(_ratio())
    area = math.pi * radius**2
    beam = elastica.CosseratRod.straight_rod(
        count,
        np.array([0.0, 0.0, -h / 2]),
        np.array([0.0, 0.0, 1.0]),
        np.array([0.0, 1.0, 0.0]),
        rod.LENGTH + h / 2,
        radius,
        rod.MASS_PER_LENGTH / area,
        youngs_modulus=rod.EXTENSION_STIFFNESS / area,
        shear_modulus=rod.EXTENSION_STIFFNESS / area,
    )
    beam.shear_matrix[:] = firmness * rod.EXTENSION_STIFFNESS * np.eye(3)[:, :, None]
    beam.shear_matrix[:, :, 0] *= 2
    beam.bend_matrix[0, 0, :] = beam.bend_matrix[1, 1, :] = rod.BENDING_STIFFNESS
    beam.mass_second_moment_of_inertia[:] /= firmness
    beam.inv_mass_second_moment_of_inertia[:] *= firmness
    return beam


def _simulator(elastica: Any, beam: Any, case: rod.RodCase) -> Any:
    class Simulator(elastica.BaseSystemCollection, elastica.Constraints, elastica.Forcing):
        """What is simulated."""

    class Couple(elastica.NoForces):
        """About the normal of the plane, on the last element."""

        def apply_torques(self, system: Any, time: float = 0.0) -> None:
            couple = rod.BENDING_STIFFNESS * case.curvature(float(time))
            system.external_torques[0, -1] += couple

    simulator = Simulator()
    simulator.append(beam)
    simulator.constrain(beam).using(
        elastica.OneEndFixedBC, constrained_position_idx=(0,), constrained_director_idx=(0,)
    )
    if case.gravity > 0.0:
        pull = np.array([case.gravity, 0.0, 0.0])
        simulator.add_forcing_to(beam).using(elastica.GravityForces, acc_gravity=pull)
    else:
        simulator.add_forcing_to(beam).using(Couple)
    simulator.finalize()
    return simulator
