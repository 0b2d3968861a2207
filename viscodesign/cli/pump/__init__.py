"""`viscodesign pump`: one module per command; adding a file adds a command.

Files whose names begin with an underscore are shared by them.
"""

from __future__ import annotations

import importlib
import pkgutil

import typer

from viscodesign.cli.options import with_single_options
from viscodesign.cli.pump._options import PumpCommand

pump = typer.Typer(
    name="pump",
    no_args_is_help=True,
    rich_markup_mode=None,
    help="Plan a profile, and play it on a real pump or a simulated one.",
)

for _name in sorted(m.name for m in pkgutil.iter_modules(__path__) if not m.name.startswith("_")):
    _module = importlib.import_module(f"{__name__}.{_name}")
    _command = with_single_options(_module.command)
    pump.command(_name, cls=PumpCommand, epilog=_module.EXAMPLE)(_command)
