"""What a plunger displaces takes time to pass the tubes."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import chain_order, in_order, leg
from tests.validation.closed_vessel import (
    AREA,
    COUNT,
    VISCOSITY,
    gas,
    liquid,
    reference,
    steady_pressure,
    stiff,
    syringe,
)
from tests.validation.rc_network import COMPLIANCE, only, outputs, resistance, worst
from viscodesign import simulate

FINE = "accuracy=1e-6"


@pytest.mark.parametrize("compressible", [False, True])
def test_reference_settles_at_the_pressure_that_conserves_the_content(compressible: bool) -> None:
    _, ratio = gas(1.0)
    times = np.array([1.0, 100.0])
    found = reference(lambda t: 0.01 * min(t, 1.0), [1.0], times, ratio, compressible)
    late = steady_pressure(AREA * 0.01, ratio, ratio if compressible else stiff)
    assert found[-1] == pytest.approx(late, rel=1e-6)


@pytest.mark.parametrize("compressible", [False, True])
@pytest.mark.parametrize("plan", ["rows", "speeds"])
def test_transient_of_gas_follows_the_reference(compressible: bool, plan: str) -> None:
    """10 mm in a second, then held, written in two ways."""
    words, ratio = gas(1.0)
    told = "rows: [[0, 0], [1, 10 mm]]" if plan == "rows" else "speeds: [[0, 10 mm/s], [1, 0 mm/s]]"
    times = np.arange(1, 21) / 10
    taken = ("gas_compressibility",) if compressible else ()
    scene = leg(f"bellows.count={COUNT}", syringe(told), words, outputs(times), only(*taken), FINE)
    found = simulate(scene, verify=False)
    assert found.status == "complete", found.failure
    expected = reference(lambda t: 0.01 * min(t, 1.0), [1.0], times, ratio, compressible)
    pressure = in_order(found.pressure, found.bellows, chain_order(COUNT // 2))
    assert worst(pressure, expected[:, 1:]) <= 1e-5
    assert worst(found.inlet_pressure["inlet"], expected[:, 0]) <= 1e-5


def closed_chain(speed: float, times: np.ndarray) -> np.ndarray:
    """Pressures (T, bellows) of a chain, closed at its far end, under a steady inflow.

    Cosine modes; their mean grows steadily.
    """
    modes, nodes = np.arange(1, COUNT), np.arange(COUNT)
    shapes = np.cos(np.pi * np.outer(modes, nodes + 0.5) / COUNT)
    rates = 4 * np.sin(np.pi * modes / (2 * COUNT)) ** 2 / (resistance(VISCOSITY) * COMPLIANCE)
    share = 2 / COUNT * shapes[:, 0] * AREA * speed / COMPLIANCE
    gain = share * (1 - np.exp(-np.outer(times, rates))) / rates
    mean = AREA * speed * times[:, None] / (COUNT * COMPLIANCE)
    return np.asarray(mean + gain @ shapes)


def test_transient_of_liquid_is_nearly_a_source_of_flow() -> None:
    """A sudden stroke: the barrel, nearly rigid, follows within 0.1 ms."""
    words, ratio = liquid()
    speed, times = 1e-3, np.arange(1, 21) / 10
    expected = reference(lambda t: speed * t, [], times, ratio, False)
    # The barrel stores 2.9e-14 of the bellows' 2.5e-10 m3/Pa.
    assert worst(expected[:, 1:], closed_chain(speed, times)) <= 3e-4
    drop = resistance(VISCOSITY) * AREA * speed
    assert worst(expected[:, 0], expected[:, 1] + drop) <= 3e-4
    scene = leg(
        f"bellows.count={COUNT}",
        syringe(f"speeds: [[0, {speed}]]"),
        words,
        outputs(times),
        only(),
        FINE,
    )
    found = simulate(scene, verify=False)
    assert found.status == "complete", found.failure
    pressure = in_order(found.pressure, found.bellows, chain_order(COUNT // 2))
    assert worst(pressure, expected[:, 1:]) <= 1e-5
    assert worst(found.inlet_pressure["inlet"], expected[:, 0]) <= 1e-5
