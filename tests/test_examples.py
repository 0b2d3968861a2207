"""The examples run, and print something."""

from __future__ import annotations

import runpy

import pytest

from tests.scenes import ROOT


@pytest.mark.parametrize("example", sorted(p.name for p in (ROOT / "examples").glob("*.py")))
def test_example_runs(example: str, capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(ROOT / "examples" / example))
    assert len(capsys.readouterr().out.splitlines()) >= 2
