"""What a run is warned of, from courses that nobody had to solve; and how a gas run ends."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import simulate
from viscodesign.checks.motion_warnings import motion_notices
from viscodesign.checks.scene_warnings import scene_notices
from viscodesign.effects.gas_compressibility import CHOKING_MACH
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.postprocess.motion_limits import Limit, MotionBlock, limit_notices
from viscodesign.results.findings import Notice
from viscodesign.results.motion_arrays import MotionArrays

TIME = np.array([0.0, 0.5, 1.0])
AMBIENT = 101325.0
CURVE = "bellows.curve={rows: [[-20 kPa, -5e-5, -0.1, 0], [0, 0, 0, 0], [30 kPa, 2e-4, 0.3, 0]]}"
AIR = ("fluid=air", "temperature=20 degC")


@dataclass(frozen=True, eq=False)
class Simulated(SceneQuantities):
    """A scene with the effects that are active in its simulation."""

    active: frozenset[str]


def quantities(*overrides: str, taken: tuple[str, ...] = ()) -> Simulated:
    return Simulated(leg("bellows.count=4", *overrides), frozenset(taken))


def course(scene: SceneQuantities, **changes: Any) -> MotionBlock:
    """A run in which nothing happens, but for what is changed."""
    graph, rest = scene.graph, scene.bellow.rest_volume
    shape, flows = (len(TIME), len(graph.bellows)), (len(TIME), len(graph.tubes))
    told = {
        "time": TIME,
        "tip": np.tile([0.0, scene.body.length, 0.0], (len(TIME), 1)),
        "pressure": np.zeros(shape),
        "volume": np.full(shape, rest),
        "flow": np.zeros(flows),
        "tube_pressure": np.zeros(flows),
        "section_stretch": np.ones((len(TIME), graph.sections)),
        "section_turn": np.zeros((len(TIME), graph.sections)),
        **changes,
    }
    motion = MotionArrays(arrays=told, arc=np.zeros(0))
    block = MotionBlock(motion, slice(None), graph, tuple(scene.scene.inputs))
    vars(block)["tube_pressure"] = told["tube_pressure"]  # which the pressures would say
    return block


def at(scene: SceneQuantities, what: str, when: int, place: int, value: float) -> MotionBlock:
    """One number of a calm run changed."""
    values = getattr(course(scene), what).copy()
    values[when, place] = value
    return course(scene, **{what: values})


def notices(scene: Simulated, met: MotionBlock) -> list[Notice]:
    return list(motion_notices(scene, scene.active, [met]))


def codes(scene: Simulated, met: MotionBlock) -> list[str]:
    return [notice.code for notice in notices(scene, met)]


def flow_at(scene: SceneQuantities, mach: float) -> float:
    """Flow at which the gas at ambient density has a Mach number in the first tube."""
    sound = scene.scene.fluid.speed_of_sound
    assert sound is not None
    return mach * sound * math.pi * scene.graph.tubes[0].radius ** 2


def test_a_calm_run_has_nothing_to_tell() -> None:
    scene = quantities()
    assert notices(scene, course(scene)) == []


def test_a_run_that_ended_before_its_first_output_has_nothing_to_tell() -> None:
    scene = quantities()
    nothing = course(scene, time=np.zeros(0), pressure=np.zeros((0, 4)))
    assert notices(scene, nothing) == []


@pytest.mark.parametrize("rows", [1, 2, 3, 50])
def test_the_rates_of_the_tip_are_the_same_in_blocks_of_any_size(rows: int) -> None:
    """Second-order differences, exact for a parabola within the run, to first order at its ends."""
    time = np.array([0.0, 0.1, 0.3, 0.4, 0.8, 1.0, 1.1])
    tip = np.column_stack([0.3 * time**2, 0.1 - 0.4 * time**2, time])
    motion = MotionArrays(arrays={"time": time, "tip": tip}, arc=np.zeros(0))
    graph = quantities().graph
    met = [
        MotionBlock(motion, slice(k, min(k + rows, len(time))), graph, ("inlet",))
        for k in range(0, len(time), rows)
    ]
    rates = np.concatenate([block.tip_velocity for block in met])
    assert rates[1:-1] == pytest.approx(np.column_stack([0.6 * time, -0.8 * time, time**0])[1:-1])
    speed = np.concatenate([block.tip_speed for block in met])
    assert speed[1:-1] == pytest.approx(time[1:-1])
    assert speed[[0, -1]] == pytest.approx([0.05, 1.05])
    assert np.concatenate([block["tip"] for block in met]) == pytest.approx(tip)


def test_the_tip_of_a_single_output_has_no_speed() -> None:
    scene = quantities()
    met = course(scene, time=TIME[:1], tip=np.array([[0.0, 0.1, 0.0]]))
    assert met.tip_speed.tolist() == [0.0]


def test_a_limit_may_be_one_of_the_tip() -> None:
    tip = np.array([[0.0, 0.1, 0.0], [0.01, 0.1, 0.0], [0.05, 0.1, 0.1]])
    met = course(quantities(), tip=tip)

    def told(
        values: Callable[[MotionBlock], np.ndarray], bound: float
    ) -> list[tuple[float, float]]:
        limit = Limit(values, bound, lambda peak: Notice("far", f"{peak.value}", "", peak.time_s))
        return [(float(n.message), n.time_s or 0.0) for n in limit_notices([limit], [met])]

    assert told(lambda block: block.tip[:, 0], 0.04) == [(0.05, 1.0)]
    assert told(lambda block: block.tip[:, 0], 0.06) == []
    assert told(lambda block: block.tip_speed, 0.07) == [(pytest.approx(0.08), 1.0)]
    assert told(lambda block: np.abs(block.tip_velocity[:, 2:]), 0.3) == []


@pytest.mark.parametrize(("lag_s", "felt"), [(0.0, 1.0), (0.5, 1 - math.exp(-1)), (50.0, None)])
def test_a_burst_counts_by_how_long_it_lasts(lag_s: float, felt: float | None) -> None:
    scene = quantities()
    burst = at(scene, "flow", 1, 0, 1.0)
    limit = Limit(
        lambda block: block.flow,
        0.1,
        lambda peak: Notice("fast", f"{peak.value}", "", peak.time_s),
        lag_s=lag_s,
    )
    told = [float(notice.message) for notice in limit_notices([limit], [], [burst])]
    assert told == ([] if felt is None else [pytest.approx(felt)])
    (at_an_output,) = limit_notices([limit], [burst])
    assert float(at_an_output.message) == 1.0


def test_a_bellow_far_beyond_its_rest_volume_is_reported_with_size_and_place() -> None:
    scene = quantities()
    rest = scene.bellow.rest_volume
    assert codes(scene, at(scene, "volume", 1, 2, 2.6 * rest)) == []
    (told,) = notices(scene, at(scene, "volume", 1, 2, 5.0 * rest))
    assert (told.code, told.where, told.time_s) == ("large_volume", scene.graph.bellows[2], 0.5)
    assert "5 times its rest volume" in told.message


def test_a_measured_curve_answers_for_large_volumes() -> None:
    scene = quantities(CURVE, taken=("material_curve",))
    assert codes(scene, at(scene, "volume", 1, 2, 5.0 * scene.bellow.rest_volume)) == []


# -- flows ------------------------------------------------------------------


@pytest.mark.parametrize(
    ("mach", "taken", "expected"),
    [
        (0.29, (), []),
        (0.31, (), ["fast_gas"]),
        (0.79, (), ["fast_gas"]),
        (0.81, (), ["choking"]),
        (1.5, (), ["choking"]),
        (0.31, ("gas_compressibility",), []),
        (0.79, ("gas_compressibility",), []),
        (0.81, ("gas_compressibility",), ["choking"]),
    ],
)
def test_fast_gas(mach: float, taken: tuple[str, ...], expected: list[str]) -> None:
    scene = quantities(*AIR, taken=("flow_regime", *taken))
    met = at(scene, "flow", 1, 2, -flow_at(scene, mach))
    found = notices(scene, met)
    assert [n.code for n in found] == expected
    for notice in found:
        assert notice.where == scene.graph.tubes[2].name
        assert notice.time_s == 0.5
        assert f"the gas reaches Mach {mach:.3g}" in notice.message
        assert ("choke" in notice.message) == (mach > CHOKING_MACH)


def test_a_thin_gas_goes_faster_for_the_same_mass() -> None:
    """A flow is told at ambient density; where the pressure is a quarter it has four times the speed."""
    scene = quantities(*AIR, taken=("flow_regime", "gas_compressibility"))
    met = at(scene, "flow", 1, 0, flow_at(scene, 0.25))
    assert codes(scene, met) == []
    thin = met.tube_pressure.copy()
    thin[1, 0] = -0.75 * AMBIENT
    (notice,) = notices(scene, course(scene, flow=met.flow, tube_pressure=thin))
    assert notice.code == "choking"
    assert "Mach 1 " in notice.message
    # Without compressibility its density stays that of the surroundings.
    plain = quantities(*AIR, taken=("flow_regime",))
    assert codes(plain, course(plain, flow=met.flow, tube_pressure=thin)) == []


def test_the_exponent_counts_in_a_thin_gas() -> None:
    words = ("fluid={name: air, polytropic_exponent: 1.4}", "temperature=20 degC")
    scene = quantities(*words, taken=("flow_regime", "gas_compressibility"))
    met = at(scene, "flow", 1, 0, flow_at(scene, 0.5))
    thin = met.tube_pressure.copy()
    thin[1, 0] = -0.75 * AMBIENT
    (notice,) = notices(scene, course(scene, flow=met.flow, tube_pressure=thin))
    assert f"Mach {0.5 * 4 ** (1 / 1.4):.3g} " in notice.message


def test_below_vacuum_a_speed_is_still_finite() -> None:
    scene = quantities(*AIR, taken=("flow_regime", "gas_compressibility"))
    met = at(scene, "flow", 1, 0, flow_at(scene, 0.1))
    found = notices(scene, course(scene, flow=met.flow, tube_pressure=met.tube_pressure - 2e5))
    assert [n.code for n in found] == ["choking"]
    assert "inf" not in found[0].message


def test_a_liquid_near_mach_1_is_called_a_fluid_and_needs_a_speed_of_sound() -> None:
    water = quantities("fluid=water", "temperature=20 degC", taken=("flow_regime",))
    (notice,) = notices(water, at(water, "flow", 0, 0, flow_at(water, 0.5)))
    assert notice.message.startswith("the fluid reaches Mach 0.5")
    oil = quantities("fluid={name: oil, viscosity: 0.1, density: 900}", taken=("flow_regime",))
    assert codes(oil, at(oil, "flow", 0, 0, 1.0)) == []


@pytest.mark.parametrize("reynolds", [2299.0, 2301.0])
@pytest.mark.parametrize("taken", [(), ("flow_regime",)])
def test_turbulence_draws_a_warning_where_no_term_models_it(
    reynolds: float, taken: tuple[str, ...]
) -> None:
    scene = quantities("fluid={name: oil, viscosity: 0.1, density: 900}", taken=taken)
    radius = scene.graph.tubes[1].radius
    met = at(scene, "flow", 2, 1, reynolds * math.pi * 0.1 * radius / (2 * 900))
    found = notices(scene, met)
    if reynolds < 2300 or taken:
        assert found == []
        return
    (notice,) = found
    assert (notice.code, notice.where, notice.time_s) == ("turbulent_flow", "R1-R2", 1.0)
    assert "in 1 of 4 tubes" in notice.message


def test_without_tubes_no_flow_is_judged() -> None:
    scene = quantities()
    vars(scene)["graph"] = replace(scene.graph, tubes=())
    assert course(scene).flow.shape == (3, 0)
    assert notices(scene, course(scene)) == []


# -- bellows ----------------------------------------------------------------


@pytest.mark.parametrize(
    ("pressure", "expected"),
    [(-30e3, "extrapolated_curve"), (-20e3, ""), (30e3, ""), (45e3, "extrapolated_curve")],
)
def test_beyond_the_measured_curve(pressure: float, expected: str) -> None:
    scene = quantities(CURVE, taken=("material_curve",))
    found = notices(scene, at(scene, "pressure", 1, 3, pressure))
    assert [n.code for n in found] == ([expected] if expected else [])
    for notice in found:
        assert notice.where == "L2"
        assert notice.time_s == 0.5
        assert f"reaches {pressure / 1e3:.4g} kPa gauge" in notice.message
        assert "-20 to 30 kPa" in notice.message


def test_a_curve_that_is_off_is_not_left() -> None:
    scene = quantities(CURVE)
    assert codes(scene, at(scene, "pressure", 1, 3, 45e3)) == []


@pytest.mark.parametrize(
    ("share", "expected"),
    [(0.2, []), (0.099, []), (0.097, ["collapse"]), (0.0, ["negative_volume"]), (-1.0, ["negative_volume"])],
)  # fmt: skip
def test_bellows_below_their_floor(share: float, expected: list[str]) -> None:
    """Loads may take up to 2 % of the floor besides."""
    scene = quantities()
    met = at(scene, "volume", 1, 2, share * scene.bellow.rest_volume)
    found = notices(scene, met)
    assert [n.code for n in found] == expected
    for notice in found:
        assert (notice.where, notice.time_s) == ("L1", 0.5)
        assert "1 of 4 bellows fall below their minimum of 0.1" in notice.message


@pytest.mark.parametrize("taken", ["collapse", "material_curve"])
def test_a_floor_is_announced_only_where_the_linear_law_rules(taken: str) -> None:
    low = "input={kind: table, rows: [[0, 0], [1, -33 kPa], [2, -34 kPa]]}"
    scene, active = quantities(low), frozenset({taken})
    assert "collapse" in [n.code for n in scene_notices(scene, frozenset())]
    assert "collapse" not in [n.code for n in scene_notices(scene, active)]
    emptied = "input={kind: table, rows: [[0, 0], [1, -36 kPa]]}"
    scene = quantities(emptied)
    assert "negative_volume" in [n.code for n in scene_notices(scene, frozenset())]
    assert "negative_volume" not in [n.code for n in scene_notices(scene, active)]


def test_a_run_with_collapse_is_not_warned_of_it() -> None:
    deep = ("input={kind: table, rows: [[0, 0], [1, -60 kPa]]}",
            "run={duration: 1 s, output_interval: 0.1 s}")  # fmt: skip
    for mode, expected in (("on", False), ("off", True)):
        scene = leg("bellows.count=4", *deep, f"effects={{collapse: {mode}, others: off}}")
        found = simulate(scene, verify=False)
        assert found.status == "complete"
        assert bool({"collapse", "negative_volume"} & {w.code for w in found.warnings}) is expected


@pytest.mark.parametrize(
    ("fluid", "absolute", "expected"),
    [
        ("water", 3e3, []),
        ("water", 2e3, ["cavitation"]),
        ("air", 1e3, []),
        ("air", -1.0, ["below_vacuum"]),
    ],
)
def test_too_little_pressure(fluid: str, absolute: float, expected: list[str]) -> None:
    scene = quantities(f"fluid={fluid}", "temperature=20 degC")
    found = notices(scene, at(scene, "pressure", 2, 1, absolute - AMBIENT))
    assert [n.code for n in found] == expected
    assert all((n.where, n.time_s) == ("R2", 1.0) for n in found)


# -- shape ------------------------------------------------------------------


def test_strains() -> None:
    scene = quantities()
    pressed = notices(scene, at(scene, "section_stretch", 1, 1, 0.19))
    assert pressed[0].code == "small_stretch"
    assert pressed[0].where == "section 2"
    assert codes(scene, at(scene, "section_stretch", 1, 1, 0.21)) == []
    (drawn,) = notices(scene, at(scene, "section_stretch", 1, 1, 2.01))
    assert (drawn.code, drawn.where, drawn.time_s) == ("large_stretch", "section 2", 0.5)
    assert "2.01 times" in drawn.message
    assert codes(scene, at(scene, "section_stretch", 1, 1, 1.99)) == []
    # A section of 54.5 mm whose inner side stands 15 mm from the axis.
    length, half = scene.body.section_length, 0.015
    assert codes(scene, at(scene, "section_turn", 0, 0, -1.01 * length / half)) == ["self_contact"]
    assert codes(scene, at(scene, "section_turn", 0, 0, -0.99 * length / half)) == []
    turning = np.full((3, 2), 1.01 * math.pi)
    turning[1:] = 0.0
    (notice,) = notices(scene, course(scene, section_turn=turning))
    assert (notice.code, notice.time_s) == ("full_turn", 0.0)


# -- a gas that runs out ----------------------------------------------------

SUCKED = ("bellows.count=4", "input={kind: table, rows: [[0, 0], [1, -90 kPa]]}",
          "run={duration: 1 s, output_interval: 0.02 s}")  # fmt: skip
GAS = "gas_compressibility: on, pressure_distribution: on, others: off"


def test_a_gas_bellow_sucked_empty_ends_the_run_by_its_name() -> None:
    found = simulate(leg(*SUCKED, f"effects={{collapse: off, {GAS}}}"), verify=False)
    assert found.status == "failed"
    assert found.failure is not None
    assert "R1 reached its minimum (collapsed) volume at t = " in found.failure
    assert "collapse" in found.failure
    # The linear law comes to its floor at -31.7 kPa, which the inlet passes after 0.39 s.
    assert 0.36 < found.time[-1] < 0.4
    assert len(found.time) == len(found.tip)
    assert np.all(np.isfinite(found.tip))


def test_with_walls_that_meet_it_goes_on() -> None:
    found = simulate(leg(*SUCKED, f"effects={{collapse: on, {GAS}}}"), verify=False)
    assert found.status == "complete", found.failure
    assert np.all(found.volume > 0.0)


def test_the_remedy_is_what_auto_does() -> None:
    scene = SceneQuantities(leg(*SUCKED, "effects={gas_compressibility: on}"))
    assert "collapse" in {e.name for e in select_effects(scene).effects}
