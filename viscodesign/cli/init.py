"""`viscodesign init`: a commented spec to start from."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated

import typer

from viscodesign.cli.completion import template_names
from viscodesign.cli.options import Answer, Output
from viscodesign.cli.templates import DEFAULT
from viscodesign.errors import UsageError
from viscodesign.lazy_dataclass import dataclass

EXAMPLE = """\b
Examples:
  viscodesign init leg.yaml
  viscodesign init --list
  viscodesign init tree.yaml --template branched_tree
  viscodesign init own.yaml --measure --wall 0.8mm --set bellows.count=12"""

DEFAULT_PATH = Path("leg.yaml")
DEFAULT_WALL = "1 mm"


def command(
    path: Annotated[
        Path, typer.Argument(metavar="PATH", help="File to write, or its folder.")
    ] = DEFAULT_PATH,
    name: Annotated[
        str | None,
        typer.Option(
            "--template",
            metavar="NAME",
            help=f"Bundled spec to copy; {DEFAULT}.",
            autocompletion=template_names,
        ),
    ] = None,
    measure: Annotated[
        bool,
        typer.Option(
            "--measure",
            help="Write a spec of your own sizes, with first estimates of what is to be measured.",
        ),
    ] = False,
    wall: Annotated[
        str | None,
        typer.Option(
            "--wall", metavar="LENGTH", help="With --measure: thickness of the walls; 1 mm."
        ),
    ] = None,
    fold: Annotated[
        str | None,
        typer.Option(
            "--fold", metavar="LENGTH", help="With --measure: depth of their folds; as the wall."
        ),
    ] = None,
    overrides: Annotated[
        list[str] | None,
        typer.Option(
            "--set", metavar="KEY=VALUE", help="With --measure: a size or another key; repeatable."
        ),
    ] = None,
    listing: Annotated[bool, typer.Option("--list", help="List the templates and exit.")] = False,
    force: Annotated[bool, typer.Option("--force", help="Overwrite PATH if it exists.")] = False,
    output: Output = None,
    *,
    answer: Answer,
) -> None:
    """Write a commented spec to start from.

    Copies a bundled spec, complete and ready to run, with the tables that it reads, and
    prints their paths. With --measure, writes one for your own sizes: coefficients that are
    not given by --set are estimated from Young's modulus and the wall, and marked as such.
    """
    from viscodesign.cli.output import write_text

    if listing:
        _list(answer.json)
        return
    target = path if output is None else output / path
    if measure:
        own = _own_sizes(target, name, wall or DEFAULT_WALL, fold, overrides or ())
    elif wall or fold or overrides:
        raise UsageError("--wall, --fold and --set belong to --measure; add it, or edit the file")
    else:
        own = _bundled(target, name or DEFAULT)
    written = [write_text(file, text, overwrite=force) for file, text in own.files.items()]
    spec, *tables = map(str, written)
    answer.give({"path": spec, "template": own.template, "tables": tables}, [spec, *tables])


@dataclass(frozen=True)
class _NewSpec:
    """What is to be written: the spec first, then its tables."""

    template: str | None
    files: Mapping[Path, str]


def _bundled(target: Path, name: str) -> _NewSpec:
    from viscodesign.cli.templates import template

    chosen = template(name)
    spec = target / f"{chosen.name}.yaml" if target.is_dir() else target
    tables = {
        spec.with_name(table.name): table.read_text(encoding="utf-8") for table in chosen.tables()
    }
    return _NewSpec(chosen.name, {spec: chosen.text(), **tables})


def _own_sizes(
    target: Path, name: str | None, wall: str, fold: str | None, sets: Sequence[str]
) -> _NewSpec:
    from viscodesign.cli.first_spec import first_spec
    from viscodesign.cli.run_folders import folder_name

    if name is not None:
        raise UsageError("--measure and --template are mutually exclusive; remove one of them")
    spec = target / DEFAULT_PATH if target.is_dir() else target
    return _NewSpec(None, {spec: first_spec(folder_name(spec.stem), sets, wall, fold)})


def _list(json: bool) -> None:
    from viscodesign.cli.output import json_text, say
    from viscodesign.cli.templates import templates
    from viscodesign.cli.texts.layout import table

    known = list(templates().values())
    if json:
        say(json_text({"templates": [{"name": t.name, "summary": t.summary()} for t in known]}))
        return
    say("\n".join(table([(t.name, t.summary()) for t in known], indent="")))
