"""A plunger on a closed vessel: what it displaces fills the bellows or is compressed."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg
from tests.validation.closed_vessel import (
    AREA,
    COUNT,
    DEAD,
    START,
    gas,
    liquid,
    steady_pressure,
    stiff,
    syringe,
)
from tests.validation.rc_network import COMPLIANCE, REST_VOLUME, outputs, worst
from viscodesign import simulate

FINE = "accuracy=1e-6"

CASES = {
    "gas barrel, stiff network": (*gas(1.0), False),
    "polytropic barrel": (*gas(1.4), False),
    "gas throughout": (*gas(1.0), True),
    "polytropic throughout": (*gas(1.4), True),
    "liquid": (*liquid(), False),
}


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("baseline", [0.0, 1e4])
def test_pressure_is_uniform_without_a_pressure_distribution(case: str, baseline: float) -> None:
    """Then a stroke of any speed is quasi-static."""
    words, ratio, compressible = CASES[case]
    taken = "gas_compressibility: on, " if compressible else ""
    stroke = 2e-3 if case == "liquid" else 1e-2
    times = np.linspace(0.0, 1.0, 11)
    scene = leg(
        f"bellows.count={COUNT}",
        syringe(f"rows: [[0, 0], [0.5, {stroke}], [1, {-stroke / 2}]]"),
        words,
        f"gauge_pressure={baseline}",
        outputs(times),
        f"effects={{{taken}others: off}}",
        FINE,
    )
    found = simulate(scene, verify=False)
    assert found.status == "complete", found.failure
    network = ratio if compressible else stiff
    places = np.interp(times, [0, 0.5, 1], [0, stroke, -stroke / 2])
    exact = [steady_pressure(AREA * x, ratio, network, baseline) for x in places]
    expected = np.repeat(np.array(exact)[:, None], COUNT, axis=1)
    assert worst(found.pressure, expected) <= 1e-6
    assert found.inlet_pressure["inlet"] == pytest.approx(np.array(exact), rel=1e-6, abs=1e-2)


@pytest.mark.parametrize("case", CASES)
def test_stiffness_at_small_strokes(case: str) -> None:
    """dp/dV of barrel and bellows: their capacitances are in parallel."""
    words, ratio, compressible = CASES[case]
    taken = "gas_compressibility: on, " if compressible else ""
    stroke = 1e-7
    scene = leg(
        f"bellows.count={COUNT}",
        syringe(f"rows: [[0, 0], [1, {stroke}]]"),
        words,
        "run={duration: 1 s}",
        f"effects={{{taken}others: off}}",
        FINE,
    )
    yields = (ratio(1.0) - ratio(-1.0)) / 2
    capacity = (AREA * START + DEAD) * yields + COUNT * COMPLIANCE
    capacity += COUNT * REST_VOLUME * yields if compressible else 0.0
    found = simulate(scene, verify=False)
    assert found.pressure[-1] == pytest.approx(AREA * stroke / capacity, rel=1e-4)
