"""The data of the page, as one JSON document."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from viscodesign.report.ground_outline import ground_outline, ground_words
from viscodesign.report.page.packed_arrays import packed, packed_coordinates
from viscodesign.report.page.shown_rows import (
    ShownRows,
    shapes_near,
    shown_points,
    shown_rows,
    shown_tubes,
)
from viscodesign.report.page.sketch_numbers import ground_of, scene_of, sketch_numbers, why_not
from viscodesign.results.channels import Channel, Per, plotted_channels
from viscodesign.results.coefficient_band import COVERAGE_FACTOR as ELLIPSE_FACTOR
from viscodesign.results.coefficient_band import STILL_WORDS, why_no_band
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.scene import Scene
from viscodesign.storage.disk_arrays import rows_at

MAX_SPEC_CHARACTERS = 60_000
MAX_WARNINGS = 200
MAX_DRAWN_TUBES = 128
"""As `actuator.js` has it."""
GROUND_REACH = 4.0
"""To which a straight ground is drawn, in lengths of the actuator."""


def page_data(run: Trajectory) -> dict[str, Any]:
    """All that the page shows of a run."""
    scene = scene_of(run)
    data: dict[str, Any] = {
        "summary": _short(run.summary()),
        "spec": shortened_spec(run.spec_text),
        "length": run.length,
        "width": max(run.width, *run.section_widths, 0.0),
        "widths": list(run.section_widths),
        "inlets": run.inlets,
        "bellows": run.bellows,
        "all_tubes": tube_ends(run, scene),
        "total_rows": len(run.time),
        "surface": _ground(run),
        "notes": list(run.notes),
        "bandless": _bandless(run),
    }
    return {**data, **_motion(run, scene)} if len(run.time) else data


def _motion(run: Trajectory, scene: Scene | None) -> dict[str, Any]:
    chosen = shown_rows(run)
    shapes = shapes_near(run, chosen.rows)
    kept, shape_of = np.unique(shapes, return_inverse=True)
    tubes = shown_tubes(run)
    return {
        "notes": list(_notes(run, chosen, tubes)),
        "rows": packed(chosen.rows, "f8"),
        "time": packed(run.time[chosen.rows], "f8"),
        "tip": packed(rows_at(run.tip, chosen.rows), "f8"),
        "inlet_pressure": packed(rows_at(run["inlet_pressure"], chosen.rows), "f8"),
        "pressure": packed(rows_at(run.pressure, chosen.rows)),
        "flow": packed(rows_at(run.flow, chosen.rows)[:, tubes]),
        "tubes": [run.tubes[k] for k in tubes],
        "quantities": [_quantity(row, run, chosen.rows) for row in plotted_channels(run)],
        "arc": packed(run.arc[shown_points(run)], "f8"),
        "shape": packed_coordinates(rows_at(run.shape, kept)[:, shown_points(run)]),
        "shape_of": packed(shape_of, "f8"),
        "band": _band(run, chosen),
        "sketch": _sketch(run, scene, chosen),
    }


def _quantity(row: Channel, run: Trajectory, rows: np.ndarray) -> dict[str, Any]:
    """A quantity with a panel of its own: values (n, members) and what a picture says of them."""
    unit, factor = row.picture_unit
    values = row.values(run, rows)
    return {
        "title": row.title,
        "unit": f"{unit} {row.reference}" if row.reference else unit,
        "names": [row.title] if row.per is Per.RUN else list(run.members(row.per)),
        "values": packed(factor * values.reshape(len(rows), -1)),
    }


def _ground(run: Trajectory) -> dict[str, Any] | None:
    """The line of the ground, where there is one, and what it means."""
    ground = ground_of(run)
    if ground is None:
        return None
    outline = ground_outline(ground, GROUND_REACH * run.length)
    words = f"Dashed: {ground_words(ground)}."
    return {"outline": outline.tolist(), "foot": ground.foot_radius, "words": words}


def _bandless(run: Trajectory) -> str:
    """What stands in place of the band's width, as the command line says it; empty with a band."""
    if run.uncertainty is None:
        return why_no_band(run.warnings, run.notes, run.spec_text)
    return STILL_WORDS if run.uncertainty.is_still else ""


def _band(run: Trajectory, chosen: ShownRows) -> dict[str, Any] | None:
    """Variances of the tip at the shown rows, and the factor of its ellipses, where it moves."""
    band = run.uncertainty
    if band is None or band.is_still:
        return None
    known = chosen.rows[chosen.rows < len(band.time)]
    return {"covariance": packed(band.covariance[known]), "factor": ELLIPSE_FACTOR}


def _notes(run: Trajectory, chosen: ShownRows, tubes: np.ndarray) -> Sequence[str]:
    notes = [*run.notes, *([chosen.note] if chosen.note else [])]
    if len(tubes) < len(run.tubes):
        notes.append(
            f"flows are shown for {len(tubes)} of {len(run.tubes):,} tubes, those with the largest"
        )
    if len(run.tubes) > MAX_DRAWN_TUBES:
        notes.append(f"the {len(run.tubes):,} tubes are not drawn at the actuator")
    if len(run.shape_rows) < len(run.time):
        notes.append(
            f"shapes are stored at {len(run.shape_rows):,} of {len(run.time):,} output times "
            "(run.shape_every); between them the nearest is drawn"
        )
    return notes


def _sketch(run: Trajectory, scene: Scene | None, chosen: ShownRows) -> dict[str, Any]:
    reason = why_not(run, scene)
    if scene is None or reason:
        return {"reason": reason}
    return sketch_numbers(run, scene, from_start=chosen.from_start)


def _short(summary: Any) -> dict[str, Any]:
    """The summary with as many warnings as anybody reads."""
    warnings = summary.get("warnings", [])
    more = len(warnings) - MAX_WARNINGS
    return {**summary, "warnings": warnings[:MAX_WARNINGS], "more_warnings": max(more, 0)}


def shortened_spec(text: str) -> str:
    """A spec with as many characters as anybody reads."""
    if len(text) <= MAX_SPEC_CHARACTERS:
        return text
    return f"{text[:MAX_SPEC_CHARACTERS]}\n... ({len(text):,} characters, all in spec.yaml)\n"


def tube_ends(run: Trajectory, scene: Scene | None) -> list[list[str]]:
    """Both ends of every tube: of the spec's network, else as far as the names tell."""
    if scene is not None:
        return [[tube.start, tube.end] for tube in scene.graph.tubes]
    pairs = (name.split("#")[0].split("-") for name in run.tubes)
    return [pair for pair in pairs if len(pair) == 2]
