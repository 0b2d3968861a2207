"""What a user is told and asked."""

from __future__ import annotations

from collections.abc import Callable

from viscodesign.errors import UsageError

Tell = Callable[[str], None]
"""Receives one message that a user should read."""
Confirm = Callable[[str], bool]
"""Receives what is about to happen, its last line a question; whether the user agrees."""
ShowPosition = Callable[[str, Callable[[], int]], int]
"""Asks the user to move an axis; given what to do and what reads the position [steps].

Returns the position at which the user said so.
"""


def ignore(message: str) -> None:
    """Drop a message."""


def require(confirm: Confirm, text: str) -> None:
    """Raise `UsageError` unless the user agrees."""
    if not confirm(text):
        raise UsageError("aborted; nothing moved")
