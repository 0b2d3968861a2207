"""Home and travel as lines of a spec, and into its file."""

from __future__ import annotations

import re
from pathlib import Path

from viscodesign.errors import UsageError


def spec_lines(home: int, travel: tuple[int, int]) -> list[str]:
    """To be pasted below `pump:`."""
    return [f"home: {home}", f"travel: [{travel[0]}, {travel[1]}]"]


def with_lines(text: str, home: int, travel: tuple[int, int]) -> str:
    """A spec's text with these in its `pump:`; comments and everything else stay."""
    lines = text.splitlines(keepends=True)
    start = next((k for k, line in enumerate(lines) if re.match(r"pump:\s*(#.*)?$", line)), None)
    if start is None:
        raise UsageError("the spec has no block `pump:` of its own; paste the lines by hand")
    for line in reversed(spec_lines(home, travel)):
        key = line.partition(":")[0]
        place = _line_of(lines, start, key)
        if place is None:
            lines.insert(start + 1, f"{_indent(lines, start)}{line}\n")
        else:
            lines[place] = re.sub(r"^(\s+).*?(\s*(#.*)?)$", rf"\g<1>{line}\g<2>", lines[place])
    return "".join(lines)


def _line_of(lines: list[str], start: int, key: str) -> int | None:
    """Where a key of the block that begins at ``start`` stands, on one line."""
    for k in range(start + 1, len(lines)):
        if lines[k].strip() and not lines[k][0].isspace() and not lines[k].startswith("#"):
            return None
        if re.match(rf"\s+{key}:\s*\S", lines[k]):
            return k
    return None


def _indent(lines: list[str], start: int) -> str:
    inside = (re.match(r"(\s+)\w", line) for line in lines[start + 1 : start + 2])
    return next((found[1] for found in inside if found), "  ")


def write_spec(path: Path, home: int, travel: tuple[int, int]) -> None:
    """Change a spec's file, as a whole or not at all."""
    from viscodesign.storage.atomic_files import write_bytes

    write_bytes(path, with_lines(path.read_text(), home, travel).encode())
