"""The report of the error study, computed from its result lines only."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from scene_runs import FITTED_SEED, Record, read

from viscodesign.effects.select import NUMBERS

if TYPE_CHECKING:
    from matplotlib.axes import Axes

CONVERGED = 0.1
"""Part of the stated error, or of the true one where that is larger, below which the
reference's own counts as none: nobody escapes by stating too little."""
COVERED, WORST, SHARP, TIGHT = 0.95, 2.0, 0.80, 10.0
"""The claims: share of scenes within the stated error, largest true over stated; share of
scenes whose stated error is at most so many times the true one."""
PARTS = ("time", "space", "omitted")
QUANTILES = (0.05, 0.25, 0.5, 0.75, 0.95, 1.0)


class Found(NamedTuple):
    """The lines of all scenes, by what became of them."""

    judged: list[Record]
    unsure: list[Record]
    """With a stated error, but no reference that is accurate enough."""
    silent: list[Record]
    """Without a stated error."""
    plain: dict[int, Record]
    """Costs without verification, by scene."""
    ends: list[Record]


def write_report(path: Path, seed: int) -> None:
    """Write a Markdown page and a figure beside the result lines."""
    found = sort_out(read(path))
    text = "\n".join(report_lines(found, path.with_suffix(".png").name, seed))
    path.with_suffix(".md").write_text(text + "\n")
    if found.judged:
        draw_figure(found, path.with_suffix(".png"))
    print(text)


def sort_out(records: list[Record]) -> Found:
    """The scenes that can be compared, and the others."""
    runs = [r for r in records if r["kind"] == "run"]
    stated = [r for r in runs if r["estimated_tip_error_m"] is not None]
    return Found(
        judged=[r for r in stated if _is_judged(r)],
        unsure=[r for r in stated if not _is_judged(r)],
        silent=[r for r in runs if r["estimated_tip_error_m"] is None],
        plain={r["index"]: r for r in records if r["kind"] == "plain"},
        ends=[r for r in records if r["kind"] == "end"],
    )


def _is_judged(run: Record) -> bool:
    """Whether the reference is much better than what it judges."""
    own = run["reference_m"]
    return own is not None and own <= CONVERGED * max(run["true_m"], run["estimated_tip_error_m"])


def ratio(run: Record) -> float:
    """True error over stated error."""
    return float(run["true_m"] / run["estimated_tip_error_m"])


def report_lines(found: Found, figure: str, seed: int) -> list[str]:
    """The page."""
    return [
        "# Is the stated error right?",
        "",
        f"{len(found.ends)} scenes of seed {seed} drawn at random over the plane of timescales "
        "(`benchmarks/scene_draw.py`), each solved by `simulate(scene)` with automatically "
        "selected effects. Each is compared with a solution with all effects, refined (edges "
        "doubled and tolerance divided by ten each time) until it moves by less than a "
        "hundredth of the requested accuracy, or a tenth of the stated error if that is "
        "smaller. "
        "Regenerate with `python benchmarks/error_study.py`: `--references`, then without, "
        "`--sharpen`, and without again.",
        f"{_versions(found.judged)}; one process per scene.",
        "",
        f"Compared: {len(found.judged)} scenes. Not compared: {len(found.unsure)}, whose reference "
        f"has not converged to a tenth of the stated or the true error. No error stated: "
        f"{len(_without_error(found))}.",
        "",
        "## The claims",
        "",
        *_claim_lines(found.judged, seed),
        "",
        "## Ratio of true to stated error",
        "",
        *_quantile_lines(found.judged),
        "",
        "## The parts",
        "",
        *_part_lines(found.judged),
        "",
        "## The price",
        "",
        *_cost_lines(found),
        "",
        f"![stated and true error]({figure})",
        "",
        "## Scenes that fail",
        "",
        *_misses(found.judged),
        "",
        "## Scenes not compared",
        "",
        *_not_judged(found),
    ]


def _versions(runs: list[Record]) -> str:
    """With what the runs were made."""
    return "; ".join(sorted({run.get("made_with", "versions not noted") for run in runs}))


def _percent(share: float) -> str:
    return f"{100 * share:.3g} %"


def _claim_lines(judged: list[Record], seed: int) -> list[str]:
    if not judged:
        return ["No scene has been compared yet."]
    ratios = np.array([ratio(r) for r in judged])
    bare = np.array([ratio(_without_floor(r)) for r in judged])
    floored = sum(_without_floor(r) != r for r in judged)
    unmet = sum(r["status"] != "complete" for r in judged)
    missed = [r["true_m"] / r["requested_m"] for r in judged if ratio(r) > 1]
    return [
        "The true error is the largest distance of the two tips over all output times.",
        "",
        "| claimed | measured | without the floor |",
        "|---|---|---|",
        f"| the true error is at most the stated one in {_percent(COVERED)} | "
        f"{_percent(np.mean(ratios <= 1))} of {len(ratios)} | {_percent(np.mean(bare <= 1))} |",
        f"| at most twice the stated one in all | largest {ratios.max():.3g} times | "
        f"largest {bare.max():.3g} times |",
        f"| the stated error is at most ten times the true one in {_percent(SHARP)} | "
        f"{_percent(np.mean(ratios * TIGHT >= 1))} | {_percent(np.mean(bare * TIGHT >= 1))} |",
        "",
        f"{_independence(seed)} The last column takes the neglected part of the {floored} scenes "
        "that state just the floor as zero. Scenes that ring are in "
        "[`auto_study.md`](auto_study.md).",
        "",
        f"The true error is below the requested accuracy in {_percent(_met(judged))}; "
        f"{unmet} of the judged runs say that they missed it.",
        *([f"True errors above the stated ones reach {max(missed):.2g} of it."] if missed else []),
    ]


def _independence(seed: int) -> str:
    """On what the factors were chosen."""
    floor = f"the floor of neglected effects, {NUMBERS.least_stated:g} of the requested accuracy,"
    if seed == FITTED_SEED:
        return (
            "**These numbers are not independent.** The factors of the three parts were chosen on "
            f"the same scenes, and {floor} after an earlier run of them had shown true errors "
            "above the stated ones (the largest 0.0048 of the requested accuracy; it comes with "
            "feedback, which the estimate hardly shows there)."
        )
    return (
        f"**What is independent.** The factors of the three parts and {floor} were chosen on "
        f"scenes of seed {FITTED_SEED}, those of the one distance that holds all parts on scenes "
        "of seeds 11, 5051, 7717, 31337 and 70707, which do not judge them. The references are "
        "this program's own: they tell errors of choice, steps and mesh, not those of the "
        "equations."
    )


def _without_floor(run: Record) -> Record:
    """The scenes without the omitted part where it is just the floor."""
    omitted = run["omitted_m"]
    if run["time_m"] is None:  # one distance holds all parts
        return run
    if not omitted or not np.isclose(omitted, NUMBERS.least_stated * run["requested_m"], rtol=1e-9):
        return run
    return run | {
        "omitted_m": 0.0,
        "estimated_tip_error_m": run["estimated_tip_error_m"] - omitted,
    }


def _met(judged: list[Record]) -> float:
    return float(np.mean([r["true_m"] <= r["requested_m"] for r in judged]))


def _quantile_lines(judged: list[Record]) -> list[str]:
    if not judged:
        return []
    head = ["scenes", "count", *(_percent(q) for q in QUANTILES[:-1]), "largest"]
    groups = {"all": judged}
    for solver in sorted({r["settings"]["solver"] for r in judged}):
        groups[f"solved by {solver}"] = [r for r in judged if r["settings"]["solver"] == solver]
    for part in PARTS:
        groups[f"{part} is the largest part"] = [r for r in judged if largest_part(r) == part]
    rows = []
    for name, own in groups.items():
        if own:
            marks = np.quantile([ratio(r) for r in own], QUANTILES)
            rows.append([name, str(len(own)), *(f"{m:.2g}" for m in marks)])
    return _table(head, rows)


def _table(head: list[str], rows: list[list[str]]) -> list[str]:
    lines = [head, ["---"] * len(head), *rows]
    return ["| " + " | ".join(cells) + " |" for cells in lines]


def share(run: Record, part: str) -> float:
    """Share of one part in the stated error."""
    return float((run[f"{part}_m"] or 0.0) / run["estimated_tip_error_m"])


def largest_part(run: Record) -> str:
    """The largest part of the stated error."""
    return max(PARTS, key=lambda part: share(run, part))


def _part_lines(judged: list[Record]) -> list[str]:
    if not judged:
        return []
    rows = []
    for part in PARTS:
        shares = np.array([share(r, part) for r in judged])
        quarter, half, most = np.quantile(shares, [0.25, 0.5, 0.75])
        largest = sum(largest_part(r) == part for r in judged)
        spread = f"{_percent(half)} ({_percent(quarter)} to {_percent(most)})"
        rows.append([part, spread, str(largest)])
    head = ["part", "share of the stated error: median (quartiles)", "largest part in so many"]
    return _table(head, rows)


def _cost_lines(found: Found) -> list[str]:
    """Cost of the error estimate relative to the first solution."""
    runs = [r for r in (*found.judged, *found.unsure) if r["index"] in found.plain]
    if not runs:
        return []
    solving = [_spent(r) / _spent(found.plain[r["index"]]) for r in runs]
    trip = [r["wall_s"] / found.plain[r["index"]]["wall_s"] for r in runs]
    rows = []
    for name, values in (("building and solving", solving), ("the whole call", trip)):
        low, half, high = np.quantile(values, [0.1, 0.5, 0.9])
        rows.append([name, f"{half:.3g}", f"{low:.3g} to {high:.3g}"])
    walls = np.quantile([r["wall_s"] for r in runs], [0.5, 0.9])
    return [
        *_table(["time with verification over time without", "median", "10 % to 90 %"], rows),
        "",
        f"The whole call with verification takes {walls[0]:.2g} s in the median, {walls[1]:.2g} s "
        "at the 90th percentile.",
    ]


def _spent(run: Record) -> float:
    """Building and solving, every solution of the call [s]."""
    cost = run["cost"]
    return float(cost["build_s"] + cost["solve_s"] + cost["verify_s"])


def _misses(judged: list[Record]) -> list[str]:
    """Scenes whose true error is above the stated one."""
    over = sorted((r for r in judged if ratio(r) > 1), key=ratio, reverse=True)
    if not over:
        return ["None."]
    rows = [
        [
            str(r["index"]),
            f"{ratio(r):.3g}",
            *(f"{r[key] / r['requested_m']:.3g}" for key in ("true_m", "estimated_tip_error_m")),
            *(_percent(share(r, part)) for part in PARTS),
            str(r["settings"]["solver"]),
        ]
        for r in over
    ]
    head = ["scene", "true / stated", "true, relative to the accuracy", "stated", *PARTS, "solver"]
    return _table(head, rows)


def _without_error(found: Found) -> list[tuple[int, str]]:
    """Scenes without a stated error, and their reasons."""
    heard = {r["index"] for r in (*found.judged, *found.unsure, *found.silent)}
    said = [(r["index"], str(r["failure"])) for r in found.silent]
    gone = [(r["index"], r["note"] or "said nothing") for r in found.ends]
    return sorted(said + [(k, note) for k, note in gone if k not in heard])


def _not_judged(found: Found) -> list[str]:
    rows = [[str(r["index"]), _why_unsure(r)] for r in found.unsure]
    rows += [[str(k), " ".join(note.split())[-160:]] for k, note in _without_error(found)]
    if not rows:
        return ["None."]
    return _table(["scene", "why"], sorted(rows, key=lambda row: int(row[0])))


def _why_unsure(run: Record) -> str:
    stated = run["estimated_tip_error_m"] / run["requested_m"]
    if run["reference_m"] is None:
        return f"no reference; stated {stated:.3g} accuracies"
    own, true = (run[key] / run["requested_m"] for key in ("reference_m", "true_m"))
    return f"stated {stated:.3g}, true {true:.3g}, uncertainty of the reference {own:.3g}"


def draw_figure(found: Found, path: Path) -> None:
    """Stated against true error, and the distribution of their ratio."""
    import matplotlib.pyplot as plt

    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.4), layout="constrained")
    _draw_errors(left, found.judged)
    _draw_ratios(right, found.judged)
    figure.savefig(path, dpi=110)
    plt.close(figure)


COLOURS = {"time": "#3b4a8a", "space": "#c2703d", "omitted": "#4f8f5b"}
MARKERS = {"time": "o", "space": "s", "omitted": "^"}


def _draw_errors(axes: Axes, judged: list[Record]) -> None:
    for part in PARTS:
        own = [r for r in judged if largest_part(r) == part]
        true = [r["true_m"] / r["length_m"] for r in own]
        stated = [r["estimated_tip_error_m"] / r["length_m"] for r in own]
        marks = {"ms": 5, "alpha": 0.75, "color": COLOURS[part], "label": part}
        axes.loglog(true, stated, MARKERS[part], **marks)
    low, high = axes.get_xlim()
    line = np.array([low, high])
    for factor, style, name in ((1.0, "-", "1:1"), (0.5, "--", "2:1"), (TIGHT, ":", "1:10")):
        axes.plot(line, factor * line, color="black", lw=1, ls=style, label=f"true : stated {name}")
    axes.set_xlim(low, high)
    marked = np.array([r["estimated_tip_error_m"] / r["length_m"] for r in judged])
    axes.set_ylim(marked.min() / 3, 3 * marked.max())
    axes.set_xlabel("true error, over the length")
    axes.set_ylabel("stated error, over the length")
    axes.legend(loc="lower right", fontsize="small", title="largest part, and lines")


def _draw_ratios(axes: Axes, judged: list[Record]) -> None:
    ratios = np.sort([ratio(r) for r in judged])
    axes.set_xlim(min(ratios[0] / 2, 0.05), max(2 * ratios[-1], 5.0))
    axes.step(ratios, np.arange(1, len(ratios) + 1) / len(ratios), where="post", color="#3b4a8a")
    axes.set_xscale("log")
    for at, style in ((1.0, "-"), (WORST, "--"), (1 / TIGHT, ":")):
        axes.axvline(at, color="black", lw=1, ls=style)
    axes.axhline(COVERED, color="0.6", lw=1)
    axes.axhline(1 - SHARP, color="0.6", lw=1)
    across = axes.get_yaxis_transform()
    for height, name in ((COVERED, _percent(COVERED)), (1 - SHARP, _percent(1 - SHARP))):
        axes.text(0.01, height - 0.01, name, transform=across, va="top", color="0.4")
    for at, name in ((1.0, "1:1"), (WORST, "2:1"), (1 / TIGHT, "1:10")):
        axes.annotate(name, (at, 0.03), xytext=(3, 0), textcoords="offset points")
    axes.set_ylim(0, 1.02)
    axes.set_xlabel("ratio of true to stated error")
    axes.set_ylabel("fraction of the scenes below")
