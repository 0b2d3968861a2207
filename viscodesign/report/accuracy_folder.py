"""The files of a study of accuracy, beside those of a run or alone."""

from __future__ import annotations

import csv
import io
import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

from viscodesign.report.run_folder import STUDY_FILES, prepare_folder, text_bytes
from viscodesign.results.accuracy_study import COLUMNS, AccuracyStudy, Point
from viscodesign.results.findings import plain
from viscodesign.storage.atomic_files import refused_plainly, write_all

TABLE, DOCUMENT, PICTURE = STUDY_FILES


def write_study(
    study: AccuracyStudy,
    directory: str | Path,
    *,
    budget_s: float | None = None,
    plots: bool = True,
    force: bool = False,
) -> list[Path]:
    """Write a study's files and return them; those of an earlier one are replaced.

    No other file is touched. Table and document come first, both or none, so that no
    trouble with the picture can lose them. Raises `UsageError` where the folder cannot
    be written, or holds what is neither a run's nor a study's (without ``force``).
    """
    folder = prepare_folder(directory, force=force)
    document = json.dumps(accuracy_document(study, budget_s), indent=2, ensure_ascii=False)
    contents = {
        folder / TABLE: [points_csv(study)],
        folder / DOCUMENT: [text_bytes(document + "\n")],
    }
    picture = folder / PICTURE
    write_all(contents, first=lambda: _remove(picture))
    if plots and study.points:
        # Drawing is slow to import, and a study without a picture does not need it.
        from viscodesign.report.charts.accuracy import draw_accuracy

        draw_accuracy(study, picture)
        return [*contents, picture]
    return list(contents)


def _remove(file: Path) -> None:
    with refused_plainly(file):
        file.unlink(missing_ok=True)


def points_csv(study: AccuracyStudy) -> bytes:
    """Every point with every digit."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(COLUMNS)
    for point in study.points:
        values = asdict(point)
        writer.writerow([_cell(values[name]) for name in COLUMNS])
    return text_bytes(text.getvalue())


def _cell(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    return value if isinstance(value, str) else repr(value)


def accuracy_document(study: AccuracyStudy, budget_s: float | None = None) -> dict[str, Any]:
    """The study as one document; `budget` is there where one was given."""
    document = {
        "name": study.name,
        "version": study.version,
        "spec_sha256": study.spec_sha256,
        "status": study.status,
        "reference": None if study.reference is None else _reference(study),
        "requested": {"tip_error_m": study.requested_m, "tip_error_rel": study.requested_rel},
        "models": [
            {"name": m.name, "also": m.also, "words": m.words, "effects": m.effects}
            for m in study.models
        ],
        "points": [asdict(point) for point in study.points],
        "recommended": _recommended(study),
        "simulate_starts_with": _known(study.start),
        "table": [
            {
                "tip_error_rel": error,
                "tip_error_m": error * study.length,
                "cheapest": _known(study.cheapest(error)),
            }
            for error in study.errors
        ],
        **({} if budget_s is None else {"budget": _budget(study, budget_s)}),
        "notes": study.notes,
        "limit_s": study.limit_s,
        "spent_s": study.spent_s,
    }
    return dict(plain(document))


def _reference(study: AccuracyStudy) -> dict[str, Any]:
    found = study.reference
    assert found is not None
    told = asdict(found)
    names = ("effects", "edges", "tolerance", "solver")
    return {"settings": {name: told.pop(name) for name in names}, **told}


def _recommended(study: AccuracyStudy) -> dict[str, Any] | None:
    point = study.recommended
    return None if point is None else {**asdict(point), "set": study.recommended_changes}


def _budget(study: AccuracyStudy, budget_s: float) -> dict[str, Any]:
    return {
        "time_s": budget_s,
        "most_accurate": _known(study.most_accurate(budget_s)),
        "cheapest": _known(min(study.points, key=lambda p: p.solve_s, default=None)),
    }


def _known(point: Point | None) -> dict[str, Any] | None:
    return None if point is None else asdict(point)
