"""`viscodesign report`: the page of a run again."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from viscodesign.cli.options import Debug, Json, Output, Quiet

EXAMPLE = """\b
Example:
  viscodesign report runs/leg"""


def command(
    run: Annotated[Path, typer.Argument(metavar="DIR", help="Folder of a run.")],
    output: Output = None,
    json: Json = False,
    quiet: Quiet = False,
    _debug: Debug = False,
) -> None:
    """Write the page of a run again, from the files in its folder.

    Reads summary.json, spec.yaml, trajectory.csv and shape.csv, and solves nothing. With -o the
    page goes to another folder.
    """
    from viscodesign.cli.output import json_text, say
    from viscodesign.report.folder import PAGE
    from viscodesign.report.page.page import write_page
    from viscodesign.report.page.saved_run import saved_run

    shown, folder = saved_run(run), output if output is not None else run
    files = [write_page(shown, folder / PAGE)]
    if json:
        say(json_text({"files": [str(file) for file in files]}))
    elif not quiet:
        say("\n".join(str(file) for file in files))
