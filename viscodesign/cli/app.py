"""All commands of `viscodesign`.

A command's module imports typer and nothing heavy; the library is imported by the
command that runs, so that `--help` answers at once.
"""

from __future__ import annotations

import importlib
from collections.abc import Sequence
from typing import Annotated

import typer

from viscodesign._version import __version__
from viscodesign.cli.options import Debug, with_single_options


def _print_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"viscodesign {__version__}")
        raise typer.Exit


def viscodesign(
    _version: Annotated[
        bool,
        typer.Option(
            "--version", callback=_print_version, is_eager=True, help="Print the version and exit."
        ),
    ] = False,
    _debug: Debug = False,
) -> None:
    """Design and simulate soft actuators driven by viscous flow between their bellows.

    A spec (YAML) describes one actuator, its tubes, its fluid and its input.
    Exit codes: 0 done; 2 wrong usage or spec; 3 the solve failed, or its results cannot be
    written; 4 the pump or its port, or a plan that the pump cannot follow; 130 interrupted.
    """


EXAMPLE = """\b
Example:
  viscodesign init leg.yaml
  viscodesign check leg.yaml
  viscodesign simulate leg.yaml -o runs/leg"""
COMMANDS = (
    *("init", "check", "classify", "simulate", "report", "accuracy", "sweep", "sensitivity"),
    *("design", "reach", "fit", "compare", "stand", "walk", "cite", "effects", "schema"),
)
"""In the order of `--help`; every module has a `command` and an `EXAMPLE`."""
PUMP = "pump"


def app_for(words: Sequence[str]) -> typer.Typer:
    """All commands; or only one, where a command line begins with its name."""
    first = words[0] if words else ""
    if first in COMMANDS:
        return app_with([first])
    return app_with([*COMMANDS, PUMP], completion=True)


def app_with(names: Sequence[str], *, completion: bool = False) -> typer.Typer:
    """These commands: those that are not needed take longer to set up than a small scene.

    With ``completion`` shells can ask what may stand on a command line.
    """
    app = typer.Typer(
        name="viscodesign",
        add_completion=completion,
        no_args_is_help=True,
        rich_markup_mode=None,
        pretty_exceptions_enable=False,
        context_settings={"help_option_names": ["-h", "--help"]},
    )
    app.callback(epilog=EXAMPLE)(viscodesign)
    for name in names:
        module = importlib.import_module(f"viscodesign.cli.{name}")
        if name == PUMP:
            app.add_typer(module.pump)
        else:
            app.command(name, epilog=module.EXAMPLE)(with_single_options(module.command))
    return app
