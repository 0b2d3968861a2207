"""The chain of nodes: its steps, its drawn axis, and its meshes."""

from __future__ import annotations

import numpy as np
import pytest

from viscodesign.model.chain import Chain, TurningSteps
from viscodesign.model.rod import MINIMUM_EDGES, Body
from viscodesign.model.step_geometry import STRAIGHT

BODY = Body(0.5, 2, 1.0, 1e3, 0.1)


def arc(turn: float, edges: int) -> dict[str, np.ndarray]:
    """Outputs of a chain on an arc of the body's length, two times the same."""
    angle = turn * np.arange(1, edges + 1) / edges
    radius = BODY.length / turn
    position = radius * np.column_stack((1 - np.cos(angle), np.sin(angle)))
    rows = {"position": position.ravel(), "angle": angle, "stretch": np.ones(edges)}
    return {name: np.tile(values, (2, 1)) for name, values in rows.items()}


def test_turning_steps_preserve_lengths_to_second_order() -> None:
    chords = np.array([[0.0, 1.0], [0.3, 0.9], [0.5, 0.7]])
    y = np.append(np.cumsum(chords, axis=0).ravel(), 7.0)
    turn = np.append(np.cumsum(np.column_stack((chords[:, 1], -chords[:, 0])), axis=0).ravel(), 1.0)
    geometry = TurningSteps(slice(0, 6))
    for angle in (1e-4, 0.3):
        after = geometry.step(y, angle * turn)
        lengths = np.hypot(*np.diff(after[:6].reshape(-1, 2), axis=0, prepend=0.0).T)
        assert lengths == pytest.approx(np.hypot(*chords.T), rel=1e-12)
        assert after[6] == pytest.approx(7.0 + angle)
    small = 1e-6 * turn
    assert geometry.step(y, small) == pytest.approx(STRAIGHT.step(y, small), abs=1e-11)


def test_extrapolation_repeats_the_turn() -> None:
    geometry = TurningSteps(slice(0, 2))
    points = [np.array([np.sin(a), np.cos(a)]) for a in (0.1, 0.4, 1.0)]
    assert geometry.extrapolate(points[0], points[1], 2.0) == pytest.approx(points[2])
    assert STRAIGHT.extrapolate(np.zeros(2), np.ones(2), 0.5) == pytest.approx(np.full(2, 1.5))


def test_the_drawn_axis_lies_on_the_arc() -> None:
    chain, turn = Chain(BODY, 8), 1.5
    axis, tip_angle = chain.axis(arc(turn, chain.edges), 64)
    radius = BODY.length / turn
    assert axis.shape == (2, 64, 2)
    distance = np.hypot(axis[0, :, 0] - radius, axis[0, :, 1])
    assert distance == pytest.approx(radius, rel=1e-6)
    assert tip_angle == pytest.approx(turn)


def test_section_strains_are_the_smallest_stretch_and_the_turn() -> None:
    chain = Chain(BODY, 8)
    values = arc(1.5, chain.edges)
    values["stretch"][1, 11] = 0.4
    stretch, turn = chain.section_strains(values)
    assert stretch.tolist() == [[1.0, 1.0], [1.0, 0.4]]
    assert turn == pytest.approx(0.75)


def test_a_fold_between_two_rows_is_located() -> None:
    chain = Chain(BODY, 4)
    values = arc(1.0, chain.edges)
    assert chain.angle_jump(values) is None
    values["angle"][1, 6:] += 3.5
    assert chain.angle_jump(values) == (1, 1)


def test_the_mesh_follows_accuracy_and_turn() -> None:
    assert Chain.suggested(BODY, 1e-2, 0.1).edges == 8
    assert Chain.suggested(BODY, 1e-6, 0.1).edges == 80
    assert Chain.suggested(BODY, 1e-2, 20.0).edges_per_section == 20
    assert Chain.suggested(BODY, 1.0, 0.1).edges >= MINIMUM_EDGES
