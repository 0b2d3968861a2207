"""Text to the terminal, a pipe or a file."""

from __future__ import annotations

import contextlib
import contextvars
import json
import os
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from viscodesign.errors import OutputError, UsageError


class ReaderGoneError(Exception):
    """The reader of standard output has closed it."""


_HAS_SPOKEN = contextvars.ContextVar("has_spoken", default=False)
"""Whether this command has printed its document."""


def asks_for(option: str, words: Sequence[str]) -> bool:
    """Whether an option such as `--debug` is on the command line.

    Read from the command line itself, so that it holds for errors in parsing, too.
    """
    options = words[: words.index("--")] if "--" in words else words
    return option in options


def begin_speaking() -> None:
    """Begin the output of a command."""
    _HAS_SPOKEN.set(False)


def has_spoken() -> bool:
    """Whether this command has printed anything on standard output."""
    return _HAS_SPOKEN.get()


def say(text: str = "") -> None:
    """Print one line (or several) on standard output.

    Delivered at once, so that a closed pipe or a full disk is noticed here.
    """
    _HAS_SPOKEN.set(True)
    try:
        print(_printable(text, sys.stdout.encoding), flush=True)
    except BrokenPipeError as error:
        raise ReaderGoneError from error
    except OSError as error:
        # The interpreter would flush again at exit, and print its own error.
        abandon_stdout()
        raise OutputError(f"standard output: {error.strerror or error}") from error


def complain(text: str) -> None:
    """Print one message on standard error, whatever the state of standard output."""
    with contextlib.suppress(OSError):
        print(_printable(text, sys.stderr.encoding), file=sys.stderr, flush=True)


def abandon_stdout() -> None:
    """Redirect standard output to nothing, so that the flush at exit stays silent."""
    with contextlib.suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _printable(text: str, encoding: str | None) -> str:
    """The text without terminal control codes, which a spec's name may contain."""
    safe = "".join(c if c.isprintable() or c in "\n\t" else repr(c)[1:-1] for c in text)
    name = encoding or "utf-8"
    return safe.encode(name, errors="backslashreplace").decode(name)


def json_text(document: Mapping[str, Any]) -> str:
    """A document as JSON text; numbers that are not finite become null."""
    from viscodesign.results.findings import json_ready

    return json.dumps(json_ready(dict(document)), indent=2, allow_nan=False)


def write_text(path: Path, text: str, *, overwrite: bool) -> Path:
    """Write a file completely or not at all; never over another without ``overwrite``."""
    if path.is_dir():
        raise UsageError(f"{path} is a folder; name a file")
    if path.exists() and not overwrite:
        raise UsageError(f"{path} exists; choose another path, or use --force to overwrite it")
    # Only the commands that write need it, and `--help` is to answer at once.
    from viscodesign.storage.atomic_files import write_bytes

    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise UsageError(f"cannot write {path}: {error.strerror or error}") from error
    write_bytes(path, text.encode())
    return path
