"""Designs whose answer is known, and tasks that are refused."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml

from tests.unit.inverse.tasks import PULSE, SPEC, small, task
from viscodesign import PathDesign, design, load, simulate
from viscodesign.cli.texts.design_text import design_lines
from viscodesign.errors import SpecError
from viscodesign.inverse.free_choice import free_choice
from viscodesign.inverse.target_spec import read_target
from viscodesign.results.findings import Notice


@pytest.fixture(scope="module")
def pulse(tmp_path_factory: pytest.TempPathFactory) -> PathDesign:
    wanted = small(input__start=17.3e3, input__drop=38.1e3)
    return design(task(tmp_path_factory.mktemp("pulse"), PULSE, wanted, tolerance="0.02 mm"))


def test_the_pulse_that_made_a_path_is_found(pulse: PathDesign) -> None:
    assert pulse.status == "met"
    assert pulse.parameters["input.start"] == pytest.approx(17.3e3, rel=1e-3)
    assert pulse.parameters["input.drop"] == pytest.approx(38.1e3, rel=1e-3)
    assert pulse.evaluations < 20


def test_its_spec_runs_and_does_what_it_says(pulse: PathDesign) -> None:
    run = simulate(load(pulse.spec_text))
    apart = np.linalg.norm(run.tip[:, :2] - pulse.wanted, axis=1)
    assert float(np.sqrt(np.mean(apart**2))) == pytest.approx(pulse.confirmed_rms_m, rel=1e-6)
    assert run.accuracy.estimated_tip_error_m == pulse.stated_error_m
    assert all(verdict.mode == "auto" for verdict in run.effects)
    assert pulse.document()["validity"] == {"state": "inside", "reasons": []}


def test_a_design_outside_of_what_the_model_describes_says_so(pulse: PathDesign) -> None:
    found = replace(pulse, violations=(Notice("below_vacuum", "no pump reaches that", "input"),))
    assert found.document()["validity"]["reasons"][0]["code"] == "below_vacuum"
    said = "\n".join(design_lines(found, Path("out"), []))
    assert "outside of the model: below_vacuum; the stated error does not count it" in said


def test_lengths_are_found_and_stay_within_bounds(tmp_path: Path) -> None:
    wanted = small(network__tubes=[
        {"from": "inlet", "to": "R1", "length": 0.025}, {"from": "R1", "to": "R2", "length": 0.06},
        {"from": "R2", "to": "L2", "length": 0.05}, {"from": "L2", "to": "L1", "length": 0.03},
    ])  # fmt: skip
    free = {"network.tubes[*].length": ["5 mm", "300 mm"]}
    found = design(task(tmp_path, free, wanted, tolerance="0.02 mm"))
    assert found.status == "met"
    assert all(0.005 <= value <= 0.3 for value in found.parameters.values())
    again = design(tmp_path / "target.yaml")
    assert again.parameters == found.parameters


def test_a_search_may_begin_at_rest(tmp_path: Path) -> None:
    """Without pressure nothing flows, and no tube's length would count."""
    times = [0.0, 3.0, 6.0, 9.0, 12.0]
    moving = small(
        input={"kind": "table", "rows": [[t, p] for t, p in zip(times, PRESSURES, strict=True)]}
    )
    free = {
        "network.tubes[inlet-R1].length": ["5 mm", "300 mm"],
        **{f"input.rows[{k}].pressure": ["-15 kPa", "15 kPa"] for k in range(1, 5)},
    }
    path = task(tmp_path, free, moving, tolerance="0.02 mm")
    resting = {**SPEC, "input": {"kind": "table", "rows": [[t, 0.0] for t in times]}}
    (tmp_path / "spec.yaml").write_text(yaml.safe_dump(resting))
    found = design(path)
    assert found.status == "met"
    assert found.parameters["input.rows[1].pressure"] == pytest.approx(PRESSURES[1], rel=0.02)


PRESSURES = [0.0, 9e3, -6e3, 4e3, 8e3]


def test_what_bounds_forbid_is_not_met_and_names_them(tmp_path: Path) -> None:
    free = {"input.drop": ["10 kPa", "20 kPa"]}
    found = design(task(tmp_path, free, small(), tolerance="0.02 mm"))
    assert found.status == "not_met"
    assert found.parameters["input.drop"] <= 20e3
    assert found.at_bounds == ("input.drop",)
    assert "at their bounds: input.drop" in found.reason
    assert found.confirmed_rms_m == pytest.approx(found.rms_m, rel=0.02)


def test_a_pulse_that_brings_the_tip_back_is_no_loop(tmp_path: Path) -> None:
    wanted = small(run__duration=40.0)
    run = simulate(wanted, verify=False)
    rows = np.column_stack([run.time, run.tip[:, :2]])
    assert np.linalg.norm(rows[-1, 1:] - rows[0, 1:]) < 1e-5
    found = design(task(tmp_path, PULSE, {"rows": rows.tolist()}, tolerance="0.02 mm"))
    assert found.status == "met"
    assert not found.closed


ROWS = {"rows": [[0.0, 0.0, 0.029], [1.0, 0.0, 0.0291]]}
NAMED = {
    "network.tubes[inlet-R1].length": ["10 mm", "60 mm"],
    "network.graph": "tree",
    "network.tubes[R1-R2].length": ["10 mm", "60 mm"],
}
LOOP = {"rows": [[0.0, 0.029], [0.001, 0.03], [-0.001, 0.03], [0.0, 0.029]]}


@pytest.mark.parametrize(
    ("free", "target", "message"),
    [
        ({}, ROWS, "free: nothing is free"),
        ({"input.drop": ["60 kPa", "10 kPa"]}, ROWS, "are reversed"),
        ({"input.drop": [10, "60 kPa"]}, ROWS, "10 has no unit beside '60 kPa'"),
        ({"input.drop": [10, 60]}, ROWS, r"far from the spec's 42 kPa.*\[10 kPa, 60 kPa\]"),
        ({"input": {"drop": [10, 60]}}, ROWS, r"have no unit.*\[10 kPa, 60 kPa\]"),
        ({"network.tubes[*].length": [20, 600]}, ROWS, r"have no unit.*\[20 mm, 600 mm\]"),
        ({"input.drop": "10 kPa"}, ROWS, "expected two bounds"),
        (
            {"network.tube_length": ["1 mm", "2 mm"], "network.tubes[*].length": ["1 mm", "2 mm"]},
            ROWS,
            "overlaps with network.tube_length",
        ),
        ({"input.dorp": ["10 kPa", "60 kPa"]}, ROWS, "did you mean 'input.drop'"),
        ({"network.tube_radius": ["-1 mm", "1 mm"]}, ROWS, "must be above 0"),
        ({"network.graph": "star"}, ROWS, "must be one of keep, chain, tree"),
        ({"network.graph": "keep"}, ROWS, "leaves nothing free"),
        (
            NAMED,
            ROWS,
            r"one of 2 such keys.*write network.tubes\[\*\].length for",
        ),
        (PULSE, {"rows": [[0.0, 0.029]]}, "one point"),
        (PULSE, {"rows": [[0.0, 0.029]] * 3}, "target.rows: the target is one point"),
        (PULSE, {"rows": [[0, 0, 0.029], [0, 0, 0.03]]}, "times must increase"),
        (PULSE, {"rows": [[0, float("nan")], [0, 0.03]]}, "finite number"),
        (PULSE, {"rows": [[0, 0.029], [0, 0.03]], "timing": "given"}, "needs a column of times"),
        (PULSE, {"file": "none.csv"}, "cannot be read"),
        (PULSE, LOOP, "does not repeat"),
        (PULSE, {}, "exactly one of 'file' and 'rows'"),
    ],
)
def test_a_task_without_sense_gets_one_message(
    free: dict[str, Any], target: dict[str, Any], message: str, tmp_path: Path
) -> None:
    with pytest.raises(SpecError, match=message) as caught:
        design(task(tmp_path, free, target))
    (fault,) = caught.value.faults
    assert fault.file.endswith("target.yaml")
    assert fault.line is not None
    assert not fault.key.startswith("free.free")


def test_bounds_without_a_unit_are_si_where_the_spec_is_near(tmp_path: Path) -> None:
    free = {"input.drop": [10e3, 60e3], "network.tube_radius": [2e-4, 2e-3]}
    read = read_target(task(tmp_path, free, ROWS))
    assert [[own.low, own.high] for own in free_choice(read, small()).ranges] == [*free.values()]


def test_a_tolerance_that_a_tip_at_rest_meets_is_refused(tmp_path: Path) -> None:
    """0.15 without a unit is 15 cm."""
    message = "tolerance: 150 mm is no less than the whole path, 100 um: a tip at rest"
    with pytest.raises(SpecError, match=message) as caught:
        design(task(tmp_path, PULSE, ROWS, tolerance=0.15))
    assert caught.value.faults[0].line is not None
