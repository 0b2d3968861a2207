"""Axes of arcs and the strains of loads: loops and arrays agree with each other and by hand."""

from __future__ import annotations

import numpy as np
import pytest

from viscodesign.estimate import axis_loops
from viscodesign.estimate.axis_loops import axes_laid, axes_strained
from viscodesign.native.angles import MAX_ANGLE
from viscodesign.native.loops import PythonLoops

LENGTH = 0.02
SHAPE = (3, 5, 7)
"""Axes, pieces and samples."""


def strains() -> tuple[np.ndarray, np.ndarray]:
    random = np.random.default_rng(3)
    curvature = 20 * random.normal(size=SHAPE)
    curvature[0, 0, :3] = 0.0
    return curvature, 1 + 0.1 * random.normal(size=SHAPE)


@pytest.fixture(params=["native code", "its twin in Python", "arrays"])
def native(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    if request.param == "its twin in Python":
        monkeypatch.setattr(axis_loops, "native_loops", PythonLoops)
    elif request.param == "arrays":
        monkeypatch.setenv("VISCODESIGN_NATIVE", "off")


@pytest.mark.usefixtures("native")
def test_pieces_are_arcs_end_to_end() -> None:
    curvature, stretch = strains()
    nodes, middle, direction = axes_laid(curvature, stretch, LENGTH)
    for s, t in np.ndindex(SHAPE[0], SHAPE[2]):
        angle, place = 0.0, np.zeros(2)
        for k in range(SHAPE[1]):
            turn = curvature[s, k, t] * LENGTH
            along = np.linspace(0.0, 1.0, 2001)
            tangents = (
                stretch[s, k, t]
                * LENGTH
                * np.stack([np.sin(angle + along * turn), np.cos(angle + along * turn)])
            )
            end = place + np.trapezoid(tangents, along)
            assert nodes[s, :, k, t] == pytest.approx(end, abs=1e-8)
            assert middle[s, :, k, t] == pytest.approx((place + end) / 2, abs=1e-8)
            half = angle + turn / 2
            assert direction[s, :, k, t] == pytest.approx([np.sin(half), np.cos(half)])
            angle, place = angle + turn, end


@pytest.mark.usefixtures("native")
@pytest.mark.parametrize("samples", [1, SHAPE[2]])
def test_strains_balance_the_forces_towards_the_tip(samples: int) -> None:
    curvature, stretch = strains()
    nodes, middle, direction = axes_laid(curvature, stretch, LENGTH)
    force = np.random.default_rng(5).normal(size=(SHAPE[0], 2, SHAPE[1], samples))
    bending, extension = np.linspace(0.2, 0.6, SHAPE[1]), np.linspace(30.0, 50.0, SHAPE[1])
    most = 0.2
    vectors = nodes, middle, direction
    turned, drawn = axes_strained((bending, extension), vectors, force, most)
    force = np.broadcast_to(force, nodes.shape)
    reached = []
    for s, k, t in np.ndindex(*SHAPE):
        arms = nodes[s, :, k:, t] - middle[s, :, k, t, None]
        carried = force[s, :, k:, t]
        moment = np.sum(carried[0] * arms[1] - carried[1] * arms[0])
        normal = direction[s, :, k, t] @ carried.sum(axis=1)
        turn = np.clip(moment / bending[k], -most, most)
        reached.append(abs(turn) == most)
        assert turned[s, k, t] == pytest.approx(turn, abs=1e-12)
        assert drawn[s, k, t] == pytest.approx(normal / extension[k], abs=1e-12)
    assert 0 < sum(reached) < len(reached)


@pytest.mark.usefixtures("native")
def test_what_is_no_number_stays_none() -> None:
    curvature, stretch = strains()
    curvature[1, 2, 3] = np.nan
    nodes, middle, direction = axes_laid(curvature, stretch, LENGTH)
    assert np.isnan(nodes[1, :, 2:, 3]).all()
    assert np.isfinite(nodes[0]).all()
    stiffnesses = np.ones(SHAPE[1]), np.ones(SHAPE[1])
    turned, drawn = axes_strained(stiffnesses, (nodes, middle, direction), nodes, 3.0)
    assert np.isnan(turned[1, 2, 3])
    assert np.isnan(drawn[1, 2, 3])
    assert np.isfinite(turned[0]).all()


def test_angles_beyond_the_loop_are_laid_by_arrays() -> None:
    curvature, stretch = strains()
    curvature[0, 0, 0] = 10 * MAX_ANGLE / LENGTH
    nodes, _, _ = axes_laid(curvature, stretch, LENGTH)
    half = curvature[0, 0, 0] * LENGTH / 2
    chord = LENGTH * stretch[0, 0, 0] * np.sin(half) / half
    expected = chord * np.array([np.sin(half), np.cos(half)])
    assert nodes[0, :, 0, 0] == pytest.approx(expected, rel=1e-9, abs=1e-15)
