"""Locks on open files, where the system has them (Windows has others, and needs none here).

A lock ends with its process, however that ends. Windows removes no file that is open, which tells
a writer at work from a leftover just as well.
"""

from __future__ import annotations

try:
    import fcntl
except ImportError:  # Windows
    ARE_THERE = False
else:
    ARE_THERE = True


def lock(handle: int) -> None:
    """Lock an open file, waiting for whoever holds it. Raises `OSError` where that is refused."""
    if ARE_THERE:
        fcntl.flock(handle, fcntl.LOCK_EX)


def lock_free(handle: int) -> None:
    """Lock an open file that nobody else has locked; raises `OSError` if somebody has."""
    if ARE_THERE:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
