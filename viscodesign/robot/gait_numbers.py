"""What a gait asks of feet and pumps, and what its solution left of the balances."""

from __future__ import annotations

import numpy as np

from viscodesign.results.robot_motion import RobotMotion
from viscodesign.results.walk_study import ContactInvariants, FootUse, PumpUse
from viscodesign.robot.march import RecordedWalk
from viscodesign.robot.robot_model import RobotModel
from viscodesign.scene.robot import RobotPump

SLIDES = 1e-9
"""Way of a contact point in a step from which on it slides [m]."""


def foot_uses(motion: RobotMotion) -> dict[str, FootUse]:
    """What every foot does in the last cycle, by leg."""
    cycle = motion.last_cycle
    normal, friction = motion.normal[cycle], motion.friction[cycle]
    loaded = normal > 0.0
    slides = loaded & (np.abs(motion.slip[cycle]) > SLIDES)
    return {
        name: FootUse(
            lift_m=float(np.max(motion.feet[cycle, k, 1])),
            stance_share=float(np.mean(loaded[1:, k])),
            slide_share=float(np.mean(slides[1:, k])),
            peak_normal_n=float(np.max(normal[:, k])),
            peak_friction_n=float(np.max(np.abs(friction[:, k]))),
        )
        for k, name in enumerate(motion.legs)
    }


def pump_uses(motion: RobotMotion, pump: RobotPump | None) -> dict[str, PumpUse]:
    """What every source asks of its pump in the last cycle; the volume also of the whole run."""
    held = motion.barrel[motion.last_cycle]
    volumes, whole = np.ptp(held, axis=0), np.ptp(motion.barrel, axis=0)
    flows = np.max(np.abs(np.diff(held, axis=0)), axis=0) / motion.step
    rows = zip(motion.sources, np.column_stack([volumes, whole, flows]).tolist(), strict=True)
    return {
        name: PumpUse(volume, most, flow, _is_feasible(most, flow, pump))
        for name, (volume, most, flow) in rows
    }


def _is_feasible(volume: float, flow: float, pump: RobotPump | None) -> bool | None:
    if pump is None:
        return None
    most = np.inf if pump.stroke_time is None else pump.volume / pump.stroke_time
    return bool(volume <= pump.volume and flow <= most)


def invariants(model: RobotModel, recording: RecordedWalk) -> ContactInvariants:
    """What the whole motion left of contact conditions and balances."""
    motion = recording.motion
    gap, normal = motion.feet[1:, :, 1], motion.normal[1:]
    friction, work = motion.friction[1:], motion.friction[1:] * motion.slip[1:]
    excess = np.abs(friction) - model.feet.friction * normal
    return ContactInvariants(
        worst_penetration_m=abs(float(np.min(gap, initial=0.0))),
        worst_gap_force_n_m=float(np.max(np.abs(gap * normal))),
        worst_cone_excess_n=float(max(np.max(excess), 0.0)),
        friction_work_j=float(np.sum(work)),
        largest_friction_work_j=float(np.max(work)),
        force_imbalance_rel=_force_imbalance(model, recording),
        gas_mass_imbalance_rel=recording.gas_imbalance,
        energy_imbalance_rel=recording.energy.imbalance_rel,
    )


def _force_imbalance(model: RobotModel, recording: RecordedWalk) -> float:
    """Largest part of the weight that the change of momentum does not account for."""
    motion = recording.motion
    momentum = recording.velocities * model.masses
    across = momentum[:, [0, *range(4, model.size, 3)]].sum(axis=1)
    down = momentum[:, [1, *range(5, model.size, 3)]].sum(axis=1)
    forces = [motion.friction[1:].sum(axis=1), -motion.normal[1:].sum(axis=1)]
    worst = 0.0
    for total, pull, force in zip((across, down), model.gravity, forces, strict=True):
        left = np.diff(total) / motion.step - model.mass * pull - force
        worst = max(worst, float(np.max(np.abs(left[recording.whole]), initial=0.0)))
    return worst / model.weight
