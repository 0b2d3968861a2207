"""`init` writes a spec with its comments and overwrites nothing unasked."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from .conftest import CONFIGS, Call


def test_the_default_is_the_commented_leg(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    outcome = call("init")
    assert (outcome.status, outcome.out, outcome.err) == (0, "leg.yaml\n", "")
    assert (tmp_path / "leg.yaml").read_bytes() == (CONFIGS / "leg.yaml").read_bytes()


def test_another_template(call: Call, tmp_path: Path) -> None:
    assert call("init", tmp_path / "new" / "a.yaml", "--template", "branched_tree").status == 0
    text = (tmp_path / "new" / "a.yaml").read_text()
    assert text == (CONFIGS / "branched_tree.yaml").read_text()


def test_a_folder_gets_a_file_named_by_the_template(call: Call, tmp_path: Path) -> None:
    call("init", tmp_path, "--template", "leg_4_air")
    assert [p.name for p in tmp_path.iterdir()] == ["leg_4_air.yaml"]


def test_an_existing_file_is_not_overwritten(call: Call, tmp_path: Path) -> None:
    target = tmp_path / "leg.yaml"
    target.write_text("mine")
    outcome = call("init", target)
    assert outcome.status == 2
    assert "--force" in outcome.err
    assert str(target) in outcome.err
    assert target.read_text() == "mine"
    assert call("init", target, "--force").status == 0
    assert target.read_text() != "mine"
    assert [p.name for p in tmp_path.iterdir()] == ["leg.yaml"]


def test_a_misspelt_template_gets_a_suggestion(call: Call, tmp_path: Path) -> None:
    outcome = call("init", tmp_path / "a.yaml", "--template", "branched_three")
    assert outcome.status == 2
    assert "did you mean 'branched_tree'?" in outcome.err
    assert not (tmp_path / "a.yaml").exists()


def test_list_names_every_template_with_a_summary(call: Call) -> None:
    outcome = call("init", "--list")
    names = [line.split()[0] for line in outcome.out.splitlines()]
    assert names[0] == "leg"
    assert set(names) == {path.stem for path in CONFIGS.glob("*.yaml")}
    assert all(len(line.split()) > 5 for line in outcome.out.splitlines())


def test_json(call: Call, tmp_path: Path) -> None:
    path = tmp_path / "leg.yaml"
    assert json.loads(call("init", path, "--json").out) == {
        "path": str(path),
        "template": "leg",
        "tables": [],
    }
    listed = json.loads(call("init", "--list", "--json").out)["templates"]
    assert all(item["name"] and item["summary"] for item in listed)


def test_output_is_the_folder_of_the_file(call: Call, tmp_path: Path) -> None:
    assert call("init", "a.yaml", "-o", tmp_path / "specs", "-q").out == ""
    assert (tmp_path / "specs" / "a.yaml").is_file()


def test_a_place_that_cannot_be_written(call: Call, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    outcome = call("init", tmp_path / "file" / "leg.yaml")
    assert outcome.status == 2
    assert "cannot write" in outcome.err


def test_a_template_brings_the_tables_that_it_reads(call: Call, tmp_path: Path) -> None:
    from viscodesign import load

    outcome = call("init", tmp_path / "own.yaml", "--template", "measured_bellow")
    assert outcome.status == 0
    tables = [path.name for path in tmp_path.glob("*.csv")]
    assert len(tables) == 1
    assert tables[0] in outcome.out
    assert load(tmp_path / "own.yaml").bellows.curve is not None
