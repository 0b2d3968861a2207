"""The barrel's closed forms: what it holds, and where the plunger has to be."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign.pump.ax.servo_drive import ServoDrive
from viscodesign.pump.planning.demand import FeedLine, feed_line_at
from viscodesign.pump.plunger.barrel import Barrel

AMBIENT = 101325.0


def barrel(*words: str, line: FeedLine | None = None, fluid: str = "fluid=air") -> Barrel:
    own = ", ".join(("syringe_diameter: 34.9 mm", *words))
    scene = leg(f"pump={{{own}}}", fluid, "temperature=20 degC")
    assert scene.pump is not None
    return Barrel(scene, ServoDrive(scene.pump), line or FeedLine())


def test_a_closed_gas_keeps_its_temperature() -> None:
    """Nothing given: p V = const (Boyle)."""
    found = barrel("dead_volume: 5 mL", "home: 500")
    full = found.full_volume
    pressure = np.array([-3e4, 0.0, 2e4, 5e4])
    place = found.position(pressure, 0.0)
    left = full - found.drive.area * place
    assert (AMBIENT + pressure) * left == pytest.approx(np.full(4, AMBIENT * full))


def test_dead_volume_alone_needs_its_own_compression() -> None:
    """To 20 kPa gauge a plunger sweeps V (1 - P0/P), however large V is."""
    for dead in (0.0, 5e-6, 50e-6):
        found = barrel(f"dead_volume: {dead!r}")
        swept = found.drive.area * found.position(20e3, 0.0)
        assert swept == pytest.approx(found.full_volume * (1 - AMBIENT / (AMBIENT + 20e3)))


def test_volume_given_at_the_baseline_equals_volume_swept() -> None:
    found = barrel("dead_volume: 5 mL")
    assert found.drive.area * found.position(0.0, 3e-6) == pytest.approx(3e-6)


def test_a_cushion_beside_a_liquid_keeps_its_temperature() -> None:
    found = barrel(
        "dead_volume: 4 mL",
        fluid="fluid={name: w, viscosity: 1e-3, density: 1000, bulk_modulus: 1e30}",
    )
    pressure = 30e3
    squeezed = 4e-6 * (1 - AMBIENT / (AMBIENT + pressure))
    assert found.drive.area * found.position(pressure, 1e-6) == pytest.approx(1e-6 + squeezed)


@pytest.mark.parametrize("fluid", ["fluid=air", "fluid=water"])
@pytest.mark.parametrize("line", [FeedLine(), FeedLine(2e-6, 3e-12, True)])
def test_position_and_content_are_inverse(fluid: str, line: FeedLine) -> None:
    found = barrel("dead_volume: 5 mL", "home: 400", fluid=fluid, line=line)
    pressure, given = np.array([-2e4, 1e4, 4e4]), np.array([-2e-6, 0.0, 8e-6])
    place = found.position(pressure, given)
    held = found.held(pressure, place)
    assert found.held(0.0, 0.0) - held == pytest.approx(given, abs=1e-18)


def test_stiffness_of_a_gas_is_its_volume_over_its_pressure() -> None:
    found = barrel("dead_volume: 5 mL")
    place = float(found.position(20e3, 0.0))
    left = found.full_volume - found.drive.area * place
    assert found.compliance(20e3, place) == pytest.approx(left / (AMBIENT + 20e3), rel=1e-6)


def test_the_line_at_an_inlet_is_half_a_tube_of_gas() -> None:
    scene = leg(
        "network.feed_line={length: 1 m, radius: 1.5 mm}", config="leg_16_straight_air_auto"
    )
    line = feed_line_at(scene, "inlet", frozenset({"gas_compressibility", "tube_compliance"}))
    assert line.volume == pytest.approx(np.pi * 1.5e-3**2 / 2)
    assert feed_line_at(scene, "inlet", frozenset()) == FeedLine()
