"""A command line called as a user calls it, and a run that nobody had to solve."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from viscodesign.cli.main import main
from viscodesign.trajectory import (
    Accuracy,
    Classification,
    Cost,
    Invariants,
    Notice,
    Scales,
    Trajectory,
    Verdict,
)

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
    """The default spec."""
    return CONFIGS / "leg_16_straight_air.yaml"


@pytest.fixture
def classification() -> Classification:
    """The paper's leg in quadrant III."""
    return Classification(
        name="leg",
        scales=Scales(t_s=0.0292, t_f=0.157, t_i=0.67, t_net=1.04),
        quadrant="III",
        meaning="pressure distribution, input on the fluid's timescale",
        cutoff_frequency_hz=63.7,
    )


@pytest.fixture
def trajectory(classification: Classification) -> Trajectory:
    """Two bellows, three times, one warning twice and another once."""
    times = np.array([0.0, 0.5, 1.0])
    tip = np.array([[0.0, 0.109, 0.0], [0.02, 0.1, 0.4], [-0.01, 0.105, -0.2]])
    shape = np.zeros((3, 2, 2))
    shape[:, 1, :] = tip[:, :2]
    return Trajectory(
        name="leg",
        status="complete",
        time=times,
        tip=tip,
        inlet_pressure={"inlet": np.array([0.0, 1e3, 2e3])},
        bellows=("R1", "L1"),
        pressure=np.zeros((3, 2)),
        volume=np.full((3, 2), 2.16e-6),
        tubes=("inlet-R1", "R1-L1"),
        flow=np.zeros((3, 2)),
        arc=np.array([0.0, 0.109]),
        shape=shape,
        length=0.109,
        width=0.03,
        classification=classification,
        effects=(
            Verdict("inertia", "auto", False, 0.0019, "(t_s/t_i)^2", "left out: weight small"),
            Verdict("feedback", "on", True, 0.3, "da/dN against da/dp", "taken as the spec says"),
        ),
        accuracy=Accuracy(requested_m=0.000545, estimated_tip_error_m=0.000109, method="refined"),
        cost=Cost(build_s=0.1, solve_s=0.2, verify_s=0.3, steps=123),
        invariants=Invariants(volume_imbalance_rel=1e-12),
        warnings=(
            Notice("negative_volume", "below its floor", where="R1", time_s=0.25),
            Notice("negative_volume", "below its floor", where="L1", time_s=0.5),
            Notice("reynolds", "turbulent", where="inlet-R1"),
        ),
        spec_text="name: leg\n",
        spec_sha256="0" * 64,
        version="0.1.0",
    )
