"""Specs of several actuators on the command line."""

from __future__ import annotations

import json
from pathlib import Path

from tests.scenes import SEVERAL_SPECS

from .conftest import Call

SPEC = SEVERAL_SPECS[0]
SHORT = ("--set", "run={duration: 0.5 s, output_interval: 0.1 s}")


def test_check_tells_of_each(call: Call) -> None:
    outcome = call("check", SPEC, "--json")
    assert (outcome.status, outcome.err) == (0, "")
    document = json.loads(outcome.out)
    assert document["name"] == SPEC.stem
    assert list(document["actuators"]) == ["left", "right", "middle"]
    assert {"scales", "quadrant", "effects"} <= set(document["actuators"]["left"])
    assert "also feeds right" in call("check", SPEC).out


def test_classify_places_each(call: Call) -> None:
    document = json.loads(call("classify", SPEC, "--json").out)
    names = [own["name"] for own in document["specs"]]
    assert names == ["three_legs.left", "three_legs.right", "three_legs.middle"]


def test_simulate_writes_a_folder_for_each(call: Call, tmp_path: Path) -> None:
    options = ("--no-verify", "--no-plots", "--no-report", *SHORT)
    outcome = call("simulate", SPEC, "-o", tmp_path / "run", *options)
    assert outcome.status == 0
    assert "right, fed by A: equal to left, and solved with it" in outcome.out
    assert (tmp_path / "run" / "middle" / "trajectory.csv").is_file()
    header = (tmp_path / "run" / "trajectory.csv").read_text().partition("\n")[0]
    assert header.startswith("time_s,left.tip_x_m,")
    again = call("simulate", SPEC, "-o", tmp_path / "run", *options, "--json")
    assert json.loads(again.out)["actuators"]["right"]["equal_to"] == "left"


def test_other_commands_say_which_take_it(call: Call) -> None:
    outcome = call("reach", SPEC)
    assert (outcome.status, outcome.out) == (2, "")
    assert "this spec has several actuators" in outcome.err
