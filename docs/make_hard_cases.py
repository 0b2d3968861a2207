"""Solve every hard case and tabulate the outcomes: python docs/make_hard_cases.py

Fills the block of `docs/hard-cases.md`; the rest of that page is written by hand.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

DOCS = Path(__file__).parent
sys.path[:0] = [str(DOCS.parent), str(DOCS)]

from make_pages import fill, table  # noqa: E402

from tests.hard.case import Case, Outcome, outcome  # noqa: E402
from tests.hard.cases import CASES  # noqa: E402

MESSAGE_CHARACTERS = 160


def main() -> None:
    """Solve every case, print its row, and fill the page."""
    rows, failed, began = [], 0, time.perf_counter()
    for case in CASES:
        start = time.perf_counter()
        found = outcome(case)
        failed += bool(found.complaints)
        rows.append(_row(case, found, time.perf_counter() - start))
        print(" | ".join(rows[-1][:4]), flush=True)
    head = (
        "case",
        "what is hard",
        "expected",
        "outcome",
        "worst finding",
        "volume",
        "energy",
        "steps",
        "time",
    )
    told = (
        f"{len(CASES)} cases, {len(CASES) - failed} as expected, in "
        f"{time.perf_counter() - began:.0f} s.\n\n{table(head, rows)}"
    )
    fill(DOCS / "hard-cases.md", {"cases": told})
    if failed:
        raise SystemExit(f"{failed} cases are not as expected")


def _row(case: Case, found: Outcome, seconds: float) -> tuple[str, ...]:
    verdict = found.ending if not found.complaints else f"**{'; '.join(found.complaints)}**"
    if found.message:
        verdict += f": {found.message.replace(chr(10), ' ')[:MESSAGE_CHARACTERS]}"
    run = found.run
    shares = [f for f in found.findings if f.allowed]
    worst = max(shares, key=lambda f: f.share, default=None)
    return (
        case.number,
        case.name,
        case.must,
        verdict,
        "" if worst is None else f"{worst.what}: {worst.share:.2g} of the limit",
        "" if run is None else _size(run.invariants.volume_imbalance_rel),
        "" if run is None else _size(run.invariants.energy_imbalance_rel),
        "" if run is None else str(run.cost.steps),
        f"{seconds:.2f} s",
    )


def _size(value: float | None) -> str:
    return "" if value is None else f"{value:.1e}"


if __name__ == "__main__":
    main()
