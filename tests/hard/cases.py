"""The table of hard cases, each with its criterion, solved with default settings."""

from __future__ import annotations

from tests.hard import (
    buckling_cases,
    found_cases,
    gas_cases,
    limit_cases,
    linear_cases,
    network_cases,
    rod_cases,
    snap_cases,
)
from tests.hard.case import Case

CASES: tuple[Case, ...] = (
    *network_cases.CASES,
    *linear_cases.CASES,
    *gas_cases.CASES,
    *buckling_cases.CASES,
    *rod_cases.CASES,
    *limit_cases.CASES,
    *snap_cases.CASES,
    *found_cases.CASES,
)
