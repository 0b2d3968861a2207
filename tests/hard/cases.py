"""The table of hard cases: every one with its criterion, solved by the default settings."""

from __future__ import annotations

from tests.hard import found_cases, network_cases, rod_cases
from tests.hard.case import Case

CASES: tuple[Case, ...] = (*network_cases.CASES, *rod_cases.CASES, *found_cases.CASES)
