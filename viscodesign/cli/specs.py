"""The specs of a command line: files, or standard input; one after the other if there are many."""

from __future__ import annotations

import sys
import traceback
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from viscodesign.cli.failures import INTERRUPTED, Failure, failure_of
from viscodesign.cli.options import Answer
from viscodesign.cli.output import ReaderGoneError, complain, json_text, say
from viscodesign.errors import SpecError, UsageError, ViscodesignError
from viscodesign.lazy_dataclass import dataclass

if TYPE_CHECKING:
    from viscodesign.scene.reading.sources import SpecSource
    from viscodesign.scene.robot_scene import RobotScene
    from viscodesign.scene.scene import Scene
    from viscodesign.scene.several_scene import SeveralScene

STANDARD_INPUT = "-"


def read_scene(spec: Path, overrides: Sequence[str] | None) -> Scene:
    """The scene of a spec on the command line; `-` is standard input."""
    from viscodesign import load

    return load(_source(spec), overrides or ())


def read_pumped(spec: Path, overrides: Sequence[str] | None) -> Scene:
    """What a pump feeds: the scene of a spec, or all actuators of one of several as one."""
    from viscodesign.loading import load_pumped

    return load_pumped(_source(spec), overrides or ())


def read_robot(spec: Path, overrides: Sequence[str] | None) -> RobotScene:
    """The robot of a spec on the command line; `-` is standard input."""
    from viscodesign import load_robot

    return load_robot(_source(spec), overrides or ())


def read_any(spec: Path, overrides: Sequence[str] | None) -> Scene | RobotScene | SeveralScene:
    """What a spec on the command line is of; `-` is standard input."""
    from viscodesign.loading import load_any

    return load_any(_source(spec), overrides or ())


def _source(spec: Path) -> SpecSource:
    """What a spec on the command line is read from."""
    if str(spec) != STANDARD_INPUT:
        return spec
    if sys.stdin is None:
        raise SpecError.plain("standard input is closed; name a file instead of '-'")
    return getattr(sys.stdin, "buffer", sys.stdin)


@dataclass(frozen=True)
class SpecResult:
    """What a command found of one spec."""

    document: dict[str, Any]
    lines: Sequence[str] = ()
    """For people."""
    error: ViscodesignError | None = None
    """Why it is not complete."""


def run_specs(
    specs: Sequence[Path],
    run: Callable[[Path], SpecResult],
    answer: Answer,
    keep: Callable[[dict[str, Any]], None] = lambda document: None,
) -> None:
    """Run a command on each spec, and print what it found.

    One spec that fails does not keep the others from running; the exit code is then the largest.
    An interrupt ends them all. ``keep`` is given the document, before it is printed.
    """
    if [str(spec) for spec in specs].count(STANDARD_INPUT) > 1:
        raise UsageError("'-' is given twice; standard input holds one spec")
    if len(specs) == 1:
        _run_alone(specs[0], run, answer, keep)
        return
    documents, statuses = [], [0]
    for spec in specs:
        found, failure = _outcome(spec, run, answer.debug)
        told = {} if found is None else found.document
        error = {} if failure is None else {"error": failure.document}
        documents.append({"spec": str(spec), **told, **error})
        statuses.append(0 if failure is None else failure.status)
        if found is not None and not (answer.json or answer.quiet):
            say("\n".join([*([""] if len(documents) > 1 else []), *found.lines]))
        if failure is not None:
            if answer.debug and failure.error is not None:
                traceback.print_exception(failure.error)
            complain(_named(failure.message, spec))
        if statuses[-1] == INTERRUPTED:
            break
    document = {"specs": documents}
    keep(document)
    if answer.json:
        say(json_text(document))
    if max(statuses):
        raise typer.Exit(max(statuses))


def _run_alone(
    spec: Path,
    run: Callable[[Path], SpecResult],
    answer: Answer,
    keep: Callable[[dict[str, Any]], None],
) -> None:
    found = run(spec)
    keep(found.document)
    answer.give(found.document, found.lines)
    if found.error is not None:
        raise found.error


def _outcome(
    spec: Path, run: Callable[[Path], SpecResult], debug: bool
) -> tuple[SpecResult | None, Failure | None]:
    """What was found of a spec, and how it failed."""
    try:
        found = run(spec)
    except ReaderGoneError:
        raise
    except (KeyboardInterrupt, Exception) as error:
        return None, failure_of(error, debug)
    return found, None if found.error is None else failure_of(found.error, debug)


def _named(message: str, spec: Path) -> str:
    """A message that names the spec it is about."""
    return message if str(spec) in message else f"{spec}: {message}"
