"""`check` and `schema` on the bundled specs."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.scenes import ACTUATOR_SPECS

from .conftest import Call


@pytest.mark.parametrize("spec", ACTUATOR_SPECS, ids=lambda path: path.stem)
def test_every_bundled_spec_is_valid(call: Call, spec: Path) -> None:
    outcome = call("check", spec, "--json")
    assert (outcome.status, outcome.err) == (0, "")
    document = json.loads(outcome.out)
    assert document["name"] == spec.stem
    assert {"scales", "ratios", "quadrant", "effects", "warnings"} <= set(document)


def test_the_text_has_decisions_network_and_warnings(call: Call, leg: Path) -> None:
    outcome = call("check", leg)
    assert (outcome.status, outcome.err) == (0, "")
    for words in ("quadrant III", "t_net", "pressure_distribution", "gravity", "16 bellows"):
        assert words in outcome.out
    assert "warnings" in outcome.out


def test_quiet_says_nothing(call: Call, leg: Path) -> None:
    assert call("check", leg, "-q") == call("check", leg, "--quiet")
    assert call("check", leg, "-q").out == ""


def test_set_overrides(call: Call, leg: Path) -> None:
    plain = json.loads(call("check", leg, "--json").out)
    water = json.loads(call("check", leg, "--json", "--set", "fluid=water").out)
    assert water["scales"]["t_f"] > 50 * plain["scales"]["t_f"]


def test_a_bad_override_is_named(call: Call, leg: Path) -> None:
    outcome = call("check", leg, "--set", "bellows.cout=4")
    assert (outcome.status, outcome.out) == (2, "")
    assert "--set bellows.cout=4" in outcome.err
    assert "Traceback" not in outcome.err


def test_all_faults_of_a_file_at_once(call: Call, leg: Path, tmp_path: Path) -> None:
    spec = tmp_path / "leg.yaml"
    text = (
        leg.read_text().replace("count: 16", "count: 15").replace("height: 30 mm", "height: 3 kg")
    )
    spec.write_text(text)
    outcome = call("check", spec)
    assert (outcome.status, outcome.out) == (2, "")
    assert "bellows.count" in outcome.err
    assert "actuator.height" in outcome.err
    assert f"{spec.name}:" in outcome.err


def test_a_missing_file(call: Call, tmp_path: Path) -> None:
    outcome = call("check", tmp_path / "none.yaml")
    assert (outcome.status, outcome.out) == (2, "")
    assert "none.yaml" in outcome.err


def test_output_keeps_the_document(call: Call, leg: Path, tmp_path: Path) -> None:
    outcome = call("check", leg, "--json", "-o", tmp_path / "made")
    assert (tmp_path / "made" / "check.json").read_text() == outcome.out


def test_schema_is_json_with_or_without_asking(call: Call, tmp_path: Path) -> None:
    outcome = call("schema", "-o", tmp_path)
    assert json.loads(outcome.out)["type"] == "object"
    assert (tmp_path / "spec.schema.json").read_text() == outcome.out
    assert call("schema", "--json").out == outcome.out
    assert call("schema", "-q").out == ""
