"""Where a gait leaves what the equations of the legs hold for."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.physics import tube
from viscodesign.physics.tube import LAMINAR_REYNOLDS
from viscodesign.results.findings import Notice
from viscodesign.robot.leg_network import barrel_volume, flow
from viscodesign.robot.march import RecordedWalk
from viscodesign.robot.robot_model import LegGroup, RobotModel

ENERGY_IMBALANCE = 1e-2
"""Part of the work from which on the balance of energy is told to be poor."""


def gait_warnings(model: RobotModel, recording: RecordedWalk) -> Iterator[Notice]:
    """Turbulent tubes and bellows below their floor, over the recorded rows; lost energy."""
    rows = recording.motion.rows
    sources = recording.motion.pressure[rows]
    for index, group in enumerate(model.groups):
        pressures = np.array([state.legs[index].pressure for state in recording.states])
        yield from _turbulence(model, group, pressures, sources)
        yield from _collapse(group, _least(model, recording, index))
    if not recording.energy.imbalance_rel <= ENERGY_IMBALANCE:
        yield Notice(
            "energy_imbalance",
            f"the residual of the energy balance is {recording.energy.imbalance_rel:.2g} of the "
            f"work done (limit {ENERGY_IMBALANCE:g}); use shorter steps: a smaller accuracy",
        )


def _turbulence(
    model: RobotModel, group: LegGroup, pressures: np.ndarray, sources: np.ndarray
) -> Iterator[Notice]:
    design = group.functions.design
    ends = np.concatenate([pressures, sources[:, group.sources, None]], axis=2)
    found = []
    for own in design.tubes:
        rate = flow(design.fluid, own, ends[..., own.start], ends[..., own.end], np)
        fluid = design.fluid
        number = tube.reynolds_number(rate, fluid.density, fluid.viscosity, own.radius)
        found.append((float(np.max(number)), own.name))
    worst, name = max(found, default=(0.0, ""))
    count = sum(number > LAMINAR_REYNOLDS for number, _ in found)
    if count:
        yield Notice(
            "turbulent_flow",
            f"the Reynolds number exceeds {LAMINAR_REYNOLDS:.0f} in {count} of {len(found)} tubes "
            f"and reaches {worst:.4g} in {name}: slow viscous flow does not hold there",
            name,
        )


def emptied(model: RobotModel, recording: RecordedWalk) -> str:
    """What is said of a bellow whose volume is zero or less; empty where each has some."""
    found = [_least(model, recording, index) for index in range(len(model.groups))]
    worst = min(found, key=lambda own: own.share)
    if worst.share > 0.0:
        return ""
    return (
        f"{worst.bellow} of {worst.leg} shrinks to {worst.share:.3g} of its rest volume: no fluid "
        "fills less than nothing. Use smaller strokes, or a higher gauge_pressure"
    )


@dataclass(frozen=True)
class _LeastVolume:
    """The bellow of a group of legs that shrinks most."""

    leg: str
    bellow: str
    share: float
    """Its least volume over that at rest [1]."""


def _least(model: RobotModel, recording: RecordedWalk, index: int) -> _LeastVolume:
    group = model.groups[index]
    design, count = group.functions.design, group.functions.design.bellows
    pressures = np.array([state.legs[index].pressure[:, :count] for state in recording.states])
    contents = np.array([state.legs[index].content[:, :count] for state in recording.states])
    volumes = barrel_volume(design.fluid, contents, pressures)
    least = np.unravel_index(int(np.argmin(volumes)), volumes.shape)
    leg, bellow = model.leg_names[group.legs[least[1]]], design.nodes[least[2]]
    return _LeastVolume(leg, bellow, float(volumes[least] / design.bellow.rest_volume))


def _collapse(group: LegGroup, least: _LeastVolume) -> Iterator[Notice]:
    law = group.functions.design.bellow
    floor = law.floor_volume / law.rest_volume
    if least.share < floor:
        yield Notice(
            "negative_volume",
            f"{least.bellow} of {least.leg} shrinks to {least.share:.3g} of its rest volume, below "
            f"the minimum of {floor:.3g}: its walls would meet",
            f"{least.leg}.{least.bellow}",
        )
