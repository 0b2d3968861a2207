"""Laws of walls and fluids: energies and integrals agree with their derivatives."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from viscodesign.model.bellow_wall import CollapsingWall, LinearWall, MeasuredWall, Wall
from viscodesign.model.fluid import FluidLaw, Gas, Incompressible, Liquid
from viscodesign.physics import bellow
from viscodesign.physics.curves import PiecewiseCubic

SX = ca.SX
REST, COMPLIANCE = 2.16e-6, 6.14e-11
AMBIENT = 101325.0
FLOOR, FADE = bellow.collapse_pressures(REST, COMPLIANCE, 0.1, AMBIENT)
ROWS = np.array([-2e4, 0.0, 3e4, 6e4])
LINEAR = LinearWall(SX(REST), SX(COMPLIANCE), SX(1e-5), SX(2e-6))
WALLS: dict[str, Wall] = {
    "linear": LINEAR,
    "collapsing": CollapsingWall(LINEAR, SX(FLOOR), SX(FADE), SX(bellow.RESIDUAL_COMPLIANCE)),
    "measured": MeasuredWall(
        SX(REST),
        PiecewiseCubic.monotone(ROWS, np.array([-9e-7, 0.0, 3.6e-6, 5.4e-6])),
        PiecewiseCubic.monotone(ROWS, np.array([-0.1, 0.0, 0.3, 0.4])),
        PiecewiseCubic.monotone(ROWS, np.array([-0.01, 0.0, 0.04, 0.06])),
    ),
}
FLUIDS: dict[str, FluidLaw] = {
    "incompressible": Incompressible(),
    "isothermal": Gas(SX(AMBIENT), 1.0),
    "adiabatic": Gas(SX(AMBIENT), 1.4),
    "liquid": Liquid(SX(2e6)),
}
PRESSURES = [-9e4, FLOOR, FLOOR + FADE - 1.0, FLOOR + FADE + 1.0, -1e4, 0.0, 1.0, 2e4, 5e4, 1e5]


@pytest.mark.parametrize("pressure", PRESSURES)
@pytest.mark.parametrize("name", WALLS)
def test_energy_of_a_wall_is_the_work_done_on_it(name: str, pressure: float) -> None:
    """dU = p dV."""
    p, wall = SX.sym("p"), WALLS[name]
    rates = [ca.jacobian(wall.energy(p), p), p * ca.jacobian(wall.volume(p), p)]
    energy, work = (float(v) for v in ca.Function("rates", [p], rates)(pressure))
    assert energy == pytest.approx(work, rel=1e-7, abs=1e-14)


@pytest.mark.parametrize("name", WALLS)
def test_walls_are_unstrained_at_zero_gauge(name: str) -> None:
    p, wall = SX.sym("p"), WALLS[name]
    laws = [wall.volume(p), wall.curvature(p), wall.stretch(p), wall.energy(p)]
    volume, curvature, stretch, energy = (float(v) for v in ca.Function("at", [p], laws)(0.0))
    assert volume == pytest.approx(REST, rel=1e-14)
    assert [curvature, stretch] == pytest.approx([0.0, 0.0], abs=1e-15)
    if name != "measured":  # whose constant is another
        assert energy == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize("law", ["volume", "curvature", "stretch"])
def test_wall_contact_has_no_effect_above_its_range(law: str) -> None:
    p = SX.sym("p")
    laws = [getattr(WALLS[name], law)(p) for name in ("linear", "collapsing")]
    both = ca.Function("both", [p], laws)
    linear, collapsing = (float(v) for v in both(FLOOR + FADE + 1.0))
    assert linear == collapsing
    linear, collapsing = (float(v) for v in both(FLOOR))
    assert abs(collapsing) < abs(linear) or law == "volume"
    assert float(ca.Function("v", [p], [WALLS["collapsing"].volume(p)])(-AMBIENT)) >= 0.1 * REST


@pytest.mark.parametrize("pressure", [-5e4, -1.0, 0.0, 1e3, 2e5])
@pytest.mark.parametrize("name", FLUIDS)
def test_integrals_of_a_fluid_agree_with_its_density(name: str, pressure: float) -> None:
    p, fluid = SX.sym("p"), FLUIDS[name]
    density = SX(fluid.density(p))
    slopes = [
        density,
        ca.jacobian(SX(fluid.density_integral(p)), p),
        ca.jacobian(SX(fluid.specific_work(p)), p),
    ]
    rho, driven, work = (float(v) for v in ca.Function("slopes", [p], slopes)(pressure))
    assert driven == pytest.approx(rho, rel=1e-12)
    assert work == pytest.approx(1 / rho, rel=1e-12)


@pytest.mark.parametrize("name", FLUIDS)
def test_density_is_relative_to_ambient_pressure(name: str) -> None:
    p, fluid = SX.sym("p"), FLUIDS[name]
    laws = [SX(fluid.density(p)), fluid.density_integral(p), fluid.specific_work(p)]
    assert [float(v) for v in ca.Function("at", [p], laws)(0.0)] == [1.0, 0.0, 0.0]
