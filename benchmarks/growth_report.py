"""The report of growth.py: a table and a figure, computed from its result lines only."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

Record = dict[str, Any]
SMALLEST_FITTED = {"bellows": 16, "edges": 32, "duration": 10}
"""Size from which an exponent is fitted; below it, fixed costs dominate."""
LARGEST_EXPONENT = 1.1
"""Largest acceptable exponent of the solve time over the number of bellows or of edges."""
TITLES = {
    "bellows_arcs": "Bellows, quasi-static arcs",
    "bellows_dynamic": "Bellows, dynamic with gravity",
    "edges": "Edges, 16 bellows, dynamic with gravity",
    "duration_arcs": "Duration [s], sine of 0.5 Hz, quasi-static arcs",
    "duration_dynamic": "Duration [s], sine of 0.5 Hz, dynamic with gravity",
}
ABOUT = """# How the cost grows with the work

CPU times. Solve and build are warm: the fastest of up to three further solutions, in the same
process, of a scene that was solved before; solving includes the equilibrium, all outputs,
shapes and balances. Cold is the first one, which also finds the formulas or makes them.
Peak memory is the whole process's. Exponents are least squares in log-log over the upper
sizes, the first of which is told. One thread.

More bellows divide the same actuator more finely: its length, its total turn and extension
at a pressure, its total tube length, storage and rest volume stay, so that the network's
slowest time is nearly the same at any count. Dynamic is inertia, damping, feedback and
gravity. More of each family: benchmarks/growth.py.
"""


def read(path: Path) -> dict[str, list[Record]]:
    """Records by family, ascending in size."""
    records = [json.loads(line) for line in path.read_text().splitlines()]
    return {
        family: sorted((r for r in records if r["family"] == family), key=lambda r: r["size"])
        for family in TITLES
        if any(r["family"] == family for r in records)
    }


def write_report(path: Path) -> None:
    """Markdown and figure beside the result lines."""
    families = read(path)
    parts = [ABOUT, f"![Growth]({path.stem}.png)\n", _summary(families)]
    parts.append(_aim(families))
    parts += [_table(family, records) for family, records in families.items()]
    path.with_suffix(".md").write_text("\n".join(parts))
    _draw(families, path.with_suffix(".png"))


def told(power: float) -> str:
    """An exponent with two digits, or "not fitted"."""
    return "not fitted" if power != power else f"{power:.2f}"


def exponent(records: list[Record], key: str, smallest: float) -> float:
    """Slope of log(cost) over log(size); nan with fewer than two points."""
    fitted = [r for r in records if not r["note"] and r["size"] >= smallest]
    if len(fitted) < 2:
        return float("nan")
    size, cost = (np.log([r[k] for r in fitted]) for k in ("size", key))
    return float(np.polyfit(size, cost, 1)[0])


def _smallest(family: str) -> int:
    return SMALLEST_FITTED[family.split("_")[0]]


def _summary(families: dict[str, list[Record]]) -> str:
    keys = ("solve_s", "build_s", "cold_s", "peak_memory_mb", "steps")
    lines = [
        "| family | fitted from | solve | build | cold | memory | steps |",
        "|---|---|---|---|---|---|---|",
    ]
    for family, records in families.items():
        smallest = _smallest(family)
        powers = " | ".join(told(exponent(records, key, smallest)) for key in keys)
        lines.append(f"| {TITLES[family]} | {smallest} | {powers} |")
    return "\n".join(lines) + "\n"


def _aim(families: dict[str, list[Record]]) -> str:
    """The growth with the number of bellows and of edges compared with the target."""
    words = [f"The target over bellows and edges is an exponent of at most {LARGEST_EXPONENT:g}."]
    for family in (f for f in families if not f.startswith("duration")):
        records, smallest = families[family], _smallest(family)
        whole, steps = (exponent(records, key, smallest) for key in ("solve_s", "steps"))
        met = "met" if whole <= LARGEST_EXPONENT else "missed"
        if len({r["solver"] for r in records if not r["note"]}) > 1:
            words.append(f"{TITLES[family]}: {told(whole)}, {met}; the solver changes on the way.")
            continue
        words.append(
            f"{TITLES[family]}: {told(whole)}, {met}; {told(steps)} of it are more steps, "
            f"{told(whole - steps)} the work of one."
        )
    return " ".join(words) + "\n"


def _table(family: str, records: list[Record]) -> str:
    lines = [
        f"## {TITLES[family]}\n",
        "| size | solve | build | cold | peak memory | steps | unknowns | solver |",
        "|---|---|---|---|---|---|---|---|",
    ]
    return "\n".join(lines + [_row(r) for r in records]) + "\n"


def _row(r: Record) -> str:
    if r["note"]:
        return f"| {r['size']} | {r['note']} | | | | | | |"
    times = " | ".join(f"{1e3 * r[k]:.3g} ms" for k in ("solve_s", "build_s", "cold_s"))
    counts = f"{r['peak_memory_mb']:.0f} MB | {r['steps']} | {r['unknowns']} | {r['solver']}"
    return f"| {r['size']} | {times} | {counts} |"


def _draw(families: dict[str, list[Record]], path: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, 3, figsize=(12, 4), layout="constrained", sharey=True)
    names = {"bellows": "bellows [1]", "edges": "edges [1]", "duration": "simulated time [s]"}
    for ax, (kind, name) in zip(axes, names.items(), strict=True):
        for colour, family in enumerate(f for f in families if f.startswith(kind)):
            records = [r for r in families[family] if not r["note"]]
            label = family.partition("_")[2] or "dynamic"
            for key, style in (("solve_s", "o-"), ("build_s", "x:")):
                power = exponent(records, key, _smallest(family))
                ax.loglog(
                    [r["size"] for r in records],
                    [r[key] for r in records],
                    style,
                    color=f"C{colour}",
                    label=f"{label}, {key[:-2]}: exponent {told(power)}",
                )
        ax.set_xlabel(name)
        ax.grid(alpha=0.3)
        if ax.has_data():
            ax.legend(fontsize=8)
    axes[0].set_ylabel("CPU time, warm [s]")
    figure.savefig(path, dpi=120)
    plt.close(figure)
