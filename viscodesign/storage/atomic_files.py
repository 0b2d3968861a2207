"""Files that are complete or absent.

A writer holds a lock on its hidden temporary file, which the system releases however the
writer ends: that tells the files of killed writers from those of writers at work.
"""

from __future__ import annotations

import contextlib
import errno
import os
import re
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import IO

from viscodesign.errors import OutputError, UsageError
from viscodesign.storage import file_locks

TEMPORARY_SUFFIX = r"\.[a-z0-9_]{8}"
"""How the names of temporary files end."""
NO_ROOM = "Free some space, or use another folder."
OUTPUT_ERRNOS = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)
"""What says that a disk takes no more, rather than that a path was chosen badly."""
REMEDIES = {
    errno.ENOSPC: NO_ROOM,
    errno.EDQUOT: NO_ROOM,
    errno.EFBIG: "Raise the limit on the size of files, or use another folder.",
    errno.EROFS: "Use a writable folder.",
    errno.EACCES: "Use a folder that you may write to.",
    errno.EPERM: "Use a folder that you may write to.",
    errno.EEXIST: "Part of the path is a file; use another path.",
    errno.ENOTDIR: "Part of the path is a file; use another path.",
    errno.EISDIR: "That is a folder; use another name.",
    errno.ENAMETOOLONG: "Use a shorter name.",
    errno.ENOENT: "The folder does not exist; create it first.",
}


@contextlib.contextmanager
def replaced(path: Path) -> Iterator[IO[bytes]]:
    """A binary file that appears when it is complete, and vanishes on any interruption.

    Raises `UsageError` where the folder refuses it, `OutputError` where the disk is full.
    """
    with write_errors_as_usage(path):
        temporary: str | None = None
        try:
            handle, temporary = _temporary_beside(path)
            with os.fdopen(handle, "wb") as file:
                yield file
                file.flush()
                os.chmod(temporary, 0o666 & ~_umask())
                if not file_locks.ARE_THERE:
                    file.close()  # Windows moves no open file
                # Elsewhere still locked, so that nobody takes it for a leftover.
                os.replace(temporary, path)
                temporary = None
        finally:
            if temporary is not None:
                with contextlib.suppress(OSError):
                    os.unlink(temporary)


@contextlib.contextmanager
def write_errors_as_usage(path: Path) -> Iterator[None]:
    """Turn an `OSError` while writing ``path`` into an error with a remedy: an `OutputError` where
    the disk takes no more, else a `UsageError`.
    """
    try:
        yield
    except OSError as error:
        reason = error.strerror or str(error)
        remedy = REMEDIES.get(error.errno or 0, "Use another location.")
        kind = OutputError if error.errno in OUTPUT_ERRNOS else UsageError
        raise kind(f"cannot write {path}: {reason}. {remedy}") from error


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def write_bytes(path: Path, content: bytes) -> None:
    """Write a file completely or not at all."""
    with replaced(path) as file:
        file.write(content)


def write_all(
    contents: Mapping[Path, Iterable[bytes]], first: Callable[[], None] = lambda: None
) -> None:
    """Write several files, part by part; none appears before all are on the disk.

    ``first`` is called right before they do.
    """
    with contextlib.ExitStack() as stack:
        # The stack unwinds in reverse order, so the first file appears first.
        for path, parts in reversed(list(contents.items())):
            file = stack.enter_context(replaced(path))
            for part in parts:
                file.write(part)
            file.flush()
        first()


def _temporary_beside(path: Path) -> tuple[int, str]:
    """Open a new hidden file beside a path, locked; returns its handle and its name."""
    while True:
        handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name[:100]}.")
        # Some file systems have no locks; nothing is ever cleared there.
        with contextlib.suppress(OSError):
            file_locks.lock(handle)
        if os.path.exists(name):
            return handle, name
        # Another process took it for a leftover before it was locked.
        os.close(handle)


def clear_leftovers(folder: Path, names: Iterable[str]) -> None:
    """Remove temporary files of these names that interrupted writers left in a folder."""
    known = "|".join(re.escape(name) for name in names)
    for file in folder.iterdir():
        if re.fullmatch(rf"\.({known}){TEMPORARY_SUFFIX}", file.name):
            with contextlib.suppress(OSError), file.open("r+b") as opened:
                file_locks.lock_free(opened.fileno())
                file.unlink()
