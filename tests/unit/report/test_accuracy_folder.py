"""A study's files: whole, replaced by the next study, and at peace with those of a run."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import pytest

from tests.studies import made_study
from tests.trajectories import made_run
from viscodesign.errors import UsageError
from viscodesign.report.accuracy_folder import write_study
from viscodesign.report.folder import STUDY_FILES
from viscodesign.report.run_folder import write_run

POINT_COLUMNS = "model,edges,tolerance,solver,solve_s,build_s,tip_error_m,tip_error_rel,dominated"


def names(folder: Path) -> set[str]:
    return {file.name for file in folder.iterdir()}


def test_all_files_are_written_and_returned_in_order(tmp_path: Path) -> None:
    written = write_study(made_study(), tmp_path / "deep" / "study")
    assert tuple(file.name for file in written) == STUDY_FILES.names
    assert names(tmp_path / "deep" / "study") == set(STUDY_FILES.names)
    assert written[2].read_bytes().startswith(b"\x89PNG")


def test_the_table_has_exactly_its_columns_and_every_digit(tmp_path: Path) -> None:
    study = made_study()
    table = write_study(study, tmp_path, plots=False)[0].read_text()
    assert table.splitlines()[0] == POINT_COLUMNS
    rows = list(csv.DictReader(table.splitlines()))
    assert len(rows) == len(study.points)
    for row, point in zip(rows, study.points, strict=True):
        assert float(row["tip_error_m"]) == point.tip_error_m
        assert int(row["edges"]) == point.edges
        assert row["dominated"] == ("true" if point.dominated else "false")


def test_the_document_is_complete() -> None:
    study = made_study()
    told = study.document(0.02)
    assert set(told) >= {
        "name", "version", "spec_sha256", "status", "reference", "requested", "points",
        "recommended", "table", "notes",
    }  # fmt: skip
    assert told["reference"]["settings"] == {
        "effects": [*list(study.taken), "feedback"], "edges": 16, "tolerance": 1e-7,
        "solver": "rosenbrock",
    }  # fmt: skip
    assert told["reference"]["convergence_rel"] == 6.7e-6
    assert told["recommended"]["solve_s"] == 0.012
    assert told["recommended"]["set"] == []
    assert [row["tip_error_rel"] for row in told["table"]] == [0.01, 0.005, 0.001, 0.0001]
    assert told["budget"]["most_accurate"]["solve_s"] == 0.020
    assert "budget" not in study.document()
    json.dumps(told, allow_nan=False)


def test_a_study_without_a_point_has_a_table_and_a_document(tmp_path: Path) -> None:
    write_study(made_study(), tmp_path)
    bare = made_study(points=(), start=None, reference=None, status="interrupted")
    write_study(bare, tmp_path)
    assert names(tmp_path) == {"accuracy.csv", "accuracy.json"}
    assert (tmp_path / "accuracy.csv").read_text() == POINT_COLUMNS + "\n"
    told = json.loads((tmp_path / "accuracy.json").read_text())
    assert told["status"] == "interrupted"
    assert told["reference"] is None
    assert told["recommended"] is None


def test_a_run_and_a_study_share_a_folder(tmp_path: Path) -> None:
    run = made_run()
    write_run(run, tmp_path, plots=False)
    before = {file.name: file.read_bytes() for file in tmp_path.iterdir()}
    write_study(made_study(), tmp_path)
    assert names(tmp_path) == set(before) | set(STUDY_FILES.names)
    assert {name: (tmp_path / name).read_bytes() for name in before} == before
    studied = {name: (tmp_path / name).read_bytes() for name in STUDY_FILES.names}
    write_run(run, tmp_path, plots=False)
    assert {name: (tmp_path / name).read_bytes() for name in STUDY_FILES.names} == studied


def test_a_run_goes_where_a_study_was(tmp_path: Path) -> None:
    write_study(made_study(), tmp_path)
    (tmp_path / "notes.txt").write_text("mine")
    write_study(made_study(), tmp_path, plots=False)
    write_run(made_run(), tmp_path, plots=False)
    assert (tmp_path / "notes.txt").read_text() == "mine"
    assert "accuracy.png" not in names(tmp_path)
    assert "accuracy.csv" in names(tmp_path)


def test_a_folder_with_other_files_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text("mine")
    with pytest.raises(UsageError, match=r"holds other files \(a\.txt\)"):
        write_study(made_study(), tmp_path)
    assert names(tmp_path) == {"a.txt"}
    write_study(made_study(), tmp_path, plots=False, force=True)
    assert names(tmp_path) == {"a.txt", "accuracy.csv", "accuracy.json"}
