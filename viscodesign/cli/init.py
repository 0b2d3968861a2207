"""`viscodesign init`: a commented spec to start from."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from viscodesign.cli.completion import template_names
from viscodesign.cli.options import Debug, Json, Output, Quiet
from viscodesign.cli.templates import DEFAULT

EXAMPLE = """\b
Examples:
  viscodesign init leg.yaml
  viscodesign init --list
  viscodesign init tree.yaml --template branched_tree"""

DEFAULT_PATH = Path("leg.yaml")


def command(
    path: Annotated[
        Path, typer.Argument(metavar="PATH", help="File to write, or its folder.")
    ] = DEFAULT_PATH,
    name: Annotated[
        str,
        typer.Option(
            "--template",
            metavar="NAME",
            help="Bundled spec to copy.",
            autocompletion=template_names,
        ),
    ] = DEFAULT,
    listing: Annotated[bool, typer.Option("--list", help="List the templates and exit.")] = False,
    force: Annotated[bool, typer.Option("--force", help="Overwrite PATH if it exists.")] = False,
    output: Output = None,
    json: Json = False,
    quiet: Quiet = False,
    _debug: Debug = False,
) -> None:
    """Write a commented spec to start from.

    Copies a bundled spec, complete and ready to run, with the tables that it reads, and
    prints their paths.
    """
    from viscodesign.cli.output import json_text, say, write_text
    from viscodesign.cli.templates import template

    if listing:
        _list(json)
        return
    chosen = template(name)
    target = path if output is None else output / path
    if target.is_dir():
        target = target / f"{chosen.name}.yaml"
    written = write_text(target, chosen.text(), overwrite=force)
    beside = [
        write_text(
            written.with_name(table.name), table.read_text(encoding="utf-8"), overwrite=force
        )
        for table in chosen.tables()
    ]
    if json:
        tables = [str(table) for table in beside]
        say(json_text({"path": str(written), "template": chosen.name, "tables": tables}))
    elif not quiet:
        say("\n".join(map(str, [written, *beside])))


def _list(json: bool) -> None:
    from viscodesign.cli.output import json_text, say
    from viscodesign.cli.templates import templates
    from viscodesign.cli.texts.layout import table

    known = list(templates().values())
    if json:
        say(json_text({"templates": [{"name": t.name, "summary": t.summary()} for t in known]}))
        return
    say("\n".join(table([(t.name, t.summary()) for t in known], indent="")))
