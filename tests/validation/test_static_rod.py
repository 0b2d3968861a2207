"""The rod at rest, against closed forms and independent solutions."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar, Self

import casadi as ca
import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipe, ellipeinc, ellipk, ellipkinc

from tests.scenes import (
    LEG_EA,
    LEG_EI,
    LEG_LENGTH,
    LEG_MASS_PER_LENGTH,
    STATIC,
    STILL,
    leg,
    reference,
)
from viscodesign import simulate
from viscodesign.effects.base import Effect
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.arc_shape import arc_nodes
from viscodesign.model.rod_equations import COORDINATES
from viscodesign.model.system import System
from viscodesign.results.trajectory import Trajectory
from viscodesign.simulation.build_problem import Settings, build
from viscodesign.solve.statics import Start, equilibrium

SHORT = "run={duration: 1 s, output_interval: 1 s}"
FINE = "accuracy=0.001 %"


def tip_at_rest(*overrides: str) -> Trajectory:
    found = simulate(leg(STILL, STATIC, SHORT, FINE, *overrides))
    assert found.status == "complete", found.failure
    return found


def off_by(found: Trajectory, expected: dict[str, Any]) -> float:
    """Distance of the tip from the expected position, in lengths."""
    x, z = float(expected["x_tip_over_L"]), float(expected["z_tip_over_L"])
    return float(np.hypot(*(found.tip[-1, :2] / LEG_LENGTH - (x, z))))


@pytest.mark.parametrize("case", reference("rod_static")["tip_load"], ids=lambda c: c["FL2_EI"])
def test_cantilever_under_tip_load(case: dict[str, Any]) -> None:
    force = case["FL2_EI"] * LEG_EI / LEG_LENGTH**2
    found = tip_at_rest(f"loads.tip_force.x={force!r}")
    assert off_by(found, case["extensible_paper_eta"]) <= 1e-5
    angle = float(case["extensible_paper_eta"]["phi_tip_rad"])
    assert found.tip[-1, 2] == pytest.approx(angle, abs=1e-5)
    estimate = found.accuracy.estimated_tip_error_m
    assert estimate is not None
    assert off_by(found, case["extensible_paper_eta"]) <= estimate / LEG_LENGTH <= 1e-5


@pytest.mark.parametrize("case", reference("rod_static")["distributed_transverse"])
def test_heavy_horizontal_cantilever(case: dict[str, Any]) -> None:
    acceleration = case["qL3_EI"] * LEG_EI / LEG_LENGTH**3 / LEG_MASS_PER_LENGTH
    found = tip_at_rest(f"loads.gravity={{acceleration: {acceleration!r}, tilt: 90 deg}}")
    assert off_by(found, case["paper_eta"]) <= 1e-5


def elastica(load: float) -> tuple[float, float]:
    """Tip (x, z)/L of an inextensible cantilever under a transverse dead load F L^2/EI.

    Bisshopp and Drucker, Large deflection of cantilever beams, Q. Appl. Math. 3 (1945).
    """

    def amplitude(modulus: float) -> float:
        return float(np.arcsin(1 / (np.sqrt(2) * modulus)))

    def excess(modulus: float) -> float:
        parameter = modulus**2
        return float(ellipk(parameter) - ellipkinc(amplitude(modulus), parameter) - np.sqrt(load))

    modulus = brentq(excess, np.sqrt(0.5) + 1e-14, 1 - 1e-12, xtol=1e-15)
    parameter = modulus**2
    tip_angle = np.arcsin(2 * parameter - 1)
    along = np.sqrt(2 * np.sin(tip_angle) / load)
    across = 1 - 2 / np.sqrt(load) * (ellipe(parameter) - ellipeinc(amplitude(modulus), parameter))
    return float(across), float(along)


def chain_tip(edges_per_section: int, *overrides: str) -> np.ndarray:
    """Tip (x, z)/L of the chain of a given number of edges at rest."""
    # The smallest accuracy allowed, so that the axis is as stiff as it can be.
    quantities = SceneQuantities(leg(STILL, STATIC, SHORT, "accuracy=0.00001 %", *overrides))
    effects = select_effects(quantities).effects
    problem = build(quantities, effects, Settings(edges_per_section, 1e-6))
    start: Start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    position = problem.equations.algebraics.physical(COORDINATES, start.algebraics)
    return np.asarray(position[-2:] / LEG_LENGTH)


# A leg so stiff along its axis that it is practically inextensible.
INEXTENSIBLE = "actuator.extension_factor=1e6"


@pytest.mark.parametrize("load", [0.25, 0.5, 2.0, 5.0, 10.0])
def test_inextensible_cantilever_converges_at_fourth_order(load: float) -> None:
    force = f"loads.tip_force.x={load * LEG_EI / LEG_LENGTH**2!r}"
    exact = np.array(elastica(load))
    meshes = (1, 2, 4) if load < 5 else (2, 4, 8)  # a sharper bend asks for finer edges
    errors = [np.linalg.norm(chain_tip(k, INEXTENSIBLE, force) - exact) for k in meshes]
    assert errors[-1] <= 1e-6
    rates = np.log2(np.array(errors[:-1]) / errors[1:])
    # Nothing is left to converge where the finest error is already round-off of 1e-8.
    assert errors[-1] <= 1e-8 or np.all(rates >= 3.5), (errors, rates)


def test_extensible_cantilever_converges_at_second_order_with_a_small_constant() -> None:
    case = reference("rod_static")["tip_load"][-1]
    force = f"loads.tip_force.x={case['FL2_EI'] * LEG_EI / LEG_LENGTH**2!r}"
    expected = case["extensible_paper_eta"]
    exact = np.array([float(expected["x_tip_over_L"]), float(expected["z_tip_over_L"])])
    errors = [np.linalg.norm(chain_tip(k, force) - exact) for k in (2, 4, 8)]
    assert errors[0] <= 2e-4
    assert np.log2(errors[0] / errors[1]) == pytest.approx(2, abs=0.2)
    assert np.log2(errors[1] / errors[2]) == pytest.approx(2, abs=0.2)


@dataclass(frozen=True)
class TipMoment(Effect):
    """A moment at the tip, for which there is no spec key yet."""

    name: ClassVar[str] = "tip_moment"
    formula: ClassVar[str] = "M l / (E I)"
    moment: float

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        return cls(0.0)

    def weight(self, quantities: SceneQuantities) -> float:
        return 1.0

    def reason(self, quantities: SceneQuantities) -> str:
        return "for a test"

    def join(self, system: System) -> None:
        system.tip_moment += system.parameter("tip_moment", self.moment)


@pytest.mark.parametrize("turns", [0.25, 1.0, 1.2])
def test_end_moment_rolls_the_rod_into_a_circle(turns: float) -> None:
    quantities = SceneQuantities(leg(STILL, STATIC, SHORT))
    moment = TipMoment(turns * 2 * np.pi * LEG_EI / LEG_LENGTH)
    problem = build(quantities, [moment], Settings(1, 1e-6))
    start = equilibrium(problem, 0.0, problem.schedule.initial_piece)
    position = problem.equations.algebraics.physical(COORDINATES, start.algebraics)
    angle = turns * 2 * np.pi
    exact = LEG_LENGTH / angle * np.array([1 - np.cos(angle), np.sin(angle)])
    assert position[-2:] == pytest.approx(exact, abs=1e-12)
    arguments = [
        ca.DM(a) for a in (start.states, start.algebraics, *problem.tail(0.0, np.zeros(3)))
    ]
    named = dict(
        zip(
            problem.equations.output_function.name_out(),
            problem.equations.output_function.call(arguments),
            strict=True,
        )
    )
    assert float(np.array(named["angle"])[-1, 0]) == pytest.approx(angle, rel=1e-12)


@pytest.mark.parametrize("rod", ["off", "on"])
def test_the_unloaded_tip_lies_on_the_exact_arcs(rod: str) -> None:
    """Nonuniform steady pressures: both the closed form and the chain give the exact arcs."""
    left, right = 9e3, -4e3
    tubes = ", ".join(
        [f"{{from: left, to: L{j}, length: 40 mm}}" for j in range(1, 6)]
        + [f"{{from: right, to: R{j}, length: 40 mm}}" for j in range(2, 9)]
    )
    scene = leg(
        f"network={{layout: custom, tube_radius: 0.325 mm, tubes: [{tubes}]}}",
        f"inputs={{left: {{kind: constant, value: {left}}}, "
        f"right: {{kind: constant, value: {right}}}}}",
        f"effects={{inertia: {rod}, damping: {rod}, pressure_distribution: on, others: off}}",
        "run={duration: 0.1 s, output_interval: 0.05 s}",
        FINE,
        *(["input=null"]),
    )
    found = simulate(scene)
    p_left = np.array([left if j < 5 else 0.0 for j in range(8)])
    p_right = np.array([right if j > 0 else 0.0 for j in range(8)])
    section = LEG_LENGTH / 8
    curvature = 10.266 / 1.8e6 * (p_left - p_right) / section
    stretch = 1 + 0.047 / 1.8e6 * (p_left + p_right) / section
    nodes, angles = arc_nodes(curvature[None], stretch[None], section, 1)
    assert found.tip[-1, :2] == pytest.approx(nodes[0, -1], abs=1e-7 * LEG_LENGTH)
    assert found.tip[-1, 2] == pytest.approx(angles[0, -1], abs=1e-7)
    # The arcs themselves, by integrating the tangent on a fine grid.
    arc = np.linspace(0, section, 2001)
    heading, x, z = 0.0, 0.0, 0.0
    for kappa, lam in zip(curvature, stretch, strict=True):
        phi = heading + kappa * arc
        x += lam * np.trapezoid(np.sin(phi), arc)
        z += lam * np.trapezoid(np.cos(phi), arc)
        heading = phi[-1]
    assert nodes[0, -1] == pytest.approx((x, z), abs=1e-8)


def test_tension_stretches_the_rod_by_hookes_law() -> None:
    force = 5.0
    found = tip_at_rest(f"loads.tip_force.z={force}")
    assert found.tip[-1, 1] == pytest.approx(LEG_LENGTH * (1 + force / LEG_EA), rel=1e-9)
