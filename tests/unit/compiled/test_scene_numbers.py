"""All numbers of a problem as a function of the free ones, against problems built anew."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import ClassVar, Self

import casadi as ca
import numpy as np
import pytest

from tests.free_numbers import SHARED, Case, assert_equal, assert_slopes, of_build, valid_values
from tests.scenes import CONFIGS, leg
from tests.thorough import configs
from viscodesign import load
from viscodesign.compiled.free_keys import FreeKeys, candidates
from viscodesign.compiled.scene_numbers import ProblemNumbers, SceneNumbers
from viscodesign.effects.base import Effect
from viscodesign.errors import SpecError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.system import System
from viscodesign.simulation.build_problem import build

SPECS = configs()
OFF = "effects={pressure_distribution: on, others: off}"


@cache
def case(config: Path) -> Case:
    return Case.of(load(config))


def small(*overrides: str) -> Case:
    return Case.of(leg(OFF, *overrides, config="leg_4_air"))


@pytest.mark.parametrize("config", SPECS, ids=lambda path: path.stem)
def test_numbers_of_every_config_are_those_of_a_rebuilt_problem(config: Path) -> None:
    here = case(config)
    numbers = here.numbers(*here.usable)
    assert len(numbers.names) > 10
    for values in (numbers.values, valid_values(numbers, 0.03)):
        wanted = here.rebuilt(numbers.scene(values))
        assert_equal(of_build(numbers, numbers.at(values)), wanted, 1e-12)


@pytest.mark.parametrize("config", SPECS, ids=lambda path: path.stem)
def test_derivatives_of_every_config_are_central_differences(config: Path) -> None:
    here = case(config)
    numbers = here.numbers(*here.usable)
    values = valid_values(numbers, 0.02)
    assert_slopes(here, numbers, values, 1e-6)


def test_numbers_are_those_of_a_problem_that_is_built() -> None:
    here = small("effects={others: on}")
    numbers = here.numbers("network.tubes[*].length", "actuator.youngs_modulus", "input.drop")
    values = 1.1 * numbers.values
    quantities = SceneQuantities(numbers.scene(values))
    problem = build(quantities, here.effects(quantities), here.settings)
    found, equations = numbers.at(values), problem.equations
    names = [symbol.name() for symbol in ca.vertsplit(equations.formulas.parameters)]
    assert tuple(names[-len(numbers.parameter_names) :]) == numbers.parameter_names
    own = [not name.startswith("size.") for name in numbers.parameter_names]
    np.testing.assert_allclose(found.parameters[own], equations.parameter_values[own], rtol=1e-12)
    schedule = problem.schedule
    firsts = np.searchsorted(schedule.edges, found.stops[:-1])
    np.testing.assert_allclose(found.pieces, schedule.pieces[firsts], rtol=1e-12)
    np.testing.assert_allclose(found.initial_piece, schedule.initial_piece, rtol=1e-12)
    assert np.all(np.isin(found.stops, schedule.edges))


ALL = (
    "loads.gravity={tilt: 30 deg}",
    "loads.tip_force={x: 0.1 N, z: 0.2 N}",
    "loads.payload=5 g",
    "network.tube_wall={youngs_modulus: 1 MPa, thickness: 0.3 mm, poissons_ratio: 0.4}",
    "network.feed_line={length: 1 m, radius: 1 mm}",
    "effects={others: on}",
)
USELESS = {"temperature", "fluid.gas_constant"}
"""What no equation of a gas with given properties depends on."""


def test_with_all_effects_every_key_can_be_free() -> None:
    here = Case.of(leg(*ALL, config="leg_4_air"))
    left = set(candidates(here.scene)) - set(here.usable) - set(SHARED)
    assert left == USELESS
    numbers = here.numbers(*here.usable)
    values = valid_values(numbers, 0.03)
    assert_equal(of_build(numbers, numbers.at(values)), here.rebuilt(numbers.scene(values)), 1e-12)
    assert_slopes(here, numbers, values, 1e-6)


INPUTS = {
    "step": "{kind: step, value: 10 kPa, time: 1 s}",
    "square": "{kind: square, high: 10 kPa, low: -2 kPa, frequency: 0.3 Hz, duty: 0.4}",
    "trapezoid": "{kind: trapezoid, high: 9 kPa, low: 1 kPa, rise: 1, hold: 1, fall: 1, rest: 0.7}",
    "sine": "{kind: sine, amplitude: 10 kPa, frequency: 0.7 Hz, phase: 1, mean: 1 kPa}",
    "constant": "{kind: constant, value: 10 kPa}",
    "table": "{kind: table, rows: [[0.1, 1 kPa], [1, 2 kPa], [2, 5 kPa], [2.5, 5 kPa], [9, 1 kPa]]}",
    "jump": "{kind: table, rows: [[0, 1 kPa], [1, 2 kPa], [1, 5 kPa], [2.5, 3 kPa]]}",
    "syringe": "{kind: syringe, diameter: 10 mm, start: 40 mm, dead_volume: 1 mL, cushion: 0.1 mL, "
    "rows: [[0.3, 0], [2, 8 mm], [4, 2 mm]]}",
    "speeds": "{kind: syringe, diameter: 10 mm, start: 40 mm, speeds: [[0.3, 5 mm/s], [2, 0]]}",
}


@pytest.mark.parametrize("kind", INPUTS)
def test_every_number_of_every_input_moves_as_if_rebuilt(kind: str) -> None:
    here = small(f"input={INPUTS[kind]}", *(["fluid=water"] if kind == "syringe" else []))
    own = [key for key in here.usable if key.startswith("input")]
    assert own
    numbers = here.numbers(*own)
    values = valid_values(numbers, 0.03)
    assert_equal(of_build(numbers, numbers.at(values)), here.rebuilt(numbers.scene(values)), 1e-12)
    for k, name in enumerate(numbers.names):
        step = 1e-6 * (np.arange(len(values)) == k) * np.maximum(np.abs(values), 1e-3)
        ends = [here.rebuilt(numbers.keys.placed(values + side * step)) for side in (1, -1)]
        for part, slopes in of_build(numbers, numbers.jacobian_at(values)).items():
            wanted = (ends[0][part] - ends[1][part]) / 2
            size = 1e-6 * np.abs(wanted) + 1e-13 * np.max(np.abs(ends[0][part]), initial=0.0)
            assert np.all(np.abs(slopes @ step - wanted) <= size), (name, part)


def test_tables_have_one_number_for_every_row() -> None:
    numbers = small(f"input={INPUTS['table']}").numbers("input.rows[*].pressure")
    assert numbers.names == tuple(f"input.rows[{k}].pressure" for k in range(5))
    np.testing.assert_array_equal(numbers.values, [1e3, 2e3, 5e3, 5e3, 1e3])


@pytest.mark.parametrize(
    ("kind", "key", "beyond"),
    [
        ("square", "input.frequency", 0.4),  # one more period
        ("square", "input.frequency", 0.2),
        ("trapezoid", "input.hold", 0.1),
        ("table", "input.rows[4].time", 7.0),  # a corner within the run
        ("step", "input.time", 9.0),
        ("step", "input.time", 3.0),
    ],
)
def test_beyond_a_corner_other_formulas_hold(kind: str, key: str, beyond: float) -> None:
    here = small(f"input={INPUTS[kind]}")
    numbers = here.numbers(key)
    for _ in range(2):  # made, and found again
        numbers.check([beyond])
        wanted = here.rebuilt(numbers.scene([beyond]))
        assert_equal(of_build(numbers, numbers.at([beyond])), wanted, 1e-12)
    assert_equal(of_build(numbers, numbers.at(numbers.values)), here.rebuilt(here.scene), 1e-12)


@pytest.mark.parametrize("key", ["rise", "hold", "rest"])
@pytest.mark.parametrize("value", [0.0, 1e-14])
def test_where_corners_meet_there_are_values_but_no_derivatives(key: str, value: float) -> None:
    here, name = small(f"input={INPUTS['trapezoid']}"), f"input.{key}"
    numbers = here.numbers("input.high", name)
    wanted = here.rebuilt(numbers.scene([9e3, value]))
    for _ in range(2):  # made, and found again
        assert_equal(of_build(numbers, numbers.at([9e3, value])), wanted, 1e-12)
        with pytest.raises(SpecError, match=f"{name}: has no derivative at .*the input") as refused:
            numbers.jacobian_at([9e3, value])
        assert [fault.key for fault in refused.value.faults] == [name]
    numbers.jacobian_at([9e3, 1e-3])


def test_several_inlets_have_keys_of_their_own() -> None:
    here = case(CONFIGS / "antagonistic_two_inlets.yaml")
    numbers = here.numbers("inputs.left.amplitude", "inputs.right.phase")
    found = numbers.jacobian_at(numbers.values).pieces[0]
    assert np.count_nonzero(found, axis=0).tolist() == [1, 1]


def test_a_stiffness_that_cannot_be_told_from_infinite_stays() -> None:
    stiff = small("actuator.extension_factor=1e6")
    with pytest.raises(SpecError, match="nothing in this scene's equations depends on it"):
        stiff.numbers("actuator.extension_factor")
    numbers = stiff.numbers("actuator.youngs_modulus")
    place = numbers.parameter_names.index("extension_stiffness")
    assert not numbers.jacobian_at(numbers.values).parameters[place].any()


def test_the_library_numbers_of_a_named_fluid_can_be_free() -> None:
    here = small("fluid=air", "effects={others: on, material_curve: off}")
    numbers = here.numbers("fluid.viscosity", "fluid.density")
    assert numbers.values[0] == here.scene.fluid.viscosity
    values = 2 * numbers.values
    assert numbers.scene(values).fluid.viscosity == values[0]
    assert numbers.scene(values).fluid.is_gas
    assert_equal(of_build(numbers, numbers.at(values)), here.rebuilt(numbers.scene(values)), 1e-12)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ([0.0, 0.1], r"network.tube_radius: must be above 0 m; got 0 m"),
        ([1e-3, np.nan], r"input.fall_time: must be a finite number; got nan"),
        ([1e-3, -0.1], r"input.fall_time: must be at least 0 s; got -0.1 s"),
        ([-1e-3, -0.1], r"tube_radius: must be above 0 m; got -0.001 m\n.*fall_time"),
        ([1e-3], r"expected 2 values, one for each free number"),
    ],
)
def test_values_out_of_range_are_refused(values: list[float], message: str) -> None:
    numbers = small().numbers("network.tube_radius", "input.fall_time")
    with pytest.raises(SpecError, match=message):
        numbers.check(values)


def test_values_that_keys_refuse_together_are_refused() -> None:
    numbers = small(f"input={INPUTS['square']}").numbers("input.high", "input.low")
    with pytest.raises(SpecError, match=r"input.high: must be at least low"):
        numbers.check([1e3, 2e3])


def test_a_load_may_vanish_but_stays_in_the_equations() -> None:
    numbers = small("loads.payload=1 g", "loads.tip_force.x=1 mN").numbers("loads.payload")
    place = numbers.parameter_names.index("payload")
    assert numbers.at([0.0]).parameters[place] == 0.0


def test_a_number_that_cannot_move_by_a_little_is_refused() -> None:
    with pytest.raises(SpecError, match=r"input.time: cannot be free at 0: the input"):
        small("input={kind: step, value: 1 kPa, time: 0}").numbers("input.time")
    with pytest.raises(SpecError, match=r"loads.payload: cannot be free at 0: the effect tip_load"):
        small("loads.tip_force.x=1 mN").numbers("loads.payload")


def test_a_force_along_z_may_start_at_zero_beside_one_along_x() -> None:
    numbers = small("loads.tip_force.x=1 mN").numbers("loads.tip_force.z")
    numbers.check([1e-3])
    place = numbers.parameter_names.index("tip_force.z")
    assert numbers.jacobian_at([0.0]).parameters[place] == 1.0


CURVE = "{rows: [[-20 kPa, -5e-5, -0.1, -0.3 mm], [0, 0, 0, 0], [30 kPa, 2e-4, 0.3, 2 mm]]}"


@pytest.mark.parametrize(
    ("key", "place"),
    [
        ("bellows.curve.rows[*].area", "the effect material_curve"),
        ("bellows.length", "a law of the fluid or of the bellows' walls"),
        ("actuator.length", "a law of the fluid or of the bellows' walls"),
    ],
)
def test_numbers_that_formulas_hold_as_constants_are_refused(key: str, place: str) -> None:
    here = small(f"bellows.curve={CURVE}", "effects.material_curve=on")
    with pytest.raises(SpecError, match=f"cannot be free: {place} holds its value as a constant"):
        here.numbers(key)
    with pytest.raises(SpecError) as refused:
        here.numbers("network.tube_radius", key)
    assert all(fault.key == key for fault in refused.value.faults)


SNAPPING = (
    "bellows.curve={rows: [[-20 kPa, -5e-5, -0.1, -0.3 mm], [0, 0, 0, 0], [30 kPa, 2e-4, 0.3, 2 mm], "
    "[25 kPa, 4e-4, 0.5, 3 mm], [60 kPa, 6e-4, 0.7, 4 mm]]}"
)


@pytest.mark.parametrize("key", ["gauge_pressure", "bellows.length", "actuator.length"])
def test_numbers_that_decide_where_a_bellow_snaps_are_refused(key: str) -> None:
    here = small(SNAPPING, "effects={material_curve: on, pressure_distribution: on, others: off}")
    with pytest.raises(SpecError, match=f"{key}: cannot be free: .*holds its value as a constant"):
        here.numbers(key)
    here.numbers("actuator.youngs_modulus", "input.drop")


def test_the_exponent_of_a_gas_is_a_constant_of_its_law() -> None:
    here = small("fluid={name: air, polytropic_exponent: 1.2}", "effects.gas_compressibility=on")
    with pytest.raises(SpecError, match="holds its value as a constant"):
        here.numbers("fluid.polytropic_exponent")


def test_products_with_the_derivatives_are_those_with_dense_ones() -> None:
    numbers = small(f"input={INPUTS['table']}").numbers("input.rows[*].time", "actuator.length")
    dense, at = numbers.jacobian_at(numbers.values), numbers.at(numbers.values)
    random = np.random.default_rng(2)
    dots = random.normal(size=len(numbers.values))
    for rate, slopes in zip(numbers.push_forward(numbers.values, dots), dense, strict=True):
        np.testing.assert_allclose(rate, slopes @ dots, rtol=1e-12, atol=1e-300)
    bars = ProblemNumbers(*(random.normal(size=part.shape) for part in at))
    wanted = sum(np.tensordot(b, s, b.ndim) for b, s in zip(bars, dense, strict=True))
    np.testing.assert_allclose(numbers.pull_back(numbers.values, bars), wanted, rtol=1e-12)
    flat = numbers.branch.function(numbers.values)
    for part, whole in zip(at, flat, strict=True):
        np.testing.assert_array_equal(part, np.array(whole).reshape(part.shape))


def test_threads_may_share_it() -> None:
    numbers = small(f"input={INPUTS['square']}").numbers("input.frequency", "input.high")
    rows = [numbers.values * factor for factor in (0.5, 0.9, 1.0, 1.1, 1.7, 1.1)]
    alone = [numbers.at(row) for row in rows]
    again = small(f"input={INPUTS['square']}").numbers("input.frequency", "input.high")
    with ThreadPoolExecutor(4) as pool:
        together = list(pool.map(again.at, rows))
    for one, other in zip(alone, together, strict=True):
        for found, wanted in zip(one, other, strict=True):
            np.testing.assert_array_equal(found, wanted)


@dataclass(frozen=True)
class TipSpring(Effect):
    """A spring that pulls the tip back to the axis, as strong as the body is stiff."""

    name: ClassVar[str] = "tip_spring"
    formula: ClassVar[str] = "1"

    stiffness: float

    @classmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        body = quantities.body
        return cls(np.sqrt(body.bending_stiffness) / body.length**3)

    def weight(self, quantities: SceneQuantities) -> float:
        return 1.0

    def reason(self, quantities: SceneQuantities) -> str:
        return "a spring"

    def join(self, system: System) -> None:
        stiffness = system.parameter("tip_spring.stiffness", self.stiffness)
        system.load_potential += stiffness * system.rod.tip[0] ** 2 / 2


@dataclass(frozen=True)
class RigidTipSpring(TipSpring):
    """The same, its stiffness written into the formula."""

    def join(self, system: System) -> None:
        system.load_potential += self.stiffness * system.rod.tip[0] ** 2 / 2


def with_effect(kind: type[Effect], *free: str) -> SceneNumbers:
    here = small()
    chosen = [*here.effects(here.quantities), kind.of(here.quantities)]
    return SceneNumbers(here.quantities, chosen, here.settings, FreeKeys(here.scene, free))


def test_a_new_effect_brings_its_own_parameters() -> None:
    numbers = with_effect(TipSpring, "actuator.youngs_modulus")
    place = numbers.parameter_names.index("tip_spring.stiffness")
    wanted = TipSpring.of(small("actuator.youngs_modulus=2 MPa").quantities).stiffness
    assert numbers.at([2e6]).parameters[place] == pytest.approx(wanted, rel=1e-14)
    slope = numbers.jacobian_at([2e6]).parameters[place, 0]
    assert slope == pytest.approx(wanted / 2 / 2e6, rel=1e-14)


def test_an_effect_that_hides_a_number_in_its_formula_refuses_it() -> None:
    message = "actuator.youngs_modulus: cannot be free: the effect tip_spring holds its value as a"
    with pytest.raises(SpecError, match=message):
        with_effect(RigidTipSpring, "actuator.youngs_modulus")
    with_effect(RigidTipSpring, "network.tube_radius")


@dataclass(frozen=True)
class StiffTipSpring(TipSpring):
    """A spring that only a stiff body has."""

    def join(self, system: System) -> None:
        if self.stiffness > 1.0:
            super().join(system)


def test_values_of_other_equations_are_refused() -> None:
    numbers = with_effect(StiffTipSpring, "actuator.youngs_modulus")
    numbers.check(numbers.values)
    with pytest.raises(SpecError, match="these values make other equations"):
        numbers.check(1e-9 * numbers.values)
