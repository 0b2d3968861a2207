"""Fluid inertance: resistor, inductor and capacitor, in closed form."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import chain_order, in_order, leg
from tests.validation.rc_network import COMPLIANCE, TUBE, only, outputs, resistance, step_response
from viscodesign import simulate

DENSITY, VISCOSITY = 1000.0, 1e-3
LIQUID = f"fluid={{name: plain liquid, viscosity: {VISCOSITY}, density: {DENSITY}}}"
INERTANCE = only("fluid_inertance")
FINE = "accuracy=1e-6"
STEP = 1e4


def inertance(radius: float) -> float:
    """Momentum of a parabolic profile: 4/3 of that of a flat one [kg/m4]."""
    return 4 / 3 * DENSITY * TUBE / (np.pi * radius**2)


def ring(radius: float, times: np.ndarray) -> np.ndarray:
    """Step response of I C p'' + R C p' + p = STEP from its two roots."""
    rate = resistance(VISCOSITY, radius=radius) / (2 * inertance(radius))
    root = np.sqrt(complex(rate**2 - 1 / (inertance(radius) * COMPLIANCE)))
    slow, fast = -rate + root, -rate - root
    shape = (fast * np.exp(slow * times) - slow * np.exp(fast * times)) / (slow - fast)
    return np.asarray(STEP * (1 + np.real(shape)))


def custom(radius: float, *ends: str) -> str:
    entries = ", ".join("{from: " + e.replace(" ", ", to: ") + "}" for e in ends)
    return (
        f"network={{layout: custom, tube_radius: {radius!r}, tube_length: {TUBE}, "
        f"tubes: [{entries}]}}"
    )


def step(count: int, network: str, times: np.ndarray) -> tuple[str, ...]:
    source = f"input={{kind: step, value: {STEP}}}"
    return (f"bellows.count={count}", network, source, LIQUID, outputs(times, "rest"), FINE)


@pytest.mark.parametrize("radius", [3.25e-4, 8e-4, 2e-3])
@pytest.mark.parametrize("both", [True, False])
def test_one_tube_and_one_bellow(radius: float, both: bool) -> None:
    """From overdamped, the paper's tube, to ringing; the other bellow the same, or sealed."""
    period = 2 * np.pi * np.sqrt(inertance(radius) * COMPLIANCE)
    times = np.linspace(0.05, 4.0, 80) * period
    ends = ["inlet R1", "inlet L1"] if both else ["inlet R1"]
    found = simulate(leg(*step(2, custom(radius, *ends), times), INERTANCE), verify=False)
    assert found.status == "complete", found.failure
    assert np.max(np.abs(found.pressure[:, 0] - ring(radius, times))) <= 2e-5 * STEP
    other = ring(radius, times) if both else np.zeros(len(times))
    assert np.max(np.abs(found.pressure[:, 1] - other)) <= 2e-5 * STEP


def chain_rates(radius: float, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Rates of (pressures, flows) of a chain, and the contribution of the step."""
    resist, inert = resistance(VISCOSITY, radius=radius), inertance(radius)
    rate = np.zeros((2 * count, 2 * count))
    own, flows = np.arange(count), count + np.arange(count)
    rate[own, flows] = 1 / COMPLIANCE
    rate[own[:-1], flows[1:]] = -1 / COMPLIANCE
    rate[flows, own] = -1 / inert
    rate[flows[1:], own[:-1]] = 1 / inert
    rate[flows, flows] = -resist / inert
    drive = np.zeros(2 * count)
    drive[count] = STEP / inert
    return rate, drive


def test_reference_is_the_closed_form_for_one_bellow() -> None:
    times = np.linspace(0.01, 1.0, 20)
    found = step_response(*chain_rates(8e-4, 1), times)
    assert found[:, 0] == pytest.approx(ring(8e-4, times), rel=1e-9)


@pytest.mark.parametrize("radius", [3.25e-4, 1e-3])
def test_chain_of_four(radius: float) -> None:
    rate, drive = chain_rates(radius, 4)
    times = np.linspace(0.02, 2.0, 60)
    exact = step_response(rate, drive, times)
    network = f"network={{layout: straight, tube_radius: {radius!r}, tube_length: {TUBE}}}"
    found = simulate(leg(*step(4, network, times), INERTANCE), verify=False)
    pressure = in_order(found.pressure, found.bellows, chain_order(2))
    assert np.max(np.abs(pressure - exact[:, :4])) <= 2e-5 * STEP
    assert np.max(np.abs(found.flow - exact[:, 4:])) <= 1e-4 * np.ptp(exact[:, 4:])
    # Under a constant source, viscosity dissipates energy and nothing supplies any.
    away = pressure - STEP
    energy = COMPLIANCE * (away**2).sum(axis=1) + inertance(radius) * (found.flow**2).sum(axis=1)
    assert np.all(np.diff(energy) <= 1e-5 * energy[0])


def test_junction_without_volume() -> None:
    """A trunk forks into two branches of different length, each to a bellow; flows sum to zero."""
    radius, lengths = 1e-3, np.array([1.0, 0.5, 2.0])
    times = np.linspace(0.02, 1.5, 50)
    resist = resistance(VISCOSITY, radius=radius) * lengths
    inert = inertance(radius) * lengths
    # States p1, p2, q1, q2; the trunk carries q1 + q2.
    mass = np.array([[inert[0] + inert[1], inert[0]], [inert[0], inert[0] + inert[2]]])
    loss = np.array([[resist[0] + resist[1], resist[0]], [resist[0], resist[0] + resist[2]]])
    rate = np.zeros((4, 4))
    rate[:2, 2:] = np.eye(2) / COMPLIANCE
    rate[2:, :2] = -np.linalg.inv(mass)
    rate[2:, 2:] = -np.linalg.solve(mass, loss)
    exact = step_response(rate, np.append([0, 0], np.linalg.solve(mass, [STEP, STEP])), times)
    ends = zip(
        ("inlet", "fork", "fork"), ("fork", "R1", "L1"), (lengths * TUBE).tolist(), strict=True
    )
    tubes = ", ".join(f"{{from: {a}, to: {b}, length: {length!r}}}" for a, b, length in ends)
    network = f"network={{layout: custom, tube_radius: {radius!r}, tubes: [{tubes}]}}"
    found = simulate(leg(*step(2, network, times), INERTANCE), verify=False)
    assert np.max(np.abs(found.pressure - exact[:, :2])) <= 2e-5 * STEP
    assert np.max(np.abs(found.flow[:, 0] - found.flow[:, 1] - found.flow[:, 2])) <= 1e-7 * np.ptp(
        found.flow
    )
