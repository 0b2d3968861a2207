"""Several rods in one system: every answer is that of each rod by itself, side by side."""

from __future__ import annotations

import numpy as np
import pytest

from viscodesign.model.chain import Chain
from viscodesign.model.rod import Body
from viscodesign.model.several_rods import SeveralRods, several_bodies

LONG = Body(0.109, 8, 0.1, 600.0, 0.27)
SHORT = Body(0.04, 2, 0.05, 500.0, 0.2)
BOTH = several_bodies([LONG, SHORT])


def rods(is_shearable: bool = False) -> SeveralRods:
    return SeveralRods(BOTH, 2, is_shearable)


def test_the_softest_stands_for_all_and_sections_are_counted_in_a_row() -> None:
    assert BOTH.sections == 10
    assert (BOTH.length, BOTH.bending_stiffness) == (LONG.length, LONG.bending_stiffness)
    assert BOTH.section_lengths == pytest.approx([0.109 / 8] * 8 + [0.02] * 2)
    assert BOTH.masses_per_length == pytest.approx([0.27] * 8 + [0.2] * 2)
    assert BOTH.lengths == [0.109, 0.04]


def test_every_rod_has_about_as_many_edges() -> None:
    assert [chain.edges for chain in rods().chains] == [16, 16]
    fine, turn = 1e-5, 0.1
    most = Chain.suggested(LONG, fine, turn).edges
    found = SeveralRods.suggested(BOTH, fine, turn)
    assert min(chain.edges for chain in found.chains) >= most


@pytest.mark.parametrize("is_shearable", [False, True])
def test_shapes_without_load_are_those_of_each(is_shearable: bool) -> None:
    own = rods(is_shearable)
    curvature = np.linspace(-5, 5, 10)
    stretch = np.linspace(0.9, 1.1, 10)
    found = own.unloaded_coordinates(curvature, stretch)
    long, short = own.chains
    first = long.unloaded_coordinates(curvature[:8], stretch[:8])
    second = short.unloaded_coordinates(curvature[8:], stretch[8:])
    assert found[:32] == pytest.approx(first[:32], abs=1e-15)
    scale = SHORT.length / LONG.length  # one length scales all of them
    assert found[32:64] == pytest.approx(second[:32] * scale, abs=1e-15)
    assert found[64:] == pytest.approx([*first[32:], *second[32:]], abs=1e-15)


@pytest.mark.parametrize("is_shearable", [False, True])
def test_unknowns_are_eliminated_one_rod_after_the_other(is_shearable: bool) -> None:
    own = rods(is_shearable)
    order, inner = own.elimination_order()
    assert sorted(order) == list(range(len(order)))
    assert (inner == (order < 64)).all()
    alone, _ = own.chains[0].elimination_order()
    first = order[: len(alone)]
    # Unknowns of the first rod: inner ones 0 to 31, places 64 to 95, angles from 128 on.
    assert (np.argsort(np.argsort(first)) == alone).all()
    assert set(first) == {*range(32), *range(64, 96), *(range(128, 144) if is_shearable else ())}


def test_steps_turn_the_chords_of_each_rod() -> None:
    own = rods()
    generator = np.random.default_rng(1)
    y = own.unloaded_coordinates(np.zeros(10), np.ones(10))
    step = 1e-3 * generator.standard_normal(64)
    span = slice(0, 64)
    found = own.step_geometry(span).step(y, step)
    beyond = own.step_geometry(span).extrapolate(y, y + step, 0.5)
    for part, chain in zip((slice(0, 32), slice(32, 64)), own.chains, strict=True):
        alone = chain.step_geometry(slice(0, 32))
        assert found[part] == pytest.approx(alone.step(y[part], step[part]), abs=1e-15)
        expected = alone.extrapolate(y[part], (y + step)[part], 0.5)
        assert beyond[part] == pytest.approx(expected, abs=1e-15)


def test_jumps_and_strains_name_sections_in_a_row() -> None:
    own = rods()
    angle = np.zeros((3, 32))
    angle[2, 24:] = 4.0  # the second section of the second rod folds over
    values = {
        "position": np.zeros((3, 64)),
        "angle": angle,
        "stretch": np.linspace(0.9, 1.1, 96).reshape(3, 32),
        "intrinsic_curvature": np.zeros((3, 10)),
        "intrinsic_stretch": np.zeros((3, 10)),
    }
    assert own.angle_jump(values) == (2, 9)
    stretch, turn = own.section_strains(values)
    assert stretch.shape == turn.shape == (3, 10)
    assert turn[2] == pytest.approx([0.0] * 9 + [4.0])
    assert stretch[0, 9] == pytest.approx(values["stretch"][0, 24])
