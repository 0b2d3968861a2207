"""What a library writes to standard error below Python is held back, and only that."""

from __future__ import annotations

import os

import pytest

from viscodesign.solve.solvers.quiet_stderr import quiet_stderr


def test_nothing_comes_through_and_then_everything(capfd: pytest.CaptureFixture[str]) -> None:
    with quiet_stderr():
        os.write(2, b"a step failed\n")
    os.write(2, b"told again\n")
    assert capfd.readouterr().err == "told again\n"


def test_it_ends_with_an_error_too(capfd: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(RuntimeError, match="no step"), quiet_stderr():
        raise RuntimeError("no step")
    os.write(2, b"told again\n")
    assert capfd.readouterr().err == "told again\n"
