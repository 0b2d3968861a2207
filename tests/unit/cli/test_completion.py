"""What a shell offers for a word that is being typed."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from viscodesign import load
from viscodesign.cli import completion
from viscodesign.cli.app import app_for
from viscodesign.errors import SpecError

from .conftest import CONFIGS


def words(offers: list[tuple[str, str]]) -> list[str]:
    return [word for word, _ in offers]


def test_specs_are_offered_by_their_path(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("leg.yaml", "led.yml", "leg.csv", "sub/leg.yaml"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).touch()
    monkeypatch.chdir(tmp_path)
    assert completion.spec_files("le") == ["led.yml", "leg.yaml"]
    assert completion.spec_files("sub/") == ["sub/leg.yaml"]
    assert completion.spec_files("sub/l") == ["sub/leg.yaml"]
    assert completion.spec_files(f"{tmp_path}/sub/") == [f"{tmp_path}/sub/leg.yaml"]
    assert completion.spec_files("none/") == []


@pytest.mark.parametrize(
    ("incomplete", "offered"),
    [
        ("network.tube_l", ["network.tube_length="]),
        ("effects.gra", ["effects.gravity="]),
        ("effects.gravity=o", ["effects.gravity=on", "effects.gravity=off"]),
        ("network.layout=", ["network.layout=straight", "network.layout=crossed", "network.layout=custom"]),
        ("run.start=p", ["run.start=periodic"]),
        ("effects=a", ["effects=auto"]),
        ("actuator.length=", []),
        ("nonsense", []),
    ],
)  # fmt: skip
def test_keys_and_words_of_overrides(incomplete: str, offered: list[str]) -> None:
    assert words(completion.override_keys(incomplete)) == offered


def test_every_key_that_is_offered_exists() -> None:
    offered = [key for key, _ in completion.spec_keys()]
    assert len(offered) == len(set(offered)) > 80
    for key in (key for key in offered if not key.startswith(("input", "pump", "network.tube"))):
        assert "no such key" not in told_of(key), key


def told_of(key: str) -> str:
    """What is said of a word as the value of a key."""
    try:
        load(CONFIGS / "leg_4_air.yaml", {key: "nonsense"})
    except SpecError as error:
        return str(error)
    return ""


def test_templates_and_effects() -> None:
    assert words(completion.template_names("leg_4_w")) == ["leg_4_water", "leg_4_water_auto"]
    assert words(completion.effect_names("gra")) == ["gravity"]
    assert all(meaning for _, meaning in completion.effect_names(""))


def test_only_the_whole_command_line_asks_for_it() -> None:
    assert not app_for(["check"])._add_completion
    assert app_for([])._add_completion


@pytest.mark.parametrize(
    ("line", "offered"),
    [
        ("viscodesign init --template leg_4_water_", "leg_4_water_auto"),
        ("viscodesign check leg.yaml --set run.dur", "run.duration="),
        ("viscodesign pump pl", "plan"),
    ],
)
def test_a_shell_is_answered(line: str, offered: str) -> None:
    typed = line.split()
    asked = {
        "_VISCODESIGN_COMPLETE": "complete_bash",
        "COMP_WORDS": "\n".join(typed),
        "COMP_CWORD": str(len(typed) - 1),
    }
    done = subprocess.run(
        [sys.executable, "-m", "viscodesign"],
        env=os.environ | asked, capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert done.stdout.split() == [offered]
