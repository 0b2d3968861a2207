"""YAML read safely: plain data, bounded in size and depth, every key with its line.

Built from the events of PyYAML's C parser in one pass. Its times, against the round-trip loader
of ruamel.yaml 0.19 (pure Python; its C parser keeps neither lines nor comments):

======================================  =======  ===========
spec                                    here     ruamel.yaml
======================================  =======  ===========
configs/leg_16_straight_air.yaml        0.3 ms   8 ms
a custom network of 2,000 lines         50 ms   1,000 ms
======================================  =======  ===========

ruamel.yaml would also stop at the first duplicate key, where all errors of a file are wanted
at once, so it is not used.
"""

from __future__ import annotations

import codecs
from collections.abc import Iterator, Mapping
from dataclasses import field, replace
from typing import Any

import yaml

from viscodesign.errors import Fault, SpecError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.effects_choice import KnownEffects
from viscodesign.scene.reading.yaml_events import (
    MAX_DEPTH,
    TOO_DEEP,
    event_lists,
    line_of,
    nesting,
    plain_value,
)
from viscodesign.scene.spec_part import KeyPath

ROBOT_KEY = "robot"
"""The key that makes a spec one of a robot."""
ACTUATORS_KEY = "actuators"
"""The key that, without a robot, makes a spec one of several actuators."""
MAX_NODES = 400_000
IGNORED_PREFIX = "x-"
"""How top-level keys begin that a spec keeps for itself, such as values that anchors name."""
MERGE_KEY = "<<"
"""Whose value is a mapping, or several, that give what a mapping has not got itself."""
MERGES_MAPPINGS = (
    "'<<' merges mappings; expected an alias of one, such as '*base', or a list of them"
)
QUOTED_KEYS = '; within { } a key with [ ] has quotes: {"network.tubes[*].radius": 2 %}'


@dataclass
class Document:
    """Plain data with the line of every key, and the overrides laid over it."""

    file: str
    data: dict[str, Any] = field(default_factory=dict)
    lines: dict[KeyPath, int] = field(default_factory=dict)
    overrides: dict[KeyPath, str] = field(default_factory=dict)
    faults: list[Fault] = field(default_factory=list)
    """Faults of single keys and values, which leave the rest of the document readable."""
    model: Any = None
    """The pydantic model that it is read into; None for a spec of a scene."""
    effects: KnownEffects = KnownEffects(())
    """Those that it may name."""

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
        """File and line of a key, or of its nearest parent; an override names itself."""
        for depth in range(len(path), 0, -1):
            if path[:depth] in self.overrides:
                return self.overrides[path[:depth]], None
            if path[:depth] in self.lines:
                return self.file, self.lines[path[:depth]]
        return self.file, None

    def places(
        self, before: Mapping[str, tuple[str, int | None]]
    ) -> dict[str, tuple[str, int | None]]:
        """File and line of all keys by their dotted paths, but for entries of lists.

        ``before``: those of a spec that this one changes.
        """
        found = dict(before)
        for path, line in self.lines.items():
            if not any(part.isdigit() for part in path):
                found[".".join(path)] = self.file, line
        for path, place in self.overrides.items():
            key = ".".join(path)
            found = {own: at for own, at in found.items() if not f"{own}.".startswith(f"{key}.")}
            found[key] = place, None
        return found


def read_document(text: bytes, file: str) -> Document:
    """Parse one YAML document that is a mapping. Raises `SpecError`."""
    documents = event_lists(decoded(text, file), file)
    if len(documents) > 1:
        raise SpecError([Fault(f"contains {len(documents)} documents; expected one", file=file)])
    if not documents or getattr(documents[0][0], "value", None) == "":
        raise SpecError([Fault("is empty; create a spec with 'viscodesign init'", file=file)])
    document = Document(file)
    data = _Builder(document, documents[0]).value((), 0)
    if not isinstance(data, dict):
        kind = "a list" if isinstance(data, list) else "a single value"
        message = f"is {kind}; expected a mapping with keys such as 'name:'"
        raise SpecError([Fault(message, file=file, line=1)])
    document.data = data
    return document


def encoding_of(content: bytes) -> str:
    """The encoding of a spec, by the mark at its beginning; UTF-8 without one."""
    if content.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        return "utf-16"
    return "utf-8-sig" if content.startswith(codecs.BOM_UTF8) else "utf-8"


def decoded(content: bytes, file: str) -> str:
    """The text of a spec: UTF-8, or UTF-16 with a mark, as YAML has it. Raises `SpecError`."""
    try:
        return content.decode(encoding_of(content))
    except UnicodeDecodeError as error:
        byte, line = content[error.start], 1 + content.count(b"\n", 0, error.start)
        message = f"not UTF-8 text (byte 0x{byte:02x}); expected a YAML file, saved as UTF-8"
        raise SpecError([Fault(message, file=file, line=line)]) from error


def parse_value(text: str, source: str) -> Any:
    """The value of an override, read like a YAML value; ``source`` names it in faults."""
    document = Document(source)
    try:
        documents = event_lists(text or "''", source)
        if len(documents) > 1:
            document.faults.append(Fault("expected a single YAML value", file=source))
        data = _Builder(document, documents[0]).value((), 0) if documents else None
    except UnicodeEncodeError as error:  # bytes of a command line that are not text
        raise SpecError([Fault("not UTF-8 text", file=source)]) from error
    except SpecError as error:
        hint = QUOTED_KEYS if "{" in text and "[*]" in text else ""
        faults = [replace(own, line=None, message=own.message + hint) for own in error.faults]
        raise SpecError(faults) from error
    if document.faults:
        raise SpecError([replace(fault, line=None) for fault in document.faults])
    return data


class _Builder:
    """Builds plain data from the events of one document."""

    def __init__(self, document: Document, events: list[yaml.Event]) -> None:
        self.document = document
        self.events = events
        self.next = 0
        self.anchors = {
            event.anchor: k
            for k, event in enumerate(events)
            if isinstance(event, yaml.NodeEvent) and not isinstance(event, yaml.AliasEvent)
        }
        self.count = 0

    def value(self, path: KeyPath, depth: int) -> Any:
        """The value whose events come next."""
        event = self.events[self.next]
        self.count += 1
        if self.count > MAX_NODES or depth > MAX_DEPTH:
            problem = TOO_DEEP if depth > MAX_DEPTH else "too large once its aliases are expanded"
            self._refuse(event, path[:4], problem)
            raise SpecError(self.document.faults[-1:])
        self.next += 1
        if isinstance(event, yaml.AliasEvent):
            behind, self.next = self.next, self.anchors[event.anchor]
            data = self.value(path, depth)
            self.next = behind
            return data
        if isinstance(event, yaml.MappingStartEvent):
            return self._mapping(path, depth)
        if isinstance(event, yaml.SequenceStartEvent):
            return self._sequence(path, depth)
        return self._scalar(event, path)

    def _mapping(self, path: KeyPath, depth: int) -> dict[str, Any]:
        data: dict[str, Any] = {}
        lines: dict[str, int] = {}
        merged: list[int] = []
        while not self._collection_ends():
            event = self.events[self.next]
            key = self._key()
            if key is None:
                self._refuse(event, path, "a key must be a word, not a list or a mapping")
                self._skip()
            elif key == MERGE_KEY and not getattr(event, "style", None):
                merged.append(self.next)
                self._skip()
            elif key in lines:
                problem = f"duplicate key, first defined on line {lines[key]}"
                self._refuse(event, (*path, key), problem)
                self._skip()
            else:
                lines[key] = self.document.lines[(*path, key)] = line_of(event)
                data[key] = self.value((*path, key), depth + 1)
        behind = self.next
        for at in merged:
            self.next = at
            self._merge(data, path, depth)
        self.next = behind
        return data

    def _merge(self, data: dict[str, Any], path: KeyPath, depth: int) -> None:
        """Add the keys of the mapping, or the list of mappings, that comes next; own ones stay."""
        event, lines = self.events[self.next], self.document.lines
        for given, own in self._merged_mappings(path, depth):
            if given is None:
                self._refuse(event, (*path, MERGE_KEY), MERGES_MAPPINGS)
                continue
            new = {key for key in given if key not in data}
            data |= {key: given[key] for key in given if key in new}
            lines |= {at: line for at, line in own.items() if at[len(path)] in new}

    def _merged_mappings(
        self, path: KeyPath, depth: int
    ) -> Iterator[tuple[dict[str, Any] | None, dict[KeyPath, int]]]:
        """Each mapping to be merged with the lines of its keys; None for what is none."""
        outer = self.document.lines
        is_list = isinstance(self.events[self.next], yaml.SequenceStartEvent)
        self.next += is_list
        while not (is_list and self._collection_ends()):
            self.document.lines = {}
            given = self.value(path, depth + 1)
            own, self.document.lines = self.document.lines, outer
            yield (given, own) if isinstance(given, dict) else (None, {})
            if not is_list:
                return

    def _key(self) -> str | None:
        """The next key; None if it is not a word."""
        event = self.events[self.next]
        if isinstance(event, yaml.AliasEvent):
            event = self.events[self.anchors[event.anchor]]
        self._skip()
        return event.value if isinstance(event, yaml.ScalarEvent) else None

    def _sequence(self, path: KeyPath, depth: int) -> list[Any]:
        items: list[Any] = []
        while not self._collection_ends():
            inner = (*path, str(len(items)))
            self.document.lines[inner] = line_of(self.events[self.next])
            items.append(self.value(inner, depth + 1))
        return items

    def _scalar(self, event: Any, path: KeyPath) -> Any:
        tag = event.tag or ""
        if tag.startswith(("!", "tag:yaml.org,2002:python")):
            self._refuse(event, path, f"the tag {tag} is not supported; write a plain value")
            return None
        return event.value if event.style else plain_value(event.value)  # a style means quotes

    def _collection_ends(self) -> bool:
        """Whether the collection being read ends here; its end is then behind."""
        ends = isinstance(self.events[self.next], yaml.CollectionEndEvent)
        self.next += ends
        return ends

    def _skip(self) -> None:
        """Move behind the next value, or key."""
        depth = nesting(self.events[self.next])
        self.next += 1
        while depth:
            depth += nesting(self.events[self.next])
            self.next += 1

    def _refuse(self, event: yaml.Event, path: KeyPath, problem: str) -> None:
        fault = Fault(problem, ".".join(path), self.document.file, line_of(event))
        self.document.faults.append(fault)
