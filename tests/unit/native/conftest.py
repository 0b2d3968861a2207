"""Native code of these tests goes to a folder of its own."""

from __future__ import annotations

from pathlib import Path

import pytest

from viscodesign.native.code_cache import FOLDER_VARIABLE


@pytest.fixture(autouse=True)
def cache(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The cache folder; common to all tests of a process, so that the loops compile once."""
    folder = tmp_path_factory.getbasetemp() / "native_cache"
    monkeypatch.setenv(FOLDER_VARIABLE, str(folder))
    return folder / "native"
