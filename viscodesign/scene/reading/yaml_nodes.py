"""YAML read safely: plain data, bounded in size and depth, every key with its line."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from typing import Any

import yaml

from viscodesign.errors import Fault, SpecError
from viscodesign.scene.section import KeyPath

DEEPEST = 32
TOO_DEEP = f"is nested too deeply, more than {DEEPEST} levels"
MOST_NODES = 400_000


_INTEGER = re.compile(r"[-+]?[0-9]+")
_NUMBER = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")


@dataclass
class Document:
    """Plain data with the line of every key, and the overrides laid over it."""

    file: str
    data: dict[str, Any]
    lines: dict[KeyPath, int] = field(default_factory=dict)
    overrides: dict[KeyPath, str] = field(default_factory=dict)
    faults: list[Fault] = field(default_factory=list)
    """Of keys and values; the rest of the document is read all the same."""

    def given(self, path: KeyPath) -> Any:
        """The value as it was written; None where there is none."""
        here: Any = self.data
        for part in path:
            if isinstance(here, list):
                here = here[int(part)] if part.isdigit() and int(part) < len(here) else None
            else:
                here = here.get(part) if isinstance(here, dict) else None
        return here

    def place(self, path: KeyPath) -> tuple[str, int | None]:
        """File and line of a key, or of the nearest key above it; an override names itself."""
        for depth in range(len(path), 0, -1):
            if path[:depth] in self.overrides:
                return self.overrides[path[:depth]], None
            if path[:depth] in self.lines:
                return self.file, self.lines[path[:depth]]
        return self.file, None


def read_document(text: bytes, file: str) -> Document:
    """Parse one YAML document that is a mapping. Raises `SpecError`.

    Faults that leave the rest readable, such as a key that stands twice, are kept in
    the document instead.
    """
    document = Document(file, {})
    data = _Reader(document).read(_one_node(text, file), (), 0)
    if not isinstance(data, dict):
        kind = "a list" if isinstance(data, list) else "a single value"
        raise SpecError(
            [Fault(f"is {kind}; a mapping of keys such as 'name:' is wanted", file=file, line=1)]
        )
    document.data = data
    return document


def _one_node(text: bytes, file: str) -> yaml.Node:
    """The one document of a file as YAML nodes, which keep their lines."""
    try:
        decoded = text.decode("utf-8-sig")
        _check_depth(decoded, file)
        nodes = [n for n in yaml.compose_all(decoded, Loader=yaml.CSafeLoader) if n is not None]
    except UnicodeDecodeError as error:
        raise SpecError(
            [Fault("is not a text in UTF-8; a YAML file is wanted", file=file)]
        ) from error
    except yaml.YAMLError as error:
        raise SpecError([_syntax_fault(error, file)]) from error
    if len(nodes) > 1:
        raise SpecError([Fault(f"holds {len(nodes)} documents; one is wanted", file=file)])
    if not nodes or (isinstance(nodes[0], yaml.ScalarNode) and not nodes[0].value):
        raise SpecError([Fault("is empty; write a spec with 'viscodesign init'", file=file)])
    return nodes[0]


def _check_depth(text: str, file: str) -> None:
    """Refuse deep nesting before the composer, which recurses in C, can overflow its stack."""
    depth = 0
    for event in yaml.parse(text, Loader=yaml.CSafeLoader):
        if isinstance(event, yaml.CollectionStartEvent):
            depth += 1
            if depth > DEEPEST:
                line = event.start_mark.line + 1 if event.start_mark else None
                raise SpecError([Fault(TOO_DEEP, "", file, line)])
        elif isinstance(event, yaml.CollectionEndEvent):
            depth -= 1


def parse_scalar(text: str, place: str) -> Any:
    """The value of an override, read like a YAML value."""
    try:
        value = text or "''"
        _check_depth(value, place)
        node = yaml.compose(value, Loader=yaml.CSafeLoader)
    except UnicodeEncodeError as error:  # bytes of a command line that are no text
        raise SpecError([Fault("the value is not a text in UTF-8", file=place)]) from error
    except yaml.YAMLError as error:
        deep = TOO_DEEP if _is_too_deep(error) else "the value is not YAML"
        raise SpecError([Fault(deep, file=place)]) from error
    document = Document(place, {})
    data = _Reader(document).read(node, (), 0) if node is not None else None
    if document.faults:
        raise SpecError([replace(fault, line=None) for fault in document.faults])
    return data


def plain_value(text: str) -> Any:
    """What a word without quotes stands for: nothing, true, false, a number, or itself."""
    if text in ("", "~", "null", "Null", "NULL"):
        return None
    if text.lower() in ("true", "false"):
        return text.lower() == "true"
    if _INTEGER.fullmatch(text):
        return int(text) if len(text) < 100 else float(text)
    if _NUMBER.fullmatch(text):
        return float(text)
    return text


def _is_too_deep(error: Exception) -> bool:
    """Whether the parser itself refused the depth, as PyYAML does from 6.0.4 on."""
    return "nesting depth" in str(error)


def _syntax_fault(error: Exception, file: str) -> Fault:
    mark = getattr(error, "problem_mark", None)
    problem = getattr(error, "problem", None) or "is not YAML"
    if isinstance(error, yaml.reader.ReaderError):
        problem = "holds bytes that are no text; a YAML file is wanted"
    if _is_too_deep(error):
        return Fault(TOO_DEEP, file=file, line=mark.line + 1 if mark else None)
    return Fault(f"not YAML: {problem}", file=file, line=mark.line + 1 if mark else None)


class _Reader:
    """Walks a node graph into plain data."""

    def __init__(self, document: Document) -> None:
        self.document = document
        self.count = 0

    def read(self, node: yaml.Node, path: KeyPath, depth: int) -> Any:
        self.count += 1
        if self.count > MOST_NODES or depth > DEEPEST:
            what = "nested too deeply" if depth > DEEPEST else "too large once its aliases unfold"
            self._fault(node, path[:4], f"is {what}")
            raise SpecError(self.document.faults[-1:])
        if isinstance(node, yaml.MappingNode):
            return self._mapping(node, path, depth)
        if isinstance(node, yaml.SequenceNode):
            for k, item in enumerate(node.value):
                self.document.lines[(*path, str(k))] = item.start_mark.line + 1
            return [self.read(v, (*path, str(k)), depth + 1) for k, v in enumerate(node.value)]
        if isinstance(node, yaml.ScalarNode):
            return self._scalar(node, path)
        raise TypeError(f"a YAML node of kind {type(node).__name__}")

    def _mapping(self, node: yaml.MappingNode, path: KeyPath, depth: int) -> dict[str, Any]:
        data: dict[str, Any] = {}
        first: dict[str, int] = {}
        for key_node, value_node in node.value:
            line = key_node.start_mark.line + 1
            if not isinstance(key_node, yaml.ScalarNode):
                self._fault(key_node, path, "a key is a list or a mapping; a word is wanted")
                continue
            key = key_node.value
            if key in first:
                self._fault(key_node, (*path, key), f"stands twice, first in line {first[key]}")
                continue
            first[key] = line
            self.document.lines[(*path, key)] = line
            data[key] = self.read(value_node, (*path, key), depth + 1)
        return data

    def _scalar(self, node: yaml.ScalarNode, path: KeyPath) -> Any:
        explicit = node.tag.startswith("!") or node.tag.startswith("tag:yaml.org,2002:python")
        if explicit:
            self._fault(node, path, f"the tag {node.tag} is not read; write a plain value")
            return None
        return node.value if node.style else plain_value(node.value)  # a style means quotes

    def _fault(self, node: yaml.Node, path: KeyPath, message: str) -> None:
        line = node.start_mark.line + 1
        self.document.faults.append(Fault(message, ".".join(path), self.document.file, line))
