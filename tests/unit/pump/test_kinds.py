"""Kinds of pump: what each brings, and what the rest knows of them."""

from __future__ import annotations

import ast
import re
from typing import Any

import pytest

from tests.scenes import ROOT, leg
from viscodesign.errors import SpecError, UsageError
from viscodesign.pump import BoardAddress, calibrate, record, rehearse, status, upload
from viscodesign.pump.kinds.base import PumpKind
from viscodesign.pump.kinds.servo import ServoKind
from viscodesign.pump.planning.demand_kinds import demand_kind, pump_of
from viscodesign.pump.planning.limits import verdict
from viscodesign.pump.planning.motion import InletHistory, RequestedMotion
from viscodesign.pump.sessions.board_names import boards_of, kind_behind, pump_kinds
from viscodesign.pump.sessions.connection import connected
from viscodesign.pump.simulated.device import Device
from viscodesign.scene.pump import DEFAULT_KIND, PUMP_KINDS
from viscodesign.scene.pumps.servo import ServoPumpSpec
from viscodesign.scene.scene import Scene

NEUTRAL = ("play", "sessions", "planning")
MODULES = sorted(
    path for room in NEUTRAL for path in (ROOT / "viscodesign" / "pump" / room).glob("*.py")
)
COMMANDS = sorted((ROOT / "viscodesign" / "cli" / "pump").glob("*.py"))
FAMILIES = re.compile(
    r"viscodesign\.(pump\.(ax|plunger|drive|kinds\.(?!base|connection))|scene\.pumps\.servo)"
)
EXAMPLES = {
    ("demand_kinds", "servo: ax18a"),  # what a spec without a pump may add
    ("axis", "'servo'"),
    ("result", "called: servo"),
}


@pytest.fixture
def regulated() -> Scene:
    return leg("pump={kind: regulator, full_scale: 100 kPa}", config="leg_16_pump")


@pytest.mark.parametrize("path", MODULES, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_what_serves_all_kinds_names_none(path) -> None:  # type: ignore[no-untyped-def]
    text = path.read_text(encoding="utf-8")
    for module, words in EXAMPLES:
        if path.stem == module:
            text = text.replace(words, "")
    assert not re.findall(r"(?i)servos?\b", text)
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.ImportFrom) and node.module:
            assert not FAMILIES.match(node.module), node.module


@pytest.mark.parametrize("path", COMMANDS, ids=lambda path: path.stem)
def test_a_command_knows_the_contract_only(path) -> None:  # type: ignore[no-untyped-def]
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module:
            assert not FAMILIES.match(node.module), node.module


@pytest.mark.parametrize("kind", pump_kinds().values(), ids=lambda kind: kind.name)
def test_a_kind_brings_its_section_its_demand_and_its_boards(kind: PumpKind) -> None:
    section = PUMP_KINDS[kind.name]
    assert section.name == kind.name
    assert demand_kind(kind.simulated_pump()).__name__ == type(kind).__name__.replace(
        "Kind", "Demand"
    )
    assert kind.simulated_board(poses=False).simulated
    assert not any(board.simulated for board in kind.boards().values())
    found = status(BoardAddress(), None) if kind.name == DEFAULT_KIND else None
    assert found is None or found.noun == kind.noun


def test_every_section_has_its_kind_and_no_two_kinds_share_a_board() -> None:
    assert set(PUMP_KINDS) == set(pump_kinds())
    names = [name for kind in pump_kinds().values() for name in kind.boards()]
    assert len(names) == len(set(names))


def test_a_spec_that_names_no_kind_has_a_servo() -> None:
    scene = leg("pump={syringe_diameter: 34.9 mm}", config="leg_16_pump")
    assert scene.pump is not None
    assert scene.pump.kind == DEFAULT_KIND == "servo"


def test_a_kind_that_does_not_exist_is_refused_with_those_there_are() -> None:
    known = ", ".join(PUMP_KINDS)
    with pytest.raises(SpecError, match=f"kind must be one of {known}; got 'regulater'"):
        leg("pump={kind: regulater}", config="leg_16_pump")


@pytest.mark.parametrize(
    ("board", "config", "message"),
    [
        ("dynamixel", "leg_16_regulator", "does not drive a pump of kind regulator"),
        ("regulator", "leg_16_pump", "does not drive a pump of kind servo"),
    ],
)
def test_a_board_of_another_kind_is_refused(board: str, config: str, message: str) -> None:
    scene = leg(config=config)
    with pytest.raises(UsageError, match=message):
        kind_behind(board, scene)
    assert board not in boards_of(kind_behind("simulated", scene))


@pytest.mark.parametrize(
    ("config", "message"),
    [
        ("antagonistic_two_inlets", "a regulator drives one inlet, and this scene has 2"),
        ("leg_4_water", "a regulator moves a gas; water takes pump.kind: servo"),
    ],
)
def test_what_a_regulator_cannot_drive_is_refused(config: str, message: str) -> None:
    with pytest.raises(SpecError, match=message):
        pump_of(leg("pump={kind: regulator, full_scale: 100 kPa}", config=config))


def test_a_regulator_has_no_poses_and_no_calibration(regulated: Scene) -> None:
    at = BoardAddress("regulator", "/dev/nowhere")
    with pytest.raises(UsageError, match="a pump of kind regulator plays no profile by itself"):
        upload(regulated)
    with pytest.raises(UsageError, match="a regulator has nothing to calibrate here"):
        calibrate(regulated, at, confirm=lambda text: True)
    with pytest.raises(UsageError, match="measures its own pressure"):
        rehearse(regulated, without_sensor=True)


def test_the_status_of_a_regulator_has_its_pressures(regulated: Scene) -> None:
    found = status(scene=regulated)
    assert found.document()["regulators"] == [{"id": 1, "set_point_steps": 0, "outlet_steps": 0}]
    assert found.pressure == (0.0,)
    assert found.objections == ()


def test_a_recording_has_the_columns_of_its_kind(regulated: Scene, tmp_path) -> None:  # type: ignore[no-untyped-def]
    address = BoardAddress(pace="max")
    record(tmp_path / "rest.csv", address, regulated, rate=20.0, duration=0.2)
    head, *rows = (tmp_path / "rest.csv").read_text().splitlines()
    assert head == "time_s,inlet_pressure_pa,wanted_pressure_pa,outlet_pa,set_point_pa"
    assert len(rows) == 5


def demand(scene: Scene, pressure: list[float], seconds: float = 1.0):  # type: ignore[no-untyped-def]
    import numpy as np

    time, values = seconds * np.arange(len(pressure)), np.array(pressure)[:, None]
    run = InletHistory(time, values, 0 * values)
    kind = demand_kind(pump_of(scene))
    lines = {"inlet": None}
    motion = RequestedMotion(kind, scene, frozenset(), lines, run, run.until(0))  # type: ignore[arg-type]
    return motion.demands(pump_of(scene))[0]


@pytest.mark.parametrize(
    ("pressure", "name", "severity", "ratio"),
    [
        ([0, 20e3, 0], "cap", "ok", 20 / 25),
        ([0, 30e3, 0], "cap", "infeasible", 30 / 25),
        ([0, -2e3, 0], "range", "infeasible", 1 + 2e3 / (255 * 1e5 / 1023)),
        ([0, 20e3, 20e3], "rate", "ok", 20 / 50),
        ([0, 60e3, 60e3], "rate", "infeasible", 60 / 50),
        ([0, 20e3, 20e3], "lag", "ok", 20 * 0.2 / 15),
        ([0, 90e3, 90e3], "lag", "advice", 90 * 0.2 / 15),
        ([0, 1e3, 0], "resolution", "advice", 20 * (1e5 / 1023) / 1e3),
    ],
)
def test_each_limit_of_a_regulator(
    regulated: Scene, pressure: list[float], name: str, severity: str, ratio: float
) -> None:
    found = verdict(demand(regulated, pressure), name)
    assert (found.severity, found.ratio) == (severity, pytest.approx(ratio))


def test_a_regulator_goes_in_whole_steps_no_faster_than_its_rate(regulated: Scene) -> None:
    import numpy as np

    asked = demand(regulated, [0.0, 10e3, 10e3, 0.0], seconds=0.1)
    path = asked.path(asked.pressure)
    assert np.abs(np.diff(path)) == pytest.approx(
        [5e3, 10e3 - 5e3 - 10e3 % (1e5 / 1023), 5e3], abs=100.0
    )
    assert path[2] / (1e5 / 1023) == pytest.approx(round(10e3 / (1e5 / 1023)))


@pytest.mark.parametrize("inlets", [1, 2])
def test_a_simulated_device_is_told_the_number_of_inlets(
    inlets: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    scene = leg("pump={syringe_diameter: 34.9 mm}", config="leg_16_pump")
    if inlets == 2:
        ids = "pump={syringe_diameter: 34.9 mm, servo_id: {left: 1, right: 2}}"
        scene = leg(ids, config="antagonistic_two_inlets")
    assert len(scene.inputs) == inlets
    told: list[int] = []
    make = ServoKind.simulated_device

    def device(
        self: ServoKind, pump: ServoPumpSpec, count: int, *rest: Any, **options: Any
    ) -> Device:
        told.append(count)
        return make(self, pump, count, *rest, **options)

    monkeypatch.setattr(ServoKind, "simulated_device", device)
    with connected(BoardAddress(pace="max"), scene):
        pass
    with connected(BoardAddress(pace="max"), None):
        pass
    assert told == [inlets, 1]
