"""`classify` places specs on the plane of timescales."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from .conftest import CONFIGS, Call


def test_one_object_for_each_spec(call: Call) -> None:
    specs = [CONFIGS / "leg_4_air.yaml", CONFIGS / "steady_right.yaml"]
    outcome = call("classify", *specs, "--json")
    assert (outcome.status, outcome.err) == (0, "")
    found = json.loads(outcome.out)["specs"]
    assert [item["name"] for item in found] == ["leg_4_air", "steady_right"]
    assert found[1]["scales"]["t_i"] is None  # a constant input never swings


def test_the_text_is_a_table(call: Call, leg: Path) -> None:
    outcome = call("classify", leg, CONFIGS / "leg_16_straight_water.yaml")
    heading, first, second = outcome.out.splitlines()[:3]
    assert heading.split()[:3] == ["spec", "quadrant", "t_s"]
    assert first.split()[:2] == ["leg_16_straight_air", "III"]
    assert second.split()[:2] == ["leg_16_straight_water", "III"]


@pytest.mark.parametrize("ending", [".png", ".svg"])
def test_plot(call: Call, leg: Path, tmp_path: Path, ending: str) -> None:
    picture = tmp_path / "new" / f"plane{ending}"
    assert call("classify", leg, "--plot", picture, "-q").status == 0
    assert picture.stat().st_size > 5000


def test_an_unknown_kind_of_picture(call: Call, leg: Path, tmp_path: Path) -> None:
    outcome = call("classify", leg, "--plot", tmp_path / "plane.txt")
    assert outcome.status == 2
    assert ".png" in outcome.err


def test_one_bad_spec_fails_the_command(call: Call, leg: Path, tmp_path: Path) -> None:
    outcome = call("classify", leg, tmp_path / "none.yaml")
    assert (outcome.status, outcome.out) == (2, "")


def test_output_keeps_the_document(call: Call, leg: Path, tmp_path: Path) -> None:
    outcome = call("classify", leg, "--json", "-o", tmp_path)
    assert (tmp_path / "classification.json").read_text() == outcome.out
