"""Tables and a figure of the races, from their lines of JSON alone."""

from __future__ import annotations

import json
from collections import defaultdict
from pathlib import Path
from typing import Any

import matplotlib as mpl

mpl.use("Agg")
import matplotlib.pyplot as plt

Record = dict[str, Any]
WANTED = (1e-2, 1e-3, 1e-4)
"""Errors for which the cheapest setting is told, over the case's scale."""
OURS = "viscodesign"
TARGET_ERROR = 1e-3
"""Error at which the aims are judged."""
TARGETS = [
    ("leg_8s", "script", 50.0, 50.0, "both sides' time is residuals and Jacobians; ours are "
     "exact and sparse, but interpreted, and the script's numpy does many columns at once"),
    ("network_water", "SciPy BDF", 1.0, 1.0, ""),
    ("network_air", "SciPy BDF", 1.0, 1.0, ""),
    ("network_water", "FONSim", 500.0, 500.0, "smooth pulses suit its long steps, and most of "
     "our own time is not steps but reading outputs and balances"),
    ("network_air", "FONSim", 500.0, 500.0, "the same"),
    ("cycle_fast", "Exudyn", 1.0, 1 / 3, "one cubic element does what takes two or three of our "
     "edges, and its formulas are compiled"),
    ("cycle_slow", "Exudyn", 1.0, 1 / 3, "inertia is left out, as it may be; what is left is "
     "mostly reading outputs and balances"),
    ("release", "Exudyn", 1.0, 1 / 3, "every swing of an undamped rod has to be followed, by "
     "formulas that are interpreted"),
    ("cycle_fast", "PyElastica", 10.0, 10.0, ""),
]  # fmt: skip
"""Case, beginning of the rivals' names, how many times faster we want to be than the best
of them, how many at the least, and what stands in the way where we are not."""
LOWEST = 1e-8
"""Error below which nothing is drawn."""
MARKERS = "osD^vP*X<>ph"
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000", "#999999")
"""Okabe and Ito's, which colour-blind readers tell apart."""


def write_report(path: Path) -> None:
    """Write `peers.md` and `peers.png` beside the lines."""
    lines = [json.loads(line) for line in path.read_text().splitlines()]
    header = next(line for line in lines if line["kind"] == "header")
    cases = [line for line in lines if line["kind"] == "case"]
    results: dict[str, list[Record]] = defaultdict(list)
    for line in lines:
        if line["kind"] == "result":
            results[line["case"]].append(line)
    words = [_head(header), *_targets(cases, results)]
    for case in cases:
        words += _case(case, results[case["case"]])
    words.append("![error against time](peers.png)\n")
    path.with_suffix(".md").write_text("\n".join(words))
    _draw(cases, results, path.with_suffix(".png"))


def _head(header: Record) -> str:
    versions = ", ".join(f"{k} {v}" for k, v in header["versions"].items() if v != "absent")
    return (
        "# viscodesign beside other tools\n\n"
        "Each solves the same motion; of its settings, coarse to fine, the cheapest counts whose "
        "error against a common converged reference is small enough. Times are of one solution in "
        "a process that has solved before (warm), on one thread; cold is import, building and "
        "first solution in a fresh process. Regenerate with `python benchmarks/peers/race.py`.\n\n"
        f"Python {header['python']}, {header['cpu']}; {versions}.\n"
    )


def _targets(cases: list[Record], results: dict[str, list[Record]]) -> list[str]:
    """What was aimed at and what was reached, the fastest of either side against each other."""
    titles = {case["case"]: case["title"] for case in cases}
    words = [
        f"## Aims, at an error of {100 * TARGET_ERROR:g} %\n",
        "How many times faster than the best of the others; below 1 they are faster.\n",
        "| motion | against | aim | reached | met? |",
        "|---|---|---|---|---|",
    ]
    for case, rival, aim, least, limit in TARGETS:
        if case not in titles:
            continue
        best = _cheapest(results[case], TARGET_ERROR)
        ours = min((r["warm_s"] for n, r in best.items() if OURS in n), default=None)
        theirs = min((r["warm_s"] for n, r in best.items() if n.startswith(rival)), default=None)
        if ours is None or theirs is None:
            reached = f"{'we' if ours is None else 'they'} do not come to this error in time"
            verdict = limit if ours is None else "met"
        else:
            ratio = theirs / ours
            reached = f"{ratio:.3g}"
            verdict = f"{'in part' if ratio >= least else 'missed'}: {limit}"
            verdict = "met" if ratio >= aim else verdict
        bound = f"{aim:g}" if aim == least else f"{aim:g}, at the least {least:.2g}"
        words.append(f"| {titles[case]} | {rival} | {bound} | {reached} | {verdict} |")
    return [*words, ""]


def _cheapest(results: list[Record], wanted: float) -> dict[str, Record]:
    """By tool, the fastest result whose error is small enough."""
    good = [r for r in results if r.get("warm_s") is not None and r.get("error_rel") is not None]
    best: dict[str, Record] = {}
    for r in sorted(good, key=lambda r: r["warm_s"]):
        if r["error_rel"] <= wanted:
            best.setdefault(r["name"], r)
    return best


def _case(case: Record, results: list[Record]) -> list[str]:
    words = [
        f"## {case['title']}\n",
        f"Compared: {case['quantity']}; errors over {case['scale']:g}; the reference is good to "
        f"{case['reference_error']:.1g}.\n",
    ]
    for wanted in WANTED:
        best = _cheapest(results, wanted)
        ours = min((r["warm_s"] for n, r in best.items() if OURS in n), default=None)
        words += [
            f"Error at most {100 * wanted:g} %:\n",
            "| tool | setting | error | warm | cold | over viscodesign |",
            "|---|---|---|---|---|---|",
        ]
        for name in dict.fromkeys(r["name"] for r in results):
            words.append(_row(name, best.get(name), ours))
        words.append("")
    return words


def _row(name: str, found: Record | None, ours: float | None) -> str:
    if found is None:
        return f"| {name} | not reached | | | | |"
    setting = ", ".join(f"{k} {v:g}" if isinstance(v, float) else f"{k} {v}"
                        for k, v in found["setting"].items())  # fmt: skip
    ratio = "" if ours is None else f"{found['warm_s'] / ours:.3g}"
    start = found.get("overhead_s", 0.0)
    told = f", {1e3 * start:.3g} of it the program's start" if start else ""
    return (
        f"| {name} | {setting} | {found['error_rel']:.1e} | {1e3 * found['warm_s']:.3g} ms{told} "
        f"| {found['cold_s']:.2g} s | {ratio} |"
    )


def _draw(cases: list[Record], results: dict[str, list[Record]], path: Path) -> None:
    shown = [case for case in cases if results[case["case"]]]
    columns = min(2, len(shown))
    rows = -(-len(shown) // columns)
    size = (8.2 * columns, 4.4 * rows)
    figure, axes = plt.subplots(rows, columns, figsize=size, squeeze=False, layout="constrained")
    for axis in axes.flat[len(shown) :]:
        axis.set_visible(False)
    places: dict[str, int] = {}
    for axis, case in zip(axes.flat, shown, strict=False):
        names = list(dict.fromkeys(r["name"] for r in results[case["case"]]))
        for name in names:
            # A tool looks the same in every panel.
            taken = {places[n] for n in names if n in places}
            places.setdefault(name, min(set(range(len(names) + 1)) - taken))
        _panel(axis, case, results[case["case"]], {name: places[name] for name in names})
    figure.savefig(path, dpi=150)


def _panel(axis: Any, case: Record, results: list[Record], places: dict[str, int]) -> None:
    least = 1.0
    for name, k in places.items():
        own = [r for r in results if r["name"] == name and r.get("error_rel") and r.get("warm_s")]
        least = min([least, *(r["error_rel"] for r in own)])
        axis.loglog(
            [1e3 * r["warm_s"] for r in own],
            [r["error_rel"] for r in own],
            marker=MARKERS[k % len(MARKERS)],
            color=COLOURS[k % len(COLOURS)],
            linewidth=2.2 if OURS in name else 1.0,
            linestyle="-" if k < len(COLOURS) else "--",
            label=name if own else f"{name}: none",
        )
    axis.set_ylim(max(least / 2, LOWEST), 1.0)
    axis.set_title(case["title"], fontsize=10)
    axis.set_xlabel("time of one solution, warm [ms]")
    axis.set_ylabel("largest error, over the scale [1]")
    axis.grid(which="major", color="0.85", linewidth=0.6)
    axis.legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.01, 1.0), frameon=False)
