"""Machine code and formulas kept in the user's cache folder between processes.

A file is whole or absent, and only loaded if its checksum agrees. A folder that cannot be read
or written only costs the time to compile again.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import sys
from collections.abc import Callable
from functools import cache
from inspect import getsource
from pathlib import Path
from types import ModuleType

from viscodesign.errors import OutputError, UsageError
from viscodesign.storage.atomic_files import write_bytes

FOLDER_VARIABLE = "VISCODESIGN_CACHE"
"""Environment variable: another cache folder; empty or ``off`` for none."""
MAX_BYTES = 64 * 2**20
"""Bytes that are kept; beyond, what was not used for longest goes."""
KEPT_SHARE = 15 / 16
"""Part of them that then stays, so that a folder need not be looked through at every file."""
MAGIC = b"viscodesign machine code 1\n"
SUFFIX = ".code"


def cached(parts: tuple[str | bytes, ...], make: Callable[[], bytes]) -> bytes:
    """What ``make`` gives, from the cache folder if it was made there for the same parts."""
    code = kept(parts)
    if code is None:
        code = make()
        keep(parts, code)
    return code


def kept(parts: tuple[str | bytes, ...]) -> bytes | None:
    """What was kept for these parts."""
    folder = cache_folder()
    return None if folder is None else _read(folder / (digest(parts) + SUFFIX))


def keep(parts: tuple[str | bytes, ...], code: bytes) -> None:
    """Keep it for them, if there is a cache folder."""
    folder = cache_folder()
    if folder is not None:
        _write(folder / (digest(parts) + SUFFIX), code)


def cache_folder() -> Path | None:
    """The folder of machine code, which need not exist; None without a cache."""
    moved = os.environ.get(FOLDER_VARIABLE)
    if moved is not None:
        off = moved.strip().lower() in ("", "off")
        return None if off else Path(moved) / "native"
    try:
        home = Path.home()
    except RuntimeError:
        return None
    usual = home / ("Library/Caches" if sys.platform == "darwin" else ".cache")
    given = Path(os.environ.get("XDG_CACHE_HOME", ""))
    return (given if given.is_absolute() else usual) / "viscodesign" / "native"


def digest(parts: tuple[str | bytes, ...]) -> str:
    """One name for all parts, whatever they contain."""
    whole = hashlib.sha256()
    for part in parts:
        data = part.encode() if isinstance(part, str) else part
        whole.update(f"{len(data)}:".encode() + data)
    return whole.hexdigest()


@cache
def written_by(*modules: ModuleType) -> str:
    """What tells one way of writing code from another; two of them may have the same version."""
    try:
        return digest(tuple(getsource(module) for module in modules))
    except OSError:
        return "code without source"


def _read(path: Path) -> bytes | None:
    """The code in a file, if it is whole and a file of this user (or of root)."""
    try:
        with path.open("rb") as file:
            owner = os.fstat(file.fileno()).st_uid
            content = file.read(MAX_BYTES + 1)
    except OSError:
        return None
    head, code = content[: len(MAGIC) + 32], content[len(MAGIC) + 32 :]
    # Windows has no numbers of users; there, the folder is the user's own.
    is_own = os.name != "posix" or owner in (os.getuid(), 0)
    if not is_own or head != MAGIC + hashlib.sha256(code).digest():
        return None
    # The time of the last use, for `_make_room`.
    with contextlib.suppress(OSError):
        os.utime(path)
    return code


def _write(path: Path, code: bytes) -> None:
    """Add a file, and remove the oldest ones if they are too many."""
    with contextlib.suppress(OSError, UsageError, OutputError):
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        content = MAGIC + hashlib.sha256(code).digest() + code
        write_bytes(path, content)
        total = _totals.get(path.parent, MAX_BYTES) + len(content)
        _totals[path.parent] = _make_room(path.parent) if total > MAX_BYTES else total


_totals: dict[Path, int] = {}
"""Bytes in each folder when it was last looked through, and what this process wrote since."""


def _make_room(folder: Path) -> int:
    """Remove the oldest files of a folder that holds too much; how many bytes are left."""
    files = []
    for entry in os.scandir(folder):
        # Others may remove files at the same time.
        with contextlib.suppress(OSError):
            files.append((entry.stat().st_mtime, entry.stat().st_size, entry.path))
    total = sum(size for _, size, _ in files)
    if total <= MAX_BYTES:
        return total
    for _, size, name in sorted(files):
        if total <= KEPT_SHARE * MAX_BYTES:
            break
        with contextlib.suppress(OSError):
            os.unlink(name)
        total -= size
    return total
