"""Flows through tubes of negligible resistance, at the default accuracy, against exact ones."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg
from tests.validation.rc_network import COMPLIANCE, only, resistance
from viscodesign import Trajectory, simulate
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.simulation.build_problem import HARDLY_RESISTS, wide_tubes

COUNT, AMPLITUDE, FREQUENCY = 16, 3e3, 1.0
SINE = f"input={{kind: sine, amplitude: {AMPLITUDE!r}, frequency: {FREQUENCY!r}}}"


def chain(viscosity: float, *changes: str) -> Trajectory:
    fluid = f"fluid={{name: own, viscosity: {viscosity!r}, density: 1.2}}"
    run = "run={duration: 2 s, output_interval: 0.02 s}"
    return simulate(leg(SINE, fluid, run, only(), *changes))


def exact_flows(resistances: np.ndarray, times: np.ndarray) -> np.ndarray:
    """Flows (T, n) through a chain from rest under a sine, by its modes.

    C p' = -L p + g_1 w(t) e_1 is a mode y' = -rate y + share sin(omega t) each, hence
    y = share ((rate sin - omega cos) + omega exp(-rate t)) / (rate^2 + omega^2). A tube lets
    through what the bellows behind it take.
    """
    conductance = 1 / resistances
    matrix = np.diag(conductance + np.append(conductance[1:], 0.0))
    matrix -= np.diag(conductance[1:], 1) + np.diag(conductance[1:], -1)
    rate, modes = np.linalg.eigh(matrix / COMPLIANCE)
    share = modes[0] * conductance[0] * AMPLITUDE / COMPLIANCE
    omega, t = 2 * np.pi * FREQUENCY, times[:, None]
    swing = omega * (rate * np.cos(omega * t) + omega * np.sin(omega * t))
    speed = share * (swing - omega * rate * np.exp(-rate * t)) / (rate**2 + omega**2)
    taken = COMPLIANCE * speed @ modes.T
    return np.asarray(np.cumsum(taken[:, ::-1], axis=1)[:, ::-1])


def off(run: Trajectory, exact: np.ndarray) -> float:
    """Largest error of a flow, relative to the largest flow; the first instant, at rest, excluded."""
    return float(np.max(np.abs(run.flow - exact)[1:]) / np.max(np.abs(exact)))


@pytest.mark.parametrize("viscosity", [2e-11, 2e-9, 2e-8, 2e-7, 2e-6, 2e-5, 1e-3])
def test_flows_follow_from_what_the_bellows_store(viscosity: float) -> None:
    """From tubes without any pressure drop to a first bellow that hardly moves."""
    run = chain(viscosity)
    assert run.status == "complete", run.failure
    exact = exact_flows(np.full(COUNT, resistance(viscosity)), run.time)
    assert off(run, exact) <= 0.01
    told = [notice for notice in run.warnings if notice.code == "uncertain_flows"]
    assert not told
    assert run.invariants.energy_imbalance_rel is not None
    assert run.invariants.energy_imbalance_rel <= 1e-4


def test_one_wide_tube_among_others() -> None:
    run = chain(2e-5, "network.changes={R2-R3: {length: 37.5 nm}}")
    resistances = np.full(COUNT, resistance(2e-5))
    resistances[2] *= 1e-6
    assert run.status == "complete", run.failure
    assert off(run, exact_flows(resistances, run.time)) <= 1e-3


def test_which_tubes_are_wide() -> None:
    """Those far faster than the swing or the other tubes; none of the leg's."""
    assert not wide_tubes(SceneQuantities(leg()))
    one = SceneQuantities(leg("network.changes={R2-R3: {length: 37.5 nm}}"))
    assert wide_tubes(one) == {"R2-R3"}
    thin = SceneQuantities(leg("fluid={name: thin, viscosity: 1e-11, density: 1.2}"))
    assert len(wide_tubes(thin)) == COUNT
    filling = thin.scales.t_i / thin.bellow.compliance
    assert max(thin.resistances.values()) < HARDLY_RESISTS * filling
