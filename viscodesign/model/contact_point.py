"""A point of the rod that a rigid surface may touch: its gap, its slip and the forces on it."""

from __future__ import annotations

import casadi as ca

from viscodesign.lazy_dataclass import dataclass

SX = ca.SX


@dataclass(frozen=True, eq=False)
class ContactPoint:
    """One candidate for contact, in symbols."""

    name: str
    gap: SX
    """Distance from the surface [m]; negative inside it."""
    along: SX
    """Path of the point along the surface [m]."""
    slip: SX
    """The same with rolling taken off [m]; only its changes count."""
    friction: SX
    """Coulomb's coefficient [1]."""
    normal_force: SX
    """Force with which the surface pushes the rod away, a symbol [N]."""
    tangential_force: SX
    """Force of friction on the rod in the direction of growing slip, a symbol [N]."""

    @property
    def potential(self) -> SX:
        """What the forces on the point follow from, as if they were dead loads [J]."""
        return -self.normal_force * self.gap - self.tangential_force * self.along


def contact_forces(points: list[ContactPoint]) -> SX:
    """Normal, then tangential forces of all points (2c,) [N]."""
    normal = [point.normal_force for point in points]
    return ca.vertcat(SX(0, 1), *normal, *(point.tangential_force for point in points))


def contact_paths(points: list[ContactPoint]) -> SX:
    """Gaps, then slips (2c,) [m], whose changes are the paths of these forces."""
    return ca.vertcat(SX(0, 1), *(p.gap for p in points), *(p.slip for p in points))


def contact_friction(points: list[ContactPoint]) -> SX:
    """Coefficients of friction (c,) [1]."""
    return ca.vertcat(SX(0, 1), *(point.friction for point in points))
