"""A progress bar on a terminal, and nothing in a pipe."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Protocol


class Advance(Protocol):
    """Told the fraction done, 0 to 1, and words to show beside it."""

    def __call__(self, fraction: float, words: str = "", /) -> None: ...


def _silent(fraction: float, words: str = "", /) -> None:
    del fraction, words


REDRAW_S = 0.1
"""Shortest time between two redraws, so that drawing takes no time from the solver [s]."""


@contextmanager
def progress(quiet: bool, later: str = "verifying", first: str = "solving") -> Iterator[Advance]:
    """A function to call with the fraction done, 0 to 1; a fall back begins the next pass.

    It draws on standard error if that is a terminal. ``first`` names the first pass,
    ``later`` those after it.
    """
    if quiet or not sys.stderr.isatty():
        yield _silent
        return
    # Importing rich takes time that a pipe does not have to spend.
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        Progress,
        TaskProgressColumn,
        TextColumn,
        TimeRemainingColumn,
    )

    columns = BarColumn(30), TaskProgressColumn(), TextColumn("{task.description}")
    bar = Progress(
        *columns,
        TimeRemainingColumn(),
        console=Console(file=sys.stderr),
        transient=True,
        auto_refresh=False,
        redirect_stdout=False,
        redirect_stderr=False,
    )
    task, passes, fraction_before, drawn_at = bar.add_task(first, total=1.0), 1, 0.0, -REDRAW_S

    def advance(fraction: float, words: str = "", /) -> None:
        nonlocal passes, fraction_before, drawn_at
        if fraction < fraction_before:
            passes += 1
            bar.reset(task, description=f"{later}, pass {passes}")
        fraction_before = fraction
        now = time.monotonic()
        if now - drawn_at >= REDRAW_S:
            drawn_at = now
            shown: dict[str, Any] = {"description": words} if words else {}
            bar.update(task, completed=fraction, refresh=True, **shown)

    with bar:
        # rich hides the cursor; a second Ctrl-C ends the process before it could show it again.
        bar.console.show_cursor(True)
        yield advance
