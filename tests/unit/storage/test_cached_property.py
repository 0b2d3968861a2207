"""Properties that are computed once, whoever else computes theirs meanwhile."""

from __future__ import annotations

import re
from concurrent.futures import ThreadPoolExecutor
from threading import Barrier

from tests.architecture import PACKAGE
from viscodesign.storage import cached_property as module
from viscodesign.storage.cached_property import cached_property


class Meeting:
    """Its property is there once two threads compute it at the same time."""

    together = Barrier(2)

    def __init__(self, number: int) -> None:
        self.number, self.computed = number, 0

    @cached_property
    def double(self) -> int:
        """Twice the number."""
        self.together.wait(timeout=30.0)
        self.computed += 1
        return 2 * self.number


def test_two_objects_do_not_wait_for_each_other() -> None:
    meetings = [Meeting(1), Meeting(2)]
    with ThreadPoolExecutor(2) as pool:
        assert list(pool.map(lambda meeting: meeting.double, meetings)) == [2, 4]
    assert [meeting.double for meeting in meetings] == [2, 4]
    assert [meeting.computed for meeting in meetings] == [1, 1]


def test_a_class_shows_the_property_itself() -> None:
    assert isinstance(Meeting.__dict__["double"], cached_property)
    assert Meeting.double.__doc__ == "Twice the number."


def test_the_package_has_no_property_that_locks_its_whole_class() -> None:
    locking = re.compile(r"from functools import .*cached_property|functools\.cached_property\(")
    found = {path for path in PACKAGE.rglob("*.py") if locking.search(path.read_text())}
    assert found == {PACKAGE / "storage" / "cached_property.py"}
    assert module.__file__ is not None
