"""The gait of a robot read again from its folder."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from viscodesign.report.folder import LEGS_TABLE, SUMMARY, WALK_TABLE
from viscodesign.report.saved_files import (
    SavedTable,
    all_made,
    fitting_files,
    made,
    saved_spec,
    saved_summary,
    saved_table,
)
from viscodesign.results.findings import Notice
from viscodesign.results.gait_energy import GaitEnergy
from viscodesign.results.robot_motion import RobotMotion
from viscodesign.results.walk_study import ContactInvariants, FootUse, PumpUse, WalkStudy
from viscodesign.scene.reading.read_robot import robot_of
from viscodesign.scene.robot_scene import RobotScene

BODY = ("body_x_m", "body_height_m", "body_pitch_rad", "body_roll_rad")


def read_gait(directory: str | Path) -> WalkStudy:
    """The gait in a folder that `write_walk` has written, at its recorded times.

    Raises `UsageError` where the folder holds no complete gait.
    """
    folder = Path(directory)
    summary = saved_summary(folder / SUMMARY)
    text, scene = saved_spec(folder, summary, robot_of, "gait")
    tables = saved_table(folder / WALK_TABLE), saved_table(folder / LEGS_TABLE)
    with fitting_files(folder, "Let the robot walk again"):
        return _study(summary, text, _motion(scene, *tables, summary["period_s"]))


def _motion(scene: RobotScene, walk: SavedTable, legs: SavedTable, period: float) -> RobotMotion:
    names, sources = tuple(scene.robot.legs), tuple(scene.sources)
    time = walk.columns(["time_s"])[:, 0]

    def by_leg(quantity: str) -> np.ndarray:
        return walk.columns(f"{name}.{quantity}" for name in names)

    def by_source(quantity: str) -> np.ndarray:
        return walk.columns(f"{name}.{quantity}" for name in sources)

    x, gap = by_leg("foot_x_m"), by_leg("foot_gap_m")
    unknown = np.full_like(x, np.nan)
    return RobotMotion(
        legs=names,
        sources=sources,
        source_of=tuple(sources.index(leg.source) for leg in scene.robot.legs.values()),
        foot_radius=scene.robot.foot.radius,
        period=period,
        time=time,
        body=walk.columns(BODY),
        feet=np.stack([x, gap, unknown], axis=-1),
        normal=by_leg("normal_force_n"),
        friction=by_leg("friction_force_n"),
        slip=unknown,
        pressure=by_source("gauge_pressure_pa"),
        delivered=by_source("delivered_m3"),
        barrel=by_source("barrel_m3"),
        rows=np.arange(len(time)),
        axes=_axes(legs, scene, len(time)),
    )


def _axes(table: SavedTable, scene: RobotScene, rows: int) -> np.ndarray:
    """Ends of all sections of every leg (R, L, n, 2) [m]."""
    legs = {name: scene.leg_scene(leg.actuator) for name, leg in scene.robot.legs.items()}
    points = {name: 1 + own.bellows.count // 2 for name, own in legs.items()}
    found = np.full((rows, len(legs), max(points.values()), 2), np.nan)
    for k, (name, count) in enumerate(points.items()):
        for axis, word in enumerate(("x_m", "height_m")):
            found[:, k, :count, axis] = table.columns(f"{name}.p{j}_{word}" for j in range(count))
    return found


def _study(summary: Mapping[str, Any], text: str, motion: RobotMotion) -> WalkStudy:
    def number(key: str) -> float:
        value = summary.get(key)
        return math.nan if value is None else float(value)

    def numbers(key: str) -> tuple[float, ...]:
        return tuple(math.nan if value is None else float(value) for value in summary[key])

    status = summary["status"]
    return WalkStudy(
        name=summary["name"],
        body_length_m=summary["body_length_m"],
        motion=motion,
        steps_s=numbers("steps_s"),
        advances_by_step_m=numbers("advances_by_step_m"),
        advances_by_cycle_m=numbers("advances_by_cycle_m"),
        body_path_error_m=number("body_path_error_m"),
        feet_path_error_m=number("feet_path_error_m"),
        step_halving_change=number("step_halving_change"),
        cycle_change=number("cycle_change"),
        refusal=summary["refusal"] or "",
        end=status if status in ("failed", "interrupted") else "",
        feet={name: made(FootUse, own) for name, own in summary["feet"].items()},
        pumps={name: made(PumpUse, own) for name, own in summary["pumps"].items()},
        invariants=made(ContactInvariants, summary["invariants"]),
        energy=made(GaitEnergy, summary["energy"]),
        warnings=all_made(Notice, summary["warnings"]),
        spec_text=text,
        solve_cpu_s=float(summary["cost"]["solve_cpu_s"]),
        total_s=float(summary["cost"]["total_s"]),
        provenance=dict(summary["provenance"]),
    )
