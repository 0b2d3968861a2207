"""Columns and documents have the names of the public interface and survive JSON."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import numpy as np

from tests.trajectories import ABLATIONS, CLASSIFICATION, ablated_run, made_run
from viscodesign.results.findings import (
    Scales,
    Verdict,
    check_document,
    classification_document,
    json_ready,
)


def test_a_summary_has_its_sections_and_only_numbers_that_json_can_represent() -> None:
    constant = replace(CLASSIFICATION, scales=Scales(0.029, 0.16, math.inf, 1.1))
    document = replace(made_run(), classification=constant).summary()
    assert json.loads(json.dumps(document, allow_nan=False)) == document
    assert document["scales"]["t_i"] is None
    assert document["ratios"]["ts_over_ti"] == 0.0
    assert document["invariants"]["energy_imbalance_rel"] is None
    assert set(document) >= {
        "name", "version", "spec_sha256", "status", "scales", "ratios", "quadrant", "effects",
        "accuracy", "cost", "invariants", "warnings", "metrics",
        "validity", "provenance",
    }  # fmt: skip
    assert set(document["effects"][0]) == {
        "name", "mode", "taken", "weight", "formula", "reason", "contribution_m", "budget_share", "present",
        "traits",
    }  # fmt: skip
    assert document["effects"][0]["taken"] is False
    assert document["validity"] == {"state": "inside", "reasons": []}
    assert set(document["warnings"][0]) == {"code", "message", "where", "time_s"}


def test_measured_effects_are_in_the_summary_only_if_there_are_any() -> None:
    assert "proof" not in made_run().summary()
    proof = ablated_run().summary()["proof"]
    assert [p["name"] for p in proof] == [p.name for p in ABLATIONS]
    assert proof[0] == {
        "name": "fluid_mass", "taken": False, "estimated_m": 4.3e-6, "measured_m": 3.9e-6,
        "solve_s": 1.1, "note": "",
    }  # fmt: skip
    told = {p["name"]: p for p in proof}
    assert told["flow_regime"]["estimated_m"] is None
    assert told["gas_compressibility"]["measured_m"] is None
    assert told["gas_compressibility"]["note"] == "bellows empty at t = 0.7 s"
    assert json.dumps(proof, allow_nan=False)


def test_a_check_and_a_classification_use_the_same_names() -> None:
    verdicts = [Verdict("inertia", "on", True, math.nan, "t_s / t_i", "asked for")]
    document = check_document(CLASSIFICATION, verdicts, ["16 bellows"])
    assert document["effects"][0]["weight"] is None
    assert document["facts"] == ["16 bellows"]
    assert classification_document(CLASSIFICATION).items() <= document.items()


def test_numbers_of_numpy_are_plain() -> None:
    given = {"a": np.float64(math.inf), "b": np.bool_(True), "c": np.int64(3), "d": np.arange(2)}
    assert json_ready(given) == {"a": None, "b": True, "c": 3, "d": [0, 1]}
    assert json_ready(given)["b"] is True
