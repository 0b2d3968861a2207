"""Changes of single values of a spec in its text; comments, order and all else stay."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import yaml

from viscodesign.errors import UsageError
from viscodesign.scene.effects_choice import MODE, is_effect, mapping_of
from viscodesign.scene.reading.document import decoded, encoding_of


def write_values(file: Path, section: str, values: Mapping[str, str]) -> None:
    """Set keys of a section in a spec's file, completely or not at all.

    ``values`` are YAML texts by key. Raises `UsageError` where there is no such section.
    """
    from viscodesign.storage.atomic_files import write_bytes

    content = file.read_bytes()
    text = with_values(decoded(content, str(file)), section, values)
    write_bytes(file, text.encode(encoding_of(content)))


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


def with_value(text: str, path: Sequence[str], value: str) -> str:
    """The text of a spec with one key set to a YAML text, wherever it is; comments stay.

    A word such as `gravity: on` is replaced by the mapping that it abbreviates.
    """
    here: yaml.Node | None = yaml.compose(text, Loader=yaml.SafeLoader)
    for depth, key in enumerate(path):
        below = _value_of(here, key)
        if below is None:
            return _inserted(text, here, key, _nested(path[depth + 1 :], value))
        has_keys = isinstance(below, yaml.MappingNode) and below.value
        if has_keys and is_effect(path) and depth == 1 and not value.startswith("{"):
            return with_value(text, (*path, MODE), value)
        if depth == len(path) - 1 or not has_keys:
            start, end = below.start_mark.index, _end(below)
            said = mapping_of(tuple(path[: depth + 1]), text[start:end])
            new = _nested(path[depth + 1 :], value, said if depth < len(path) - 1 else {})
            return text[:start] + new + text[end:]
        here = below
    return text


def _nested(path: Sequence[str], value: str, beside: Mapping[str, str] | None = None) -> str:
    """A value as mappings of mappings, on one line; ``beside`` it: keys of the outermost one."""
    new = "".join(f"{{{key}: " for key in path) + value + "}" * len(path)
    return new.replace("{", "{" + "".join(f"{k}: {v}, " for k, v in (beside or {}).items()), 1)


def _inserted(text: str, node: yaml.Node | None, key: str, value: str) -> str:
    """The text with one more key: first in a section, last at the top level."""
    if not isinstance(node, yaml.MappingNode) or not node.value or node.start_mark.column == 0:
        return f"{text.rstrip()}\n\n{key}: {value}\n"
    first = node.value[0][0].start_mark
    behind = ", " if node.flow_style else "\n" + " " * first.column
    return f"{text[: first.index]}{key}: {value}{behind}{text[first.index :]}"


def _value_of(node: yaml.Node | None, key: str) -> yaml.Node | None:
    pairs = node.value if isinstance(node, yaml.MappingNode) else []
    return next((value for name, value in pairs if name.value == key), None)


def _end(node: yaml.Node) -> int:
    """Where a value ends; the end mark of an indented block is at the next key."""
    if not isinstance(node, yaml.CollectionNode) or node.flow_style or not node.value:
        return int(node.end_mark.index)
    last = node.value[-1]
    return _end(last[1] if isinstance(last, tuple) else last)
