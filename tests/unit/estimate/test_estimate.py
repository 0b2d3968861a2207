"""MotionEstimatees against exact networks and beams, and against what the solver makes of them."""

from __future__ import annotations

import math
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.linalg import expm

from tests.scenes import LEG_EA, LEG_EI, LEG_LENGTH, leg
from viscodesign import classify, simulate
from viscodesign.effects.gas_compressibility import PolytropicGas
from viscodesign.effects.rotary_inertia import RotaryInertia
from viscodesign.effects.select import select_effects
from viscodesign.estimate import network_averages
from viscodesign.estimate.linear_network import LinearNetworks
from viscodesign.estimate.motion_estimate import MotionEstimate, tips
from viscodesign.estimate.network_estimate import average_all
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.estimate.term import EstimateTerm

RAMPS = "input={kind: table, rows: [[0, 1 kPa], [0.25, 5 kPa], [0.25, -2 kPa], [0.875, -2 kPa], [1, 0]]}"
SHORT = "run={duration: 2 s, output_interval: 0.0625 s}"
STILL = "input={kind: constant, value: 0}"
SOFT = "network.tube_wall={youngs_modulus: 100 kPa, thickness: 0.3 mm}"


def bare(*overrides: str) -> MotionEstimate:
    return SceneQuantities(leg(*overrides)).bare_estimate


def exact(
    estimate: MotionEstimate,
    matrix: np.ndarray,
    feed: np.ndarray,
    start: np.ndarray,
    drive: np.ndarray,
) -> np.ndarray:
    """y' = matrix y + feed u at the estimate's times, u straight between them, by exponentials."""
    step, count = np.diff(estimate.setting.time), len(start)
    block = np.zeros((len(step), count + 2, count + 2))
    block[:, :count, :count] = matrix
    block[:, :count, count] = feed
    block[:, count, count + 1] = 1.0
    found = [start]
    slope = np.diff(drive) / np.where(step > 0.0, step, np.inf)
    for k, growth in enumerate(expm(block * step[:, None, None])):
        found.append((growth @ np.concatenate([found[-1], [drive[k], slope[k]]]))[:count])
    return np.array(found)


def chain(estimate: MotionEstimate) -> tuple[np.ndarray, np.ndarray]:
    """Conductances of the straight chain R1, R2, L2, L1, in the order of the bellows."""
    conductance = 1 / estimate.setting.resistance[0]
    order = [0, 1, 3, 2]
    laplacian = np.zeros((4, 4))
    for a, b in pairwise(order):
        laplacian[[a, b], [a, b]] += conductance
        laplacian[[a, b], [b, a]] -= conductance
    laplacian[0, 0] += conductance
    return -laplacian, np.array([conductance, 0.0, 0.0, 0.0])


@pytest.mark.parametrize("start", ["rest", "equilibrium"])
def test_a_linear_chain_is_solved_exactly(start: str) -> None:
    estimate = bare("bellows.count=4", RAMPS, SHORT, f"run.start={start}", "gauge_pressure=1 kPa")
    estimate = estimate.plus(EstimateTerm(distributed=True))
    inlet = estimate.setting.drive[0]
    leaving, feed = chain(estimate)
    capacity = estimate.setting.compliance
    first = np.full(4, inlet[0] if start == "equilibrium" else 0.0)
    expected = 1e3 + exact(estimate, leaving / capacity, feed / capacity, first, inlet)
    assert np.max(np.abs(estimate.network.pressure - expected)) <= 1e-6
    assert np.ptp(estimate.network.pressure) > 1e3


def test_flows_follow_from_the_pressures() -> None:
    estimate = bare("bellows.count=4", RAMPS, SHORT).plus(EstimateTerm(distributed=True))
    pressure, inlet = estimate.network.pressure, estimate.setting.drive[0]
    along = np.column_stack((inlet, pressure[:, [0, 1, 3, 2]]))
    expected = -np.diff(along, axis=1) / estimate.setting.resistance
    assert estimate.network.flows() == pytest.approx(expected, rel=1e-9, abs=1e-15)


def test_inertance_of_one_tube_is_an_oscillator() -> None:
    """One bellow behind one tube: I C p'' + R C p' + p = u, which is exact in an estimate."""
    estimate = bare(
        "bellows.count=2",
        "network={layout: custom, tubes: [{from: inlet, to: R1, length: 0.5 m, radius: 2 mm}]}",
        "fluid=water",
        RAMPS,
        "run={duration: 2 s, start: rest, output_interval: 0.25 s}",
    )
    inertance = 4 / 3 * 1000.0 * 0.5 / (math.pi * 2e-3**2)
    estimate = estimate.plus(EstimateTerm(distributed=True, inertance=(inertance,)))
    capacity, resistance = estimate.setting.compliance, float(estimate.setting.resistance[0])
    assert resistance < 2 * math.sqrt(inertance / capacity)  # it rings
    matrix = np.array([[0.0, 1 / capacity], [-1 / inertance, -resistance / inertance]])
    feed = np.array([0.0, 1 / inertance])
    state = exact(estimate, matrix, feed, np.zeros(2), estimate.setting.drive[0])
    assert np.max(np.abs(estimate.network.pressure[:, 0] - state[:, 0])) <= 1e-3
    flow = estimate.network.flows()[:, 0]
    # Driven by pressures that are straight between samples, which is near enough.
    assert np.max(np.abs(flow - state[:, 1])) <= 0.05 * np.max(np.abs(state[:, 1]))


@pytest.mark.parametrize("uniform", [True, False])
def test_sealed_islands_keep_their_amount(uniform: bool) -> None:
    tubes = "{from: inlet, to: R1}, {from: L1, to: T}, {from: T, to: L2}"
    estimate = bare(
        "bellows.count=4",
        f"network={{layout: custom, tube_radius: 0.3 mm, tube_length: 4 cm, tubes: [{tubes}]}}",
        "gauge_pressure=2 kPa",
        "bellows.area_per_moment=1e-5",
        RAMPS,
        SHORT,
        "loads.tip_force.x=0.05 N",
    )
    estimate = estimate.plus(EstimateTerm(distributed=not uniform))
    taken = np.zeros_like(estimate.network.pressure)
    assert np.all(estimate.network.pressure[:, 1:] == pytest.approx(2e3, rel=1e-12))
    # What loads take up in one bellow of the island leaves the other.
    taken[:, 2] = 1e-8 * estimate.setting.time
    found = estimate.network.averaged.networks.pressures(taken.T[None])[0].T
    held = estimate.setting.compliance * (found[:, 2:4] - 2e3).sum(axis=1) + taken[:, 2]
    assert np.max(np.abs(held)) <= 1e-12 * np.max(np.abs(taken))
    assert np.max(np.abs(found[:, 2] - 2e3)) > 0.1
    assert found[:, 1] == pytest.approx(np.full(len(found), 2e3), rel=1e-12)


@pytest.mark.parametrize("uniform", [True, False])
def test_a_plunger_fills_its_closed_network(uniform: bool) -> None:
    estimate = bare(
        "bellows.count=4",
        "fluid=air",
        SHORT,
        "input={kind: syringe, diameter: 20 mm, start: 40 mm, rows: [[0, 0], [1, 1 mm]]}",
    ).plus(EstimateTerm(distributed=not uniform))
    pushed = np.pi / 4 * 0.02**2 * np.interp(estimate.setting.time, [0, 1], [0, 1e-3])
    everywhere = estimate.network.averaged.networks.pressures()[0].T
    capacity = np.array([estimate.setting.compliance] * 4 + [estimate.setting.syringes["inlet"]])
    held = everywhere @ capacity
    assert np.max(np.abs(held - pushed)) <= 1e-8 * np.max(pushed)
    # Long after the stroke one pressure rules.
    assert np.ptp(everywhere[-1]) <= 1e-2 * np.max(everywhere[-1])


def test_soft_tubes_store_at_their_ends() -> None:
    """All that a step brings in is what bellows and tube ends hold."""
    plain = bare(RAMPS, SHORT).plus(EstimateTerm(distributed=True))
    end = 1e-12
    stored = plain.plus(EstimateTerm(storage=(("R1", end), ("inlet", 5.0))))
    held = [estimate.network.averaged.networks.capacity[0] for estimate in (plain, stored)]
    assert held[1] - held[0] == pytest.approx([end] + [0.0] * 15, rel=1e-9)


# -- shape ------------------------------------------------------------------


def test_a_small_tip_force_bends_it_like_a_cantilever() -> None:
    force = 1e-4
    estimate = bare(STILL, "run.duration=1 s").plus(EstimateTerm(tip_force=(force, 0.0)))
    expected = force * LEG_LENGTH**3 / (3 * LEG_EI)
    # Moments at the middles of 8 pieces: too little by (1/8)^2/4.
    assert estimate.tip[-1, 0] == pytest.approx(expected, rel=6e-3)
    assert estimate.tip[-1, 0] == pytest.approx(expected * (1 - 1 / 256), rel=1e-4)


def test_a_force_along_the_axis_draws_it() -> None:
    estimate = bare(STILL, "run.duration=1 s").plus(EstimateTerm(tip_force=(0.0, 2.0)))
    assert estimate.tip[-1, 1] - LEG_LENGTH == pytest.approx(2.0 * LEG_LENGTH / LEG_EA, rel=1e-9)
    assert estimate.tip[-1, 0] == 0.0


def test_weight_across_bends_it_as_an_even_load() -> None:
    estimate = bare(STILL, "run.duration=1 s").plus(EstimateTerm(acceleration=(0.1, 0.0)))
    weight = estimate.setting.mass_per_length * 0.1
    expected = weight * LEG_LENGTH**4 / (8 * LEG_EI)
    assert estimate.tip[-1, 0] == pytest.approx(expected, rel=0.02)
    heavier = estimate.plus(EstimateTerm(tip_mass=0.01))
    more = expected + 0.01 * 0.1 * LEG_LENGTH**3 / (3 * LEG_EI)
    assert heavier.tip[-1, 0] == pytest.approx(more, rel=0.02)


def test_large_loads_stay_near_the_solver() -> None:
    """The shape that loads have bent is loaded once more."""
    loads = ("loads.tip_force.x=4 N", STILL, "run={duration: 1 s, output_interval: 1 s}")
    solved = simulate(leg(*loads, "effects={others: off}"), verify=False).tip[-1, :2]
    estimated = bare(*loads).plus(EstimateTerm(tip_force=(4.0, 0.0))).tip[-1]
    assert abs(solved[0]) > 0.3 * LEG_LENGTH
    assert math.dist(solved, estimated) <= 0.05 * math.dist(solved, (0.0, LEG_LENGTH))


def one_sided(count: int) -> str:
    """A chain of the right bellows alone; the left ones keep what they have."""
    nodes = ["inlet", *(f"R{j}" for j in range(1, count // 2 + 1))]
    tubes = ", ".join(f"{{from: {a}, to: {b}}}" for a, b in pairwise(nodes))
    return f"network={{layout: custom, tube_radius: 1 mm, tube_length: 4 cm, tubes: [{tubes}]}}"


@pytest.mark.parametrize("count", [4, 8, 16])
def test_without_effects_it_is_the_row_of_arcs(count: int) -> None:
    """Sections that the pieces of an estimate divide evenly: nearly to round-off."""
    overrides = (f"bellows.count={count}", one_sided(count), RAMPS, SHORT, "gauge_pressure=1 kPa")
    solved = simulate(leg(*overrides, "effects={others: off}"), verify=False)
    estimate = bare(*overrides)
    times = estimate.setting.time[estimate.setting.output_mask]
    assert times == pytest.approx(solved.time, abs=1e-12)
    # A corner is told a billionth of the run before it.
    apart = estimate.tip[estimate.setting.output_mask] - solved.tip[:, :2]
    assert np.max(np.abs(apart)) <= 1e-8 * LEG_LENGTH
    assert np.ptp(solved.tip[:, 0]) > 1e-3


@pytest.mark.parametrize("count", [2, 6, 20])
def test_sections_that_pieces_divide_unevenly_differ_little(count: int) -> None:
    overrides = (f"bellows.count={count}", RAMPS, SHORT)
    taken = "effects={pressure_distribution: on, others: off}"
    solved = simulate(leg(*overrides, taken), verify=False)
    estimate = bare(*overrides).plus(EstimateTerm(distributed=True))
    apart = estimate.tip[estimate.setting.output_mask] - solved.tip[:, :2]
    moved = np.max(np.abs(solved.tip[:, :2] - (0.0, LEG_LENGTH)))
    assert np.max(np.hypot(*apart.T)) <= 0.02 * moved


# -- motion -----------------------------------------------------------------


def test_a_damped_massless_rod_lags_behind() -> None:
    """A jump is followed as 1 - exp(-t/t_v)."""
    jump = "input={kind: table, rows: [[0, 0], [1, 0], [1, 2 kPa], [2, 2 kPa]]}"
    estimate = bare(jump, SHORT)
    late = estimate.plus(EstimateTerm(damping_time=0.2))
    time = estimate.setting.time
    after = time > 1.0
    there, start = estimate.tip[-1], estimate.tip[0]
    expected = start + (there - start) * (1 - np.exp(-(time[after, None] - 1.0) / 0.2))
    assert np.max(np.abs(late.tip[after] - expected)) <= 1e-9
    assert np.max(np.abs(late.tip[time < 1.0] - start)) <= 1e-12


def test_masses_let_a_jump_overshoot_and_settle() -> None:
    """Bending of one side: the tip of a first mode swings to twice where it goes."""
    network = "network={layout: custom, tubes: [{from: inlet, to: R1, length: 1 mm, radius: 1 mm}]}"
    jump = "input={kind: table, rows: [[0, 0], [0.125, 0], [0.125, 500 Pa], [2, 500 Pa]]}"
    estimate = bare(
        "bellows.count=2", network, jump, "run={duration: 0.25 s, output_interval: 3 ms}"
    )
    there = estimate.tip[-1, 0]
    assert abs(there) > 1e-4
    ringing = (
        estimate.plus(EstimateTerm(resists_acceleration=True, damping_time=1e-4)).tip[:, 0] / there
    )
    assert np.max(ringing) == pytest.approx(1.9, abs=0.1)
    assert np.min(ringing[estimate.setting.time > 0.15]) == pytest.approx(0.1, abs=0.1)
    damped = (
        estimate.plus(EstimateTerm(resists_acceleration=True, damping_time=1e-2)).tip[:, 0] / there
    )
    assert damped[-1] == pytest.approx(1.0, rel=1e-2)
    assert np.max(damped) < 1.3


def test_turning_and_payload_slow_the_swing() -> None:
    estimate = bare(STILL)
    plain = estimate.bending_rate()
    # First root of a clamped-free beam, squared: 3.516/t_s.
    assert plain == pytest.approx(3.516 / classify(leg()).scales.t_s, rel=1e-3)
    assert (
        estimate.plus(
            EstimateTerm(modal_mass=RotaryInertia(0.03 / math.sqrt(12), 0.0).modal_mass)
        ).bending_rate()
        < plain
    )
    mass = 0.02
    light = bare(STILL)
    light.setting.mass_per_length = 1e-9
    carried = light.plus(EstimateTerm(tip_mass=mass)).bending_rate()
    assert carried == pytest.approx(math.sqrt(3 * LEG_EI / LEG_LENGTH**3 / mass), rel=1e-5)
    axial = estimate.axial_rate()
    speed = math.sqrt(LEG_EA / estimate.setting.mass_per_length)
    assert axial == pytest.approx(math.pi / 2 * speed / LEG_LENGTH, rel=1e-9)


# -- distances --------------------------------------------------------------


def test_distance_is_the_largest_over_the_outputs() -> None:
    estimate = bare(RAMPS, SHORT)
    other = estimate.plus(EstimateTerm(distributed=True))
    told = estimate.setting.output_mask
    expected = max(
        math.dist(a, b) for a, b in zip(estimate.tip[told], other.tip[told], strict=True)
    )
    assert estimate.distance(other) == pytest.approx(expected)
    assert estimate.distance(other) == other.distance(estimate)
    assert estimate.distance(estimate.plus()) == 0.0


def test_what_is_not_finite_is_infinitely_far() -> None:
    estimate = bare(RAMPS, SHORT)
    assert estimate.distance(estimate.plus(EstimateTerm(tip_force=(math.nan, 0.0)))) == math.inf


def test_the_settled_state_of_a_network_is_computed_once_for_equal_numbers() -> None:
    estimate = bare(RAMPS, SHORT).plus(EstimateTerm(distributed=True))
    assert (
        estimate.plus(EstimateTerm(resists_acceleration=True)).network.averaged
        is estimate.network.averaged
    )
    assert (
        estimate.plus(EstimateTerm(fluid=PolytropicGas(1.0))).network.averaged
        is not estimate.network.averaged
    )


def side_by_side() -> list[MotionEstimate]:
    """Estimates that share some laws and networks, and lack one term each."""
    estimate = bare(
        "fluid=air",
        "bellows.collapse_fraction=0.5",
        "input={kind: square, high: 3 kPa, low: -60 kPa, frequency: 2 Hz}",
        "run={duration: 1 s, output_interval: 0.01 s}",
    )
    floor, count = -20e3, len(estimate.setting.resistance)

    def wall(pressure: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        met = np.maximum(pressure, floor)
        setting = estimate.setting
        return setting.compliance * met, setting.curvature * met, setting.stretch * met

    terms = (
        EstimateTerm(distributed=True),
        EstimateTerm(fluid=PolytropicGas(1.0)),
        EstimateTerm(flow_loss=lambda flow: 1 + 1e5 * np.abs(flow)),
        EstimateTerm(inertance=(1e7,) * count),
        EstimateTerm(wall=wall),
        EstimateTerm(acceleration=(0.0, 9.8)),
        EstimateTerm(tip_force=(0.1, 0.0), tip_mass=0.01),
        EstimateTerm(held_density=1000.0),
        EstimateTerm(resists_acceleration=True),
        EstimateTerm(damping_time=1e-3),
        EstimateTerm(volume_per_force=1e-8, volume_per_moment=1e-6),
        EstimateTerm(shear_compliance=0.01, modal_mass=lambda length, damped: 0.1),
    )
    fewer = [terms[:k] + terms[k + 1 :] for k in range(len(terms))]
    return [estimate.plus(*own) for own in (terms, *fewer)]


def test_estimates_side_by_side_are_those_alone() -> None:
    together = tips(side_by_side())
    for row, estimate in zip(together, side_by_side(), strict=True):
        alone = tips([estimate])[0]
        assert np.max(np.abs(row - alone)) <= 1e-9 * LEG_LENGTH
    ends = np.round(together[..., -1] / LEG_LENGTH, 12)
    assert len(np.unique(ends, axis=0)) == len(together)


def test_rounds_end_where_means_have_settled(monkeypatch: pytest.MonkeyPatch) -> None:
    """With a loss that hardly changes three rounds do what six do, to a part of what it does."""

    def pressures(settled: float) -> tuple[np.ndarray, int]:
        calls, plain = list[str](), LinearNetworks.pressures

        def counted(*given: Any) -> np.ndarray:
            calls.append("pressures")
            return plain(*given)

        with monkeypatch.context() as patch:
            patch.setattr(network_averages, "SETTLED", settled)
            patch.setattr(LinearNetworks, "pressures", counted)
            estimate = bare(RAMPS, SHORT).plus(
                EstimateTerm(distributed=True), EstimateTerm(flow_loss=lambda q: 1 + 1e6 * abs(q))
            )
            return estimate.network.pressure, len(calls)

    few, rounds = pressures(network_averages.SETTLED)
    many, all_rounds = pressures(-1.0)
    linear = bare(RAMPS, SHORT).plus(EstimateTerm(distributed=True)).network.pressure
    assert rounds < all_rounds == network_averages.AVERAGING_ROUNDS + 1
    assert np.max(np.abs(few - many)) < 0.02 * np.max(np.abs(linear - many))


def test_what_settles_beside_others_is_what_settles_alone() -> None:
    """Also where those take more rounds."""
    estimate = bare(RAMPS, SHORT).plus(EstimateTerm(distributed=True))

    def lost(factor: float, flow: np.ndarray) -> np.ndarray:
        return 1 + factor * np.abs(flow)

    own = [EstimateTerm(flow_loss=partial(lost, factor)) for factor in (1e4, 1e6, 1e8)]
    together = [estimate.plus(term).network for term in own]
    found = [one.pressure.T for one in average_all(together)]
    for term, pressure in zip(own, found, strict=True):
        alone = bare(RAMPS, SHORT).plus(EstimateTerm(distributed=True), term).network.pressure
        assert np.max(np.abs(pressure - alone)) <= 1e-12 * np.max(np.abs(alone))


def test_a_long_train_is_estimated_by_its_beginning() -> None:
    estimate = bare("input={kind: sine, amplitude: 3 kPa, frequency: 10 Hz}", "run.duration=100 s")
    assert 1.0 < estimate.setting.time[-1] < 10.0
    assert len(estimate.setting.time) < 3000


def test_outputs_sparser_than_the_estimate_may_fall_on_any_sample() -> None:
    run = "run={duration: 2000 s, output_interval: 50 s}"
    estimate = bare("input={kind: sine, amplitude: 3 kPa, frequency: 1 Hz}", run)
    assert len(estimate.setting.output_mask) > 300
    assert estimate.distance(estimate.plus(EstimateTerm(distributed=True))) > 0.0


def test_the_start_has_the_values_after_a_jump_and_a_corner_those_before() -> None:
    """A step at zero shows at once; one at an output time not yet."""
    estimate = bare(
        "input={kind: table, rows: [[0, 0], [1, 0], [1, 5 kPa], [2, 5 kPa]]}",
        "run={duration: 2 s, output_times: [0, 1, 2]}",
    )
    tips = estimate.tip[estimate.setting.output_mask]
    assert len(tips) == 3
    assert tips[1] == pytest.approx(tips[0], abs=1e-12)
    assert math.dist(tips[2], tips[0]) > 1e-4


def test_a_step_at_zero_is_told_from_the_start() -> None:
    step = ("bellows.count=4", "input={kind: step, value: 5 kPa}",
            "run={duration: 1 s, output_times: [0, 1]}")  # fmt: skip
    solved = simulate(leg(*step, "effects=off"), verify=False).tip[:, :2]
    estimate = bare(*step)
    assert estimate.tip[estimate.setting.output_mask] == pytest.approx(solved, abs=1e-9)
    assert solved[0, 1] > LEG_LENGTH * 1.001


def test_outputs_that_begin_behind_the_estimate_do_not_empty_it() -> None:
    """A long train of swings is estimated for its first ones, whenever the outputs begin."""
    scene = leg(
        "input={kind: sine, amplitude: 5 kPa, frequency: 2 Hz}",
        "run={duration: 40 s, output_times: [39.5, 40]}",
        config="leg_4_air_auto",
    )
    selection = select_effects(SceneQuantities(scene))
    assert all(np.isfinite(v.contribution_m) for v in selection.verdicts)


def test_a_gas_between_two_inlets_is_densest_at_the_higher() -> None:
    """Of a steady isothermal flow through equal tubes the square of the pressure falls evenly."""
    ambient, high, low = 101325.0, 60e3, -60e3
    estimate = bare(
        "bellows.count=2",
        "input=null",
        "network={layout: custom, tube_length: 40 mm, tube_radius: 0.3 mm, tubes: [{from: a, to: R1}, {from: R1, to: L1}, {from: L1, to: b}]}",
        f"inputs={{a: {{kind: constant, value: {high}}}, b: {{kind: constant, value: {low}}}}}",
        "run={duration: 1 s, output_interval: 0.1 s, start: equilibrium}",
        f"ambient_pressure={ambient}",
    ).plus(EstimateTerm(distributed=True))
    squares = np.linspace((ambient + high) ** 2, (ambient + low) ** 2, 4)[1:-1]
    found = estimate.plus(EstimateTerm(fluid=PolytropicGas(1.0))).network.pressure[-1]
    assert found == pytest.approx(np.sqrt(squares) - ambient, rel=0.03)
    assert estimate.network.pressure[-1] == pytest.approx([20e3, -20e3], rel=1e-6)


def test_turning_counts_more_where_nothing_damps_the_rod() -> None:
    lively = bare("bellows.count=4", RAMPS, SHORT).plus(EstimateTerm(resists_acceleration=True))
    calm = lively.plus(EstimateTerm(damping_time=1e-3))
    moved = [
        s.distance(s.plus(EstimateTerm(modal_mass=RotaryInertia(5e-3, 0.0).modal_mass)))
        for s in (calm, lively)
    ]
    assert moved[1] > 2 * moved[0] > 0.0
