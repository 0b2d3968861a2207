"""How a robot walks: what must hold in every gait, and what was found of the paper's."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.robots import hexapod, mirrored, moved
from tests.scenes import leg
from tests.thorough import ALL
from viscodesign import SpecError, WalkStudy, load_robot, simulate, stand, walk
from viscodesign.cli.main import main
from viscodesign.cli.texts.walk_text import walk_lines
from viscodesign.cli.walk import no_speed
from viscodesign.errors import SolveError
from viscodesign.report.film.walk_film import write_walk_film
from viscodesign.report.page.gait_page import gait_data
from viscodesign.report.picture_options import picture_options
from viscodesign.report.read_gait import read_gait
from viscodesign.report.walk_folder import write_walk
from viscodesign.robot.build_robot import build_robot
from viscodesign.robot.energy import GaitEnergyLedger
from viscodesign.robot.gait_numbers import pump_uses
from viscodesign.robot.leg_design import leg_design
from viscodesign.robot.leg_equations import leg_functions
from viscodesign.robot.march import StepPlan, march
from viscodesign.robot.robot_check import check_robot
from viscodesign.robot.robot_model import Feet, LegGroup, RigidBody, RobotModel
from viscodesign.robot.stance import set_down
from viscodesign.robot.stated_speed import refusal
from viscodesign.robot.time_step import RobotState, Step, StepSolver
from viscodesign.robot.walk import start_state
from viscodesign.scene.robot import RobotPump

COARSE = 125
"""Steps of a cycle: the advance is within 2.5 % of that of infinitely many."""


@pytest.fixture(scope="module")
def study() -> WalkStudy:
    return walk(hexapod("run.duration=10 s", "accuracy=2 %"), steps_per_cycle=COARSE)


def test_the_paper_s_gait_is_found(study: WalkStudy) -> None:
    """0.05 body lengths a second are published; legs that lean by 2 degrees reach 0.053."""
    assert study.refusal == ""
    assert study.speed_body_lengths_per_s == pytest.approx(0.053, abs=0.001)
    assert study.advance_per_cycle_m == pytest.approx(-0.0335, abs=5e-4)
    assert study.step_halving_change < 0.03
    assert all(0.8e-3 < foot.lift_m < 3e-3 for foot in study.feet.values())


def test_the_pumps_do_what_a_prototype_found(study: WalkStudy) -> None:
    """31 mL of barrel and 40 mL/s."""
    assert 1e6 * study.pump_volume_m3 == pytest.approx(31, abs=2)
    assert 1e6 * max(pump.flow_m3_s for pump in study.pumps.values()) == pytest.approx(40, abs=2)
    assert all(pump.is_feasible for pump in study.pumps.values())


def test_a_barrel_is_judged_by_the_whole_run(study: WalkStudy) -> None:
    """It must hold what the first strokes give back, too."""
    barrel = study.motion.barrel
    for k, pump in enumerate(study.pumps.values()):
        assert pump.run_volume_m3 == pytest.approx(np.max(barrel[:, k]) - np.min(barrel[:, k]))
    least, most = study.pump_volume_m3, study.pump_run_volume_m3
    assert most > 1.05 * least
    told = [
        pump_uses(study.motion, RobotPump(volume=volume))
        for volume in (1.01 * least, 0.99 * most, 1.01 * most)
    ]
    can = [all(own.is_feasible for own in uses.values()) for uses in told]
    assert can == [False, False, True]
    text = "\n".join(walk_lines(study, Path("out"), []))
    assert f"{1e6 * most:.3g} mL in the run" in text


def test_contact_is_exact(study: WalkStudy) -> None:
    found = study.invariants
    assert found.worst_penetration_m <= 1e-12
    assert found.worst_gap_force_n_m <= 1e-12
    assert found.worst_cone_excess_n <= 1e-9
    assert found.largest_friction_work_j <= 1e-14
    assert found.friction_work_j < -1e-3


def test_balances_hold(study: WalkStudy) -> None:
    assert study.invariants.force_imbalance_rel < 1e-9
    assert study.invariants.gas_mass_imbalance_rel < 1e-8


def test_energy_is_accounted_for(study: WalkStudy) -> None:
    """What the pumps and the coupling give is stored or lost, up to the trapezoidal rule."""
    energy = study.energy
    assert energy.imbalance_rel < 1e-3
    assert energy.work_j["friction"] == pytest.approx(study.invariants.friction_work_j, rel=1e-9)
    given = energy.cycle_work_j["pump"] + energy.cycle_work_j["coupling"]
    gone = sum(energy.cycle_loss_j.values()) - energy.cycle_work_j["friction"]
    assert given == pytest.approx(gone + energy.cycle_stored_j, rel=1e-3)
    assert abs(energy.cycle_stored_j) < 2e-3 * given  # a cycle ends nearly as it began
    assert min(energy.cycle_loss_j.values()) >= 0.0


def test_a_mirrored_robot_walks_mirrored() -> None:
    own, other = moved(hexapod(), 60, 1), moved(mirrored(), 60, 1)
    size = np.max(np.abs(own.body[:, 0]))
    assert size > 5e-3
    np.testing.assert_allclose(other.body[:, 0], -own.body[:, 0], atol=1e-6 * size)
    np.testing.assert_allclose(
        other.body[:, 2], -own.body[:, 2], atol=1e-6 * np.max(np.abs(own.body[:, 2]))
    )
    np.testing.assert_allclose(other.body[:, 1], own.body[:, 1], atol=1e-9)


@pytest.mark.skipif(not ALL, reason="thorough; mirrored front to back is tested")
def test_left_and_right_swapped_walks_the_same_way() -> None:
    data = hexapod().model_dump()
    for each in data["robot"]["legs"].values():
        each["y"] = -each["y"]
    own, other = moved(hexapod(), 60, 1), moved(load_robot(data), 60, 1)
    np.testing.assert_allclose(other.body[:, :3], own.body[:, :3], atol=1e-9)
    np.testing.assert_allclose(other.body[:, 3], -own.body[:, 3], atol=1e-9)
    assert np.max(np.abs(own.body[:, 3])) > 1e-4


def test_small_strokes_walk_the_other_way_at_a_shorter_period() -> None:
    small = "inputs.A.amplitude=5 kPa"
    slow = moved(hexapod(small), 80, 3).advances[-1]
    fast = moved(
        hexapod(small, "inputs.A.frequency=0.8333333333 Hz", "inputs.B.delay=0.6 s"), 80, 4
    ).advances[-1]
    assert slow < -5e-3
    assert fast > 2e-3


def test_an_undamped_gait_states_no_speed() -> None:
    found = walk(hexapod("robot.damping_time=0 s", "run.duration=5 s"), steps_per_cycle=40)
    assert "robot.damping_time" in found.refusal
    assert len(found.advances_by_step_m) == 3
    document = found.document()
    assert document["status"] == "refused"
    assert document["speed_body_lengths_per_s"] is None
    assert document["advance_per_cycle_m"] is None


def test_a_hand_over_at_one_instant_solves() -> None:
    """Both tripods change at once, and all feet bear the same for a moment."""
    square = "{kind: square, high: 8 kPa, low: -8 kPa, frequency: 0.8 Hz, duty: 50 %}"
    found = moved(
        hexapod(f"inputs.A={square}", "inputs.B.delay=0.625 s", "gauge_pressure=20 kPa"), 100, 2
    )
    assert np.min(found.feet[..., 1]) > -1e-12
    assert np.all(np.abs(found.friction) <= 0.6 * found.normal + 1e-9)


def test_a_robot_that_is_dropped_comes_to_stand() -> None:
    scene = hexapod("robot.hip_height=150 mm")
    model = build_robot(scene)
    state, pressures = start_state(scene, model), np.full(2, scene.gauge_pressure)
    solver = StepSolver(model, 0.01)
    first = solver.advance(state, pressures)
    assert first.velocity[1] == pytest.approx(9.80665 * 0.01)
    assert not first.contact_forces.any()
    state = first
    for _ in range(250):
        state = solver.advance(state, pressures)
    height = float(np.mean(model.hip_heights(state.place)))
    assert height == pytest.approx(stand(hexapod()).own.height_m, abs=1e-5)
    assert np.max(np.abs(state.velocity[:4])) < 1e-4  # gas still settles


def test_a_robot_in_flight_keeps_to_its_parabola() -> None:
    """Whatever the step; the energy that it gains is what its weight does."""
    scene = hexapod("robot.hip_height=400 mm")
    model, pressures = build_robot(scene), np.full(2, scene.gauge_pressure)
    for step in (0.05, 0.02):
        state, solver = start_state(scene, model), StepSolver(model, step)
        ledger, high = GaitEnergyLedger(model), float(np.mean(model.hip_heights(state.place)))
        for _ in range(round(0.2 / step)):
            after = solver.advance(state, pressures)
            ledger.add(Step(solver, state, after, pressures, pressures))
            state = after
        fallen = high - float(np.mean(model.hip_heights(state.place)))
        assert fallen == pytest.approx(9.80665 * 0.2**2 / 2, rel=1e-9)
        assert state.velocity[1] == pytest.approx(9.80665 * 0.2, rel=1e-9)
        found = ledger.balance(0.0)
        assert abs(found.loss_j["steps"]) < 1e-9 * model.weight * fallen


def test_the_error_of_paths_is_that_of_halving_the_step(study: WalkStudy) -> None:
    """The next halving moves them by about half as much: the order is one."""
    assert 0.0 < study.body_path_error_m < 5e-3
    assert study.body_path_error_m <= study.feet_path_error_m < 5e-3
    assert f"body's path within {1e3 * study.body_path_error_m:.3g} mm" in "\n".join(
        walk_lines(study, Path("out"), [])
    )


def test_a_leg_with_gas_moves_as_simulate_moves_it() -> None:
    """One weightless foot in the air below a body that nothing moves."""
    scene = leg(
        "effects={pressure_distribution: on, gas_compressibility: on, feedback: on, damping: on, others: off}",
        "loads.gravity=off", "gauge_pressure=38.7 kPa", "accuracy=0.01 %",
        "network.entrance_loss=0", "network.exit_loss=0",
        "input={kind: sine, amplitude: 10 kPa, frequency: 0.4 Hz}",
        "run={duration: 2.5, output_interval: 0.1}",
    )  # fmt: skip
    expected = simulate(scene, verify=False)
    functions = leg_functions(leg_design(scene))
    group = LegGroup(functions, np.array([0]), np.zeros((1, 5)), np.array([0]))
    model = RobotModel(
        RigidBody(1e9, 1e9, 1e9),
        Feet(1e-9, 0.0, 0.5),
        (group,),
        ("only",),
        ("A",),
        1e-3,
        (0.0, 0.0),
    )
    place, legs = set_down(model, np.array([38.7e3]))
    place[[1, 5]] -= 0.05
    state = RobotState(0.0, place, np.zeros(7), legs, np.zeros(2), (0,), np.zeros(1))
    solver, tips = StepSolver(model, 0.01), []
    for k in range(1, 251):
        state = solver.advance(
            state, np.array([38.7e3 + 10e3 * np.sin(2 * np.pi * 0.4 * 0.01 * k)])
        )
        tips.append(state.place[4:6] - state.place[:2])
    found = np.array(tips)[9::10]
    apart = np.hypot(*(found - expected.tip[1:, :2]).T)
    way = np.ptp(expected.tip[:, 0])
    assert np.max(apart) < 2e-3 * way


@pytest.mark.parametrize(
    ("overrides", "message"),
    [
        (["run.duration=4 s"], r"run.duration: 4 s is less than 2 cycles of 2.5 s"),
        (
            ["inputs.A={kind: step, value: 5 kPa, time: 1 s}"],
            "inputs: a gait needs inputs that repeat",
        ),
        (
            ["inputs.A.amplitude=145 kPa"],
            r"inputs.A: the lowest pressure, -106.3 kPa gauge .* is -4.97\d kPa absolute; must be above",
        ),
        (
            ["gauge_pressure=-150 kPa"],
            "gauge_pressure: -150 kPa gauge .* is -48.67 kPa absolute",
        ),
        (["run.max_steps=100"], "run.max_steps: the gait needs 1250 steps"),
    ],
)
def test_gaits_that_cannot_be_are_told(overrides: list[str], message: str) -> None:
    with pytest.raises(SpecError, match=message):
        walk(hexapod(*overrides))


@pytest.mark.parametrize(
    ("stop", "status"),
    [(KeyboardInterrupt(), 130), (SolveError("it broke", quantity="place", where="robot"), 3)],
)
def test_what_was_solved_is_kept(
    stop: BaseException, status: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where the second solution ends, the first one stays, without a speed."""
    plans = []

    def once(
        model: RobotModel, start: RobotState, pressures: Any, plan: StepPlan, told: Any
    ) -> Any:
        plans.append(plan)
        if len(plans) > 1:
            raise stop
        return march(model, start, pressures, plan, told)

    monkeypatch.setattr("viscodesign.robot.walk.march", once)
    found = walk(hexapod("run.duration=5 s"), steps_per_cycle=30)
    error = no_speed(found)
    assert error is not None
    assert error.exit_code == status
    assert len(found.advances_by_step_m) == 1
    assert np.isnan(found.step_halving_change)
    assert found.document()["status"] == "refused"


@pytest.mark.parametrize(
    ("stop", "status", "told"),
    [
        (KeyboardInterrupt(), 130, "interrupted"),
        (SolveError("it broke", quantity="place", where="robot"), 3, "failed"),
    ],
)
def test_the_beginning_of_a_gait_is_kept(
    stop: BaseException, status: int, told: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where the first solution ends within its first cycle, what it has is written."""
    advance = StepSolver.advance

    def until(self: StepSolver, now: RobotState, sources: np.ndarray) -> RobotState:
        if now.time > 0.5:
            raise stop
        return advance(self, now, sources)

    monkeypatch.setattr(StepSolver, "advance", until)
    found = walk(hexapod("run.duration=5 s"), steps_per_cycle=50)
    error = no_speed(found)
    assert error is not None
    assert error.exit_code == status
    document = found.document()
    assert (document["status"], document["advance_per_cycle_m"]) == (told, None)
    assert 0.5 < found.motion.time[-1] < 0.6
    files = write_walk(found, tmp_path)
    rows = np.genfromtxt(next(f for f in files if f.name == "walk.csv"), delimiter=",", names=True)
    assert rows["time_s"][-1] <= found.motion.time[-1]
    assert walk_lines(found, tmp_path, files)


def test_a_step_that_does_not_converge_is_halved() -> None:
    """Twenty steps a cycle are too few for Newton's method."""
    found = moved(hexapod(), 20, 1)
    assert np.min(found.feet[..., 1]) > -1e-12
    assert found.advances[0] == pytest.approx(moved(hexapod(), 60, 1).advances[0], rel=0.2)


def test_a_robot_that_sways_does_not_start() -> None:
    with pytest.raises(SolveError, match="sways on its legs at the start"):
        walk(hexapod("robot.payload=9 kg"))


def test_files_of_a_gait(study: WalkStudy, tmp_path: Path) -> None:
    files = write_walk(study, tmp_path / "out", pictures=picture_options("svg", "paper"))
    tables = {"walk.csv", "legs.csv", "summary.json", "spec.yaml"}
    assert {file.name for file in files} == {*tables, "report.html", "walk.svg"}
    table = np.genfromtxt(tmp_path / "out" / "walk.csv", delimiter=",", names=True)
    assert table.dtype.names is not None
    assert len(table) == len(study.motion.rows)
    assert table["body_x_m"][-1] == study.motion.body[study.motion.rows[-1], 0]
    document = json.loads((tmp_path / "out" / "summary.json").read_text())
    keys = {
        "advance_per_cycle_m",
        "speed_body_lengths_per_s",
        "worst_penetration_m",
        "pump_volume_m3",
        "step_halving_change",
    }
    assert keys <= set(document)
    again = load_robot(tmp_path / "out" / "spec.yaml")
    assert again.robot == hexapod().robot
    film = write_walk_film(study, tmp_path / "walk.gif", frames_per_second=1, speed=2.5, width=320)
    assert film.read_bytes()[:3] == b"GIF"


def test_a_gait_is_drawn_again_from_its_files(
    study: WalkStudy, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_walk(study, tmp_path, plots=False)
    page = (tmp_path / "report.html").read_text()
    found = read_gait(tmp_path)
    assert gait_data(found) == gait_data(study)
    assert json.dumps(found.document()) == json.dumps(study.document())
    (tmp_path / "report.html").unlink()
    film = str(tmp_path / "walk.gif")
    words = ["--film", film, "--fps", "1", "--speed", "5", "--width", "320"]
    assert main(["report", str(tmp_path), *words, "--pictures"]) == 0
    assert capsys.readouterr().out.split() == [
        str(tmp_path / name) for name in ("report.html", "walk.png", "walk.gif")
    ]
    assert (tmp_path / "report.html").read_text() == page
    (tmp_path / "legs.csv").write_text("time_s\n0\n")
    assert main(["report", str(tmp_path)]) == 2
    assert "do not fit together" in capsys.readouterr().err


def test_drawn_legs_reach_from_hip_to_foot(study: WalkStudy) -> None:
    motion = study.motion
    feet = motion.feet[motion.rows]
    np.testing.assert_allclose(motion.axes[:, :, -1, 0], feet[:, :, 0], atol=5e-6)
    np.testing.assert_allclose(motion.axes[:, :, -1, 1], feet[:, :, 1] + 0.015, atol=5e-6)
    np.testing.assert_allclose(
        motion.axes[:, :, 0, 1].mean(axis=1), motion.body[motion.rows, 1], atol=1e-12
    )


def test_simulate_walks_and_keeps_a_gait_without_speed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Two cycles are not periodic yet."""
    words = [
        "--set",
        "run.duration=5 s",
        "--set",
        "accuracy=20 %",
        "-o",
        str(tmp_path),
        "--no-plots",
        "--json",
    ]
    assert main(["simulate", "configs/hexapod.yaml", *words]) == 3
    out, err = capsys.readouterr()
    document = json.loads(out)
    assert document["status"] == "refused"
    assert "not periodic yet" in err
    assert (tmp_path / "walk.csv").exists()


@pytest.mark.parametrize(
    ("override", "told"),
    [
        ("robot.payload=9 kg", "its legs bear 82"),
        ("robot.foot.friction=0", "slides: without friction"),
        ("inputs.A.phase=90 deg", "sways from 82"),
    ],
)
def test_a_check_says_whether_it_stands(
    override: str, told: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["check", "configs/hexapod.yaml", "--set", override]) == 0
    out = " ".join(capsys.readouterr().out.split())
    assert told in out
    assert ("no_stance" in out) == ("sways" not in told)


@pytest.mark.parametrize("command", ["check", "classify"])
def test_other_commands_take_a_robot(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main([command, "configs/hexapod.yaml"]) == 0
    assert "hexapod.leg" in capsys.readouterr().out


def test_no_speed_without_a_body_length_a_cycle(study: WalkStudy) -> None:
    refused = replace(study, refusal="for a test")
    assert np.isnan(refused.speed_body_lengths_per_s)
    assert repr(refused) == "<WalkStudy hexapod: no speed stated>"


def test_no_speed_where_a_bellow_has_no_volume() -> None:
    scene = hexapod("inputs.A.amplitude=130 kPa", "run.duration=5 s", "accuracy=20 %")
    found = walk(scene, steps_per_cycle=60)
    assert re.match(r"[RL]\d of [RLMF]+ shrinks to -0\.\d+ of its rest volume", found.refusal)
    error = no_speed(found)
    assert error is not None
    assert error.exit_code == 3


@pytest.mark.parametrize("imbalance", [2e-8, float("nan")])
def test_no_speed_where_fluid_is_lost(study: WalkStudy, imbalance: float) -> None:
    left = replace(study.invariants, gas_mass_imbalance_rel=imbalance)
    told = refusal(replace(study, invariants=left), is_damped=True, emptied="")
    assert "the fluid's mass is off by" in told
    assert refusal(study, is_damped=True, emptied="") == ""


def test_no_check_below_vacuum() -> None:
    with pytest.raises(SpecError, match=r"inputs.A: the lowest pressure, -106.3 kPa gauge"):
        check_robot(hexapod("inputs.A.amplitude=145 kPa"))
