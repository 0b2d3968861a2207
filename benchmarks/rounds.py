"""The command of a benchmark that measures scenes in rounds, and reports."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

Record = dict[str, Any]


def measure_and_report(
    doc: str,
    rounds: int,
    results: Path,
    names: Iterable[str],
    measure: Callable[[str, int], Record],
    report: Callable[[list[Record]], list[str]],
) -> None:
    """Measure every name in so many rounds, unless only a report is asked for, and write the page.

    ``doc``: of the benchmark; its first line is what `--help` says. ``rounds``: unless others are
    asked for. The page stands beside ``results``, JSON lines.
    """
    parser = argparse.ArgumentParser(description=doc.splitlines()[0])
    parser.add_argument("--rounds", type=int, default=rounds)
    parser.add_argument("--report", action="store_true", help="only report")
    given = parser.parse_args()
    if not given.report:
        lines = [measure(name, given.rounds) for name in names]
        results.write_text("".join(json.dumps(line) + "\n" for line in lines))
    records = [json.loads(line) for line in results.read_text().splitlines()]
    results.with_suffix(".md").write_text("\n".join(report(records)) + "\n")
