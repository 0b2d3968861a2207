"""Labels placed beside points so that they hide neither each other nor the points."""

from __future__ import annotations

from collections.abc import Sequence

from viscodesign.lazy_dataclass import dataclass

CHARACTER_WIDTH, LINE_HEIGHT = 0.6, 1.3
"""Typical width of a character and height of a line, per font size."""
POINTS_PER_INCH = 72.0
HALF_MARK = 5.0
"""Half the space of a mark [pt]."""
HALF_LINE = 0.004
"""Half the space of a line across the plane, of the plane's side."""
DISTANCES = (6.0, 16.0, 30.0, 48.0, 70.0)
"""From a point to its label [pt]; from the second on, a line connects them."""
DISTANCE_COST = 1e-6
"""Cost of the next distance, as an area: less than that of hiding anything."""
FAINT_COST = 1e-4
"""Factor on the cost of hiding a thin line, which is better than a larger distance."""
DIRECTIONS = (
    (1, 0), (-1, 0), (0, 1), (0, -1), (0.8, 0.6), (0.8, -0.6), (-0.8, 0.6), (-0.8, -0.6),
)  # fmt: skip


@dataclass(frozen=True)
class Box:
    """A rectangle, in fractions of the side of the plane."""

    left: float
    bottom: float
    right: float
    top: float
    faint: bool = False
    """A thin line rather than words or a mark."""

    def overlap(self, other: Box) -> float:
        """Area in common."""
        across = min(self.right, other.right) - max(self.left, other.left)
        up = min(self.top, other.top) - max(self.bottom, other.bottom)
        return max(across, 0.0) * max(up, 0.0)

    def outside(self) -> float:
        """Approximate area outside the plane."""
        beyond = (-self.left, -self.bottom, self.right - 1, self.top - 1)
        return sum(max(part, 0.0) for part in beyond)


@dataclass(frozen=True)
class Label:
    """Words and where they stand."""

    text: str
    point: tuple[float, float]
    x: float
    y: float
    across: str
    upright: str
    step: int
    """Index of the distance; above 0, a line connects it to the point."""


def text_box(
    text: str, place: tuple[float, float], across: str, upright: str, size: float, side: float
) -> Box:
    """Approximate space of a text of ``size`` [pt] on a plane of ``side`` [inch]."""
    lines = text.split("\n")
    width = max(len(line) for line in lines) * CHARACTER_WIDTH * size / POINTS_PER_INCH / side
    height = len(lines) * LINE_HEIGHT * size / POINTS_PER_INCH / side
    left = place[0] - {"left": 0.0, "center": 0.5, "right": 1.0}[across] * width
    bottom = place[1] - {"bottom": 0.0, "center": 0.5, "top": 1.0}[upright] * height
    return Box(left, bottom, left + width, bottom + height)


def place_labels(
    points: Sequence[tuple[float, float]],
    texts: Sequence[str],
    taken: Sequence[Box],
    *,
    size: float,
    side: float,
) -> list[Label]:
    """One label per point (in fractions of ``side`` [inch]), where it hides least."""
    mark = HALF_MARK / POINTS_PER_INCH / side
    boxes = [*taken, *(Box(x - mark, y - mark, x + mark, y + mark) for x, y in points)]
    labels = []
    for point, text in zip(points, texts, strict=True):
        choices = _choices(point, text, size, side)
        costs = [
            box.outside() + sum(_cost(box, other) for other in boxes) + DISTANCE_COST * label.step
            for label, box in choices
        ]
        best = min(range(len(choices)), key=lambda k: (round(costs[k], 9), k))
        label, box = choices[best]
        labels.append(label)
        boxes.append(box)
    return labels


def _cost(box: Box, other: Box) -> float:
    return box.overlap(other) * (FAINT_COST if other.faint else 1.0)


def _choices(
    point: tuple[float, float], text: str, size: float, side: float
) -> list[tuple[Label, Box]]:
    """Nearest first."""
    found = []
    for step, distance in enumerate(DISTANCES):
        for u, v in DIRECTIONS:
            x = point[0] + u * distance / POINTS_PER_INCH / side
            y = point[1] + v * distance / POINTS_PER_INCH / side
            across = "center" if u == 0 else "left" if u > 0 else "right"
            upright = "center" if abs(v) < 1 else "bottom" if v > 0 else "top"
            label = Label(text, point, x, y, across, upright, step)
            found.append((label, text_box(text, (x, y), across, upright, size, side)))
    return found
