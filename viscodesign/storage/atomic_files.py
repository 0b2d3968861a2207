"""Files that are whole or absent."""

from __future__ import annotations

import contextlib
import errno
import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from typing import IO

from viscodesign.errors import UsageError
from viscodesign.storage.leftovers import temporary_beside

REMEDIES = {
    errno.ENOSPC: "Free some space, or use another folder.",
    errno.EDQUOT: "Free some space, or use another folder.",
    errno.EROFS: "Use a folder that can be written.",
    errno.EACCES: "Use a folder that you may write.",
    errno.EPERM: "Use a folder that you may write.",
    errno.ENOTDIR: "A part of the path is a file; use another path.",
    errno.EISDIR: "It is a folder; use another name.",
    errno.ENAMETOOLONG: "Use a shorter name.",
    errno.ENOENT: "Its folder does not exist; make it first.",
}


@contextlib.contextmanager
def replaced(path: Path) -> Iterator[IO[bytes]]:
    """A binary file that takes its place at the end, or vanishes on any interruption.

    Raises `UsageError` where the folder or the disk refuses it.
    """
    with refused_plainly(path):
        temporary: str | None = None
        try:
            handle, temporary = temporary_beside(path)
            with os.fdopen(handle, "wb") as file:
                yield file
                file.flush()
                # Still locked: nobody takes it for a leftover.
                os.chmod(temporary, 0o666 & ~_umask())
                os.replace(temporary, path)
                temporary = None
        finally:
            if temporary is not None:
                with contextlib.suppress(OSError):
                    os.unlink(temporary)


@contextlib.contextmanager
def refused_plainly(path: Path) -> Iterator[None]:
    """Turn the system's refusal to write ``path`` into a `UsageError` with a remedy."""
    try:
        yield
    except OSError as error:
        reason = error.strerror or str(error)
        remedy = REMEDIES.get(error.errno or 0, "Use another place.")
        raise UsageError(f"cannot write {path}: {reason}. {remedy}") from error


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def write_bytes(path: Path, content: bytes) -> None:
    """Write a file whole or not at all."""
    with replaced(path) as file:
        file.write(content)


def write_all(
    contents: Mapping[Path, Iterable[bytes]], first: Callable[[], None] = lambda: None
) -> None:
    """Write several files, part by part; none takes its place before all are on the disk.

    ``first`` is called then, right before they do.
    """
    with contextlib.ExitStack() as stack:
        # A stack is left in reverse order: the first file is to appear first.
        for path, parts in reversed(list(contents.items())):
            file = stack.enter_context(replaced(path))
            for part in parts:
                file.write(part)
            file.flush()
        first()
