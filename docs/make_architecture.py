"""Draw the rooms of the package and the imports between them: python docs/make_architecture.py

Writes `docs/architecture.svg` and fills the table of rooms in `docs/architecture.md`. Rooms and
layers come from `tests/architecture.py`, arrows from the code.
"""

from __future__ import annotations

import itertools
import random
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

DOCS = Path(__file__).parent
sys.path[:0] = [str(DOCS.parent), str(DOCS)]

from make_pages import fill, table  # noqa: E402

from tests.architecture import LAYERS, PACKAGE, Arrow, arrows, modules, room_of  # noqa: E402
from viscodesign.report.layout.look import PLAIN  # noqa: E402
from viscodesign.report.layout.style import picture  # noqa: E402

if TYPE_CHECKING:
    from matplotlib.axes import Axes

BASE = LAYERS[-1]
"""Modules that every room may use; arrows to them are not drawn."""
UNDRAWN = {*BASE, "__main__"}
BOX_W, BOX_H, ROW_H = 1.12, 0.4, 0.72
"""Size of a box, and height of a row [inch]."""
SLOTS_PUMP, SLOTS_CORE, SLOT_W = 3.0, 4.0, 1.26
"""Places side by side in the two wings, and their distance [inch]."""
ABOVE_CORE = 2
"""Rows free between the commands and the core, so that arrows from the pump lead down to it."""
GAP, MARGIN = 0.45, 0.12
RESTARTS, SWEEPS = 30, 8
"""Effort of the search for a placement with few crossings."""

Point = tuple[float, float]
Placement = dict[str, Point]


def main() -> None:
    """Draw the picture and fill the page."""
    plan = Plan.of_the_package()
    draw(plan, DOCS / "architecture.svg")
    fill(DOCS / "architecture.md", {"rooms": rooms_table(plan), "counts": counts(plan)})


@dataclass(frozen=True)
class Plan:
    """Rooms, and the imports between them."""

    rooms: frozenset[str]
    imports: Counter[Arrow]

    @classmethod
    def of_the_package(cls) -> Plan:
        """As the code is now."""
        return cls(frozenset(room for m in modules() if (room := room_of(m))), arrows())

    @cached_property
    def drawn(self) -> list[Arrow]:
        """Arrows between rooms above the base that no longer path implies."""
        inner = {arrow for arrow in self.imports if not {*arrow} & UNDRAWN}
        return sorted(arrow for arrow in inner if not _implied(arrow, inner))

    @cached_property
    def rows(self) -> list[tuple[float, list[str]]]:
        """Rooms that stand side by side, and their distance from the top [rows]."""
        layers = [
            [room for room in layer if room in self.rooms and room not in UNDRAWN]
            for layer in LAYERS[:-1]
        ]
        pump, core = (
            [row for layer in layers if (row := [r for r in layer if is_pump(r) is wanted])]
            for wanted in (True, False)
        )
        spread = (len(core) - ABOVE_CORE) / (len(pump) + 1)
        return [
            *((k + ABOVE_CORE if k else 0, row) for k, row in enumerate(core)),
            *((1 + spread * k, row) for k, row in enumerate(pump)),
        ]

    @property
    def depth(self) -> float:
        """Rows down to the bottom layer."""
        return max(y for y, _ in self.rows) + 1


def is_pump(room: str) -> bool:
    """Whether a room stands in the pump's wing."""
    return room.split(".")[0] == "pump"


def _implied(arrow: Arrow, known: set[Arrow]) -> bool:
    """Whether a longer path leads the same way."""
    start, end = arrow
    reached = {to for of, to in known if of == start and to != end}
    frontier = set(reached)
    while frontier:
        frontier = {to for of, to in known if of in frontier} - reached
        reached |= frontier
    return end in reached


# -- placement -----------------------------------------------------------------------------


def place(plan: Plan) -> Placement:
    """Middle of every box [inch], where arrows cross few boxes and few other arrows."""
    choices = [list(_places(y, row)) for y, row in plan.rows]
    found = (_settled(choices, plan.drawn, random.Random(seed)) for seed in range(RESTARTS))
    return min(found, key=lambda at: sum(_cost(at, plan.drawn, room) for room in at))


def _places(y: float, row: list[str]) -> Iterator[Placement]:
    """All ways to put the rooms of a row side by side."""
    for points in itertools.permutations(_slots(y, is_pump(row[0])), len(row)):
        if all(abs(p[0] - q[0]) > SLOT_W - 1e-9 for p, q in itertools.combinations(points, 2)):
            yield dict(zip(row, points, strict=True))


def _slots(row: float, in_pump: bool) -> list[Point]:
    """Where a room of a row may stand."""
    left, slots = (0.0, SLOTS_PUMP) if in_pump else (SLOTS_PUMP * SLOT_W + GAP, SLOTS_CORE)
    return [(left + SLOT_W * (k + 1) / 2, -row * ROW_H) for k in range(int(2 * slots) - 1)]


def _settled(choices: list[list[Placement]], drawn: list[Arrow], dice: random.Random) -> Placement:
    """A placement that changing one row does not improve."""
    here: Placement = {}
    for places in choices:
        here |= dice.choice(places)

    def cost(places: Placement) -> float:
        return sum(_cost(here | places, drawn, room) for room in places)

    for _ in range(SWEEPS):
        before = dict(here)
        for places in dice.sample(choices, len(choices)):
            here |= min(places, key=cost)
        if here == before:
            break
    return here


def _cost(at: Placement, drawn: list[Arrow], room: str) -> float:
    """What is wrong with a room's place: arrows over boxes, arrows that cross, long ways."""
    here = at[room]
    own = [(arrow, ends(at, arrow)) for arrow in drawn if room in arrow]
    others = [(arrow, ends(at, arrow)) for arrow in drawn if room not in arrow]
    covered = sum(_runs_over(line, here) for _, line in others) + sum(
        _runs_over(line, p) for arrow, line in own for name, p in at.items() if name not in arrow
    )
    crossings = sum(_cross(a, b) for (_, a), (_, b) in itertools.product(own, others))
    length = sum(abs(a[0] - b[0]) for _, (a, b) in own)
    return 50.0 * covered + 2.0 * crossings + 0.5 * length


def ends(at: Placement, arrow: Arrow) -> tuple[Point, Point]:
    """From the lower edge of one box to the upper edge of another, drawn towards each other."""
    (x, y), (u, v) = at[arrow[0]], at[arrow[1]]
    if y == v:
        side = BOX_W / 2 if u > x else -BOX_W / 2
        return (x + side, y), (u - side, v)
    lean = max(-1.0, min(1.0, (u - x) / (2 * SLOT_W))) * 0.3 * BOX_W
    return (x + lean, y - BOX_H / 2), (u - lean, v + BOX_H / 2)


def _runs_over(line: tuple[Point, Point], middle: Point) -> bool:
    (x, y), (u, v) = line
    low, high = middle[1] - BOX_H / 2 - 0.03, middle[1] + BOX_H / 2 + 0.03
    if min(y, v) >= high or max(y, v) <= low:
        return False
    shares = [(edge - y) / (v - y) for edge in (low, high)] if v != y else [0.0, 1.0]
    across = [x + min(max(s, 0.0), 1.0) * (u - x) for s in shares]
    reach = BOX_W / 2 + 0.05
    return min(across) < middle[0] + reach and max(across) > middle[0] - reach


def _cross(one: tuple[Point, Point], other: tuple[Point, Point]) -> bool:
    def side(a: Point, b: Point, c: Point) -> float:
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    (a, b), (c, d) = one, other
    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0


# -- picture -------------------------------------------------------------------------------


def draw(plan: Plan, path: Path) -> None:
    """Rooms as boxes in their layers, arrows from importer to imported."""
    at = place(plan)
    width = (SLOTS_PUMP + SLOTS_CORE) * SLOT_W + GAP
    bottom = -plan.depth * ROW_H
    height = BOX_H / 2 + 0.3 - bottom + BOX_H / 2
    with picture(path, width + 2 * MARGIN, height + 2 * MARGIN) as made:
        axes = made.add_axes((0, 0, 1, 1))
        axes.set(xlim=(-MARGIN, width + MARGIN))
        axes.set(ylim=(bottom - BOX_H / 2 - MARGIN, BOX_H / 2 + 0.3 + MARGIN))
        axes.axis("off")
        _draw_wings(axes, at, width)
        for arrow in plan.drawn:
            start, end = ends(at, arrow)
            style = {"arrowstyle": "-|>", "color": PLAIN.ink, "lw": 0.8, "mutation_scale": 8}
            axes.annotate(
                "", xy=end, xytext=start, arrowprops={**style, "shrinkA": 0, "shrinkB": 0}
            )
        for room, middle in at.items():
            _draw_box(axes, middle, BOX_W, room)
        base = ", ".join(room for room in BASE if room in plan.rooms)
        _draw_box(axes, (width / 2, bottom), width, base, "all rooms may use these")


def _draw_wings(axes: Axes, at: Placement, width: float) -> None:
    """A tint behind the pump's wing and one behind the core, each with its name."""
    from matplotlib.patches import Rectangle

    split = SLOTS_PUMP * SLOT_W + GAP / 2
    top = BOX_H / 2 + 0.08
    for name, in_pump, left, right in (
        ("the pump", True, 0.0, split - 0.08), ("the model", False, split + 0.08, width)
    ):  # fmt: skip
        low = min(y for room, (_, y) in at.items() if is_pump(room) is in_pump)
        corner, low = (left, low - BOX_H / 2 - 0.08), low - BOX_H / 2 - 0.08
        axes.add_patch(Rectangle(corner, right - left, top - low, fc="0.955", ec="none", zorder=-2))
        axes.text(left + 0.06, top + 0.05, name, fontsize=10, color=PLAIN.accent, va="bottom")


def _draw_box(axes: Axes, middle: Point, width: float, name: str, below: str = "") -> None:
    from matplotlib.patches import FancyBboxPatch

    x, y = middle
    corner = (x - width / 2, y - BOX_H / 2)
    look = {"boxstyle": "round,pad=0,rounding_size=0.05", "fc": "white", "ec": PLAIN.ink, "lw": 0.9}
    axes.add_patch(FancyBboxPatch(corner, width, BOX_H, **look))
    rise = 0.075 if below else 0.0
    axes.text(x, y + rise, name, fontsize=8.5, ha="center", va="center", color=PLAIN.ink)
    axes.text(x, y - 0.095, below, fontsize=7, ha="center", va="center", color="0.4")


# -- page ----------------------------------------------------------------------------------


def rooms_table(plan: Plan) -> str:
    """Every room from the top, with what it is for in its own words."""
    rows = [
        (f"`{room}`", purpose(room)) for layer in LAYERS for room in layer if room in plan.rooms
    ]
    return table(("room", "what it is for"), rows)


def purpose(room: str) -> str:
    """First sentence of a room's docstring."""
    import ast

    folder = PACKAGE / room.replace(".", "/")
    path = folder / "__init__.py" if folder.is_dir() else folder.with_suffix(".py")
    text = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or ""
    return " ".join(text.split("\n\n")[0].split())


def counts(plan: Plan) -> str:
    """How many rooms and imports there are."""
    inner = [arrow for arrow in plan.imports if not {*arrow} & UNDRAWN]
    return (
        f"{len(plan.rooms)} rooms, {len(plan.imports)} imports "
        f"between rooms; {len(inner)} of them between rooms above the bottom layer, of which the "
        f"picture shows {len(plan.drawn)}: it leaves out what a longer path of arrows implies."
    )


if __name__ == "__main__":
    main()
