"""What every test may take for granted of the process it runs in."""

from __future__ import annotations

import os
import signal
import sys
from pathlib import Path

import pytest
from hypothesis import settings

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
"""Matrices are small here: more threads wait for each other, and take cores from other workers."""
TESTS = Path(__file__).parent
os.environ.setdefault("VISCODESIGN_CACHE", str(TESTS.parent / ".pytest_cache" / "kernels"))
"""Leaves the user's own cache alone."""
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
sys.dont_write_bytecode = False
"""Programs under test would compile all of the package at each start: a third of `check`."""
UNIT = TESTS / "unit"


def pytest_addoption(parser: pytest.Parser) -> None:
    """`--golden`: compare with stored results closely, exactly, or write them anew."""
    parser.addoption("--golden", choices=["check", "exact", "update"], default="check")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Unit tests last: they are short, so that parallel workers end together."""
    items.sort(key=lambda item: UNIT in item.path.parents)


def pytest_configure() -> None:
    """Time no example, and let signals reach the programs under test.

    On a busy machine an example may take any time. A shell starts what it runs in the background
    with that signal ignored, and `nohup` that of a closed terminal. Children inherit it: the tests
    of signals would wait for ever.
    """
    if signal.getsignal(signal.SIGHUP) is signal.SIG_IGN:
        signal.signal(signal.SIGHUP, signal.SIG_DFL)
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    settings.register_profile("untimed", deadline=None)
    settings.load_profile("untimed")
