"""Runs that nobody had to solve."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.trajectories import made_run
from viscodesign.results.trajectory import Trajectory

Made = Callable[..., Trajectory]


@pytest.fixture
def made() -> Made:
    """Makes a run; see `made_run`."""
    return made_run


@pytest.fixture(scope="session")
def run() -> Trajectory:
    """The paper's leg and pulse."""
    return made_run()
