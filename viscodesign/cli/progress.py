"""A progress bar on a terminal, and nothing in a pipe."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

CELLS = 30
REDRAW_S = 0.1
"""A bar redrawn more often than the eye sees costs the solver time."""


@dataclass
class Bar:
    """One line on standard error, redrawn in place."""

    later: str = "verifying"
    """What the passes after the first do."""
    first: str = "solving"
    passes: int = 1
    fraction: float = 0.0
    drawn_at: float = -REDRAW_S

    def advance(self, fraction: float) -> None:
        """Show the fraction done, 0 to 1; a fall back begins the next pass."""
        if fraction < self.fraction:
            self.passes += 1
        self.fraction = fraction
        now = time.monotonic()
        if now - self.drawn_at >= REDRAW_S:
            self.drawn_at = now
            self._draw()

    def _draw(self) -> None:
        done = round(CELLS * min(max(self.fraction, 0.0), 1.0))
        label = self.first if self.passes == 1 else f"{self.later}, pass {self.passes}"
        bar = "#" * done + "." * (CELLS - done)
        sys.stderr.write(f"\r\x1b[K[{bar}] {self.fraction:4.0%}  {label}")
        sys.stderr.flush()

    def clear(self) -> None:
        """Leave an empty line behind."""
        sys.stderr.write("\r\x1b[K")
        sys.stderr.flush()


@contextmanager
def progress(
    quiet: bool, later: str = "verifying", first: str = "solving"
) -> Iterator[Callable[[float], None]]:
    """A function to call with the fraction done; it draws where somebody watches.

    ``first`` names the first pass, ``later`` what follows it.
    """
    if quiet or not sys.stderr.isatty():
        yield lambda fraction: None
        return
    bar = Bar(later, first)
    try:
        yield bar.advance
    finally:
        bar.clear()
