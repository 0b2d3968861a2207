"""The runs of several actuators read again from their folder."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from viscodesign.report.folder import SUMMARY
from viscodesign.report.read_run import read_run
from viscodesign.report.saved_files import (
    SavedTable,
    fitting_files,
    saved_spec,
    saved_summary,
    saved_table,
)
from viscodesign.results.channels import TRAJECTORY, channel
from viscodesign.results.coupled_motion import CoupledMotion
from viscodesign.results.several_runs import SeveralRuns
from viscodesign.scene.fluid_links import LinkedGroup
from viscodesign.scene.reading.read_several import several_of


def read_several(directory: str | Path) -> SeveralRuns:
    """The runs in a folder that `write_several` has written.

    Raises `UsageError` where the folder, or that of an actuator, holds no complete run.
    """
    folder = Path(directory)
    summary = saved_summary(folder / SUMMARY)
    text, scene = saved_spec(folder, summary, several_of, "runs")
    table = saved_table(folder / TRAJECTORY, may_be_empty=True)
    told: dict[str, Any] = summary["actuators"]
    with fitting_files(folder):
        coupled = tuple(_coupled(table, own) for own in scene.groups if own.names[0] in told)
        return SeveralRuns(
            name=summary["name"],
            runs={name: read_run(folder / name) for name in told},
            equal_to={name: own["equal_to"] for name, own in told.items() if own["equal_to"]},
            sources={name: scene.sources_of(name) for name in scene.actuators},
            failures=summary["failures"],
            interrupted=tuple(summary["interrupted"]),
            spec_text=text,
            spec_sha256=summary["spec_sha256"],
            version=summary["version"],
            coupled=coupled,
            known_supplies=summary["sources"],
        )


def _coupled(table: SavedTable, group: LinkedGroup) -> CoupledMotion:
    """What the actuators of a group share, without what inputs have delivered: no table has it."""
    time = table.columns(["time_s"])[:, 0]

    def read(quantity: str, names: tuple[str, ...]) -> dict[str, np.ndarray]:
        values = table.columns(channel(quantity).column(name) for name in names).T
        return dict(zip(names, values, strict=True))

    return CoupledMotion(
        actuators=group.names,
        time=time,
        inflow={},
        inlet_pressure=read("inlet_pressure", group.inputs),
        junction_pressure=read("junction_pressure", group.junctions),
        flow=read("flow", tuple(tube.name for tube in group.shared)),
    )
