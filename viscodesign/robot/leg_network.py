"""A leg's bellows and tubes: what they hold and what flows, as formulas."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import casadi as ca
import numpy as np

from viscodesign.physics import gas
from viscodesign.robot.leg_design import FilledFluid, LegDesign, LegTube
from viscodesign.robot.leg_rod import ShotRod

SX = ca.SX


def contents(design: LegDesign, pressures: SX, rod: ShotRod) -> list[SX]:
    """What every node holds, as volume at ambient density [m3]; junctions hold nothing."""
    held = []
    for k in range(design.bellows):
        j, side, law = design.sections[k], design.sides[k], design.bellow
        volume = law.rest_volume + law.compliance * pressures[k]
        volume += design.volume_per_force * rod.forces[j]
        volume += side * design.volume_per_moment * rod.moments[j]
        held.append(density(design.fluid, pressures[k], ca) * volume)
    return held + [SX(0)] * (len(design.nodes) - design.bellows)


def flow(fluid: FilledFluid, tube: LegTube, start: Any, end: Any, functions: Any) -> Any:
    """Flow through a tube between two gauge pressures, as volume at ambient density [m3/s].

    Slow laminar flow, with losses at both ends: the difference of the potentials is R q + e q|q|.
    ``functions`` is numpy or casadi.
    """
    drive = _potential(fluid, start, functions) - _potential(fluid, end, functions)
    loss, resistance = 4 * tube.end_loss, tube.resistance
    return 2 * drive / (resistance + functions.sqrt(resistance**2 + loss * functions.fabs(drive)))


def inflows(design: LegDesign, pressures: SX, source: SX) -> tuple[list[SX], SX]:
    """Net flow into every node, and the flow out of the source, at ambient density [m3/s]."""
    into = [SX(0) for _ in design.nodes]
    drawn = SX(0)
    for tube in design.tubes:
        start, end = (source if k < 0 else pressures[k] for k in (tube.start, tube.end))
        rate = flow(design.fluid, tube, start, end, ca)
        for node, sign in ((tube.start, -1), (tube.end, 1)):
            if node < 0:
                drawn -= sign * rate
            else:
                into[node] += sign * rate
    return into, drawn


def density(fluid: FilledFluid, pressure: Any, functions: Any = np) -> Any:
    """Density relative to that at ambient pressure [1], at a gauge pressure [Pa]."""
    if fluid.exponent is None:
        return 1.0
    return gas.density_ratio(pressure, fluid.ambient, fluid.exponent, functions)


def _potential(fluid: FilledFluid, pressure: Any, functions: Any) -> Any:
    if fluid.exponent is None:
        return pressure
    return gas.density_integral(pressure, fluid.ambient, fluid.exponent, functions)


def specific_work(fluid: FilledFluid, pressure: Any) -> Any:
    """Work that a unit of fluid can do at a gauge pressure [Pa]."""
    if fluid.exponent is None:
        return pressure
    return gas.specific_work(pressure, fluid.ambient, fluid.exponent)


def barrel_volume(fluid: FilledFluid, content: Any, pressure: Any) -> Any:
    """Volume at a gauge pressure of what is a volume at ambient density [m3]."""
    return content / density(fluid, np.asarray(pressure))


def section_pressures(design: LegDesign, pressures: Sequence[SX]) -> list[tuple[SX, SX]]:
    """Left minus right, and left plus right, of every section [Pa]."""
    difference = [SX(0) for _ in design.free_sections]
    total = [SX(0) for _ in design.free_sections]
    for k in range(design.bellows):
        difference[design.sections[k]] += design.sides[k] * pressures[k]
        total[design.sections[k]] += pressures[k]
    return list(zip(difference, total, strict=True))
