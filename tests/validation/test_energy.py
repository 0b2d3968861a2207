"""The energy balance detects every term: none can be halved or doubled unnoticed."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest

from tests.scenes import leg
from viscodesign import simulate
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model import formulation
from viscodesign.results.trajectory import Invariants
from viscodesign.simulation.build_problem import suggest_settings
from viscodesign.simulation.error_control import ERROR_CONTROL
from viscodesign.simulation.solve_once import solve

SEEN = 5e-4
"""Least imbalance if a term that matters (a thousandth of the work) is off by a factor of two."""
SINE = "input={kind: sine, amplitude: 3 kPa, frequency: 1 Hz}"
FEW = "bellows.count=4"
GAS = "pressure_distribution: on, gas_compressibility: on, collapse: on, flow_regime: on"
SWUNG = "run={duration: 0.5 s, output_interval: 0.02 s, start: rest}"

SCENES = {
    "one-way chain": (
        "leg_16_straight_air",
        (SINE, "effects={pressure_distribution: on, others: off}", "run.duration=3 s"),
    ),
    "the paper's leg": ("leg_16_straight_air", ()),
    "wide tubes": (
        "leg_16_straight_air",
        (SINE, "network.changes={R2-R3: {length: 37.5 nm}}", "run.duration=2 s",
         "effects={pressure_distribution: on, others: off}"),
    ),
    "undamped rod let go": (
        "leg_16_straight_air",
        (FEW, "input={kind: constant, value: 0}", "loads.gravity={acceleration: 9.81, tilt: 90 deg}",
         "effects={gravity: on, inertia: on, others: off}", SWUNG),
    ),
    "driven one-way rod": (
        "leg_16_straight_air",
        (FEW, "loads.tip_force={x: 0.5 N}", SINE, "run={duration: 1 s, start: rest}",
         "effects={inertia: on, damping: on, others: off}"),
    ),
    "gas": (
        "leg_16_straight_air",
        (FEW, f"effects={{{GAS}, others: off}}", "run.duration=3 s"),
    ),
    "syringe": ("syringe_water", ("run.duration=2 s",)),
    "heavy fluid, shared pressure": (
        "leg_16_straight_water",
        (FEW, "input={kind: sine, amplitude: 20 kPa, frequency: 5 Hz}",
         "fluid={name: mercury, viscosity: 1.5e-3, density: 13600}",
         "loads.gravity={acceleration: 9.81, tilt: 90 deg}",
         "run={duration: 0.5 s, output_interval: 7 ms, start: rest}",
         "effects={gravity: on, fluid_mass: on, inertia: on, others: off}"),
    ),
}  # fmt: skip

TERMS = [
    ("one-way chain", ("pump", "tube_loss")),
    ("the paper's leg", ("pump", "tube_loss", "material_loss", "fluid_energy", "unpaired_volume")),
    ("wide tubes", ("pump", "tube_loss")),
    ("undamped rod let go", ("kinetic_energy", "elastic_energy", "load_energy")),
    ("driven one-way rod", ("material_loss", "load_energy", "elastic_energy", "fluid_energy")),
    ("gas", ("pump", "tube_loss", "fluid_energy")),
    ("syringe", ("plunger", "tube_loss", "fluid_energy")),
    ("heavy fluid, shared pressure", ("pump", "carried", "kinetic_energy", "elastic_energy")),
]


CUT = {
    "undamped rod let go": 1e-4,
    "driven one-way rod": 1e-2,
    "heavy fluid, shared pressure": 1e-2,
}
"""Fraction of the first tolerance at which the energy is balanced; a tenth for most."""


def balance(scene: str) -> Invariants:
    """At the final tolerance of a run of the default accuracy."""
    config, changes = SCENES[scene]
    quantities = SceneQuantities(leg(*changes, config=config))
    effects = select_effects(quantities).effects
    settings = suggest_settings(quantities, effects)
    run = solve(
        quantities, effects, replace(settings, tolerance=settings.tolerance * CUT.get(scene, 0.1))
    )
    assert run.is_complete, run.motion.failure
    return run.motion.invariants


@pytest.fixture
def fresh() -> Iterator[None]:
    formulation._kept.clear()
    yield
    formulation._kept.clear()


@pytest.mark.parametrize("scene", SCENES)
def test_energy_is_balanced(scene: str) -> None:
    config, changes = SCENES[scene]
    run = simulate(leg(*changes, config=config))
    assert run.status == "complete", run.failure
    for found in (run.invariants, balance(scene)):
        assert found.energy_imbalance_rel is not None
        assert found.energy_imbalance_rel <= ERROR_CONTROL.energy_imbalance


@pytest.mark.usefixtures("fresh")
@pytest.mark.parametrize("factor", [0.5, 2.0])
@pytest.mark.parametrize(
    ("scene", "term"), [(scene, term) for scene, terms in TERMS for term in terms]
)
def test_a_wrong_term_is_detected(
    scene: str, term: str, factor: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In the equations themselves, wherever the term is: in the rates or in the outputs."""
    own = formulation._Formulation._balances

    def wrong(self: formulation._Formulation) -> object:
        sides, rates, outputs, ways = own(self)
        assert term in {**rates, **outputs}
        rates, outputs = (
            {name: factor * value if name == term else value for name, value in group.items()}
            for group in (rates, outputs)
        )
        return sides, rates, outputs, ways

    monkeypatch.setattr(formulation._Formulation, "_balances", wrong)
    # Native code takes its rates from local terms; `tests/contract/test_local_form.py` compares both.
    monkeypatch.setenv("VISCODESIGN_NATIVE", "off")
    found = balance(scene).energy_imbalance_rel
    assert found is not None
    assert found >= SEEN


RINGING = (
    FEW,
    "network={layout: crossed, tube_radius: 0.6 mm, tube_length: 60 mm, "
    "tube_wall: {youngs_modulus: 3 MPa, thickness: 0.5 mm}}",
    "input={kind: square, high: 35 kPa, low: -30 kPa, frequency: 4 Hz}",
    "loads={gravity: {tilt: 0.7}, payload: 20 g}",
    "accuracy=1 %",
)
ALL = "{others: on, choked_flow: off, shear: off}"


@pytest.mark.parametrize("interval", ["5 ms", "50 ms"])
@pytest.mark.parametrize(
    "effects", [ALL, ALL.replace("{", "{damping: off, "), ALL.replace("{", "{flow_regime: off, ")]
)
def test_works_are_resolved_while_a_rod_rings(effects: str, interval: str) -> None:
    """What square waves excite is summed up closely enough, whatever the outputs and accuracy."""
    run = f"run={{duration: 0.5 s, output_interval: {interval}}}"
    found = simulate(leg(*RINGING, run, f"effects={effects}"), verify=False)
    assert found.status == "complete"
    assert found.invariants.energy_imbalance_rel is not None
    assert found.invariants.energy_imbalance_rel < 1e-4
