"""Where a foot is, seen from its leg.

Axes: x forward, y to the right, z down, fixed to the ground. The body pitches (nose up positive)
and rolls (right side down positive); it has no yaw and does not shift sideways. A foot has a place
(x, z) and a rotation; its y follows from the leg, without resistance.
"""

from __future__ import annotations

import casadi as ca

from viscodesign.lazy_dataclass import dataclass

SX = ca.SX
BODY, FOOT, MOUNT = 4, 3, 5
"""Numbers of a body (x, z, pitch, roll), of a foot (x, z, rotation), and of a mount."""


@dataclass(frozen=True)
class Mount:
    """How a leg hangs on the body, as symbols."""

    hip: SX
    """(3,) from the centre of mass [m]."""
    tilt: SX
    """By which the leg leaves its plane, positive to the right [rad]."""
    lean: SX
    """By which it turns forward in that plane [rad]."""

    @classmethod
    def of(cls, numbers: SX) -> Mount:
        """From (MOUNT,): hip, tilt, lean."""
        return cls(numbers[:3], numbers[3], numbers[4])

    def axes(self) -> tuple[SX, SX]:
        """Unit vectors of the leg on the body: its x, and its z along the unbent leg."""
        down = ca.vertcat(0, ca.sin(self.tilt), ca.cos(self.tilt))
        forward = SX([1, 0, 0])
        c, s = ca.cos(self.lean), ca.sin(self.lean)
        return c * forward - s * down, c * down + s * forward


def tip_seen_from_leg(body: SX, foot: SX, mount: Mount) -> SX:
    """x, z and angle of the tip in the frame of its leg (3,), from body (4,) and foot (3,)."""
    x, z, pitch, roll = ca.vertsplit(body)
    hip = _turned(mount.hip, pitch, roll)
    across, along = (_turned(axis, pitch, roll) for axis in mount.axes())
    dx, dz = foot[0] - x - hip[0], foot[1] - z - hip[2]
    area = across[0] * along[2] - across[2] * along[0]
    return ca.vertcat(
        (dx * along[2] - dz * along[0]) / area,
        (across[0] * dz - across[2] * dx) / area,
        (foot[2] - pitch) / ca.cos(mount.tilt),
    )


def foot_below(body: SX, tip: SX, mount: Mount) -> SX:
    """The foot (3,) of a leg whose tip (3,) is given in the leg's frame."""
    x, z, pitch, roll = ca.vertsplit(body)
    across, along = mount.axes()
    place = _turned(mount.hip + tip[0] * across + tip[1] * along, pitch, roll)
    return ca.vertcat(x + place[0], z + place[2], pitch + tip[2] * ca.cos(mount.tilt))


def points_of_leg(body: SX, nodes: SX, mount: Mount) -> SX:
    """x and z over the ground's axes (2, n) of points (2, n) in the frame of a leg."""
    x, z, pitch, roll = ca.vertsplit(body)
    hip = _turned(mount.hip, pitch, roll)
    across, along = (_turned(axis, pitch, roll) for axis in mount.axes())
    kept = [0, 2]
    return ca.repmat(ca.vertcat(x, z) + hip[kept], 1, nodes.shape[1]) + (
        ca.horzcat(across[kept], along[kept]) @ nodes
    )


def _turned(vector: SX, pitch: SX, roll: SX) -> SX:
    """A vector of the body along the ground's axes: rolled about x, then pitched about y."""
    y = vector[1] * ca.cos(roll) - vector[2] * ca.sin(roll)
    z = vector[1] * ca.sin(roll) + vector[2] * ca.cos(roll)
    return ca.vertcat(
        vector[0] * ca.cos(pitch) + z * ca.sin(pitch),
        y,
        z * ca.cos(pitch) - vector[0] * ca.sin(pitch),
    )
