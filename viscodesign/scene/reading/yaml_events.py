"""The syntax of YAML: events of each document, and the values of plain words."""

from __future__ import annotations

import math
import re
from typing import Any

import yaml

from viscodesign.errors import Fault, SpecError
from viscodesign.scene.reading.syntax_slips import syntax_slip

MAX_DEPTH = 32
TOO_DEEP = f"nested too deeply, more than {MAX_DEPTH} levels"
_INTEGER = re.compile(r"[-+]?[0-9]+")
_NOT_FINITE = {".inf": math.inf, "+.inf": math.inf, "-.inf": -math.inf, ".nan": math.nan}
_NUMBER = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")


def plain_value(text: str) -> Any:
    """The value of an unquoted word: null, true, false, a number, or itself."""
    if text in ("", "~", "null", "Null", "NULL"):
        return None
    if text.lower() in ("true", "false"):
        return text.lower() == "true"
    if _INTEGER.fullmatch(text):
        return int(text) if len(text) < 100 else float(text)
    if _NUMBER.fullmatch(text):
        return float(text)
    return _NOT_FINITE.get(text.lower(), text)


def event_lists(text: str, file: str) -> list[list[yaml.Event]]:
    """The events of each document of a file, without its start and end."""
    documents: list[list[yaml.Event]] = []
    anchors: dict[str, int] = {}
    depth = 0
    try:
        for event in yaml.parse(text, Loader=yaml.CSafeLoader):
            if isinstance(event, yaml.DocumentStartEvent):
                documents.append([])
                anchors.clear()
            elif isinstance(event, (yaml.NodeEvent, yaml.CollectionEndEvent)):
                documents[-1].append(event)
                depth += nesting(event)
                problem = TOO_DEEP if depth > MAX_DEPTH else _anchor_problem(event, anchors)
                if problem:
                    raise SpecError([Fault(problem, file=file, line=line_of(event))])
    except yaml.YAMLError as error:
        raise SpecError([_syntax_fault(error, file, text)]) from error
    return documents


def nesting(event: yaml.Event) -> int:
    """By how many levels an event deepens the nesting."""
    return isinstance(event, yaml.CollectionStartEvent) - isinstance(event, yaml.CollectionEndEvent)


def _anchor_problem(event: yaml.Event, anchors: dict[str, int]) -> str:
    """The problem of an event's anchor or alias; ``anchors`` are those defined so far."""
    name = getattr(event, "anchor", None)
    if name is None:
        return ""
    if isinstance(event, yaml.AliasEvent):
        return "" if name in anchors else f"not YAML: undefined alias '{name}'"
    if name in anchors:
        return f"not YAML: duplicate anchor '{name}', first defined on line {anchors[name]}"
    anchors[name] = line_of(event)
    return ""


def _syntax_fault(error: yaml.YAMLError, file: str, text: str) -> Fault:
    mark = getattr(error, "problem_mark", None)
    line = mark.line + 1 if mark else None
    problem = getattr(error, "problem", None) or "invalid syntax"
    if isinstance(error, yaml.reader.ReaderError):
        problem = "contains bytes that are not text"
    if "nesting depth" in problem:  # the parser's own limit, from PyYAML 6.0.4 on
        return Fault(TOO_DEEP, file=file, line=line)
    slip = syntax_slip(text, line or 1)
    return Fault(
        f"not YAML: {slip[1] if slip else problem}", file=file, line=slip[0] if slip else line
    )


def line_of(event: yaml.Event) -> int:
    return event.start_mark.line + 1 if event.start_mark else 0
