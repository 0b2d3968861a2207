"""All commands of `viscodesign`.

A command's module imports typer and nothing heavy; the library is imported by the
command that runs, so that `--help` answers at once.
"""

from __future__ import annotations

from typing import Annotated

import typer

from viscodesign._version import __version__
from viscodesign.cli import accuracy, check, classify, effects, init, schema, simulate
from viscodesign.cli.options import Debug
from viscodesign.cli.pump import pump

app = typer.Typer(
    name="viscodesign",
    add_completion=False,
    no_args_is_help=True,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _print_version(wanted: bool) -> None:
    if wanted:
        typer.echo(f"viscodesign {__version__}")
        raise typer.Exit


@app.callback(
    epilog="""\b
Example:
  viscodesign init leg.yaml
  viscodesign check leg.yaml
  viscodesign simulate leg.yaml -o runs/leg"""
)
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
    Exit codes: 0 done; 2 wrong usage or spec; 3 the solve failed; 4 the pump or its
    port, or a plan that the pump cannot follow; 130 interrupted.
    """


COMMANDS = {
    "init": init,
    "check": check,
    "classify": classify,
    "simulate": simulate,
    "accuracy": accuracy,
    "effects": effects,
    "schema": schema,
}
"""In the order of `--help`; every module has a `command` and an `EXAMPLE`."""

for _name, _module in COMMANDS.items():
    app.command(_name, epilog=_module.EXAMPLE)(_module.command)

app.add_typer(pump)
