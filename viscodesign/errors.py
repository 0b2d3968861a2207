"""What can go wrong, each with its exit code; a message says where, what and what to do."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass


class ViscodesignError(Exception):
    """Base of every error that a user is told of."""

    exit_code = 1


@dataclass(frozen=True)
class Fault:
    """One thing wrong with a spec."""

    message: str
    key: str = ""
    file: str = ""
    line: int | None = None

    def __str__(self) -> str:
        place = self.file
        if self.file and self.line is not None:
            place = f"{self.file}:{self.line}"
        return ": ".join(_abridged(part) for part in (place, self.key, self.message) if part)


LONGEST = 600
"""Characters of a place, a key or a message: whatever a spec holds, a message can be read."""


def _abridged(text: str) -> str:
    """A text without its middle, where that makes it too long to read."""
    if len(text) <= LONGEST:
        return text
    return f"{text[: LONGEST // 2]} [...] {text[-LONGEST // 4 :]}"


MOST_TOLD = 60
"""Faults that a message lists; what has more is no slip but another file."""


class SpecError(ViscodesignError):
    """A spec that cannot be run; holds every fault that was found."""

    exit_code = 2

    def __init__(self, faults: Sequence[Fault]) -> None:
        self.faults = list(faults)
        told = [str(fault) for fault in self.faults[:MOST_TOLD]]
        if len(self.faults) > MOST_TOLD:
            told.append(f"and {len(self.faults) - MOST_TOLD} faults more")
        super().__init__("\n".join(told))

    @classmethod
    def plain(cls, message: str) -> SpecError:
        """A fault of the scene as a whole, found after its file was read."""
        return cls([Fault(message)])


class UsageError(ViscodesignError):
    """A command asked for something that cannot be done, such as writing into a file."""

    exit_code = 2


class SolveError(ViscodesignError):
    """The solver cannot go on: which quantity, where, when, and what to change."""

    exit_code = 3

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


class PumpError(ViscodesignError):
    """The pump or its port."""

    exit_code = 4


class InterruptedRunError(ViscodesignError):
    """The user stopped the work; what was computed is kept."""

    exit_code = 130
