"""A command line called as a user calls it, and a run that nobody had to solve."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from tests.trajectories import CLASSIFICATION, made_run
from viscodesign.cli.main import main
from viscodesign.results.findings import Classification, Notice, Verdict
from viscodesign.results.trajectory import Accuracy, Cost, Trajectory

CONFIGS = Path(__file__).resolve().parents[3] / "configs"


@dataclass(frozen=True)
class Outcome:
    """What a user sees of one command."""

    status: int
    out: str
    err: str


Call = Callable[..., Outcome]


@pytest.fixture
def call(capsys: pytest.CaptureFixture[str]) -> Call:
    """Run one command line in this process: words in; status, stdout and stderr out."""

    def run(*words: str | Path) -> Outcome:
        status = main([str(word) for word in words])
        captured = capsys.readouterr()
        return Outcome(status, captured.out, captured.err)

    return run


@pytest.fixture
def leg() -> Path:
    """The paper's leg, as published."""
    return CONFIGS / "leg_16_straight_air.yaml"


@pytest.fixture
def classification() -> Classification:
    """The paper's leg in quadrant III."""
    return CLASSIFICATION


@pytest.fixture
def trajectory(classification: Classification) -> Trajectory:
    """Two bellows, three times, one warning twice and another once."""
    tip = np.array([[0.0, 0.109, 0.0], [0.02, 0.1, 0.4], [-0.01, 0.105, -0.2]])
    run = made_run(
        name="leg",
        bellows=2,
        time=np.array([0.0, 0.5, 1.0]),
        classification=classification,
        effects=(
            Verdict("inertia", "auto", False, 0.0019, "(t_s/t_i)^2", "left out: weight small"),
            Verdict("feedback", "on", True, 0.3, "da/dN against da/dp", "taken as the spec says"),
        ),
        accuracy=Accuracy(requested_m=0.000545, estimated_tip_error_m=0.000109, method="refined"),
        cost=Cost(build_s=0.1, solve_s=0.2, verify_s=0.3, steps=123),
        warnings=(
            Notice("negative_volume", "below its floor", where="R1", time_s=0.25),
            Notice("negative_volume", "below its floor", where="L1", time_s=0.5),
            Notice("reynolds", "turbulent", where="inlet-R1"),
        ),
    )
    return run.with_arrays(tip=tip)
