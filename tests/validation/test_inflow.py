"""The volume each inlet has delivered, against the network's content in closed form."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

from tests.scenes import CONFIGS, leg
from tests.validation.closed_vessel import AREA, COUNT, DEAD, DIAMETER, START, STIFF, liquid
from tests.validation.rc_network import AMBIENT, COMPLIANCE, REST_VOLUME, outputs
from viscodesign import simulate
from viscodesign.loading import known_effects
from viscodesign.scene.reading.read import parse_scene
from viscodesign.scene.scene import Scene


def held(pressure: np.ndarray) -> np.ndarray:
    """Gas in bellows, as volume at ambient density [m3]."""
    return np.asarray((REST_VOLUME + COMPLIANCE * pressure) * (1 + pressure / AMBIENT))


@pytest.mark.parametrize("effects", ["pressure_distribution: on", "pressure_distribution: off"])
@pytest.mark.parametrize("baseline", [0.0, 5e3])
def test_one_inlet_delivers_what_the_bellows_hold_beyond_their_initial_content(
    effects: str, baseline: float
) -> None:
    found = simulate(
        leg(
            f"bellows.count={COUNT}",
            "input={kind: sine, amplitude: 8 kPa, frequency: 1 Hz, mean: 3 kPa}",
            f"gauge_pressure={baseline}",
            f"effects={{gas_compressibility: on, {effects}, others: off}}",
            outputs(np.linspace(0.0, 2.0, 41)),
            "accuracy=1e-6",
        ),
        verify=False,
    )
    filled = COUNT * held(np.array(baseline))
    expected = held(found.pressure).sum(axis=1) - filled
    swing = float(np.ptp(expected))
    assert found.inflow["inlet"] == pytest.approx(expected, abs=1e-4 * swing)
    assert found.inflow["inlet"][0] != 0.0  # the start is not the baseline


def shared(*overrides: str) -> Scene:
    """Both columns connected at their ends, an inlet at the start of each."""
    last = "    - {from: L7, to: L8, length: 37.5 mm}\n"
    text = (CONFIGS / "antagonistic_two_inlets.yaml").read_text(encoding="utf-8")
    assert last in text
    text = text.replace(last, last + last.replace("L7", "R8"))
    return parse_scene(text.encode(), overrides=overrides, known=known_effects())


def test_inlets_of_one_network_together_deliver_its_content() -> None:
    scene = shared("run.duration=3 s", "inputs.left.phase=40 deg", "accuracy=1e-6")
    assert [len(c.inlets) for c in scene.graph.components()] == [2]
    found = simulate(scene, verify=False)
    together = sum(found.inflow.values())
    bellows = held(found.pressure).sum(axis=1) - held(np.zeros(16)).sum()
    # Tubes between them store gas as well where that effect is included.
    assert np.asarray(together) == pytest.approx(bellows, abs=0.02 * float(np.ptp(bellows)))
    assert float(np.ptp(found.inflow["left"] - found.inflow["right"])) > 0.1 * np.ptp(bellows)


@pytest.mark.parametrize("pressure_distribution", ["on", "off"])
def test_a_cushion_of_gas_beside_a_liquid(pressure_distribution: str) -> None:
    """Slow strokes: barrel, cushion and bellows at one pressure, found by bracketing."""
    cushion, full = 5e-6, AREA * START + DEAD + 5e-6
    words, _ = liquid()
    times = np.linspace(0.0, 400.0, 41)
    barrel = f"diameter: {DIAMETER}, start: {START}, dead_volume: {DEAD}, cushion: {cushion}"
    rows = "rows: [[0, 0], [200, 0.004], [400, -0.002]]"
    found = simulate(
        leg(
            f"bellows.count={COUNT}",
            f"input={{kind: syringe, {barrel}, {rows}}}",
            words,
            outputs(times),
            f"effects={{pressure_distribution: {pressure_distribution}, others: off}}",
            "accuracy=1e-6",
        ),
        verify=False,
    )

    def content(p: float, pushed: float) -> float:
        gas = cushion * AMBIENT / (AMBIENT + p)
        return (full - pushed - gas) * (1 + p / STIFF) + COUNT * COMPLIANCE * p

    places = np.interp(times, [0, 200, 400], [0, 0.004, -0.002])
    exact = [
        brentq(lambda p, x=x: content(p, AREA * x) - content(0.0, 0.0), -9e4, 5e5, xtol=1e-9)
        for x in places
    ]
    rel = 1e-6 if pressure_distribution == "off" else 2e-2
    swing = float(np.ptp(exact))
    assert found.inlet_pressure["inlet"] == pytest.approx(np.array(exact), abs=rel * swing)
    given = COUNT * COMPLIANCE * np.array(exact)
    assert found.inflow["inlet"] == pytest.approx(given, abs=rel * float(np.ptp(given)))
    energy = found.invariants.energy_imbalance_rel
    assert energy is not None
    assert energy < 1e-5


def test_a_cushion_beside_a_gas_is_more_of_the_gas() -> None:
    def driven(dead: float, cushion: float) -> np.ndarray:
        barrel = f"diameter: {DIAMETER}, start: {START}, dead_volume: {dead}, cushion: {cushion}"
        scene = leg(
            f"input={{kind: syringe, {barrel}, rows: [[0, 0], [1, 0.01]]}}",
            "run={duration: 1 s}",
            "effects={gas_compressibility: on, others: off}",
        )
        return simulate(scene, verify=False).inlet_pressure["inlet"]

    assert driven(1e-6, 4e-6) == pytest.approx(driven(5e-6, 0.0), rel=1e-12)
