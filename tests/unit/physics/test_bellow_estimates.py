"""First estimates of coefficients, against frames, plates, and what an elastic body allows."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from viscodesign.physics.bellow import blocked_compliance
from viscodesign.physics.bellow_estimates import (
    LegSizes,
    face_swelling,
    first_coefficients,
    wall_gyration,
    wall_stiffness,
)

LEG = LegSizes(0.109, 0.03, 0.02, 16, 0.01, 0.012, 0.018, 1e-3, 1e-3)
WIDE, CLOSE = replace(LEG, wall=0.4e-3, fold=3e-3), replace(LEG, wall=2e-4, bellow_height=0.0145)


def frame_stiffness(wall: float, fold: float, width: float, perimeter: float) -> float:
    """k/E of two straight legs in a V between ends that move apart without turning.

    Beams by the stiffness method; the apex moves across and, by symmetry, does not turn.
    """
    leg, area, inertia = width / 2, perimeter * wall, 4 / 3 * perimeter * wall**3 / 12
    sine, cosine = fold / leg, math.sqrt(1 - (fold / leg) ** 2)
    turn = np.array([[cosine, sine], [-sine, cosine]])
    local = np.diag([area / leg, 12 * inertia / leg**3])
    half = turn.T @ local @ turn  # forces at the free end, which moves but does not turn
    # Half of the V: its end is pulled along, its apex is free to move across.
    along = half[0, 0] - half[0, 1] * half[1, 0] / half[1, 1]
    return float(along / 2)


@pytest.mark.parametrize("fold", [0.0, 0.02e-3, 0.1e-3, 0.2e-3])
def test_the_stiffness_of_a_folded_wall_is_that_of_a_frame(fold: float) -> None:
    sizes = replace(LEG, wall=0.05e-3, fold=fold)
    perimeter = 2 * (sizes.bellow_height + sizes.bellow_length + 2 * sizes.wall)
    expected = frame_stiffness(sizes.wall, fold, sizes.bellow_width, perimeter)
    assert wall_stiffness(sizes) == pytest.approx(expected, rel=3e-3)


def test_the_gyration_of_a_thin_square_tube() -> None:
    # I = 2/3 a^3 t of a thin square tube of side a, its area is 4 a t.
    side = 0.01
    tube = replace(LEG, bellow_height=side - 1e-6, bellow_length=side - 1e-6, wall=1e-6)
    assert wall_gyration(tube) == pytest.approx(side / math.sqrt(6), rel=1e-6)


def test_a_clamped_square_bulges_as_in_the_tables() -> None:
    """In its middle 0.001265 q a^4/D (Timoshenko and Woinowsky-Krieger), which is 4 W here."""
    cube = replace(LEG, bellow_height=0.012, bellow_length=0.012, bellow_width=0.012)
    mean = face_swelling(cube) / (4 * 0.012**2)
    rigidity = cube.wall**3 / 9
    assert 4 * mean * rigidity / 0.012**4 == pytest.approx(0.001265, rel=0.015)


@pytest.mark.parametrize("sizes", [LEG, WIDE, CLOSE])
def test_the_coefficients_of_one_elastic_body_agree(sizes: LegSizes) -> None:
    modulus = 0.7e6
    found = first_coefficients(sizes, modulus)
    volume = sizes.bellow_length
    assert volume * found.area_per_force == pytest.approx(found.extension_per_pressure / modulus)
    assert volume * found.area_per_moment == pytest.approx(found.angle_per_pressure / modulus)
    # Pressure on the ends pulls a section with twice h_b l_b, against EA over its length.
    pull = 2 * sizes.end_area * sizes.section_length
    stiffness = modulus * sizes.height * sizes.width * found.extension_factor
    assert pull / stiffness == pytest.approx(2 * found.extension_per_pressure / modulus)
    moment = sizes.end_area * sizes.offset * sizes.section_length
    bending = modulus * sizes.width * sizes.height**3 / 12 * found.bending_factor
    assert moment / bending == pytest.approx(found.angle_per_pressure / modulus)


@pytest.mark.parametrize("sizes", [LEG, WIDE, CLOSE])
def test_a_bellow_swells_in_a_section_that_is_held(sizes: LegSizes) -> None:
    found, length = first_coefficients(sizes, 1.0), sizes.section_length
    body = sizes.height * sizes.width
    for per_resultant, strain, stiffness in (
        (found.area_per_force, found.extension_per_pressure, body * found.extension_factor),
        (
            found.area_per_moment,
            found.angle_per_pressure,
            body * sizes.height**2 / 12 * found.bending_factor,
        ),
    ):
        assert (
            blocked_compliance(
                sizes.bellow_length * found.area_per_pressure,
                sizes.bellow_length * per_resultant,
                strain / length,
                stiffness,
            )
            > 0.0
        )


def test_what_is_measured_tells_of_the_stiffness() -> None:
    """The extension and the angle of the paper's leg; folds of the depth that fits are the same."""
    found = first_coefficients(LEG, 1.8e6, 0.047, 10.266)
    assert (found.extension_per_pressure, found.angle_per_pressure) == (0.047, 10.266)
    assert found.extension_factor == pytest.approx(0.18e-3 * 0.109 / (8 * 0.047 * 6e-4))
    bending = 0.18e-3 * LEG.offset * 0.109 / (8 * 10.266 * 0.02 * 0.03**3 / 12)
    assert found.bending_factor == pytest.approx(bending)
    plain = first_coefficients(LEG, 1.8e6)
    again = first_coefficients(LEG, 1.8e6, plain.extension_per_pressure, plain.angle_per_pressure)
    assert again == plain


def test_only_what_has_a_stress_in_it_depends_on_the_modulus() -> None:
    soft, stiff = first_coefficients(LEG, 1e5), first_coefficients(LEG, 1e6)
    for name in ("area_per_pressure", "area_per_force", "area_per_moment"):
        assert getattr(soft, name) == pytest.approx(10 * getattr(stiff, name))
    for name in ("angle_per_pressure", "extension_per_pressure", "bending_factor"):
        assert getattr(soft, name) == getattr(stiff, name)
