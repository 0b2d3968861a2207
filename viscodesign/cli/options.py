"""Options shared by several commands, each declared once; those that go together are a group.

A command has a group as one parameter; `with_single_options` spreads it for typer.
"""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import MISSING, Field, fields, is_dataclass
from pathlib import Path
from typing import Annotated, Any, get_type_hints

import typer

from viscodesign.cli.completion import override_keys, spec_files
from viscodesign.cli.output import complain, json_text, say
from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.picture_options import Format, PictureOptions, Style, picture_options

Spec = Annotated[
    Path,
    typer.Argument(
        metavar="SPEC", help="Spec (YAML file); - is standard input.", autocompletion=spec_files
    ),
]
Specs = Annotated[
    list[Path],
    typer.Argument(
        metavar="SPEC", help="Specs (YAML files); - is standard input.", autocompletion=spec_files
    ),
]
Overrides = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="KEY=VALUE",
        help="Override a spec key, such as `run.duration=2 s`; repeatable.",
        autocompletion=override_keys,
    ),
]
Markers = Annotated[
    Path | None,
    typer.Option(
        "--markers",
        metavar="FILE",
        help="Of recordings in space: markers at the clamp and the tip (YAML).",
    ),
]
Json = Annotated[
    bool,
    typer.Option("--json", help="Print one JSON document, and nothing else, to standard output."),
]
Output = Annotated[
    Path | None,
    typer.Option("--output", "-o", metavar="DIR", help="Write the results to this folder."),
]
RunFolder = Annotated[
    Path | None,
    typer.Option("--output", "-o", metavar="DIR", help="Output folder; runs/<name> by default."),
]
NoPlots = Annotated[bool, typer.Option("--no-plots", help="Skip the pictures.")]
NoReport = Annotated[bool, typer.Option("--no-report", help="Skip the page, report.html.")]
PictureFormat = Annotated[Format, typer.Option("--format", help="Format of the pictures.")]
PictureStyle = Annotated[
    Style,
    typer.Option(
        "--style",
        help="Style of the pictures: paper has no titles, talk is large, dark is on dark.",
    ),
]
PictureWidth = Annotated[
    str | None,
    typer.Option(
        "--width",
        metavar="MM",
        help="Width of the pictures: single (89 mm), double (183 mm; paper), or 80 to 400 mm.",
    ),
]
Force = Annotated[bool, typer.Option("--force", help="Write even if the folder holds other files.")]
Quiet = Annotated[
    bool, typer.Option("--quiet", "-q", help="Print errors only (and the JSON document).")
]
Debug = Annotated[bool, typer.Option("--debug", help="Show tracebacks of errors.")]
"""Read by `main` from the command line itself; commands only declare it."""


@dataclass(frozen=True)
class Answer:
    """How a command tells what it found."""

    json: Json = False
    quiet: Quiet = False
    debug: Debug = False

    def give(
        self,
        document: Mapping[str, Any],
        lines: Iterable[str],
        files: Sequence[Path] | None = None,
    ) -> None:
        """Print a document as JSON, with the files that were written, or its lines, if any."""
        if self.json:
            written = {} if files is None else {"files": [str(file) for file in files]}
            say(json_text({**document, **written}))
        elif not self.quiet and (text := "\n".join(lines)):
            say(text)

    def remark(self, text: str) -> None:
        """Print what there is to say beside it on standard error."""
        if text and not self.quiet:
            complain(text)


@dataclass(frozen=True)
class ResultFiles:
    """Where a command writes its files, and how their pictures look.

    Raises `UsageError` for a style or a width that there is not.
    """

    output: RunFolder = None
    no_plots: NoPlots = False
    picture_format: PictureFormat = "png"
    style: PictureStyle = "plain"
    width: PictureWidth = None
    force: Force = False

    def __post_init__(self) -> None:
        _ = self.pictures

    @property
    def pictures(self) -> PictureOptions:
        """How the pictures look."""
        return picture_options(self.picture_format, self.style, self.width)

    @property
    def writing(self) -> dict[str, Any]:
        """What those who write the files take."""
        return {"plots": not self.no_plots, "force": self.force, "pictures": self.pictures}


def with_single_options(command: Callable[..., None]) -> Callable[..., None]:
    """A command as typer takes it: every option of its groups is a parameter of its own."""
    own = inspect.signature(command, eval_str=True).parameters
    single = [one for name, p in own.items() for one in _single(name, p.annotation, p.default)]

    @functools.wraps(command)
    def called(**given: Any) -> None:
        command(**{name: _grouped(name, p.annotation, given) for name, p in own.items()})

    called.__dict__["__signature__"] = inspect.Signature(single)
    called.__annotations__ = {one.name: one.annotation for one in single}
    return called


def _single(name: str, kind: Any, default: Any) -> Iterator[inspect.Parameter]:
    """The options of a parameter: itself, or those of its group."""
    if not _members(kind):
        alone = inspect.Parameter.KEYWORD_ONLY
        yield inspect.Parameter(name, alone, default=default, annotation=kind)
    for field, own in _members(kind):
        usual = inspect.Parameter.empty if field.default is MISSING else field.default
        yield from _single(field.name, own, usual)


def _grouped(name: str, kind: Any, given: Mapping[str, Any]) -> Any:
    """What a command gets for a parameter, by the values of single options."""
    members = _members(kind)
    if not members:
        return given[name]
    return kind(**{field.name: _grouped(field.name, own, given) for field, own in members})


@functools.cache
def _members(kind: Any) -> list[tuple[Field[Any], Any]]:
    """The fields of a group, each with what is annotated; none of a single option."""
    if not is_dataclass(kind):
        return []
    hints = get_type_hints(kind, include_extras=True)
    return [(field, hints[field.name]) for field in fields(kind)]
