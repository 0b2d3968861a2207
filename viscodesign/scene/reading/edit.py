"""Changes of single values of a spec in its file; comments, order and all else stay."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import yaml

from viscodesign.errors import UsageError


def write_values(file: Path, section: str, values: Mapping[str, str]) -> None:
    """Set keys of a section in a spec's file, completely or not at all.

    ``values`` are YAML texts by key. Raises `UsageError` where there is no such section.
    """
    from viscodesign.storage.atomic_files import write_bytes

    text = file.read_bytes().decode()
    write_bytes(file, with_values(text, section, values).encode())


def with_values(text: str, section: str, values: Mapping[str, str]) -> str:
    """The text of a spec with these values in a section."""
    node = _value_of(yaml.compose(text, Loader=yaml.SafeLoader), section)
    if not isinstance(node, yaml.MappingNode) or not node.value:
        raise UsageError(f"the spec has no section `{section}:` with keys; add the lines by hand")
    first = node.value[0][0].start_mark
    behind = ", " if node.flow_style else "\n" + " " * first.column
    known = {key: found for key in values if (found := _value_of(node, key)) is not None}
    new = "".join(f"{key}: {values[key]}{behind}" for key in values if key not in known)
    changes = [(first.index, first.index, new)]
    changes += [(found.start_mark.index, _end(found), values[key]) for key, found in known.items()]
    for start, end, replacement in sorted(changes, reverse=True):
        text = text[:start] + replacement + text[end:]
    return text


def _value_of(node: yaml.Node | None, key: str) -> yaml.Node | None:
    pairs = node.value if isinstance(node, yaml.MappingNode) else []
    return next((value for name, value in pairs if name.value == key), None)


def _end(node: yaml.Node) -> int:
    """Where a value ends; the end mark of an indented block is at the next key."""
    if not isinstance(node, yaml.CollectionNode) or node.flow_style or not node.value:
        return int(node.end_mark.index)
    last = node.value[-1]
    return _end(last[1] if isinstance(last, tuple) else last)
