"""`report.html` of several actuators: all of them side by side in time."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from viscodesign.report.page.page_data import page_data, shortened_spec
from viscodesign.report.page.self_contained import self_contained, write_html
from viscodesign.results.provenance import provenance
from viscodesign.results.several_runs import SeveralRuns

TEMPLATE = "several.html"
SCRIPTS = (
    *("data.js", "svg.js", "actuator.js", "charts.js", "player.js", "tables.js"),
    "several.js",
)
"""In the order in which they run; those before the last only define functions."""
OF_ONE = ("spec", "sketch", "band", "flow", "quantities")
"""Data of a run that its own page alone shows."""


def write_several_page(found: SeveralRuns, file: str | Path) -> Path:
    """Write the page of several actuators. Raises `UsageError` where it cannot be written."""
    return write_html(Path(file), self_contained(TEMPLATE, SCRIPTS, several_data(found)))


def several_data(found: SeveralRuns) -> dict[str, Any]:
    """All that the page shows; the motion of equal actuators is there once."""
    summary = found.summary()
    told = {key: own for key, own in summary.items() if key != "actuators"}
    return {
        "summary": told,
        "spec": shortened_spec(found.spec_text),
        "provenance": provenance(),
        "actuators": [
            {
                "name": name,
                "sources": list(found.sources[name].values()),
                "equal_to": found.equal_to.get(name),
                "run": _run(found, name),
            }
            for name in found.runs
        ],
    }


def _run(found: SeveralRuns, name: str) -> dict[str, Any]:
    """That of an actuator; empty where it equals another one."""
    if name in found.equal_to:
        return {}
    return {key: own for key, own in page_data(found.runs[name]).items() if key not in OF_ONE}
