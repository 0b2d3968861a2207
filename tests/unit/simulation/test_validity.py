"""Whether a run stays within its model, and what it was computed with."""

from __future__ import annotations

import platform

import casadi
import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import Trajectory, __version__, simulate

SHORT = ("bellows.count=4", "run={duration: 1 s, output_interval: 20 ms}")


def solved(*overrides: str) -> Trajectory:
    return simulate(leg(*SHORT, *overrides), verify=False)


def reasons(run: Trajectory) -> list[str]:
    validity = run.summary()["validity"]
    assert (validity["state"] == "outside") is bool(validity["reasons"])
    assert all(set(r) == {"code", "message", "where", "time_s"} for r in validity["reasons"])
    return [reason["code"] for reason in validity["reasons"]]


def test_a_gentle_run_is_inside() -> None:
    run = solved("input={kind: sine, amplitude: 5 kPa, frequency: 1 Hz}", "fluid=water")
    assert reasons(run) == []


@pytest.mark.parametrize(("mode", "found"), [("off", ["turbulent_flow"]), ("on", [])])
def test_what_an_active_effect_models_does_not_call_for_more(mode: str, found: list[str]) -> None:
    run = solved(
        "fluid=water",
        "network.tube_radius=1 mm",
        "input={kind: sine, amplitude: 10 kPa, frequency: 1 Hz}",
        f"effects={{pressure_distribution: on, flow_regime: {mode}, others: off}}",
    )
    assert reasons(run) == found
    for reason in run.violations:
        assert reason.where == "inlet-R1"
        assert 0 < (reason.time_s or 0.0) < 1
        assert reason in run.warnings


@pytest.mark.parametrize(
    ("effects", "where"),
    [("off", "R1"), ("{pressure_distribution: on, others: off}", "input")],
    ids=["in every bellow", "at the inlet alone"],
)
def test_below_the_vapour_pressure(effects: str, where: str) -> None:
    """Thin tubes keep the bellows from following."""
    run = solved(
        "fluid=water",
        "network.tube_radius=0.2 mm",
        "input={kind: table, rows: [[0, 0], [0.1 s, 0], [20 s, -100 kPa]]}",
        "run.duration=20 s",
        "bellows.area_per_pressure=1e-10",
        f"effects={effects}",
    )
    assert reasons(run) == ["cavitation"]
    assert run.violations[0].where == where


@pytest.mark.parametrize("interval", ["20 ms", "1 s"])
def test_it_does_not_depend_on_the_outputs(interval: str) -> None:
    """Where the motion leaves the model between two outputs, at which it is at rest."""
    run = solved(
        "input={kind: sine, amplitude: 60 kPa, frequency: 1 Hz}",
        "effects={pressure_distribution: on, others: off}",
        f"run.output_interval={interval}",
    )
    assert reasons(run) == ["negative_volume", "choking", "turbulent_flow"]
    lowest, fastest, _ = run.violations
    assert lowest.time_s == pytest.approx(0.782, abs=0.01)
    assert fastest.message.startswith("the gas reaches Mach 0.87")


def test_large_stretches_are_outside() -> None:
    run = solved(
        "input={kind: constant, value: 900 kPa}",
        "effects=off",
        "bellows.extension_per_pressure=0.3 m",
    )
    assert reasons(run) == ["large_stretch", "large_volume"]
    assert run.validity == "outside"


def test_other_warnings_are_no_reasons() -> None:
    run = solved("effects={pressure_distribution: off, others: auto}")
    assert "needed_effect_off" in [notice.code for notice in run.warnings]
    assert "needed_effect_off" not in reasons(run)


def test_provenance() -> None:
    run = solved("effects=off")
    found = run.summary()["provenance"]
    assert found["version"] == __version__
    assert found["python"] == platform.python_version()
    assert found["packages"]["numpy"] == np.__version__
    assert found["packages"]["casadi"] == casadi.__version__
    assert platform.machine() in found["platform"]
    assert found["settings"] == run.summary()["settings"]
