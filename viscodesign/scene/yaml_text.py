"""YAML read safely: plain data, bounded in size and depth, every key with its line."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Any

import yaml

from viscodesign.errors import Fault, SpecError

DEEPEST = 32
MOST_NODES = 200_000
KeyPath = tuple[str, ...]

_INTEGER = re.compile(r"[-+]?[0-9]+")
_NUMBER = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")


@dataclass
class Document:
    """Plain data with the line of every key, and the overrides laid over it."""

    file: str
    data: dict[str, Any]
    lines: dict[KeyPath, int] = field(default_factory=dict)
    overrides: dict[KeyPath, str] = field(default_factory=dict)

    def place(self, path: KeyPath) -> tuple[str, int | None]:
        """File and line of a key, or of the nearest key above it; an override names itself."""
        for depth in range(len(path), 0, -1):
            if path[:depth] in self.overrides:
                return self.overrides[path[:depth]], None
            if path[:depth] in self.lines:
                return self.file, self.lines[path[:depth]]
        return self.file, None


def read_document(text: bytes, file: str) -> Document:
    """Parse one YAML document that is a mapping. Raises `SpecError`."""
    document = Document(file, {})
    reader = _Reader(document)
    try:
        decoded = text.decode("utf-8-sig")
        if not decoded.strip():
            raise SpecError([Fault("is empty; write a spec with 'viscodesign init'", file=file)])
        nodes = list(yaml.compose_all(decoded, Loader=yaml.CSafeLoader))
    except UnicodeDecodeError as error:
        raise SpecError(
            [Fault("is not a text in UTF-8; a YAML file is wanted", file=file)]
        ) from error
    except (yaml.YAMLError, RecursionError) as error:
        raise SpecError([_syntax_fault(error, file)]) from error
    if len(nodes) != 1 or nodes[0] is None:
        raise SpecError([Fault(f"holds {len(nodes)} documents; one is wanted", file=file)])
    data = reader.read(nodes[0], (), 0)
    if reader.faults:
        raise SpecError(reader.faults)
    if not isinstance(data, dict):
        kind = "a list" if isinstance(data, list) else "a single value"
        raise SpecError(
            [Fault(f"is {kind}; a mapping of keys such as 'name:' is wanted", file=file, line=1)]
        )
    document.data = data
    return document


def parse_scalar(text: str, place: str) -> Any:
    """The value of an override, read like a YAML value."""
    try:
        node = yaml.compose(text or "''", Loader=yaml.CSafeLoader)
    except yaml.YAMLError as error:
        raise SpecError([Fault("the value is not YAML", file=place)]) from error
    reader = _Reader(Document(place, {}))
    value = reader.read(node, (), 0) if node is not None else None
    if reader.faults:
        raise SpecError(reader.faults)
    return value


def _syntax_fault(error: Exception, file: str) -> Fault:
    mark = getattr(error, "problem_mark", None)
    problem = getattr(error, "problem", None) or "is not YAML"
    if isinstance(error, RecursionError):
        problem = f"is nested deeper than {DEEPEST}"
    if isinstance(error, yaml.reader.ReaderError):
        problem = "holds bytes that are no text; a YAML file is wanted"
    return Fault(f"not YAML: {problem}", file=file, line=mark.line + 1 if mark else None)


class _Reader:
    """Walks a node graph into plain data."""

    def __init__(self, document: Document) -> None:
        self.document = document
        self.faults: list[Fault] = []
        self.count = 0

    def read(self, node: yaml.Node, path: KeyPath, depth: int) -> Any:
        self.count += 1
        if self.count > MOST_NODES or depth > DEEPEST:
            what = "nested too deeply" if depth > DEEPEST else "too large once its aliases unfold"
            self._fault(node, path[:4], f"is {what}")
            raise SpecError(self.faults[-1:])
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
        text = node.value
        if node.style:  # quoted
            return text
        if text in ("", "~", "null"):
            return None
        if text in ("true", "false"):
            return text == "true"
        if _INTEGER.fullmatch(text):
            return int(text) if len(text) < 100 else float(text)
        if _NUMBER.fullmatch(text):
            return float(text)
        return text

    def _fault(self, node: yaml.Node, path: KeyPath, message: str) -> None:
        line = node.start_mark.line + 1
        self.faults.append(Fault(message, ".".join(path), self.document.file, line))
