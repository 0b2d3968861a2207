"""A design as lines of text: how near it comes, its numbers, and what else was found."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from viscodesign.cli.texts.layout import and_more, number, seconds, table
from viscodesign.results.findings import outside_words
from viscodesign.results.path_design import PathDesign

MAX_DESIGN_ROWS = 24


def design_lines(found: PathDesign, folder: Path, files: Sequence[Path]) -> list[str]:
    """The answer, then numbers, alternatives, effort and files."""
    return [
        f"{found.name}: {found.status.replace('_', ' ')}",
        *table(list(_answer(found))),
        *_numbers(found),
        "",
        *table(
            [
                ("effort", "; ".join(_effort(found))),
                ("files", f"{folder}: {', '.join(_short(file, folder) for file in files)}"),
            ]
        ),
    ]


def _answer(found: PathDesign) -> Iterator[tuple[str, str]]:
    if found.rms_m is not None and found.worst_m is not None:
        yield "search", f"{_mm(found.rms_m)} rms, at most {_mm(found.worst_m)}"
    if found.confirmed_rms_m is not None and found.confirmed_worst_m is not None:
        stated = (
            "" if found.stated_error_m is None else f", stated error {_mm(found.stated_error_m)}"
        )
        words = f"{_mm(found.confirmed_rms_m)} rms, at most {_mm(found.confirmed_worst_m)}"
        yield "confirmed", f"{words}{stated} (allowed {_mm(found.tolerance_m)})"
    if found.excess_m is not None:
        yield "excess", f"the found path is at most {_mm(found.excess_m)} from the wanted one"
    if found.confirmed_rms_m is not None:
        yield "effects", ", ".join(found.effects) or "none"
    if found.violations:
        yield "validity", f"{outside_words(found.violations)}; the stated error does not count it"
    if found.band.size:
        yield "band", f"{_mm(found.widest_band_m)} by one percent of each free number"
    if found.reason:
        yield "reason", found.reason
    if found.hint:
        yield "hint", found.hint
    if len(found.alternatives) > 1:
        yield "also", f"{len(found.alternatives) - 1} designs that are better in something else"


def _effort(found: PathDesign) -> Iterator[str]:
    yield f"{found.evaluations} solutions, {seconds(found.wall_s)}"
    if found.ended_by_budget:
        yield "ended by its budget: another run may find another design"
    if found.lost_graphs:
        yield f"a process died, and {found.lost_graphs} graphs were not tried"


def _numbers(found: PathDesign) -> list[str]:
    if found.graph and not found.parameters:
        return ["", f"  graph  {', '.join(found.graph)}"]
    rows = [(key, number(value, _unit(found, key))) for key, value in found.parameters.items()]
    tail = and_more(len(rows), MAX_DESIGN_ROWS, "result.json")
    return ["", *table(rows[:MAX_DESIGN_ROWS]), *tail] if rows else []


def _mm(length_m: float | None) -> str:
    return "unknown" if length_m is None else f"{number(1e3 * length_m)} mm"


def _short(file: Path, folder: Path) -> str:
    return str(file.relative_to(folder))


def _unit(found: PathDesign, key: str) -> str:
    unit = found.units.get(key, "1")
    return "" if unit == "1" else unit
