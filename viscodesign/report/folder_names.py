"""Names of folders, made of the names of scenes."""

from __future__ import annotations

import itertools
import re
from pathlib import Path


def folder_name(name: str) -> str:
    """A scene's name as the name of a folder."""
    return re.sub(r"[^\w.+-]+", "_", name).strip("._") or "run"


def numbered(plain: Path) -> itertools.chain[Path]:
    """A path, and the same with numbers from 2 on."""
    return itertools.chain(
        [plain], (plain.with_name(f"{plain.name}-{n}") for n in itertools.count(2))
    )
