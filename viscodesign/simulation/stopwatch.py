"""Where the time of a simulation goes."""

from __future__ import annotations

import time as clock
from collections import defaultdict
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace

from viscodesign.results.trajectory import Cost


class Stopwatch:
    """Wall time since it was made, and of parts of that [s]."""

    def __init__(self) -> None:
        self._began = clock.perf_counter()
        self._spent: defaultdict[str, float] = defaultdict(float)

    @contextmanager
    def __call__(self, part: str) -> Iterator[None]:
        """Count what is done within it as this part."""
        began = clock.perf_counter()
        try:
            yield
        finally:
            self._spent[part] += clock.perf_counter() - began

    def share_out(self, cost: Cost, *, is_only_solution: bool) -> Cost:
        """A cost whose parts sum to all that was spent so far.

        ``cost`` has what building, solving and reading the solution took that is returned. The
        rest went into other solutions, or, if there were none, into reading this one.
        """
        known = replace(
            cost, choose_s=self._spent["choose"], read_s=cost.read_s + self._spent["read"]
        )
        rest = max(clock.perf_counter() - self._began - known.total_s, 0.0)
        if is_only_solution:
            return replace(known, read_s=known.read_s + rest)
        return replace(known, verify_s=rest)
