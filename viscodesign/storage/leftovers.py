"""Hidden files of writers that were killed, told from those of writers that live.

Whoever writes holds a lock on its file, which the system takes back however it ends.
"""

from __future__ import annotations

import contextlib
import fcntl
import os
import re
import tempfile
from collections.abc import Iterable
from pathlib import Path

RANDOM = r"\.[a-z0-9_]{8}"
"""How the names of temporary files end."""


def temporary_beside(path: Path) -> tuple[int, str]:
    """A new hidden file beside a path, open and locked: its handle and its name."""
    while True:
        handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name[:100]}.")
        # Some disks know no locks; nothing is ever cleared there.
        with contextlib.suppress(OSError):
            fcntl.flock(handle, fcntl.LOCK_EX)
        if os.path.exists(name):
            return handle, name
        # It was taken for a leftover before it was locked.
        os.close(handle)


def clear_leftovers(folder: Path, names: Iterable[str]) -> None:
    """Remove what killed writers of files of these names left in a folder."""
    known = "|".join(re.escape(name) for name in names)
    for file in folder.iterdir():
        if re.fullmatch(rf"\.({known}){RANDOM}", file.name):
            with contextlib.suppress(OSError), file.open("r+b") as opened:
                fcntl.flock(opened, fcntl.LOCK_EX | fcntl.LOCK_NB)
                file.unlink()
