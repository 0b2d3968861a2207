"""Design the leg for ten paths: python docs/make_designs.py

Fills the blocks of `docs/designs.md` and draws its picture. It takes some minutes.
"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np

DOCS = Path(__file__).parent
sys.path[:0] = [str(DOCS.parent), str(DOCS)]

from design_targets import LEG, TARGETS, DesignTarget  # noqa: E402
from make_pages import fill, table  # noqa: E402

from viscodesign import PathDesign, design  # noqa: E402

PAGE = DOCS / "designs.md"
PICTURE = DOCS / "designs" / "designs.png"
SPEC = DOCS.parent / "configs" / "leg_16_straight_air_auto.yaml"
BUDGET_S = 120.0
COLUMNS = 4
HEAD = (
    "path", "free", "allowed", "answer", "confirmed, rms", "farthest point", "stated error",
    "solutions", "time",
)  # fmt: skip


def main(names: list[str]) -> None:
    """Design all, or those whose names contain one of the words."""
    chosen = [t for t in TARGETS if not names or any(word in t.name for word in names)]
    found = []
    for target in chosen:
        found.append((target, designed(target)))
        print(" | ".join(row(*found[-1])), found[-1][1].reason, found[-1][1].hint, flush=True)
    if names:
        return
    draw(found)
    answers = [f"- *{target.name}*: {reason(own)}" for target, own in found if own.reason]
    fill(
        PAGE, {"designs": table(HEAD, [row(*own) for own in found]), "reasons": "\n".join(answers)}
    )


def designed(target: DesignTarget) -> PathDesign:
    """The answer to a target."""
    task = {
        "spec": str(SPEC),
        "free": dict(target.free),
        "target": dict(target.path),
        "tolerance": target.tolerance,
    }
    return design(task, {**LEG, **target.changes}, budget=BUDGET_S)


def row(target: DesignTarget, found: PathDesign) -> tuple[str, ...]:
    """A row of the table."""
    answer = found.status.replace("_", " ")
    if found.ended_by_budget:
        answer += ", ended by its budget"
    return (
        target.name, target.words, target.tolerance, answer, length(found.confirmed_rms_m),
        length(found.confirmed_worst_m), length(found.stated_error_m), str(found.evaluations),
        f"{found.wall_s:.0f} s" if found.wall_s >= 1.0 else f"{found.wall_s:.1f} s",
    )  # fmt: skip


def length(value: float | None) -> str:
    """A length [m] in mm; empty for none."""
    return "" if value is None else f"{1e3 * value:.2g} mm"


def reason(found: PathDesign) -> str:
    """Why it is not met, and what would help."""
    return f"{found.reason}. {found.hint}." if found.hint else f"{found.reason}."


def draw(found: list[tuple[DesignTarget, PathDesign]]) -> None:
    """Wanted and found paths side by side, z downwards."""
    mpl.use("Agg")
    shown = [own for own in found if len(own[1].found)]
    rows = -(-len(shown) // COLUMNS)
    figure, places = plt.subplots(rows, COLUMNS, figsize=(11, 2.9 * rows), squeeze=False)
    for axes in places.flat[len(shown) :]:
        axes.axis("off")
    for axes, (target, own) in zip(places.flat, shown, strict=False):
        wanted = np.concatenate([own.wanted, own.wanted[:1]]) if own.closed else own.wanted
        way = np.concatenate([own.found, own.found[:1]]) if own.closed else own.found
        is_timed = len(own.wanted) < ROWS_OF_A_LINE
        marks = {"marker": "o", "ls": ""} if is_timed else {"lw": 4.0}
        axes.plot(*(1e3 * wanted.T), color="#b9c7d8", label="wanted", **marks)
        marks = {"marker": "x", "ls": ""} if is_timed else {"lw": 1.2}
        axes.plot(*(1e3 * way.T), color="#b3400c", label="found", **marks)
        axes.set_title(target.name, fontsize=9)
        axes.set_aspect("equal", adjustable="datalim")
        axes.invert_yaxis()
        axes.tick_params(labelsize=8)
    for axes in places[:, 0]:
        axes.set_ylabel("z, down from the clamp [mm]", fontsize=8)
    for axes in places[-1]:
        axes.set_xlabel("x [mm]", fontsize=8)
    places[0, 0].legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(PICTURE, dpi=110)


ROWS_OF_A_LINE = 10
"""Wanted points from which they are drawn as a line."""

if __name__ == "__main__":
    main(sys.argv[1:])
