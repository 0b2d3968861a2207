"""A compiled scene that starts on its limit cycle: values, and derivatives of the cycle itself."""

from __future__ import annotations

import numpy as np
import pytest

from tests.free_numbers import Case, assert_equal, assert_slopes, of_build, valid_values
from tests.scenes import leg
from viscodesign import compile, simulate
from viscodesign.compiled.function import CompiledFunction
from viscodesign.errors import SpecError
from viscodesign.results.channels import trajectory_columns

PERIODIC = "run={duration: 0.6 s, output_interval: 30 ms, start: periodic}"
SINE = "input={kind: sine, amplitude: 9 kPa, mean: 1 kPa, frequency: 2 Hz}"
SQUARE = "input={kind: square, high: 9 kPa, low: 1 kPa, frequency: 1.9 Hz, duty: 0.37}"
NETWORK_ALONE = "effects={pressure_distribution: on, others: off}"
COUPLED = (
    "effects={pressure_distribution: on, feedback: on, gas_compressibility: on, gravity: on, "
    "others: off}"
)
SEALED = (
    "network={layout: custom, tube_radius: 0.325 mm, tubes: ["
    "{from: inlet, to: R1, length: 20 mm}, {from: R1, to: R2, length: 20 mm}, "
    "{from: L1, to: L2, length: 20 mm}]}"
)
SCENES = {
    "sine": ([NETWORK_ALONE, SINE], ["network.tube_radius", "input.frequency"]),
    "jumps": ([NETWORK_ALONE, SQUARE], ["input.duty", "input.frequency", "input.high"]),
    "sealed": ([COUPLED, SINE, SEALED], ["network.tube_radius", "actuator.youngs_modulus"]),
}
TIGHT = 1e-9
CHANGE = 1e-3


@pytest.fixture(params=SCENES, scope="module")
def cycle(request: pytest.FixtureRequest) -> CompiledFunction:
    changes, free = SCENES[request.param]
    return compile(leg(PERIODIC, *changes, config="leg_4_air"), free, ["tip_x_m"], tolerance=TIGHT)


def test_values_are_those_of_a_simulation(cycle: CompiledFunction) -> None:
    names, columns = trajectory_columns(simulate(cycle.scene(), verify=False, tolerance=TIGHT))
    wanted = columns[:, names.index("tip_x_m")]
    assert cycle()["tip_x_m"] == pytest.approx(wanted, abs=1e-7 * np.max(np.abs(wanted)))


def test_slopes_are_those_of_differences(cycle: CompiledFunction) -> None:
    slopes, values = cycle.jacobian()["tip_x_m"], cycle.values
    for k, value in enumerate(values):
        change = CHANGE * value * (np.arange(len(values)) == k)
        near, far = (
            cycle(values + n * change)["tip_x_m"] - cycle(values - n * change)["tip_x_m"]
            for n in (1, 2)
        )
        wanted = (8 * near - far) / (12 * CHANGE * value)
        assert slopes[:, k] == pytest.approx(wanted, abs=3e-6 * np.max(np.abs(wanted)))


def test_the_gradient_is_the_jacobian_weighted(cycle: CompiledFunction) -> None:
    weights = np.random.default_rng(4).standard_normal(len(cycle.times))
    wanted = weights @ cycle.jacobian()["tip_x_m"]
    assert cycle.vjp(None, {"tip_x_m": weights}) == pytest.approx(wanted, rel=1e-9)


def test_a_motion_off_its_cycle_has_other_slopes() -> None:
    changes, free = SCENES["sine"]
    still = PERIODIC.replace("periodic", "equilibrium")
    on, off = (
        compile(leg(run, *changes, config="leg_4_air"), free, ["tip_x_m"]).jacobian()["tip_x_m"]
        for run in (PERIODIC, still)
    )
    assert np.max(np.abs(on - off)) > 0.1 * np.max(np.abs(on))


def test_numbers_of_the_cycle_are_those_of_a_rebuilt_one() -> None:
    here = Case.of(leg(PERIODIC, NETWORK_ALONE, SQUARE, config="leg_4_air"))
    numbers = here.numbers("input.duty", "input.frequency", "input.high")
    values = valid_values(numbers, 0.01)
    wanted = here.rebuilt(numbers.scene(values))
    assert len(wanted["cycle_stops"]) == 3
    assert_equal(of_build(numbers, numbers.at(values)), wanted, 1e-12)
    assert_slopes(here, numbers, values, 1e-6)


def test_periods_that_have_to_meet_are_not_free_one_by_one() -> None:
    waves = (
        "inputs={left: {kind: sine, amplitude: 9 kPa, frequency: 2 Hz}, "
        "right: {kind: sine, amplitude: 4 kPa, frequency: 1 Hz}}"
    )
    here = Case.of(leg(PERIODIC, waves, config="antagonistic_two_inlets"))
    here.numbers("inputs.left.amplitude")
    with pytest.raises(SpecError, match=r"inputs.left.frequency: cannot be free at 2: the input"):
        here.numbers("inputs.left.frequency")
