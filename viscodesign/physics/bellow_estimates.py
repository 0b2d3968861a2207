"""First estimates of a bellow's coefficients from the modulus and the wall, before any measurement.

Two bellows of a section are springs side by side, each a rectangular tube of thin wall with
shallow folds; pressure pushes on their ends and swells their faces. The derivations are in
`docs/measuring.md`, with a comparison against a measured leg. All strains are small, the
elastomer is incompressible (Poisson's ratio 1/2), and nothing solid stands between the columns.
"""

from __future__ import annotations

import math

from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class LegSizes:
    """Sizes of an actuator and of its bellows [m]; those of a bellow are inner ones."""

    length: float
    """Length of the actuator, l."""
    height: float
    """Height of the actuator along x, the direction of bending, h_s."""
    width: float
    """Width of the actuator along y, w_s."""
    count: int
    """Number of bellows, two to a section."""
    bellow_height: float
    """Along x, h_b."""
    bellow_width: float
    """Along z, the axis of the actuator, w_b."""
    bellow_length: float
    """Along y, l_b."""
    wall: float
    """Thickness of the walls, t."""
    fold: float
    """Depth of the folds between middles of the wall, d; zero for plain walls."""

    @property
    def section_length(self) -> float:
        """Pitch of the sections [m]."""
        return self.length / (self.count / 2)

    @property
    def end_area(self) -> float:
        """Area at the end of a bellow on which pressure pushes along z, h_b l_b [m^2]."""
        return self.bellow_height * self.bellow_length

    @property
    def offset(self) -> float:
        """From the axis of the actuator to the middle of a bellow that ends at the surface [m]."""
        return self.height / 2 - self.wall - self.bellow_height / 2


@dataclass(frozen=True)
class FirstCoefficients:
    """Keys of `actuator` and `bellows` that are measured, as estimates in SI."""

    solid_fraction: float
    extension_factor: float
    bending_factor: float
    area_per_pressure: float
    angle_per_pressure: float
    extension_per_pressure: float
    area_per_force: float
    area_per_moment: float


def first_coefficients(
    sizes: LegSizes,
    youngs_modulus: float,
    extension: float | None = None,
    angle: float | None = None,
) -> FirstCoefficients:
    """All eight, in agreement with one another: their coupling does no net work.

    ``youngs_modulus`` [Pa]. A measured ``extension`` per pressure sum over E [m] or ``angle`` per
    pressure difference over E [rad] tells more of the stiffness than the wall does.
    """
    push, arm, section = sizes.end_area, sizes.offset, sizes.section_length
    if extension is None:
        extension = push / (2 * wall_stiffness(sizes))
    if angle is None:
        angle = extension * arm / (arm**2 + wall_gyration(sizes) ** 2)
    swelling = face_swelling(sizes) + 2 * push * max(extension, arm * angle)
    body = sizes.height * sizes.width
    per_volume = 1 / (youngs_modulus * sizes.bellow_length)
    return FirstCoefficients(
        solid_fraction=solid_fraction(sizes),
        extension_factor=push * section / (extension * body),
        bending_factor=push * arm * section / (angle * body * sizes.height**2 / 12),
        area_per_pressure=swelling * per_volume,
        angle_per_pressure=angle,
        extension_per_pressure=extension,
        area_per_force=extension * per_volume,
        area_per_moment=angle * per_volume,
    )


def solid_fraction(sizes: LegSizes) -> float:
    r"""Solid part of the body's volume, if all but the bellows is solid [1].

    .. math:: f_m = 1 - n h_b w_b l_b / (h_s w_s l)
    """
    hollow = sizes.count * sizes.end_area * sizes.bellow_width
    return 1 - hollow / (sizes.length * sizes.height * sizes.width)


def wall_stiffness(sizes: LegSizes) -> float:
    r"""Axial stiffness of one bellow over Young's modulus, k/E [m].

    .. math:: \frac{k}{E} = \frac{b t}{w_b (1 + \frac34 (d/t)^2)}, \quad b = 2 (h_b + l_b + 2 t)

    b is the perimeter of the wall. It stretches by F w_b/(E b t); a fold of depth d bends it
    besides, as legs with built-in ends: the moment is F d/2 at their ends and changes sign in the
    middle, which lengthens them by F d^2 w_b/(12 E' I), with I = b t^3/12 and E' = 4 E/3 of a
    wide wall. The number of folds does not matter.
    """
    shape = 1 + 0.75 * (sizes.fold / sizes.wall) ** 2
    return _perimeter(sizes) * sizes.wall / (sizes.bellow_width * shape)


def wall_gyration(sizes: LegSizes) -> float:
    """Radius of gyration of one bellow's wall about its own middle, in bending [m]."""
    high, wide = sizes.bellow_height + sizes.wall, sizes.bellow_length + sizes.wall
    return math.sqrt((wide * high**2 / 2 + high**3 / 6) / _perimeter(sizes))


def face_swelling(sizes: LegSizes) -> float:
    r"""Volume by which the four faces around one bellow bulge, over p/E [m^3].

    Each is a clamped plate with the deflection W (1 - cos 2 pi x/a)(1 - cos 2 pi y/b):

    .. math:: W = \frac{p}{4 \pi^4 D (3/a^4 + 3/b^4 + 2/(a^2 b^2))}, \quad D = E t^3/9

    by Ritz's method; its mean is W. In the middle of a square it is 1.4 % above the exact one.
    """
    faces = (sizes.bellow_length, sizes.bellow_height)
    return sum(2 * _bulge(side, sizes.bellow_width, sizes.wall) for side in faces)


def _bulge(side: float, other: float, wall: float) -> float:
    """Volume under one clamped plate over p/E [m^3]."""
    shape = 3 / side**4 + 3 / other**4 + 2 / (side * other) ** 2
    return side * other * 9 / (wall**3 * 4 * math.pi**4 * shape)


def _perimeter(sizes: LegSizes) -> float:
    return 2 * (sizes.bellow_height + sizes.bellow_length + 2 * sizes.wall)
