"""The bundled specs: the folder `configs`, in a wheel or in a checkout."""

from __future__ import annotations

import difflib
import re
from pathlib import Path

from viscodesign.errors import UsageError, ViscodesignError
from viscodesign.lazy_dataclass import dataclass

DEFAULT = "leg"

PACKAGE = Path(__file__).resolve().parents[1]
FOLDERS = (PACKAGE / "configs", PACKAGE.parent / "configs")
"""In an installed wheel; in a checkout."""


@dataclass(frozen=True)
class Template:
    """One bundled spec."""

    name: str
    path: Path

    def text(self) -> str:
        """The spec with its comments."""
        return self.path.read_text(encoding="utf-8")

    def tables(self) -> list[Path]:
        """Tables beside the spec that it reads by name (`file: table.csv`)."""
        named = re.findall(r"\bfile:\s*['\"]?([\w.-]+\.csv)", self.text())
        return [self.path.with_name(name) for name in named]

    def summary(self) -> str:
        """The first paragraph of the comment at its top."""
        lines: list[str] = []
        for line in self.text().splitlines():
            words = line.removeprefix("#").strip()
            if not words or not line.startswith("#"):
                break
            lines.append(words)
        return " ".join(lines)


def templates() -> dict[str, Template]:
    """Every bundled spec by name; the default first, the others in order of name."""
    for folder in FOLDERS:
        found = {path.stem: Template(path.stem, path) for path in folder.glob("*.yaml")}
        if DEFAULT in found:
            return {name: found[name] for name in sorted(found, key=lambda n: (n != DEFAULT, n))}
    raise ViscodesignError("the bundled specs are missing; install viscodesign again")


def template(name: str) -> Template:
    """The bundled spec of this name."""
    known = templates()
    if name not in known:
        close = difflib.get_close_matches(name, known, n=1)
        hint = f"did you mean '{close[0]}'? " if close else ""
        raise UsageError(
            f"--template {name}: no such template; {hint}`viscodesign init --list` lists them"
        )
    return known[name]
