"""How stiff the tip of a leg is against a force across it."""

from __future__ import annotations

import numpy as np

from viscodesign.robot.leg_equations import matrices
from viscodesign.robot.robot_model import LegGroup, LegStates
from viscodesign.robot.stance import Stance


def tip_stiffness(found: Stance) -> float:
    """Force along x over displacement of a leg's tip [N/m], the mean of all legs.

    At the stance's load along the leg; the tip is free to turn.
    """
    every = [
        _of_group(group, legs) for group, legs in zip(found.model.groups, found.legs, strict=True)
    ]
    return float(np.mean(np.concatenate(every)))


def _of_group(group: LegGroup, legs: LegStates) -> np.ndarray:
    """Stiffness of the tips of a group (l,), their loads kept along the legs."""
    count = len(group.legs)
    load = np.zeros_like(legs.load)
    load[:, 1] = legs.load[:, 1]
    still = [legs.pressure, legs.strains, np.zeros((count, 2))]
    tip, by_load, _, _ = group.functions.hanging.rows([load, *still], count)
    flexibility = matrices(by_load, 3)
    z = tip[:, 1]
    # The moment at the tip, M_0 - F_x z + F_z x, stays zero: how M_0 goes with F_x.
    arm = (z - load[:, 1] * flexibility[:, 0, 0]) / (1 + load[:, 1] * flexibility[:, 0, 2])
    return np.asarray(1 / (flexibility[:, 0, 0] + flexibility[:, 0, 2] * arm))
