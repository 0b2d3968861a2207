"""Wanted and measured pressure while a pump moves: redrawn in place, or a line now and then."""

from __future__ import annotations

import contextlib
import os
import select
import shutil
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, TextIO

from viscodesign.lazy_dataclass import dataclass

if TYPE_CHECKING:
    from viscodesign.pump.planning.result import PumpPlan
    from viscodesign.pump.play.stream_result import TickReport
    from viscodesign.scene.pumps.base import PumpSpec

REDRAW_INTERVAL_S = 0.1
"""On a terminal."""
REPORT_INTERVAL_S = 5.0
"""Between two lines in a pipe."""
NARROWEST = 60
BAR_CELLS = (10, 40)
"""Fewest and most cells of a bar."""


@contextlib.contextmanager
def live_view(
    plan: PumpPlan, pump: PumpSpec, label: str, quiet: bool
) -> Iterator[tuple[Callable[[TickReport], None] | None, Callable[[str], None]]]:
    """What draws the ticks of a stream on standard error, and what puts a line below them.

    Neither shows anything where that is not wanted, and neither waits for a terminal.
    """
    if quiet:
        yield None, lambda line: None
        return
    course = plan.achievable
    duration = float(course.time[-1]) - course.lead_s
    span = (min(float(course.pressure.min()), 0.0), pump.max_pressure)
    with contextlib.closing(NonblockingText(sys.stderr)) as text:
        show = LiveView(plan.inlets, span, duration, label.strip(), text).show
        yield show, lambda line: text.write(f"{line}\n")


class NonblockingText:
    """Takes text, or drops it where its reader takes none now.

    A terminal that was stopped (Ctrl-S), or a link that sleeps, would otherwise stop a pump;
    that is why no library draws here.
    """

    def __init__(self, stream: TextIO) -> None:
        self.terminal = stream.isatty()
        self._stream = stream
        self._own = _reopened(stream) if self.terminal else None

    def write(self, text: str) -> None:
        """Write as much as standard error takes; a reader that has gone is not an error either."""
        with contextlib.suppress(OSError):
            if self._own is not None:
                os.write(self._own, text.encode())
            elif self._has_room():
                self._stream.write(text)
                self._stream.flush()

    def close(self) -> None:
        """Close what was opened here."""
        if self._own is not None:
            os.close(self._own)
            self._own = None

    def _has_room(self) -> bool:
        """Whether a pipe takes a line (POSIX: 512 bytes); anything else always does."""
        try:
            return bool(select.select([], [self._stream], [], 0.0)[1])
        except (OSError, ValueError):
            return True


def _reopened(stream: TextIO) -> int | None:
    """The same terminal, nonblocking; the descriptor that others share stays as it is."""
    try:
        name = os.ttyname(stream.fileno())
        return os.open(name, os.O_WRONLY | os.O_NONBLOCK | os.O_NOCTTY)
    except (OSError, AttributeError):
        return None


@dataclass
class LiveView:
    """On a terminal a picture, two bars per inlet; in a pipe a line every few seconds."""

    inlets: Sequence[str]
    span: tuple[float, float]
    """Gauge [Pa] at both ends of the bars: the deepest suction, or 0, and the cap."""
    duration: float
    """Duration of the profile [s]."""
    label: str
    """`[simulated]`, or nothing."""
    text: NonblockingText
    clock: Callable[[], float] = time.monotonic
    drawn_at: float = -REPORT_INTERVAL_S
    height: int = 0
    """Lines of the picture on the terminal."""

    def show(self, shown: TickReport) -> None:
        """Draw one tick, where it is time to."""
        terminal, now = self.text.terminal, self.clock()
        due = now - self.drawn_at >= (REDRAW_INTERVAL_S if terminal else REPORT_INTERVAL_S)
        if not (due or shown.stop):
            return
        self.drawn_at = now
        if terminal:
            self._redraw(self.picture(shown))
        else:
            self.text.write("; ".join(self.report(shown)) + "\n")

    def picture(self, shown: TickReport) -> list[str]:
        """The state and, for each inlet, two bars."""
        lines = [" ".join([self.label, self._state(shown), _skipped(shown)]).strip()]
        width = max(shutil.get_terminal_size((80, 24)).columns, NARROWEST)
        cells = min(max(width - 38, BAR_CELLS[0]), BAR_CELLS[1])
        for name, wanted, measured in self._pressures(shown):
            start = f"{name[:8]:<8} " if name else ""
            for word, value in (("wanted", wanted), ("measured", measured)):
                lines.append(f"{start}{word:<8} {_kpa(value)} {self._bar(value, cells)}")
        return [line[: width - 1] for line in lines]

    def report(self, shown: TickReport) -> list[str]:
        """The same in words."""
        parts = [" ".join([self.label, self._state(shown)]).strip()]
        for name, wanted, measured in self._pressures(shown):
            start = f"{name} " if name else ""
            parts.append(f"{start}wanted {_kpa(wanted).strip()}, measured {_kpa(measured).strip()}")
        return [*parts, *([_skipped(shown)] if shown.skipped else [])]

    def _pressures(self, shown: TickReport) -> Iterator[tuple[str, float | None, float | None]]:
        """Inlet (named where there are several), wanted and measured [Pa gauge]."""
        names = self.inlets if len(self.inlets) > 1 else [""]
        return zip(names, shown.sample.wanted, shown.sample.pressure, strict=True)

    def _state(self, shown: TickReport) -> str:
        if shown.stop is not None:
            return f"STOP at {shown.time:.1f} s: {shown.stop.rule.replace('_', ' ')}"
        if shown.time < 0.0:
            return f"moving to the start, {-shown.time:.1f} s left"
        if shown.time > self.duration:
            return "retracting"
        return f"{shown.time:.1f} of {self.duration:.1f} s"

    def _bar(self, value: float | None, cells: int) -> str:
        """From the place of 0, which is marked, to either side."""
        low, high = self.span
        zero = _cell(0.0, low, high, cells)
        place = zero if value is None else _cell(value, low, high, cells)
        first, last = sorted((zero, place))
        bar = "." * first + "#" * (last - first) + "." * (cells - last)
        return f"[{bar[:zero]}|{bar[zero:]}]"

    def _redraw(self, lines: Sequence[str]) -> None:
        up = f"\x1b[{self.height}A" if self.height else ""
        self.height = len(lines)
        self.text.write(up + "".join(f"\r\x1b[K{line}\n" for line in lines))


def _skipped(shown: TickReport) -> str:
    return f"({shown.skipped} ticks skipped)" if shown.skipped else ""


def _cell(value: float, low: float, high: float, cells: int) -> int:
    """Where a pressure lies on a bar."""
    return round(min(max((value - low) / (high - low), 0.0), 1.0) * cells)


def _kpa(value: float | None) -> str:
    return "     -     " if value is None else f"{value / 1e3:7.2f} kPa"
