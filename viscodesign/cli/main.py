"""The entry point, where every error becomes one message and one exit code.

It imports little: an interrupt before it is asked for anything would show a traceback.
"""

from __future__ import annotations

import contextlib
import errno
import gc
import os
import sys
import time as clock
from collections.abc import Sequence
from typing import Any

from viscodesign.cli.failures import (
    INTERNAL_ERROR,
    INTERRUPTED,
    Failure,
    failure_of,
    plain_failure,
)
from viscodesign.cli.output import (
    ReaderGoneError,
    abandon_stdout,
    asks_for,
    begin_speaking,
    complain,
    has_spoken,
    json_text,
    say,
)
from viscodesign.errors import OutputError, ViscodesignError
from viscodesign.interrupt import ended_like_interrupts

OUTPUT_ERRORS = (errno.ENOSPC, errno.EIO, errno.EBADF)
COLLECTED_AFTER = 500_000
"""Objects after which Python looks for cycles: what imports and a spec make stays anyway, and
looking through it again and again takes a tenth of a short command."""
ENVIRONMENT = {"OPENBLAS_NUM_THREADS": "1", "PYDANTIC_DISABLE_PLUGINS": "__all__"}
"""Settings of numpy and pydantic, unless the user has some. Matrices are small here, and threads
for them cost a tenth of a second; pydantic need not search all that is installed for plugins."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command line (by default the process's own) and return its exit code."""
    if arguments is not None:
        return _answer(list(arguments))
    gc.set_threshold(COLLECTED_AFTER)
    for variable, setting in ENVIRONMENT.items():
        os.environ.setdefault(variable, setting)  # before either is imported
    with ended_like_interrupts():
        status = _answer(sys.argv[1:])
    gc.freeze()  # or Python would look for cycles among everything once more before it ends
    return status


def _answer(words: list[str]) -> int:
    _replace_closed_streams()
    begin_speaking()
    failure = _failure_of(words)
    if failure is None:
        return 0
    if failure.error is not None and asks_for("--debug", words):
        import traceback

        traceback.print_exception(failure.error)
    if failure.message:
        complain(failure.message)
    if asks_for("--json", words) and not has_spoken():
        # Where standard output is what failed, the exit code has to do.
        with contextlib.suppress(ReaderGoneError, ViscodesignError):
            say(json_text({"error": failure.document}))
    return failure.status


def _failure_of(words: list[str]) -> Failure | None:
    """Run a command; how it failed, or None."""
    try:
        status = _run(words)
    except ReaderGoneError:
        # `viscodesign check leg.yaml | head -1`: the reader has all it needs.
        abandon_stdout()
        return None
    except (KeyboardInterrupt, Exception) as error:
        found = _usage_failure(error) or _output_failure(error)
        return found or failure_of(error, asks_for("--debug", words))
    if status == INTERRUPTED:
        return plain_failure("interrupted", status, "interrupted")
    return plain_failure("other", status, "failed", told=True) if status else None


def _usage_failure(error: Any) -> Failure | None:
    """A command line that typer cannot parse; its base of such errors has no public name."""
    typer = sys.modules.get("typer")
    if typer is None or not isinstance(error, typer.BadParameter.__mro__[2]):
        return None
    error.show()
    return plain_failure("usage", error.exit_code, error.format_message(), told=True)


def _output_failure(error: BaseException) -> Failure | None:
    """What typer's own texts meet, such as `--help`, on a full disk or a closed terminal."""
    if not isinstance(error, OSError) or error.filename is not None:
        return None
    if error.errno not in OUTPUT_ERRORS:
        return None
    abandon_stdout()
    told = OutputError(f"standard output: {error.strerror}")
    return Failure(told.exit_code, str(told), told.document(), error)


def _replace_closed_streams() -> None:
    """Let what is printed go nowhere where the caller has closed an output (`>&-`, `2>&-`)."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, "w"))  # noqa: SIM115  # until the process ends


def _run(words: list[str]) -> int:
    """Let typer find and call the command; returns its exit code.

    A command finds in its context when it was called.
    """
    began = clock.perf_counter()
    from typer.main import get_command

    from viscodesign.cli.app import app_for

    try:
        command = get_command(app_for(words))
        found = command(args=words, prog_name="viscodesign", obj=began, standalone_mode=False)
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else INTERNAL_ERROR
    return found if isinstance(found, int) else 0
