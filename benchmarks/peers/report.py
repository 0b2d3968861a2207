"""Tables and a figure of the races, from their lines of JSON alone."""

from __future__ import annotations

import json
from collections import defaultdict
from pathlib import Path
from typing import Any

import matplotlib as mpl

mpl.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter

Record = dict[str, Any]
WANTED = (1e-2, 1e-3, 1e-4)
"""Errors for which the cheapest setting is told, over the case's scale."""
OURS = "viscodesign"
TARGET_ERROR = 1e-3
"""Error at which the aims are judged."""
CALL = (
    "a whole call of `simulate` is measured, which also checks the scene, reads outputs and "
    "shapes, sums balances and looks for warnings: most of its time"
)
TARGETS = [
    ("leg_8s", "script", 20.0, ""),
    ("network_water", "SciPy LSODA", 5.0, f"{CALL}; the modes alone take 0.2 ms"),
    ("network_water", "FONSim", 500.0, "the same; smooth pulses suit its long steps"),
    ("cycle_fast", "Exudyn", 3.0, f"{CALL}; one cubic element does what takes two or three edges"),
    ("cycle_slow", "Exudyn", 1.5, f"{CALL}; inertia is left out, as it may be"),
    ("release", "Exudyn", 9.0, "every swing of an undamped rod has to be followed, and a call "
     "with given settings builds the problem anew"),
]  # fmt: skip
"""Case, beginning of the rivals' names, how many times faster we want to be than the best
of them, and what stands in the way where we are not."""
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
    duels = {(x["case"], x["name"]): x["warm_s"] for x in lines if x["kind"] == "duel"}
    words = [_head(header), *_targets(cases, duels), *EARLIER]
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
        "error against a common converged reference is small enough. Times are CPU times of one "
        "solution in a process that has solved before (warm), on one thread; cold is import, "
        "building and first solution in a fresh process. Regenerate with "
        "`python benchmarks/peers/race.py`. Settings that took too long are missing.\n\n"
        f"Python {header['python']}, {header['cpu']}; {versions}.\n"
    )


def _targets(cases: list[Record], duels: dict[tuple[str, str], float]) -> list[str]:
    """What was aimed at and what was reached, the fastest of either side against each other."""
    titles = {case["case"]: case["title"] for case in cases}
    words = [
        f"## Aims, at an error of {100 * TARGET_ERROR:g} %\n",
        "How many times faster than the best of the others; below 1 they are faster. CPU times of "
        "the cheapest settings in turn, in one process, the least of each.\n",
        "| motion | against | ours | theirs | aim | reached | met? |",
        "|---|---|---|---|---|---|---|",
    ]
    for case, rival, aim, limit in TARGETS:
        own = {name: spent for (of, name), spent in duels.items() if of == case}
        ours = min((s for n, s in own.items() if OURS in n), default=None)
        theirs = min((s for n, s in own.items() if n.startswith(rival)), default=None)
        if case not in titles or ours is None:
            continue
        head = f"| {titles[case]} | {rival} | {1e3 * ours:.3g} ms"
        if theirs is None:
            words.append(f"{head} | not reached in time | {aim:g} | | not known |")
            continue
        ratio = theirs / ours
        verdict = "met" if ratio >= aim else f"missed: {limit}"
        words.append(f"{head} | {1e3 * theirs:.3g} ms | {aim:g} | {ratio:.3g} | {verdict} |")
    return [*words, ""]


EARLIER = [
    "Not run again since version 0.3.0, on another machine: MuJoCo 4.0 (at 0.1 % 90 ms for the "
    "fast cycle and 12.7 ms for the slow one, where Exudyn took 10.1 and 1.92 ms), PyElastica 1.0 "
    "and SoRoMoX 0.5, which came to 0.1 % in none of the rod's motions, and ngspice (7.4 and "
    "10.2 ms for the networks, about 6 of them its start, where LSODA took 1.5 and 2.2 ms).\n",
]


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
        if not own:
            continue
        least = min([least, *(r["error_rel"] for r in own)])
        axis.loglog(
            [1e3 * r["warm_s"] for r in own],
            [r["error_rel"] for r in own],
            marker=MARKERS[k % len(MARKERS)],
            color=COLOURS[k % len(COLOURS)],
            linewidth=2.2 if OURS in name else 1.0,
            linestyle="-" if k < len(COLOURS) else "--",
            label=name,
        )
    axis.set_ylim(max(least / 2, LOWEST), 1.0)
    axis.set_title(case["title"], fontsize=10)
    axis.set_xlabel("CPU time of one solution, warm [ms]")
    axis.xaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axis.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axis.xaxis.set_minor_formatter(NullFormatter())
    axis.set_ylabel("largest error, over the scale [1]")
    axis.grid(which="major", color="0.85", linewidth=0.6)
    axis.legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.01, 1.0), frameon=False)
