"""`report.html` of several actuators: all of them side by side in time."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from viscodesign.report.page.packed_arrays import packed
from viscodesign.report.page.page_data import page_data, shortened_spec
from viscodesign.report.page.self_contained import self_contained, write_html
from viscodesign.results.coupled_motion import CoupledMotion
from viscodesign.results.provenance import provenance
from viscodesign.results.several_runs import SeveralRuns

TEMPLATE = "several.html"
SCRIPTS = (
    *("data.js", "svg.js", "actuator.js", "charts.js", "player.js", "tables.js"),
    "several.js",
)
"""In the order in which they run; those before the last only define functions."""
MAX_JUNCTION_ROWS = 2000
"""Times at which pressures of junctions are kept."""
OF_ONE = ("spec", "sketch", "band", "flow", "quantities")
"""Data of a run that its own page alone shows."""


def write_several_page(found: SeveralRuns, file: str | Path) -> Path:
    """Write the page of several actuators. Raises `UsageError` where it cannot be written."""
    return write_html(Path(file), self_contained(TEMPLATE, SCRIPTS, several_data(found)))


def several_data(found: SeveralRuns) -> dict[str, Any]:
    """All that the page shows; the motion of equal actuators is there once."""
    summary = found.summary()
    told = {key: own for key, own in summary.items() if key != "actuators"}
    fed_by = {name: list(found.sources[name].values()) for name in found.runs}
    for source, supply in summary["sources"].items():
        for name in supply["feeds"]:
            fed_by[name] += [] if source in fed_by[name] else [source]
    return {
        "summary": told,
        "spec": shortened_spec(found.spec_text),
        "provenance": provenance(),
        "shared": [own for motion in found.coupled for own in _shared(motion)],
        "actuators": [
            {
                "name": name,
                "sources": fed_by[name],
                "equal_to": found.equal_to.get(name),
                "run": _run(found, name),
            }
            for name in found.runs
        ],
    }


def _shared(motion: CoupledMotion) -> Iterator[dict[str, Any]]:
    """Pressures at the inlets and junctions of actuators that share fluid, at some of its times."""
    rows = np.unique(np.linspace(0, len(motion.time) - 1, MAX_JUNCTION_ROWS).astype(int))
    for name, values in (*motion.inlet_pressure.items(), *motion.junction_pressure.items()):
        yield {
            "name": name,
            "is_junction": name in motion.junction_pressure,
            "time": packed(motion.time[rows], "f8"),
            "pressure": packed(values[rows]),
        }


def _run(found: SeveralRuns, name: str) -> dict[str, Any]:
    """That of an actuator; empty where it equals another one."""
    if name in found.equal_to:
        return {}
    return {key: own for key, own in page_data(found.runs[name]).items() if key not in OF_ONE}
