"""Suppressing what a library writes to standard error below Python."""

from __future__ import annotations

import os

import pytest

from viscodesign.solve.solvers.quiet_stderr import quiet_stderr


def test_stderr_is_suppressed_inside_and_restored_after(capfd: pytest.CaptureFixture[str]) -> None:
    with quiet_stderr():
        os.write(2, b"a step failed\n")
    os.write(2, b"told again\n")
    assert capfd.readouterr().err == "told again\n"


def test_stderr_is_restored_after_an_error(capfd: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(RuntimeError, match="no step"), quiet_stderr():
        raise RuntimeError("no step")
    os.write(2, b"told again\n")
    assert capfd.readouterr().err == "told again\n"
