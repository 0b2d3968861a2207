"""A pump plan against closed forms, and against the simulation of its own plunger."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import yaml

from tests.scenes import CONFIGS, leg
from viscodesign import PumpPlan, Scene, load, plan, simulate
from viscodesign.loading import load_pumped
from viscodesign.pump.ax.servo_drive import ServoDrive
from viscodesign.pump.planning.demand import feed_line_at
from viscodesign.pump.planning.demand_kinds import pump_of
from viscodesign.pump.planning.limits import verdicts
from viscodesign.pump.planning.motion import active_effects
from viscodesign.pump.planning.plan import requested_motion
from viscodesign.pump.planning.scene_variants import (
    planned,
    with_effects_of,
    with_inputs,
)
from viscodesign.pump.planning.simulated_actuator import ActuatorPlant
from viscodesign.pump.plunger.barrel import Barrel
from viscodesign.pump.report.plan_folder import plan_columns, write_plan

AMBIENT = 101325.0
AREA = np.pi * 0.0349**2 / 4
PUMP = "pump={syringe_diameter: 34.9 mm, home: 500, dead_volume: 5 mL}"
COMPLIANCE = 18e-3 * 3.413e-9
REST = 10e-3 * 12e-3 * 18e-3
COUNT = 4
LEG_4 = "leg_4_air_auto"


@cache
def published() -> PumpPlan:
    return plan(leg(config="leg_16_pump_published"))


def severities(*changes: str) -> dict[str, str]:
    """Verdicts on the published pulse after some changes; no further ones are sought."""
    scene = leg(*changes, config="leg_16_pump_published")
    _, requested = requested_motion(scene)
    return {v.name: v.severity for d in requested.demands(pump_of(scene)) for v in verdicts(d)}


def static(fluid: str, pressure: float, *words: str) -> PumpPlan:
    """A plan that holds one pressure; nothing in the rod takes up volume."""
    return plan(
        leg(
            PUMP,
            f"fluid={fluid}",
            "temperature=20 degC",
            f"input={{kind: constant, value: {pressure!r} Pa}}",
            "run={duration: 1 s}",
            f"bellows.count={COUNT}",
            *words,
            config="leg_4_air_auto",
        )
    )


@pytest.mark.parametrize("feeds", [1, 3])
@pytest.mark.parametrize("pressure", [12e3, -8e3])
def test_volume_to_hold_a_static_pressure_gas(pressure: float, feeds: int) -> None:
    """Barrel, bellows and tubes are one closed vessel of constant content (Boyle).

    n C p for the walls, and the gas of everything at the new pressure; of all actuators that
    the pump feeds.
    """
    own = "effects={feedback: off, others: auto}"
    found = static("air", pressure, own, f"pump.feeds={feeds}")
    ratio = (AMBIENT + pressure) / AMBIENT
    drive = ServoDrive(leg(PUMP).pump)  # type: ignore[arg-type]
    full = AREA * drive.filled_at_home + 5e-6
    tube = np.pi * 0.325e-3**2 * 37.5e-3
    tubes = COUNT * tube
    # rho (full - A x + n (V0 + C p) + V_tubes) = full + n V0 + V_tubes
    others, walls = feeds * (COUNT * REST + tubes), feeds * COUNT * COMPLIANCE
    left = (full + others) / ratio - others - walls * pressure
    assert found.wanted.columns["volume_m3"][-1, 0] == pytest.approx(full - left, rel=1e-6)
    # Half of the first tube belongs to the inlet.
    behind = others - feeds * tube / 2
    given = ratio * (behind + walls * pressure) - behind
    assert found.wanted.columns["given_m3"][-1, 0] == pytest.approx(given, rel=1e-6)


@pytest.mark.parametrize("pressure", [12e3, -8e3])
def test_volume_to_hold_a_static_pressure_liquid(pressure: float) -> None:
    """n C p, the compression of the cushion, and that of the liquid, a hundredth of a percent."""
    fluid = "{name: liquid, viscosity: 1e-3, density: 1000, bulk_modulus: 2e9}"
    found = static(fluid, pressure, "effects={feedback: off, others: auto}")
    cushion = 5e-6 * (1 - AMBIENT / (AMBIENT + pressure))
    expected = COUNT * COMPLIANCE * pressure + cushion
    drive = ServoDrive(leg(PUMP).pump)  # type: ignore[arg-type]
    own = AREA * drive.filled_at_home * pressure / 2e9
    assert found.wanted.columns["volume_m3"][-1, 0] == pytest.approx(expected + own, rel=1e-4)


def test_three_legs_move_as_their_pump_was_planned_for_them() -> None:
    small = ("input={kind: sine, amplitude: 4 kPa, frequency: 0.3 Hz}", "run.duration=3 s")
    found, alone = (
        plan(leg(*small, f"pump.feeds={count}", config="leg_16_pump")) for count in (3, 1)
    )
    assert found.wanted.columns["given_m3"] == pytest.approx(
        3 * alone.wanted.columns["given_m3"], rel=1e-6, abs=1e-9
    )
    # A gas yields in the barrel as it does for one; the rest is what the legs take up.
    density = 1 + found.wanted.pressure / AMBIENT
    more = found.wanted.columns["volume_m3"] - alone.wanted.columns["volume_m3"]
    assert more == pytest.approx(2 * alone.wanted.columns["given_m3"] / density, rel=0.02, abs=1e-8)
    # Both plans are within the pump's speed and travel: what it does is what was asked for.
    assert found.clipped == alone.clipped == ()
    assert found.deviation.max() < 0.01 * leg().actuator.length


def test_isothermal_dead_volume() -> None:
    """A larger dead volume costs the plunger exactly its compression."""
    small, large = (
        static("air", 15e3, f"pump.dead_volume={volume} mL").wanted.columns["volume_m3"][-1, 0]
        for volume in (5, 45)
    )
    assert large - small == pytest.approx(40e-6 * (1 - AMBIENT / (AMBIENT + 15e3)), rel=1e-6)


@pytest.mark.parametrize(
    ("config", "words"),
    [
        ("leg_16_pump", ()),
        (LEG_4, (PUMP, "input={kind: sine, amplitude: 8 kPa, frequency: 0.5 Hz}")),
        (
            LEG_4,
            (
                PUMP,
                "input={kind: sine, amplitude: 8 kPa, frequency: 0.3 Hz, mean: 5 kPa}",
                "gauge_pressure=3 kPa",
                "fluid.polytropic_exponent=1.3",
                "network.feed_line={length: 0.5 m, radius: 1.5 mm}",
                "network.tube_wall={youngs_modulus: 5 MPa, thickness: 0.5 mm}",
            ),
        ),
        (
            "leg_4_water_auto",
            (PUMP, "input={kind: sine, amplitude: 8 kPa, frequency: 0.2 Hz}"),
        ),
    ],
)
def test_the_planned_plunger_reproduces_the_requested_pressure(
    config: str, words: tuple[str, ...]
) -> None:
    """Round trip, nothing rounded or clipped: pressures -> plunger -> pressures and tip."""
    if config != "leg_16_pump":
        words = (*words, "run={duration: 4 s}")
    scene = planned(leg(*words, config=config))
    wanted = simulate(scene)
    settled = with_effects_of(scene, wanted)
    assert scene.pump is not None
    line = feed_line_at(settled, "inlet", active_effects(wanted))
    barrel = Barrel(settled, ServoDrive(scene.pump), line)
    pressure, given = wanted.inlet_pressure["inlet"], wanted.inflow["inlet"]
    place = barrel.position(pressure, given)
    driven = with_inputs(settled, {"inlet": barrel.syringe(wanted.time, place)})
    found = simulate(driven)
    assert found.status == wanted.status == "complete"
    stated = [run.accuracy.estimated_tip_error_m for run in (wanted, found)]
    assert None not in stated
    apart = np.hypot(*(found.tip - wanted.tip)[:, :2].T)
    assert np.max(apart) <= sum(e for e in stated if e is not None)
    swing = np.ptp(pressure)
    assert np.max(np.abs(found.inlet_pressure["inlet"] - pressure)) <= 5e-3 * swing
    assert found.inflow["inlet"] == pytest.approx(given, abs=5e-3 * float(np.ptp(given)))


def test_the_published_pulse_exceeds_five_limits() -> None:
    found = published()
    assert not found.is_feasible
    told = {v.name: v for v in found.verdicts}
    failed = {name for name, v in told.items() if v.severity == "infeasible"}
    assert failed == {"stall", "speed", "travel", "barrel", "suction"}
    assert told["suction"].wanted == pytest.approx(-100.89e3, abs=50.0)
    assert told["cap_torque"].severity == "advice"
    assert "38.67 kPa gauge" in told["cap_torque"].message
    assert found.deviation_m > 0.04
    assert found.achievable.steps.min() >= 100 - 1e-9
    assert found.achievable.steps.max() <= 1000 + 1e-9
    low = found.limits["stall_nm"]
    assert np.max(np.abs(found.achievable.columns["torque_nm"])) < low


def test_the_achievable_motion_respects_the_speed_limit() -> None:
    assert np.max(published().achievable.columns["speed_share"]) <= 1.02


def test_the_combined_changes_make_it_feasible() -> None:
    changes = published().together
    assert changes
    settings = [setting for change in changes for setting in change.settings]
    found = severities(*settings)
    assert {v.name for v in published().verdicts} == set(found)
    assert "infeasible" not in found.values()


def test_each_change_alone_makes_its_verdict_pass() -> None:
    found = published()
    tried = [(v.name, c) for v in found.verdicts for c in v.changes if v.name == "suction"]
    assert tried
    for name, change in tried:
        passed = severities(*change.settings)
        assert passed[name] == "ok"
        left = {n for n, severity in passed.items() if severity == "infeasible"}
        assert left == set(change.leaves)


def test_a_jump_is_cured_by_a_ramp() -> None:
    found = plan(
        leg(
            PUMP,
            "input={kind: step, value: 10 kPa, time: 0.5 s}",
            "run={duration: 1.5 s}",
            config=LEG_4,
        )
    )
    speed = next(v for v in found.verdicts if v.name == "speed")
    assert speed.severity == "infeasible"
    assert "jumps" in speed.message
    assert speed.changes[0].key == "ramp"
    assert found.clipped
    assert found.clipped[0].startswith("speed")


def test_two_pumps_on_networks_of_their_own() -> None:
    words = "pump={syringe_diameter: 34.9 mm, servo_id: {left: 4, right: 7}, home: 500}"
    found = plan(leg(words, "run.duration=3 s", config="antagonistic_two_inlets"))
    assert found.inlets == ("left", "right")
    assert found.axes == (4, 7)
    assert found.wanted.steps.shape[1] == 2
    assert found.is_feasible
    assert found.deviation_m < 2e-4


def test_plan_files_agree_with_the_plan(tmp_path: Path) -> None:
    found = published()
    files = write_plan(found, tmp_path)
    assert [file.name for file in files] == ["plan.csv", "plan.json", "plan.png"]
    assert sorted(p.name for p in tmp_path.iterdir()) == sorted(f.name for f in files)
    table = np.genfromtxt(files[0], delimiter=",", names=True)
    names, values = plan_columns(found)
    assert list(table.dtype.names or ()) == names
    assert np.array(table.tolist()) == pytest.approx(values, nan_ok=True, rel=1e-15)
    document = json.loads(files[1].read_text())
    assert document["feasible"] is False
    assert [v["name"] for v in document["verdicts"]] == [v.name for v in found.verdicts]
    assert document["together"][0]["settings"]
    write_plan(found, tmp_path, plots=False)
    assert not (tmp_path / "plan.png").exists()


def test_the_live_actuator_agrees_with_the_simulation() -> None:
    """Tick by tick the same as in one run; the work per tick is bounded."""
    scene: Scene = leg(config="leg_16_pump")
    assert scene.pump is not None
    plant, tick = ActuatorPlant(scene), 0.033
    places = [0.02 * np.sin(np.pi * (k + 1) * tick) for k in range(60)]
    pressure = np.array([plant.advance(tick, np.array([place])) for place in places])
    assert plant.steps <= 4 * len(places)
    time = tick * np.arange(len(places) + 1)
    fine = planned(scene)
    barrel = Barrel(fine, ServoDrive(scene.pump), feed_line_at(fine, "inlet", frozenset()))
    driven = with_inputs(fine, {"inlet": barrel.syringe(time, np.array([0.0, *places]))})
    run = driven.run.model_copy(
        update={"duration": float(time[-1]), "output_times": tuple(time.tolist())}
    )
    found = simulate(driven.model_copy(update={"run": run}))
    expected = found.inlet_pressure["inlet"][1:, None]
    assert pressure == pytest.approx(expected, abs=1e-3 * float(np.ptp(expected)))
    assert np.hypot(*(plant.tip - found.tip[-1])[:2]) < 5e-3 * scene.actuator.length


@pytest.mark.parametrize("feeds", [1, 3])
def test_the_live_actuator_starts_in_equilibrium_at_its_plungers(feeds: int) -> None:
    """Before any time has passed it is in the equilibrium of the plan's closed forms."""
    several = f"pump.feeds={feeds}"
    scene = leg(several, config="leg_16_pump")
    found = plan(leg("input={kind: constant, value: 10 kPa}", several, config="leg_16_pump"))
    plant = ActuatorPlant(scene)
    place = found.wanted.columns["plunger_m"][-1]
    assert plant.advance(0.0, place) == pytest.approx([10e3], rel=1e-3)
    assert plant.advance(0.033, place) == pytest.approx([10e3], rel=1e-3)


def test_the_bundled_pump_scenes_exist() -> None:
    assert (CONFIGS / "leg_16_pump.yaml").exists()
    assert (CONFIGS / "leg_16_pump_published.yaml").exists()


@pytest.mark.parametrize("effects", ["gas_compressibility"])
def test_three_actuators_are_planned_as_three_that_are_fed_alike(effects: str) -> None:
    """Against `pump.feeds`, which knows of them that they are equal, and solves one."""
    spec = yaml.safe_load((CONFIGS / "leg_16_pump.yaml").read_text())
    spec |= {
        "input": {"kind": "sine", "amplitude": "4 kPa", "frequency": "1 Hz"},
        "run": {"duration": "1 s"},
        "effects": {effects: "on", "pressure_distribution": "on", "others": "off"},
    }
    spec["bellows"]["count"] = COUNT
    own = {key: spec.pop(key) for key in ("actuator", "bellows", "network")}
    one = spec | own | {"pump": spec["pump"] | {"feeds": 3}}
    legs = {"a": own, "b": {"like": "a"}, "c": {"like": "a"}}
    three = spec | {"actuators": legs, "inputs": {"main": spec["input"]}}
    del three["input"]
    found, expected = plan(load_pumped(three)), plan(load(one))
    # Both are as accurate as their solutions, whose steps differ.
    for of in ("given_m3", "plunger_m"):
        this, other = (each.wanted.columns[of] for each in (found, expected))
        assert this == pytest.approx(other, abs=1e-4 * float(np.ptp(other)))
    names, values = plan_columns(found)
    for actuator in legs:
        tip = values[:, names.index(f"wanted_{actuator}_tip_x_m")]
        assert tip == pytest.approx(expected.wanted_run.tip[:, 0], abs=1e-5)
    assert found.deviation_m == pytest.approx(expected.deviation_m, abs=1e-5)
