"""Where a gait leaves what the equations of the legs hold for."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from viscodesign.physics import tube
from viscodesign.results.findings import Notice
from viscodesign.robot.leg_network import barrel_volume, flow
from viscodesign.robot.march import RecordedWalk
from viscodesign.robot.robot_model import LegGroup, RobotModel

LAMINAR_REYNOLDS = 2300.0


def gait_warnings(model: RobotModel, recording: RecordedWalk) -> Iterator[Notice]:
    """Turbulent tubes and bellows below their floor, over the recorded rows."""
    rows = recording.motion.rows
    sources = recording.motion.pressure[rows]
    for index, group in enumerate(model.groups):
        pressures = np.array([state.legs[index].pressure for state in recording.states])
        contents = np.array([state.legs[index].content for state in recording.states])
        yield from _turbulence(model, group, pressures, sources)
        yield from _collapse(model, group, pressures, contents)


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


def _collapse(
    model: RobotModel, group: LegGroup, pressures: np.ndarray, contents: np.ndarray
) -> Iterator[Notice]:
    design, count = group.functions.design, group.functions.design.bellows
    volumes = barrel_volume(design.fluid, contents[..., :count], pressures[..., :count])
    least = np.unravel_index(int(np.argmin(volumes)), volumes.shape)
    if volumes[least] < design.bellow.floor_volume:
        leg, bellow = model.leg_names[group.legs[least[1]]], design.nodes[least[2]]
        share = float(volumes[least] / design.bellow.rest_volume)
        yield Notice(
            "negative_volume",
            f"{bellow} of {leg} shrinks to {share:.3g} of its rest volume, below the minimum of "
            f"{design.bellow.floor_volume / design.bellow.rest_volume:.3g}: its walls would meet",
            f"{leg}.{bellow}",
        )
