"""Help answers every command, with an example, and loads nothing heavy."""

from __future__ import annotations

import subprocess
import sys

import pytest
from typer.testing import CliRunner

from viscodesign.cli.app import COMMANDS, app_for
from viscodesign.cli.pump import pump
from viscodesign.pump.boards.line_regulator import LineRegulator
from viscodesign.pump.kinds.regulator import RegulatorKind
from viscodesign.pump.sessions.board_names import pump_kinds

app = app_for([])
PUMP = sorted(command.name or "" for command in pump.registered_commands)
MOVING = ("calibrate", "stream", "upload")
HEAVY = ("numpy", "pydantic", "casadi", "scipy", "matplotlib", "pandas", "pint", "rich", "yaml")


@pytest.mark.parametrize("name", COMMANDS)
def test_help_has_an_example(name: str) -> None:
    result = CliRunner().invoke(app, [name, "--help"])
    assert result.exit_code == 0
    assert "Example" in result.stdout
    assert f"\n    viscodesign {name}" in result.stdout
    assert all(len(line) <= 80 for line in result.stdout.splitlines())


@pytest.mark.parametrize("name", COMMANDS)
def test_a_command_is_set_up_alone(name: str) -> None:
    alone = app_for([name, "--help"])
    assert [command.name for command in alone.registered_commands] == [name]
    assert not alone.registered_groups
    pages = [CliRunner().invoke(one, [name, "--help"]).stdout for one in (alone, app)]
    assert pages[0] == pages[1]


def test_the_front_page_names_every_command_in_full() -> None:
    result = CliRunner().invoke(app, ["--help"])
    assert result.exit_code == 0
    for name in COMMANDS:
        assert f"\n  {name}" in result.stdout
    assert "..." not in result.stdout.partition("Commands:")[2]


@pytest.mark.parametrize("name", COMMANDS)
def test_common_options_are_everywhere(name: str) -> None:
    page = CliRunner().invoke(app, [name, "--help"]).stdout
    for option in ("--json", "--quiet", "-q", "--output", "-o", "--debug", "--help"):
        assert option in page
    solving = ("simulate", "accuracy", "sweep", "sensitivity", "design", "reach", "compare", "fit")
    takes_spec = name in ("init", "check", "classify", "stand", "walk", *solving)
    assert ("--set" in page) == takes_spec


@pytest.mark.parametrize("name", PUMP)
def test_pump_commands_have_examples_too(name: str) -> None:
    result = CliRunner().invoke(app, ["pump", name, "--help"])
    assert result.exit_code == 0
    assert f"\n    viscodesign pump {name}" in result.stdout
    assert all(len(line) <= 80 for line in result.stdout.splitlines())
    assert ("--dry-run" in result.stdout) == (name in MOVING)


def test_help_imports_nothing_heavy() -> None:
    program = (
        "import sys; from viscodesign.cli.main import main; main(['--help']);"
        f"print([m for m in {HEAVY!r} if m in sys.modules], file=sys.stderr)"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert done.stderr == "[]\n"


@pytest.mark.parametrize(("name", "last"), [("stop", "own-board"), ("record", "own-board")])
def test_the_help_of_a_board_names_those_of_every_kind(
    name: str, last: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    boards = {**RegulatorKind().boards(), last: LineRegulator}
    monkeypatch.setattr(RegulatorKind, "boards", lambda self: boards)
    page = " ".join(CliRunner().invoke(app_for([]), ["pump", name, "--help"]).stdout.split())
    every = [board for kind in pump_kinds().values() for board in kind.boards()]
    if name == "record":
        every.append("simulated")
    assert f"{', '.join(every[:-1])} or {every[-1]}." in page
    assert last in page
