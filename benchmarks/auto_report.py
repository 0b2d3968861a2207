"""The report of the study of `effects: auto`, computed from its result lines only."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from scene_runs import Record, read

from viscodesign.simulation.judged_effects import JUDGING

TIGHT = 10.0
CONFIDENCE = 0.95
RUNS = ("auto", "all")


def write_report(path: Path, seed: int) -> None:
    """Write a Markdown page beside the result lines."""
    records = read(path)
    text = "\n".join(report_lines(records, seed))
    path.with_suffix(".md").write_text(text + "\n")
    print(text)


def report_lines(records: list[Record], seed: int) -> list[str]:
    """The page."""
    scenes = [r for r in records if r["kind"] == "scene"]
    judged = [r for r in scenes if r["auto"]["stated_m"] and "true_m" in r["auto"]]
    ends = [r for r in records if r["kind"] == "end"]
    heard = {r["index"] for r in judged}
    return [
        "# What does `effects: auto` cost and promise?",
        "",
        f"{len(ends)} scenes of seed {seed}, in turn over the plane of timescales "
        "(`benchmarks/scene_draw.py`) and such that ring (`benchmarks/ringing_draw.py`), each "
        "solved with chosen effects and with everything on, both verified. Regenerate with "
        "`python benchmarks/auto_study.py`.",
        "",
        "**What is independent.** The settings of the coarser solution were chosen on scenes of "
        f"seed 11, what is stated ({JUDGING.stated_per_measured:g} times the distance, and the "
        "estimates) on scenes of seeds 70707 and 31337; scenes of this seed had not been run "
        f"before. At least {JUDGING.stated_per_estimated:g} times the estimates are stated because "
        "of scenes 7 of seed 5051 and 4 and 52 of seed 31337; a third solution is asked "
        "for because of scenes 10 of seed 7717 and 21, 26 and 33 of seed 31337. These seeds "
        "therefore do not judge it. The reference is this program's own: everything on, a finer "
        "mesh, a smaller tolerance. It tells errors of choice, steps and mesh, not those of the "
        "equations.",
        "",
        *(line for r in records if r["kind"] == "note" for line in (r["text"], "")),
        f"Compared: {len(judged)} scenes. Not compared: {len(ends) - len(judged)}; a scene has "
        "120 s of CPU for all of its runs and its reference, so the costly ones are missing.",
        "",
        "## The error",
        "",
        *_error_lines(judged),
        "",
        "## The cost",
        "",
        *_cost_lines(judged),
        "",
        "## Scenes not compared",
        "",
        *_others(ends, scenes, heard),
    ]


def _error_lines(judged: list[Record]) -> list[str]:
    if not judged:
        return ["None yet."]
    ratios = np.array([r["auto"]["true_m"] / r["auto"]["stated_m"] for r in judged])
    shares = np.array([r["auto"]["true_m"] / r["auto"]["requested_m"] for r in judged])
    over, missed, count = int(np.sum(ratios > 1)), int(np.sum(shares > 1)), len(ratios)
    quarters = ", ".join(f"{q:.2g}" for q in np.quantile(ratios, [0.25, 0.5, 0.75]))
    return [
        "| | |",
        "|---|---|",
        f"| true error above the stated one | {over} of {count}, "
        f"below {100 * _upper_bound(over, count):.2g} % at 95 % |",
        f"| true error above the accuracy asked for | {missed} of {count}, "
        f"below {100 * _upper_bound(missed, count):.2g} % at 95 % |",
        f"| stated error at most {TIGHT:g} times the true one | "
        f"{100 * np.mean(ratios * TIGHT >= 1):.3g} % |",
        f"| true over stated: quartiles, largest | {quarters}, {ratios.max():.2g} |",
        f"| runs repeated with more effects | {sum(r['auto']['repeated'] > 0 for r in judged)} |",
    ]


def _upper_bound(hits: int, count: int) -> float:
    """Rate that as few hits exclude with 95 % confidence (Clopper and Pearson)."""
    from scipy.stats import beta

    return float(beta.ppf(CONFIDENCE, hits + 1, count - hits)) if hits < count else 1.0


def _cost_lines(judged: list[Record]) -> list[str]:
    groups = {
        "all": judged,
        "over the plane": [r for r in judged if r["index"] % 2 == 0],
        "that ring": [r for r in judged if r["index"] % 2],
        "where the chosen rod has no inertia": [r for r in judged if r["is_quasi_static"]],
    }
    lines = [
        "CPU time of `auto` over that of everything on: median, and 10 % to 90 %. Both have to "
        "estimate every effect, `auto` in a few more sets.",
        "",
        "| scenes | count | again in one process | again, effects weighed anew | the first time |",
        "|---|---|---|---|---|",
    ]
    for name, own in groups.items():
        if own:
            found = [
                _spread([cost(r["auto"]) / cost(r["all"]) for r in own])
                for cost in (_again, _anew, _first)
            ]
            lines.append(f"| {name} | {len(own)} | " + " | ".join(found) + " |")
    return [*lines, "", *_time_lines(groups)]


def _time_lines(groups: dict[str, list[Record]]) -> list[str]:
    """The same as times."""
    lines = [
        "Medians of the CPU times themselves [ms], `auto` and everything on:",
        "",
        "| scenes | again in one process | weighing effects alone | the first time |",
        "|---|---|---|---|",
    ]
    for name, own in groups.items():
        if own:
            pairs = [
                " and ".join(f"{1e3 * np.median([r[who][key] for r in own]):,.0f}" for who in RUNS)
                for key in ("again_s", "choose_s", "first_s")
            ]
            lines.append(f"| {name} | " + " | ".join(pairs) + " |")
    return lines


def _again(run: Record) -> float:
    return float(run["again_s"])


def _anew(run: Record) -> float:
    return float(run["again_s"] + run["choose_s"])


def _first(run: Record) -> float:
    return float(run["first_s"])


def _spread(ratios: list[float]) -> str:
    low, half, high = np.quantile(ratios, [0.1, 0.5, 0.9])
    return f"{half:.2g} ({low:.2g} to {high:.2g})"


def _others(ends: list[Record], scenes: list[Record], heard: set[int]) -> list[str]:
    said = {r["index"]: r for r in scenes}
    rows = [
        f"| {r['index']} | {_why(r, said.get(r['index']))} |"
        for r in sorted(ends, key=lambda end: int(end["index"]))
        if r["index"] not in heard
    ]
    return ["| scene | why |", "|---|---|", *rows] if rows else ["None."]


def _why(end: Record, scene: Record | None) -> str:
    if scene is None:
        return str(end["note"] or "said nothing")[-120:].replace("\n", " ")
    failures = (f"{k}: {str(scene[k]['failure'])[:100]}" for k in ("auto", "all"))
    return "; ".join(failures)
