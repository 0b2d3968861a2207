"""The entry point, where every error becomes one message and one exit code."""

from __future__ import annotations

import errno
import gc
import os
import sys
import time as clock
import traceback
from collections.abc import Sequence

from viscodesign.cli.output import ReaderGoneError, abandon_stdout, complain
from viscodesign.errors import ViscodesignError
from viscodesign.interrupt import ended_like_interrupts

INTERNAL_ERROR = 1
INTERRUPTED = 130
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
    debug = _asks_for_debug(words)
    _replace_closed_streams()
    try:
        status = _run(words)
    except ReaderGoneError:
        # `viscodesign check leg.yaml | head -1`: the reader has all it needs.
        abandon_stdout()
        return 0
    except KeyboardInterrupt:
        return _report("interrupted", INTERRUPTED, debug)
    except ViscodesignError as error:
        return _report(str(error), error.exit_code, debug)
    except OSError as error:
        if error.filename is None and error.errno in OUTPUT_ERRORS:
            # typer's own texts, such as `--help`, onto a full disk or a terminal that was closed
            abandon_stdout()
            return _report(f"standard output: {error.strerror}", INTERNAL_ERROR, debug)
        return _report(_internal(error, debug), INTERNAL_ERROR, debug)
    except Exception as error:
        return _report(_internal(error, debug), INTERNAL_ERROR, debug)
    if status == INTERRUPTED:
        complain("interrupted")
    return status


def _replace_closed_streams() -> None:
    """Let what is printed go nowhere where the caller has closed an output (`>&-`, `2>&-`)."""
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:
            setattr(sys, name, open(os.devnull, "w"))  # noqa: SIM115  # until the process ends


def _run(words: list[str]) -> int:
    """Let typer find and call the command; it prints usage errors itself.

    A command finds in its context when it was called.
    """
    began = clock.perf_counter()
    from typer.main import get_command

    from viscodesign.cli.app import app_for

    try:
        get_command(app_for(words))(args=words, prog_name="viscodesign", obj=began)
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else INTERNAL_ERROR
    return 0


def _asks_for_debug(words: list[str]) -> bool:
    """Whether `--debug` is among the options.

    Read from the command line itself, so that it holds for errors in parsing, too.
    """
    options = words[: words.index("--")] if "--" in words else words
    return "--debug" in options


def _report(message: str, status: int, debug: bool) -> int:
    if debug:
        traceback.print_exc()
    complain(message)
    return status


def _internal(error: Exception, debug: bool) -> str:
    first = str(error).partition("\n")[0]
    text = f"internal error: {type(error).__name__}: {first}".removesuffix(": ")
    return text if debug else f"{text} (run again with --debug for the traceback)"
