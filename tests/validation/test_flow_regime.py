"""Friction at every Reynolds number and losses at a tube's ends, against an independent library.

The library `fluids` has Churchill's friction factor (1977); the local losses are K dynamic
pressures of the mean speed.
"""

from __future__ import annotations

import numpy as np
import pytest
from fluids.friction import Churchill_1977
from scipy.optimize import brentq

from tests.scenes import chain_order, in_order, leg
from tests.validation.rc_network import (
    COMPLIANCE,
    RADIUS,
    TUBE,
    Network,
    chain,
    only,
    outputs,
    sine,
    worst,
)
from viscodesign import simulate

DENSITY, VISCOSITY = 1000.0, 1e-5
"""A liquid so thin that a Reynolds number of a million takes few pascals."""
REGIME = only("flow_regime")
FINE = "accuracy=1e-6"
LENGTH, BORE = 0.5, 2e-3
"""Length and radius of the tubes in steady flow [m]."""


def fluid(viscosity: float) -> str:
    return f"fluid={{name: thin liquid, viscosity: {viscosity}, density: {DENSITY}}}"


def flow_at(reynolds: float) -> float:
    """[m3/s]"""
    return reynolds * np.pi * VISCOSITY * BORE / (2 * DENSITY)


def loss(flow: float, viscosity: float, length: float, radius: float, ends: float) -> float:
    """Darcy-Weisbach with the library's friction factor, and the losses at the ends [Pa]."""
    speed = flow / (np.pi * radius**2)
    reynolds = 2 * DENSITY * abs(speed) * radius / viscosity
    # Below one the turbulent part is less than round-off, and the library overflows.
    factor_reynolds = 64.0 if reynolds < 1 else reynolds * Churchill_1977(Re=reynolds, eD=0.0)
    friction = factor_reynolds * viscosity * speed * length / (8 * radius**2)
    return float(friction + ends * DENSITY * speed * abs(speed) / 2)


def steady(pressure: float, *overrides: str) -> np.ndarray:
    """Flows of two equal tubes in series, under a pressure across both."""
    found = simulate(
        leg(
            "bellows.count=2",
            f"network={{layout: custom, tube_radius: {BORE}, tube_length: {LENGTH}, "
            "tubes: [{from: a, to: joint}, {from: joint, to: b}, {from: joint, to: R1}]}",
            "input=null",
            f"inputs={{a: {{kind: constant, value: {pressure!r}}}, "
            "b: {kind: constant, value: 0}}",
            fluid(VISCOSITY),
            "run={duration: 0.1 s}",
            REGIME,
            FINE,
            *overrides,
        ),
        verify=False,
    )
    assert found.status == "complete", found.failure
    assert found.flow[-1] == pytest.approx(found.flow[0], rel=1e-7, abs=1e-16)
    assert np.abs(found.flow[-1, 2]) <= 1e-9 * np.abs(found.flow[-1, 0])
    return np.asarray(found.flow[-1, :2])


@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize("reynolds", [1.0, 1e2, 2e3, 2.8e3, 4e3, 1e4, 1e5, 1e6])
def test_friction_factor_from_laminar_to_turbulent(reynolds: float, sign: int) -> None:
    flow = sign * flow_at(reynolds)
    pressure = 2 * loss(flow, VISCOSITY, LENGTH, BORE, 0.0)
    found = steady(pressure, "network.entrance_loss=0", "network.exit_loss=0")
    assert found == pytest.approx(flow, rel=1e-6)


@pytest.mark.parametrize(
    ("reynolds", "entrance", "exit_", "keys"),
    [
        (1.0, 0.5, 1.0, False),
        (5e3, 0.5, 1.0, False),
        (1e6, 0.5, 1.0, False),
        (1e3, 3.0, 0.25, True),
    ],
)
def test_losses_at_the_ends(reynolds: float, entrance: float, exit_: float, keys: bool) -> None:
    """The first three with the defaults of the spec."""
    flow = flow_at(reynolds)
    pressure = 2 * loss(flow, VISCOSITY, LENGTH, BORE, entrance + exit_)
    told = (f"network.entrance_loss={entrance}", f"network.exit_loss={exit_}") if keys else ()
    assert steady(pressure, *told) == pytest.approx(flow, rel=1e-6)


def test_slow_flow_obeys_hagen_poiseuille() -> None:
    flow = flow_at(0.01)
    pressure = 2 * 8 * VISCOSITY * LENGTH / (np.pi * BORE**4) * flow
    assert steady(pressure, "network.entrance_loss=0", "network.exit_loss=0") == pytest.approx(
        flow, rel=1e-9
    )


class Lossy:
    """Flow through a tube of the leg at given end pressures, by bracketing the library's law."""

    def __init__(self, viscosity: float, ends: float) -> None:
        self.viscosity, self.ends = viscosity, ends
        self.slow = np.pi * RADIUS**4 / (8 * viscosity * TUBE)

    def __call__(self, before: np.ndarray, after: np.ndarray) -> np.ndarray:
        return np.array([self._one(drop) for drop in before - after])

    def _one(self, drop: float) -> float:
        # Laminar friction alone bounds the flow from above.
        most = abs(drop) * self.slow * (1 + 1e-9) + 1e-30
        size = brentq(lambda q: self._loss(q) - abs(drop), 0.0, most, xtol=1e-22, rtol=1e-13)
        return float(np.sign(drop) * size)

    def _loss(self, flow: float) -> float:
        return loss(flow, self.viscosity, TUBE, RADIUS, self.ends)


@pytest.mark.parametrize("viscosity", [2e-4, 8e-4])
def test_turbulent_chain_follows_the_reference(viscosity: float) -> None:
    """Bellows filled and emptied through tubes whose flow becomes turbulent and laminar again."""
    words, inlet = sine(2e4, 2.5e4, 1.0)
    times = np.linspace(0.02, 0.7, 35)
    scene = leg("bellows.count=4", words, fluid(viscosity), outputs(times), REGIME, FINE)
    found = simulate(scene, verify=False)
    reynolds = 2 * DENSITY * np.abs(found.flow) / (np.pi * viscosity * RADIUS)
    assert reynolds.max() >= 3e3
    assert reynolds.min() <= 1e3
    lossy = Network(chain(4), lambda p: np.full(len(p), COMPLIANCE), Lossy(viscosity, 1.5))
    expected = lossy.follow(inlet, np.full(4, inlet(0.0)), times)
    pressure = in_order(found.pressure, found.bellows, chain_order(2))
    assert worst(pressure, expected) <= 1e-5
