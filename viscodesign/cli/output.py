"""Words to the terminal, a pipe or a file."""

from __future__ import annotations

import contextlib
import json
import math
import os
import sys
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from viscodesign.errors import UsageError, ViscodesignError


class ReaderGoneError(Exception):
    """Whoever read our standard output has closed it."""


def say(text: str = "") -> None:
    """Print one line (or several) on standard output.

    Delivered at once, so that a closed pipe or a full disk is noticed here.
    """
    try:
        print(_printable(text, sys.stdout.encoding), flush=True)
    except BrokenPipeError as error:
        raise ReaderGoneError from error
    except OSError as error:
        # The exit would try again to write what is left, and fail in its own words.
        abandon_stdout()
        raise ViscodesignError(f"standard output: {error.strerror or error}") from error


def complain(text: str) -> None:
    """Print one message on standard error, whatever the state of standard output."""
    with contextlib.suppress(OSError):
        print(_printable(text, sys.stderr.encoding), file=sys.stderr, flush=True)


def abandon_stdout() -> None:
    """Point standard output at nothing, so that the exit's own flush stays silent."""
    with contextlib.suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _printable(text: str, encoding: str | None) -> str:
    """The text without terminal control codes (a spec's name may hold anything)."""
    safe = "".join(c if c.isprintable() or c in "\n\t" else repr(c)[1:-1] for c in text)
    name = encoding or "utf-8"
    return safe.encode(name, errors="backslashreplace").decode(name)


def json_text(document: Mapping[str, Any]) -> str:
    """A document as JSON text; what is not finite becomes null."""
    return json.dumps(_finite(document), indent=2, allow_nan=False)


def _finite(value: Any) -> Any:
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    if isinstance(value, Mapping):
        return {str(key): _finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(item) for item in value]
    return value


def write_text(path: Path, text: str, *, overwrite: bool) -> Path:
    """Write a file, complete or not at all; without ``overwrite`` never onto another."""
    if path.is_dir():
        raise UsageError(f"{path} is a folder; name a file")
    if path.exists() and not overwrite:
        raise UsageError(f"{path} exists and is not overwritten; choose another path, or --force")
    # Only the commands that write need it, and `--help` is to answer at once.
    from viscodesign.storage.atomic_files import write_bytes

    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise UsageError(f"cannot write {path}: {error.strerror or error}") from error
    write_bytes(path, text.encode())
    return path
