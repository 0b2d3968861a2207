"""A command that fails before it has written anything leaves no folder behind."""

from __future__ import annotations

from pathlib import Path
from typing import NoReturn

import pytest

import viscodesign
from tests.unit.cli.conftest import CONFIGS, Call
from viscodesign.errors import SpecError
from viscodesign.studies import simulate_several

LEG, ROBOT = CONFIGS / "leg_16_straight_air.yaml", CONFIGS / "hexapod.yaml"
COMMANDS: dict[str, list[str | Path]] = {
    "accuracy": [LEG],
    "compare": [LEG, LEG],
    "design": [LEG],
    "fit": [LEG, CONFIGS / "measured_bellow_made_up.csv"],
    "plan": [CONFIGS / "leg_16_pump.yaml"],
    "reach": [LEG],
    "sensitivity": [LEG],
    "simulate": [LEG],
    "stand": [ROBOT],
    "sweep": [LEG, "--over", "network.tube_radius=0.3 mm, 0.4 mm"],
    "walk": [ROBOT],
}


def _refuse(*_given: object, **_named: object) -> NoReturn:
    raise SpecError.plain("refused")


def _called(name: str) -> list[str | Path]:
    words = ["pump", "plan"] if name == "plan" else [name]
    return [*words, *COMMANDS[name]]


@pytest.mark.parametrize("name", COMMANDS)
def test_no_folder_stays_where_nothing_was_written(
    name: str, call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(viscodesign, name, _refuse)
    outcome = call(*_called(name))
    assert (outcome.status, "refused" in outcome.err) == (2, True), outcome.err
    assert list(tmp_path.iterdir()) == []


def test_none_of_several_actuators(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(simulate_several, "simulate_several", _refuse)
    assert call("simulate", CONFIGS / "three_legs.yaml").status == 2
    assert list(tmp_path.iterdir()) == []


def test_a_leg_that_is_no_target(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert call("design", LEG).status == 2
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_stood_there_and_its_files_stay(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    empty, full = tmp_path / "empty", tmp_path / "full"
    empty.mkdir()
    full.mkdir()
    (full / "reach.json").write_text("{}")
    monkeypatch.setattr(viscodesign, "reach", _refuse)
    for folder in (empty, full):
        assert call("reach", LEG, "-o", folder).status == 2
    assert empty.is_dir()
    assert (full / "reach.json").read_text() == "{}"
