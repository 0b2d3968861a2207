"""Errors with their exit codes; a message says where, what was given and what to do."""

from __future__ import annotations

import difflib
from collections.abc import Iterable, Sequence
from dataclasses import field
from typing import Any, ClassVar

from viscodesign.lazy_dataclass import dataclass


class ViscodesignError(Exception):
    """Base of every error that is reported to the user."""

    exit_code = 1
    kind = "other"
    """What failed, in one word: the ``type`` of its document."""

    def document(self) -> dict[str, Any]:
        """The error for a program: type, exit code, message, and what else is known of it."""
        return {"type": self.kind, "exit_code": self.exit_code, "message": str(self)}


@dataclass(frozen=True)
class Fault:
    """One error in a spec, and where it is."""

    message: str
    key: str = ""
    file: str = ""
    line: int | None = None
    given: Any = field(default=None, compare=False)
    """The value that was given, plain data; None where there is none."""
    allowed: str = field(default="", compare=False)
    """What the key may have instead, in words; empty where it is not about one value."""

    def document(self) -> dict[str, Any]:
        """The fault for a program, under the names of its fields."""
        return {
            "file": self.file or None,
            "line": self.line,
            "key": self.key or None,
            "given": self.given,
            "allowed": self.allowed or None,
            "message": self.message,
        }

    def __str__(self) -> str:
        place = self.file
        if self.file and self.line is not None:
            place = f"{self.file}:{self.line}"
        return ": ".join(_abridged(part) for part in (place, self.key, self.message) if part)


MAX_PART_LENGTH = 600
"""Characters of a file name, key or message that are printed: any spec gives a readable message."""


def _abridged(text: str) -> str:
    """A text without its middle if it is too long to read."""
    if len(text) <= MAX_PART_LENGTH:
        return text
    return f"{text[: MAX_PART_LENGTH // 2]} [...] {text[-MAX_PART_LENGTH // 4 :]}"


MAX_LISTED_FAULTS = 60
"""Faults that a message lists; a file with more is not a spec with typos."""


class SpecError(ViscodesignError):
    """A spec that cannot be run; holds every fault that was found."""

    exit_code = 2
    kind = "spec"

    def __init__(self, faults: Sequence[Fault]) -> None:
        self.faults = list(faults)
        lines = [str(fault) for fault in self.faults[:MAX_LISTED_FAULTS]]
        if len(self.faults) > MAX_LISTED_FAULTS:
            lines.append(f"and {len(self.faults) - MAX_LISTED_FAULTS} more errors")
        super().__init__("\n".join(lines))

    def document(self) -> dict[str, Any]:
        """With all faults, each by file, line, key, what is given and what is allowed."""
        return {**super().document(), "faults": [fault.document() for fault in self.faults]}

    @classmethod
    def plain(cls, message: str) -> SpecError:
        """An error of the scene as a whole, found after its file was read."""
        return cls([Fault(message)])


class UsageError(ViscodesignError):
    """A command cannot be carried out as given, such as writing into an existing file."""

    exit_code = 2
    kind = "usage"


class OutputError(ViscodesignError):
    """What was computed cannot be written or printed: the disk or the terminal refuses it."""

    exit_code = 3
    kind = "output"


class SolveError(ViscodesignError):
    """The solver cannot continue: which quantity, where, when, and what to change."""

    exit_code = 3
    kind = "solve"

    def __init__(
        self,
        message: str,
        *,
        quantity: str,
        where: str,
        time_s: float | None = None,
        remedy: str = "",
    ) -> None:
        self.quantity = quantity
        self.where = where
        self.time_s = time_s
        self.remedy = remedy
        self.short = message
        """The message without its remedy."""
        super().__init__(f"{message}. {remedy}" if remedy else message)

    def document(self) -> dict[str, Any]:
        """With quantity, place, time and remedy."""
        known = {"quantity": self.quantity, "where": self.where, "time_s": self.time_s}
        return {**super().document(), **known, "remedy": self.remedy or None}


class PumpError(ViscodesignError):
    """The pump or its serial port failed."""

    exit_code = 4
    kind = "pump"
    rule: ClassVar[str] = "replies"
    """The rule under which a stream that it ends is recorded."""


class RunFailedError(ViscodesignError):
    """The solver stopped before the end of the run; partial results are on disk."""

    exit_code = 3
    kind = "solve"


class InterruptedRunError(ViscodesignError):
    """The user interrupted; partial results are kept."""

    exit_code = 130
    kind = "interrupted"


def described(given: Any) -> str:
    """A given value in words, short enough for a message."""
    if given is None:
        return "nothing"
    if isinstance(given, bool):
        return "on (or true)" if given else "off (or false)"
    if isinstance(given, dict):
        return "a mapping"
    if isinstance(given, (list, tuple)):
        return "a list"
    text = repr(given)
    return text if len(text) < 60 else text[:57] + "..."


def did_you_mean(word: Any, known: Iterable[str]) -> str:
    """'; did you mean 'x'?' for the closest known word, or nothing.

    A known word of two letters must agree nearly: "none" has both letters of "on".
    """
    words = list(known)
    close = [name for name in words if name.lower() == str(word).lower() != name]
    close = close or difflib.get_close_matches(str(word), words, n=3, cutoff=0.6)
    close = [name for name in close if len(name) > 2 or _nearly(str(word), name)]
    return f"; did you mean '{close[0]}'?" if close else ""


def _nearly(word: str, name: str) -> bool:
    return difflib.SequenceMatcher(None, name.lower(), word.lower()).ratio() >= 0.75


def not_among(given: Any, known: Iterable[str], otherwise: str = "") -> str:
    """The message for a value that is none of the known words, nor what is allowed otherwise."""
    words = list(known)
    allowed = ", ".join(words) + (f"; or give {otherwise}" if otherwise else "")
    return f"must be one of {allowed}; got {described(given)}{did_you_mean(given, words)}"
