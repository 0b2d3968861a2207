"""`viscodesign cite`: BibTeX of what a run used."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from viscodesign.cli.options import Answer, Output

EXAMPLE = """\b
Examples:
  viscodesign cite runs/leg
  viscodesign cite runs/leg > references.bib"""


def command(
    run: Annotated[Path, typer.Argument(metavar="DIR", help="Folder of a run.")],
    output: Output = None,
    *,
    answer: Answer,
) -> None:
    """Print BibTeX of what a run used.

    The works behind its model, the effects that it includes, the properties of its fluid
    and its time integration, each with a comment that says what for. With -o also writes
    DIR/references.bib.
    """
    from viscodesign.citations import citations_of, own_sources
    from viscodesign.cli.output import write_text
    from viscodesign.report.read_run import read_run

    read = read_run(run)
    found, others = citations_of(read), own_sources(read)
    text = "\n\n".join(citation.bibtex for citation in found)
    if others:
        text += "\n\n% without a work of its own:" + "".join(f"\n% {line}" for line in others)
    if output is not None:
        write_text(output / "references.bib", text + "\n", overwrite=True)
    entries = [
        dict(key=c.reference.key, type=c.reference.kind, uses=list(c.uses), **c.reference.fields)
        for c in found
    ]
    answer.give({"references": entries, "without_a_work": others}, [text])
