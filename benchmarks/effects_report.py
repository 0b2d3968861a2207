"""The report of the effects study, computed from its result lines only."""

from __future__ import annotations

import json
import platform
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
from scene_runs import FITTED_SEED

Record = dict[str, Any]

LARGE = 0.1
"""Fraction of the requested accuracy from which an estimate is compared with the measurement."""
FACTOR = 3.0


def write_report(path: Path, seed: int) -> None:
    """Write a Markdown page and a figure beside the result lines."""
    records = read(path)
    page = path.with_suffix(".md")
    text = "\n".join(report_lines(records, path.with_suffix(".png").name, seed))
    page.write_text(text + "\n")
    draw_figure(records, path.with_suffix(".png"))
    print(text)


def read(path: Path) -> list[Record]:
    """All result lines of a file."""
    if not path.exists():
        return []
    return [json.loads(line) for line in path.read_text().splitlines()]


def of_kind(records: list[Record], kind: str) -> list[Record]:
    """Result lines of one kind."""
    return [r for r in records if r["kind"] == kind]


def _measured(records: list[Record]) -> list[Record]:
    """Ablations that were measured to the end of the run."""
    return [p for p in of_kind(records, "proof") if p["measured"] is not None and not p["note"]]


def report_lines(records: list[Record], figure: str, seed: int) -> list[str]:
    """The page."""
    costs, choices = of_kind(records, "cost"), of_kind(records, "choice")
    proofs = _measured(records)
    return [
        "# Does `effects: auto` choose well?",
        "",
        f"{len(of_kind(records, 'end'))} scenes of seed {seed} drawn at random over the whole "
        "plane of timescales (`benchmarks/scene_draw.py`), each solved with automatically selected "
        "effects and with everything on; regenerate with `python benchmarks/effects_study.py`.",
        f"Python {platform.python_version()}, {platform.machine()}, "
        f"{_versions()}; one process per scene.",
        "",
        f"**What is independent.** {_independence(seed)} Scenes that ring are in "
        "[`auto_study.md`](auto_study.md). The comparison is with this program's own solution with "
        "everything on: it tells the error of the choice, not that of the equations.",
        "",
        *_spread(costs),
        "",
        "## The choice",
        "",
        *_choice_lines(choices),
        "",
        "## The cost",
        "",
        *_cost_lines(costs),
        "",
        "## The estimates",
        "",
        *_estimate_lines(proofs),
        "",
        f"![choice and estimates]({figure})",
        "",
        "## Scenes that fail",
        "",
        *_misses(records),
    ]


def _independence(seed: int) -> str:
    chosen = f"The numbers of the selection were chosen on scenes of seed {FITTED_SEED}"
    if seed == FITTED_SEED:
        return f"{chosen}, these ones."
    return f"{chosen}; none of these was run before."


def _versions() -> str:
    import casadi
    import scipy

    from viscodesign import __version__

    return f"viscodesign {__version__}, casadi {casadi.__version__}, scipy {scipy.__version__}"


def _spread(costs: list[Record]) -> list[str]:
    quadrants = Counter(c["quadrant"] for c in costs)
    fluids = Counter(c["fluid"] for c in costs)
    words = ", ".join(f"{count} in {name}" for name, count in sorted(quadrants.items()))
    kinds = ", ".join(f"{count} {name}" for name, count in fluids.most_common())
    bellows = [c["bellows"] for c in costs]
    return [f"Quadrants: {words}. Fluids: {kinds}. Bellows: {min(bellows)} to {max(bellows)}."]


def _choice_lines(choices: list[Record]) -> list[str]:
    whole = [c for c in choices if c["status"] == ["complete", "complete"]]
    apart = np.array([c["distance_over_accuracy"] for c in whole])
    within = float(np.mean(apart <= 1.0))
    return [
        "Largest distance of the two tips over all output times, relative to the requested "
        "accuracy; both solved with a tolerance twenty times smaller than the scene's. These runs "
        "are not verified: it is the choice by the estimates alone. A verified run measures what "
        "it neglects, and takes in more where that is too much ([their errors](error_study.md)).",
        "",
        "| claim | measured |",
        "|---|---|",
        f"| at most the accuracy in 95 % of the scenes | {100 * within:.3g} % of {len(whole)} |",
        f"| at most three times in all | largest {apart.max():.3g} |",
        f"| median, 90th percentile | {np.median(apart):.2g}, {np.quantile(apart, 0.9):.2g} |",
    ]


def _cost_lines(costs: list[Record]) -> list[str]:
    rows = []
    for name, keys in (
        ("solving", ["solve_s"]),
        ("building and solving", ["build_s", "solve_s"]),
        ("selecting, building and solving", ["choose_s", "build_s", "solve_s"]),
    ):
        auto, every = (
            np.array([sum(c[which][k] for k in keys) for c in costs]) for which in ("auto", "all")
        )
        ratio = auto / every
        rows.append(
            f"| {name} | {1e3 * np.median(auto):.3g} ms | {1e3 * np.median(every):.3g} ms | "
            f"{np.median(ratio):.2g} | {np.quantile(ratio, 0.1):.2g} to "
            f"{np.quantile(ratio, 0.9):.2g} |"
        )
    unknowns = np.median([c["auto"]["unknowns"] / c["all"]["unknowns"] for c in costs])
    return [
        "| median wall time | auto | everything on | median of ratios | 10 % to 90 % |",
        "|---|---|---|---|---|",
        *rows,
        "",
        f"Unknowns: auto has {100 * unknowns:.3g} % of those of everything on (median). "
        "Selection is the estimate of every effect, which both cases need.",
    ]


def _ratios(proofs: list[Record]) -> np.ndarray:
    """Ratio of estimate to measurement, where either is large."""
    pairs = np.array([[p["estimated"], p["measured"]] for p in proofs])
    large = pairs.max(axis=1) > LARGE
    return np.asarray(pairs[large, 0] / np.maximum(pairs[large, 1], 1e-300))


def _near(ratios: np.ndarray) -> float:
    return float(np.mean((ratios <= FACTOR) & (ratios >= 1 / FACTOR))) if ratios.size else 1.0


def _estimate_lines(proofs: list[Record]) -> list[str]:
    lines = [
        "Each effect is switched by itself, the scene is solved again, and the tip displacement is "
        "compared with the estimate, where either exceeds a tenth of the accuracy.",
        "",
        "| effect | cases | within a factor 3 | median ratio of estimate to measurement |",
        "|---|---|---|---|",
    ]
    for name in sorted({p["effect"] for p in proofs}):
        ratios = _ratios([p for p in proofs if p["effect"] == name])
        if ratios.size:
            lines.append(_estimate_row(name, ratios))
    return [*lines, _estimate_row("**all**", _ratios(proofs))]


def _estimate_row(name: str, ratios: np.ndarray) -> str:
    near = f"{100 * _near(ratios):.3g} %"
    return f"| {name} | {ratios.size} | {near} | {np.median(ratios):.2g} |"


def _misses(records: list[Record]) -> list[str]:
    rows = []
    for c in of_kind(records, "choice"):
        if c["status"] != ["complete", "complete"]:
            words = "; ".join(f for f in c["failure"] if f)
            rows.append(f"| {c['index']} | {' / '.join(c['status'])} | {words[:160]} |")
        elif c["distance_over_accuracy"] > 1.0:
            taken = ", ".join(c["taken"])
            rows.append(f"| {c['index']} | {c['distance_over_accuracy']:.3g} | taken: {taken} |")
    for e in of_kind(records, "end"):
        if e["note"]:
            rows.append(f"| {e['index']} | {' '.join(e['note'].split())[-160:]} | |")
    return ["| scene | distance over accuracy | |", "|---|---|---|", *rows] if rows else ["None."]


def draw_figure(records: list[Record], path: Path) -> None:
    """Distance against cost, and estimate against measurement."""
    import matplotlib.pyplot as plt

    costs = {c["index"]: c for c in of_kind(records, "cost")}
    whole = [c for c in of_kind(records, "choice") if c["status"] == ["complete", "complete"]]
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.4), layout="constrained")
    for quadrant, marker in zip(("I", "II", "III", "IV"), "osD^", strict=True):
        own = [c for c in whole if costs[c["index"]]["quadrant"] == quadrant]
        ratio = [_cost_ratio(costs[c["index"]]) for c in own]
        apart = [max(c["distance_over_accuracy"], 1e-4) for c in own]
        left.loglog(ratio, apart, marker, ms=5, alpha=0.75, label=f"quadrant {quadrant}")
    left.axhline(1.0, color="black", lw=1, ls="--")
    left.text(0.99, 1.15, "requested accuracy", transform=left.get_yaxis_transform(), ha="right")
    left.set_xlabel("building and solving, over that of everything on")
    left.set_ylabel("distance of both tips, relative to the accuracy")
    left.legend(loc="lower right", fontsize="small")
    proofs = _measured(records)
    pairs = np.array([[p["measured"], p["estimated"]] for p in proofs])
    large = pairs.max(axis=1) > LARGE
    right.loglog(*np.maximum(pairs[~large], 1e-3).T, ".", color="0.75", label="below a tenth")
    right.loglog(*np.maximum(pairs[large], 1e-3).T, ".", color="#3b4a8a", label="above a tenth")
    line = np.array([1e-3, 1e4])
    right.fill_between(line, line / FACTOR, line * FACTOR, color="0.5", alpha=0.15, lw=0)
    right.plot(line, line, color="black", lw=1)
    right.set_xlim(1e-3, 1e4)
    right.set_ylim(1e-3, 1e4)
    right.set_xlabel("measured tip displacement, relative to the accuracy")
    right.set_ylabel("estimated move, relative to the accuracy")
    right.legend(loc="upper left", fontsize="small", title="band: a factor of 3")
    figure.savefig(path, dpi=110)
    plt.close(figure)


def _cost_ratio(cost: Record) -> float:
    auto, every = (cost[k]["build_s"] + cost[k]["solve_s"] for k in ("auto", "all"))
    return float(auto / every)
