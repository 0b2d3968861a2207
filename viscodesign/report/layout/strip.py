"""Frames of different sizes, at one scale, arranged in rows."""

from __future__ import annotations

from collections.abc import Sequence

from viscodesign.lazy_dataclass import dataclass

LABEL_WIDTH, LABEL_HEIGHT = 0.86, 0.24
"""Space for the label above a frame [inch]."""
STRIP_GAP, ROW_GAP = 0.12, 0.22
"""Smallest distance between frames, and between rows [inch]."""
LARGEST_LENGTH = 1.9
"""Largest length of the actuator as drawn [inch]."""
LARGEST_STRIP_HEIGHT = 6.5
"""Largest height of the strip [inch]."""
MAX_STRIP_ROWS = 3


@dataclass(frozen=True)
class Frame:
    """Extent of a drawing about its clamp [mm], z pointing down."""

    left: float
    top: float
    right: float
    bottom: float


@dataclass(frozen=True)
class Strip:
    """Where the frames go; places in mm from the upper left corner, z pointing down."""

    scale: float
    """Inches per millimetre."""
    height: float
    """Height of the strip [inch]."""
    origins: list[tuple[float, float]]
    """Position of the clamp in each frame."""
    label_levels: list[float]
    """Vertical centre of the label of each frame."""


def arrange(frames: Sequence[Frame], length: float, width: float) -> Strip:
    """Arrange frames in the number of rows that draws them largest.

    ``length`` of the actuator [mm], ``width`` of the strip [inch].
    """
    choices = [_rows(frames, count) for count in range(1, min(MAX_STRIP_ROWS, len(frames)) + 1)]
    scales = [_scale(rows, LARGEST_LENGTH / length, width) for rows in choices]
    # More rows have to be worth their space on the page.
    best = max(range(len(choices)), key=lambda k: (scales[k] * 0.93**k, -k))
    return _placed(choices[best], scales[best], width)


def _rows(frames: Sequence[Frame], count: int) -> list[list[Frame]]:
    each = -(-len(frames) // count)
    return [list(frames[k : k + each]) for k in range(0, len(frames), each)]


def _scale(rows: list[list[Frame]], largest: float, width: float) -> float:
    """The largest scale [inch/mm] at which the rows fit into width and height."""
    if _fits(rows, largest, width):
        return largest
    low, high = 0.0, largest
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if _fits(rows, middle, width) else (low, middle)
    return low


def _fits(rows: list[list[Frame]], scale: float, width: float) -> bool:
    across = max(_row_width(row, scale) for row in rows)
    return across <= width and sum(_row_height(row, scale) for row in rows) <= LARGEST_STRIP_HEIGHT


def _row_width(row: list[Frame], scale: float) -> float:
    return sum(sum(_sides(frame, scale)) for frame in row) + STRIP_GAP * (len(row) - 1)


def _sides(frame: Frame, scale: float) -> tuple[float, float]:
    """Space to the left and right of the middle of the clamp [inch], with the label."""
    return max(-frame.left * scale, LABEL_WIDTH / 2), max(frame.right * scale, LABEL_WIDTH / 2)


def _row_height(row: list[Frame], scale: float) -> float:
    extent = max(f.bottom for f in row) - min(f.top for f in row)
    return LABEL_HEIGHT + extent * scale + ROW_GAP


def _placed(rows: list[list[Frame]], scale: float, width: float) -> Strip:
    gap = _gap(rows, scale, width)
    origins: list[tuple[float, float]] = []
    levels: list[float] = []
    down = 0.0
    for row in rows:
        clamp = down + LABEL_HEIGHT - min(f.top for f in row) * scale
        along = 0.0
        for frame in row:
            left, right = _sides(frame, scale)
            origins.append(((along + left) / scale, clamp / scale))
            levels.append((down + LABEL_HEIGHT / 2) / scale)
            along += left + right + gap
        down += _row_height(row, scale)
    return Strip(scale, down, origins, levels)


def _gap(rows: list[list[Frame]], scale: float, width: float) -> float:
    """Distance between frames: the free width of the fullest row, shared out, up to a limit."""
    spare = [
        STRIP_GAP + (width - _row_width(row, scale)) / (len(row) - 1)
        for row in rows
        if len(row) > 1
    ]
    return min([*spare, 0.5])
