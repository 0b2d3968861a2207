"""A leg's rod by shooting: three numbers at the clamp give the whole shape.

The rod has no mass, so the force F is the same all along it, and the moment follows from where
its points are: M(s) = M_0 - F_x z(s) + F_z x(s). What remains is an initial value problem in x, z
and the angle, which one Runge-Kutta step of order 4 a section solves.

Kelvin-Voigt damping of the strains, over a step of implicit Euler, is the same rod with a larger
stiffness and other strains at rest: M = EI ((1 + r) kappa - kappa_p - r kappa_before), where r is
the damping time over the step.
"""

from __future__ import annotations

import casadi as ca

from viscodesign.lazy_dataclass import dataclass
from viscodesign.robot.leg_design import LegDesign

SX = ca.SX
STRAIN_POINTS = 3
"""Points of a section at which strains are kept: its ends and its middle."""


@dataclass(frozen=True)
class RodLoad:
    """Force at the tip [N] and moment at the clamp [N m], as symbols."""

    force_x: SX
    force_z: SX
    clamp_moment: SX


@dataclass(frozen=True)
class RodSection:
    """Strains of a section without load, and those that it had a step before."""

    curvature: SX
    stretch: SX
    curvature_before: SX
    """(STRAIN_POINTS,) [1/m]"""
    stretch_before: SX
    """(STRAIN_POINTS,) beyond 1"""
    is_free: bool


@dataclass
class ShotRod:
    """The rod that leaves the clamp with a load."""

    tip: SX
    """x, z [m] and angle [rad] of its tip (3,)."""
    forces: list[SX]
    """Mean normal force of each section [N]."""
    moments: list[SX]
    """Mean moment of each section [N m]."""
    curvatures: list[SX]
    """At the points of all sections, (STRAIN_POINTS,) each [1/m]."""
    stretches: list[SX]
    """Likewise, beyond 1."""
    nodes: list[SX]
    """x, z and angle at the ends of all sections, clamp first (3,) each."""


class RodShooting:
    """Integrates a leg's rod from the clamp to the tip."""

    def __init__(self, design: LegDesign, load: RodLoad, damping_rate: SX) -> None:
        """``damping_rate``: damping time over the step [1]; 0 at rest."""
        self.design, self.load, self.rate = design, load, damping_rate

    def shoot(self, sections: list[RodSection]) -> ShotRod:
        """The rod with these sections, clamp first."""
        rod = ShotRod(SX.zeros(3), [], [], [], [], [SX.zeros(3)])
        for section in sections:
            rod.tip = self._section(rod.tip, section, rod)
            rod.nodes.append(rod.tip)
        return rod

    def _section(self, start: SX, section: RodSection, rod: ShotRod) -> SX:
        """The state at a section's end; its strains and resultants go into ``rod``."""
        h = self.design.section_length
        strains = [self._strains(start, section, 0)]
        slopes = [_slope(start, *strains[0])]
        states = [start]
        for share, point in ((0.5, 1), (0.5, 1), (1.0, 2)):
            state = start + share * h * slopes[-1]
            states.append(state)
            strains.append(self._strains(state, section, point))
            slopes.append(_slope(state, *strains[-1]))
        kept = (0, 2, 3)
        rod.curvatures.append(ca.vertcat(*(strains[k][0] for k in kept)))
        rod.stretches.append(ca.vertcat(*(strains[k][1] for k in kept)))
        rod.forces.append(_mean([self._force(states[k]) for k in kept]))
        rod.moments.append(_mean([self._moment(states[k]) for k in kept]))
        return start + h / 6 * (slopes[0] + 2 * slopes[1] + 2 * slopes[2] + slopes[3])

    def _moment(self, state: SX) -> SX:
        load = self.load
        return load.clamp_moment - load.force_x * state[1] + load.force_z * state[0]

    def _force(self, state: SX) -> SX:
        return self.load.force_x * ca.sin(state[2]) + self.load.force_z * ca.cos(state[2])

    def _strains(self, state: SX, section: RodSection, point: int) -> tuple[SX, SX]:
        """Curvature [1/m], and stretch beyond 1."""
        if not section.is_free:
            return SX(0), SX(0)
        design, rate = self.design, self.rate
        bent = section.curvature + self._moment(state) / design.bending_stiffness
        drawn = section.stretch + self._force(state) / design.extension_stiffness
        return (
            (bent + rate * section.curvature_before[point]) / (1 + rate),
            (drawn + rate * section.stretch_before[point]) / (1 + rate),
        )


def _slope(state: SX, curvature: SX, stretch: SX) -> SX:
    """Derivative of x, z and the angle along the rod."""
    length = 1 + stretch
    return ca.vertcat(length * ca.sin(state[2]), length * ca.cos(state[2]), curvature)


def _mean(values: list[SX]) -> SX:
    """Simpson's rule."""
    return (values[0] + 4 * values[1] + values[2]) / 6
