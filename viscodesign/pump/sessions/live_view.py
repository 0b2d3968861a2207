"""Wanted and measured pressure while a pump moves: redrawn in place, or a line now and then."""

from __future__ import annotations

import shutil
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from viscodesign.pump.play.stream import TickReport
from viscodesign.pump.sessions.outlet import Outlet

REDRAW = 0.1
"""Between two pictures on a terminal [s]."""
REPORT = 5.0
"""Between two lines in a pipe [s]."""
NARROWEST = 60
CELLS = (10, 40)
"""Fewest and most cells of a bar."""


@dataclass
class LiveView:
    """On a terminal a picture, two bars for each inlet; in a pipe a line every few seconds."""

    inlets: Sequence[str]
    span: tuple[float, float]
    """Gauge [Pa] at both ends of the bars: the deepest suction, or 0, and the cap."""
    duration: float
    """Of the profile [s]."""
    simulated: bool
    outlet: Outlet
    clock: Callable[[], float] = time.monotonic
    drawn_at: float = -REPORT
    height: int = 0
    """Lines of the picture on the terminal."""

    def show(self, shown: TickReport) -> None:
        """Draw one tick, where it is time to."""
        terminal = self.outlet.terminal
        now = self.clock()
        due = now - self.drawn_at >= (REDRAW if terminal else REPORT)
        if not (due or shown.stop):
            return
        self.drawn_at = now
        if terminal:
            self._redraw(self.picture(shown))
        else:
            self.outlet.write("; ".join(self.report(shown)) + "\n")

    def picture(self, shown: TickReport) -> list[str]:
        """State and, for each inlet, two bars."""
        lines = [" ".join([self._label(), self._state(shown), self._ticks(shown)]).strip()]
        width = max(shutil.get_terminal_size((80, 24)).columns, NARROWEST)
        cells = min(max(width - 38, CELLS[0]), CELLS[1])
        for k, inlet in enumerate(self.inlets):
            name = f"{inlet[:8]:<8} " if len(self.inlets) > 1 else ""
            for word, value in (
                ("wanted", shown.sample.wanted[k]),
                ("measured", shown.sample.pressure[k]),
            ):
                lines.append(f"{name}{word:<8} {_kpa(value)} {self._bar(value, cells)}")
        return [line[: width - 1] for line in lines]

    def report(self, shown: TickReport) -> list[str]:
        """The same in words."""
        parts = [" ".join([self._label(), self._state(shown)]).strip()]
        for k, inlet in enumerate(self.inlets):
            name = f"{inlet} " if len(self.inlets) > 1 else ""
            wanted, measured = shown.sample.wanted[k], shown.sample.pressure[k]
            parts.append(f"{name}wanted {_kpa(wanted).strip()}, measured {_kpa(measured).strip()}")
        return [*parts, *([self._ticks(shown)] if shown.skipped else [])]

    def _label(self) -> str:
        return "[simulated]" if self.simulated else ""

    def _state(self, shown: TickReport) -> str:
        if shown.stop is not None:
            return f"STOP at {shown.time:.1f} s: {shown.stop.rule.replace('_', ' ')}"
        if shown.time < 0.0:
            return f"going to the start, {-shown.time:.1f} s left"
        if shown.time > self.duration:
            return "drawing back"
        return f"{shown.time:.1f} of {self.duration:.1f} s"

    def _ticks(self, shown: TickReport) -> str:
        return f"({shown.skipped} ticks skipped)" if shown.skipped else ""

    def _bar(self, value: float | None, cells: int) -> str:
        """From the place of 0, marked, to both sides."""
        low, high = self.span
        zero = _cell(0.0, low, high, cells)
        place = zero if value is None else _cell(value, low, high, cells)
        first, last = sorted((zero, place))
        bar = "." * first + "#" * (last - first) + "." * (cells - last)
        return f"[{bar[:zero]}|{bar[zero:]}]"

    def _redraw(self, lines: Sequence[str]) -> None:
        up = f"\x1b[{self.height}A" if self.height else ""
        self.height = len(lines)
        self.outlet.write(up + "".join(f"\r\x1b[K{line}\n" for line in lines))


def _cell(value: float, low: float, high: float, cells: int) -> int:
    """Where a pressure lies on a bar."""
    return round(min(max((value - low) / (high - low), 0.0), 1.0) * cells)


def _kpa(value: float | None) -> str:
    return "     -     " if value is None else f"{value / 1e3:7.2f} kPa"
