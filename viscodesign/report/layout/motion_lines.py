"""Lines of several motions that can be told apart, also in grey."""

from __future__ import annotations

from collections.abc import Sequence

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.layout.look import look

LINE_STYLES = ("-", "--", ":", "-.")
"""Dashes that tell lines of one colour apart, as matplotlib names them."""
DASHES: tuple[Sequence[float], ...] = ((), (5, 2), (1.2, 1.2), (6, 1.6, 1.2, 1.6))


@dataclass(frozen=True)
class LineStyle:
    """Colour and dashes of a line."""

    colour: str
    dashes: Sequence[float]
    """Lengths of strokes and gaps in turn, in widths of the line; none for a full line."""


def line_style(k: int) -> LineStyle:
    """The style of the k-th motion; after all colours the dashes change."""
    colours = look().motions
    return LineStyle(colours[k % len(colours)], DASHES[(k // len(colours)) % len(DASHES)])
