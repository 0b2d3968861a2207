"""Several actuators at once: the same as one by one, equal ones once, and all of their files."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest
import yaml

from tests.coupled_specs import FLOW_ALONE, coupled_spec
from tests.scenes import SEVERAL_SPECS
from viscodesign import (
    SeveralRuns,
    check_several,
    classify_several,
    load,
    load_several,
    simulate,
    simulate_several,
)
from viscodesign.cli.several import checked_several
from viscodesign.cli.texts.run_text import both_errors
from viscodesign.errors import SolveError, SpecError, UsageError
from viscodesign.scene.reading.write import resolved_yaml
from viscodesign.studies import simulate_several as module

SHORT = {"run": {"duration": 1.0, "output_interval": 0.1}}


@pytest.fixture(scope="module")
def runs() -> SeveralRuns:
    return simulate_several(load_several(SEVERAL_SPECS[0], SHORT), verify=False)


def test_every_tip_is_that_of_the_actuator_alone(runs: SeveralRuns) -> None:
    scene = load_several(SEVERAL_SPECS[0], SHORT)
    for name, own in scene.scenes.items():
        alone = simulate(load(resolved_yaml(own)), verify=False)
        assert np.abs(runs[name].tip - alone.tip).max() < 1e-6  # a thousandth of a millimetre
        assert runs[name].effects == alone.effects
    assert np.ptp(runs["left"].tip[:, 0]) > 0.01
    assert np.abs(runs["left"].tip - runs["middle"].tip).max() > 0.01


def test_what_uncertainty_cannot_say_is_refused_before_anything_is_solved(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(module, "simulate", lambda *_, **__: 1 / 0)
    stated = {**SHORT, "uncertainty": {"network.tube_radus": "5 %"}}
    scene = load_several(SEVERAL_SPECS[0], stated)
    for takes in (simulate_several, lambda own: checked_several(own, lines=False)):
        with pytest.raises(SpecError, match="tube_radus: no such number"):
            takes(scene)


def test_equal_actuators_are_solved_once(monkeypatch: pytest.MonkeyPatch) -> None:
    solved: list[str] = []

    def counted(scene: Any, **options: Any) -> Any:
        solved.append(scene.name)
        return simulate(scene, **options)

    monkeypatch.setattr(module, "simulate", counted)
    found = simulate_several(load_several(SEVERAL_SPECS[0], SHORT), verify=False)
    assert solved == ["three_legs.left", "three_legs.middle"]
    assert list(found) == ["left", "right", "middle"]
    assert found.equal_to == {"right": "left"}
    assert (found["left"].tip == found["right"].tip).all()
    assert found["right"].name == "three_legs.right"
    assert "name: three_legs.right" in found["right"].spec_text


def test_columns_have_the_names_of_their_actuators(runs: SeveralRuns) -> None:
    frame = runs.frame()
    assert list(frame.columns[:3]) == ["time_s", "left.tip_x_m", "left.tip_z_m"]
    assert {"right.inlet_pressure_pa", "middle.pressure_R1_pa"} <= {*frame.columns}
    assert frame["middle.tip_x_m"].to_numpy() == pytest.approx(runs["middle"].tip[:, 0], abs=0)


def test_equal_legs_on_one_syringe_take_up_what_it_gives() -> None:
    plunger = {"kind": "syringe", "diameter": "20 mm", "start": "50 mm",
               "rows": [[0, 0], [1, "5 mm"]]}  # fmt: skip
    keys = ("actuators", "fluid", "temperature", "gauge_pressure", "effects", "loads")
    text = yaml.safe_load(SEVERAL_SPECS[0].read_text())
    own = {key: text[key] for key in keys}
    own["actuators"]["middle"] = {"like": "left"}
    scene = load_several(
        {**own, **SHORT, "name": "on one syringe", "inputs": {"A": plunger}, "fluid": "water"}
    )
    assert "each of the 3 has an even part" in check_several(scene)["left"].facts[0]
    found = simulate_several(scene, verify=False)
    assert found.equal_to == {"right": "left", "middle": "left"}
    _, volume = found.supply("A")
    pushed = np.pi * 0.02**2 / 4 * 5e-3
    # Water yields little: nearly all that the plunger pushes out enters the legs.
    assert np.ptp(volume) == pytest.approx(pushed, rel=1e-2)
    told = found.summary()["sources"]["A"]
    assert told["feeds"] == ["left", "right", "middle"]
    assert told["largest_flow_m3_s"] == pytest.approx(pushed, rel=0.1)


def test_a_source_supplies_all_that_it_feeds(runs: SeveralRuns) -> None:
    _, volume = runs.supply("A")
    assert volume == pytest.approx(2 * runs["left"].inflow["inlet"], rel=1e-12)
    assert set(runs.supplies()) == {"A", "B"}


def test_files_of_each_and_of_all(runs: SeveralRuns, tmp_path: Path) -> None:
    files = runs.save(tmp_path, report=False)
    assert files[-1] == tmp_path / "summary.json"
    assert {file.name for file in tmp_path.iterdir()} == {
        *("left", "right", "middle"),
        *("trajectory.csv", "spec.yaml", "tips.png", "summary.json"),
    }
    summary = json.loads(files[-1].read_text())
    assert summary["status"] == "complete"
    assert summary["actuators"]["right"]["equal_to"] == "left"
    assert summary["actuators"]["middle"]["sources"] == {"inlet": "B"}
    table = pd.read_csv(tmp_path / "trajectory.csv")
    assert table.to_numpy() == pytest.approx(runs.frame().to_numpy(), abs=0)
    assert load_several(tmp_path / "spec.yaml").scenes["left"].name == "three_legs.left"
    own = json.loads((tmp_path / "right" / "summary.json").read_text())
    assert own["name"] == "three_legs.right"
    assert load(tmp_path / "right" / "spec.yaml").name == "three_legs.right"
    runs.save(tmp_path, report=False, plots=False)
    assert not (tmp_path / "tips.png").exists()


def test_one_that_fails_does_not_keep_the_others_from_running(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def failing(scene: Any, **options: Any) -> Any:
        if scene.name.endswith("left"):
            raise SolveError("no equilibrium", quantity="rod", where="rod", remedy="None")
        return simulate(scene, **options)

    monkeypatch.setattr(module, "simulate", failing)
    found = simulate_several(load_several(SEVERAL_SPECS[0], SHORT), verify=False)
    assert list(found) == ["middle"]
    assert set(found.failures) == {"left", "right"}
    assert found.status == "failed"
    assert "left: no equilibrium" in (found.failure or "")


def test_where_a_system_fails_is_told_by_the_sections_of_each(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def failing(scene: Any, **options: Any) -> Any:
        raise SolveError("section 3 is too thin", quantity="rod", where="section 3", remedy="None")

    monkeypatch.setattr(module, "simulate", failing)
    found = simulate_several(load_several(coupled_spec()), verify=False)
    assert set(found.failures) == {"left", "right"}
    assert "right: section 1 of right is too thin" in (found.failure or "")


def test_what_shares_fluid_has_one_check_and_columns_of_its_own(tmp_path: Path) -> None:
    scene = load_several(coupled_spec(effects=FLOW_ALONE))
    checks = check_several(scene)
    assert checks["left"] is checks["right"]
    assert checks["left"].facts[0] == "left and right: one system, with one set of effects"
    assert list(classify_several(scene)) == ["left", "right"]
    found = simulate_several(scene, verify=False)
    shared = ["junction_pressure_T_pa", "flow_A-T_m3_s", "flow_T-left.inlet_m3_s"]
    assert set(shared) <= set(found.frame().columns)
    assert found.summary()["share_fluid"] == [["left", "right"]]
    assert found.supplies()["A"]["feeds"] == ["left", "right"]
    assert "from the coefficients unknown (see the note)" in both_errors(found["left"])
    assert any("not supported of actuators that share fluid" in own for own in found["left"].notes)
    found.save(tmp_path, report=False, plots=False)
    alone = load(tmp_path / "right" / "spec.yaml")
    assert list(alone.inputs) == ["T"]
    assert alone.graph.tubes[-1].name == "T-joint"


def test_all_are_checked_and_classified() -> None:
    scene = load_several(SEVERAL_SPECS[0])
    checks = check_several(scene)
    assert list(checks) == ["left", "right", "middle"]
    fed = "inlet is fed by A, which also feeds right: a given pressure, whatever flows"
    assert checks["left"].facts[0] == fed
    assert any(v.name == "tip_load" and v.taken for v in checks["middle"].effects)
    assert {found.quadrant for found in classify_several(scene).values()} == {"III"}


def test_a_single_scene_is_none() -> None:
    with pytest.raises(UsageError, match="expected several actuators"):
        simulate_several(load(SEVERAL_SPECS[0].with_name("leg.yaml")))  # type: ignore[arg-type]
