"""How a command, or one spec of several, failed: what people and programs are told."""

from __future__ import annotations

from typing import Any

from viscodesign.errors import ViscodesignError
from viscodesign.lazy_dataclass import dataclass

INTERNAL_ERROR = 1
INTERRUPTED = 130


@dataclass(frozen=True)
class Failure:
    """An exit code, a message, and the document of `--json`."""

    status: int
    message: str
    """Empty where it has been printed already."""
    document: dict[str, Any]
    error: BaseException | None = None


def failure_of(error: BaseException, debug: bool) -> Failure:
    """The failure that an error is; one that nobody foresaw is named as such."""
    if isinstance(error, KeyboardInterrupt):
        return plain_failure("interrupted", INTERRUPTED, "interrupted", error)
    if isinstance(error, ViscodesignError):
        return Failure(error.exit_code, str(error), error.document(), error)
    return plain_failure("internal", INTERNAL_ERROR, _internal(error, debug), error)


def plain_failure(
    kind: str, status: int, message: str, error: BaseException | None = None, *, told: bool = False
) -> Failure:
    """A failure of which no more is known; ``told``: its message has been printed."""
    document = {"type": kind, "exit_code": status, "message": message}
    return Failure(status, "" if told else message, document, error)


def _internal(error: BaseException, debug: bool) -> str:
    first = str(error).partition("\n")[0]
    text = f"internal error: {type(error).__name__}: {first}".removesuffix(": ")
    return text if debug else f"{text} (run again with --debug for the traceback)"
