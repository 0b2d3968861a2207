"""Nothing moves before the user has agreed."""

from __future__ import annotations

import sys
from collections.abc import Callable

from viscodesign.cli.output import complain
from viscodesign.errors import UsageError


def asking(*, yes: bool, quiet: bool = False) -> Callable[[str], bool]:
    """A function that shows what is about to happen on standard error, and asks.

    Its text ends with the question. ``yes``: agreed to beforehand; then ``quiet`` shows
    nothing. Raises `UsageError` where there is no one to ask.
    """

    def confirm(text: str) -> bool:
        plan, _, question = text.rpartition("\n")
        if plan and not (quiet and yes):
            complain(plan)
        if yes:
            return True
        if not sys.stdin.isatty():
            raise UsageError(
                "not a terminal, cannot ask for confirmation; nothing moved. Read the plan above "
                "and add --yes to agree beforehand"
            )
        return _agreed(question)

    return confirm


def _agreed(question: str) -> bool:
    """Whether the user types y or yes; anything else, an end of file too, is a no."""
    sys.stderr.write(f"{question} [y/N] ")
    sys.stderr.flush()
    return sys.stdin.readline().strip().lower() in ("y", "yes")
