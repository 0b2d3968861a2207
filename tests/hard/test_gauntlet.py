"""Every hard case, solved with default settings or refused by name."""

from __future__ import annotations

import pytest

from tests.hard.case import Case, moved_by_refinement, outcome
from tests.hard.cases import CASES
from tests.thorough import ALL

LONG = {"21b", "32", "37a", "42"}
"""Cases that take a third of the time of all, for what their neighbours have in small."""
TRIED = [case for case in CASES if ALL or case.number not in LONG]


@pytest.mark.parametrize("case", TRIED, ids=lambda case: f"{case.number} {case.name}")
def test_case(case: Case) -> None:
    found = outcome(case)
    assert not found.complaints
    if found.ending == "complete" and case.converges:
        assert found.run is not None
        finding = moved_by_refinement(case, found.run)
        assert finding.holds, str(finding)


def test_numbers_are_unique() -> None:
    numbers = [case.number for case in CASES]
    assert len(set(numbers)) == len(numbers)
