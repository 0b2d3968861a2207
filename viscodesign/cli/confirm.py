"""Nothing moves before somebody said so."""

from __future__ import annotations

import sys
from collections.abc import Sequence

from viscodesign.cli.output import complain
from viscodesign.errors import UsageError


def confirm(lines: Sequence[str], question: str, *, yes: bool) -> None:
    """Show on standard error what is going to happen, and go on only where it is agreed to.

    Raises `UsageError` where the answer is no, and where nobody is there to be asked: then
    ``yes`` has to be given beforehand.
    """
    if lines:
        complain("\n".join(lines))
    if yes:
        return
    if not sys.stdin.isatty():
        raise UsageError(
            "nobody to ask (standard input is no terminal), so nothing moves; "
            "read the plan above and add --yes to agree to it beforehand"
        )
    if not _agreed(question):
        raise UsageError("not agreed to; nothing has moved")


def _agreed(question: str) -> bool:
    """Whether the user types y or yes; anything else, an end of file too, is a no."""
    sys.stderr.write(f"{question} [y/N] ")
    sys.stderr.flush()
    return sys.stdin.readline().strip().lower() in ("y", "yes")
