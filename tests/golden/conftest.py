"""Fixtures of the golden tests."""

from __future__ import annotations

import pytest


@pytest.fixture
def golden(request: pytest.FixtureRequest) -> str:
    """What to do with golden results: `check`, `exact` or `update`."""
    return str(request.config.getoption("--golden"))
