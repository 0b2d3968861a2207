"""The files of a plan of the pump, beside those of a run or alone."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from viscodesign.pump.planning.result import PumpPlan
from viscodesign.report.csv_text import csv_table
from viscodesign.report.folder import PLAN_FILES
from viscodesign.report.picture_options import AS_USUAL, PictureOptions
from viscodesign.results.channels import TIP_COLUMNS
from viscodesign.results.findings import documents, json_ready
from viscodesign.results.provenance import provenance

SHARED = ("name", "version", "spec_sha256", "resolved_sha256", "status", "failure")
"""What `plan.json` says as the plan does."""


def write_plan(
    plan: PumpPlan,
    directory: str | Path,
    *,
    plots: bool = True,
    force: bool = False,
    pictures: PictureOptions = AS_USUAL,
) -> list[Path]:
    """Write a plan's files and return them; see `FileSet.write`."""

    def draw(picture: Path) -> None:
        # Drawing is slow to import, and a plan without a picture does not need it.
        from viscodesign.pump.report.plan_chart import draw_plan

        draw_plan(plan, picture)

    names, values = plan_columns(plan)
    table, drawer = csv_table(names, values.tolist()), draw if plots else None
    document = plan_document(plan)
    return PLAN_FILES.write(directory, table, document, drawer, force=force, pictures=pictures)


def plan_columns(plan: PumpPlan) -> tuple[list[str], np.ndarray]:
    """Names and values (T, columns) of `plan.csv`; pressures are gauge.

    Tips begin with the run itself; before, during the lead-in, they are NaN.
    """
    time = plan.wanted.time
    found = {"time_s": time, "run_time_s": time - plan.wanted.lead_s}
    for kind, course in (("wanted", plan.wanted), ("achievable", plan.achievable)):
        for word, values in course.columns.items():
            for inlet, column in zip(plan.inlets, values.T, strict=True):
                own = "" if len(plan.inlets) == 1 else f"{inlet}_"
                found[f"{kind}_{own}{word}"] = column
    before = np.full(len(time) - len(plan.wanted_run.time), np.nan)
    for kind, run in (("wanted", plan.wanted_run), ("achievable", plan.achievable_run)):
        for actuator, tip in plan.tips(run).items():
            own = f"{actuator}_" if actuator else ""
            for word, column in zip(TIP_COLUMNS, tip.T, strict=True):
                found[f"{kind}_{own}{word}"] = np.concatenate([before, column])
    return list(found), np.column_stack(list(found.values()))


def plan_document(plan: PumpPlan) -> dict[str, Any]:
    """The plan without its courses."""
    document = {
        **{name: getattr(plan, name) for name in SHARED},
        "feasible": plan.is_feasible,
        plan.noun: plan.device,
        "inlets": dict(zip(plan.inlets, plan.axes, strict=True)),
        "lead_s": plan.wanted.lead_s,
        "duration_s": float(plan.wanted.time[-1]),
        "verdicts": [asdict(verdict) for verdict in plan.verdicts],
        "together": [asdict(change) for change in plan.together],
        "limits": dict(plan.limits),
        "numbers": {inlet: dict(numbers) for inlet, numbers in plan.numbers.items()},
        "achievable": {
            "clipped": plan.clipped,
            "sweeps": plan.sweeps,
            f"unsettled_{plan.unit}": plan.unsettled_steps,
            "tip_deviation_m": plan.deviation_m,
        },
        "accuracy": {
            "wanted": asdict(plan.wanted_run.accuracy),
            "achievable": asdict(plan.achievable_run.accuracy),
            "tip_error_m": plan.error_m,
            "validity": plan.validity,
        },
        "effects": [v.name for v in plan.wanted_run.effects if v.taken],
        "warnings": documents(plan.warnings),
        "provenance": provenance(),
    }
    return dict(json_ready(document))
