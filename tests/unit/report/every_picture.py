"""A subject for every kind of picture that is written: made-up numbers, drawn at once."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

from tests.studies import made_study
from tests.trajectories import CLASSIFICATION, ablated_run, made_run, with_two_inlets
from tests.unit.report.charts.test_exploration import FLUID, LENGTH, RADIUS, sweep_over
from viscodesign import compare
from viscodesign.pump.ax.servo_demand import AxDemand
from viscodesign.pump.planning.result import PumpCourse
from viscodesign.pump.report.fit_chart import draw_fit as draw_poses
from viscodesign.pump.report.plan_chart import draw_plan
from viscodesign.report.charts.accuracy import draw_accuracy
from viscodesign.report.charts.compare import draw_comparison
from viscodesign.report.charts.design import draw_design
from viscodesign.report.charts.effects import draw_effects
from viscodesign.report.charts.fit import draw_fit
from viscodesign.report.charts.paper_figure import draw_figure
from viscodesign.report.charts.pressures import draw_pressures
from viscodesign.report.charts.quadrants import draw_plane
from viscodesign.report.charts.reach import draw_reach
from viscodesign.report.charts.shapes import draw_shapes
from viscodesign.report.charts.stand import draw_stand
from viscodesign.report.charts.sweep import draw_sweep
from viscodesign.report.charts.tip import draw_tip
from viscodesign.report.charts.tornado import draw_tornado
from viscodesign.report.charts.walk import draw_walk
from viscodesign.results.findings import Scales
from viscodesign.results.fit_result import FittedRun
from viscodesign.results.paper_figure import FigurePanel, PaperCheck, PaperFigure
from viscodesign.results.path_design import HistoryRow, without_design
from viscodesign.results.reach_study import ReachedPoint, ReachStudy
from viscodesign.results.robot_motion import RobotMotion
from viscodesign.results.sensitivity_study import SensitiveNumber, SensitivityStudy

TIME = np.linspace(0.0, 4.0, 81)
CIRCLE = np.column_stack([0.02 * np.cos(np.pi * TIME / 2), 0.1 + 0.01 * np.sin(np.pi * TIME / 2)])


def _sensitivity(has_band: bool) -> SensitivityStudy:
    slopes = np.sin(TIME)[:, None, None] * np.array([[[2e-3, 1e-3], [1e-3, -2e-3]]])
    numbers = (
        SensitiveNumber("network.tube_radius", 1.0, "m", 1.0),
        SensitiveNumber("fluid.viscosity", 1.0, "Pa s", 1.0),
    )
    return SensitivityStudy(
        name="leg", version="0", spec_sha256="", time=TIME, tip=CIRCLE, numbers=numbers,
        slopes=slopes, effects=frozenset(), variances=slopes**2 if has_band else None,
    )  # fmt: skip


def _design() -> Any:
    found = without_design(
        "leg", "not_met", "", tolerance_m=1e-4, wanted=CIRCLE, closed=True, evaluations=9
    )
    history = (HistoryRow(1, 0.1, 1e-3, ""), HistoryRow(4, 0.3, 3e-4, ""))
    band = np.full_like(CIRCLE, 6e-4)
    return replace(found, found=1.02 * CIRCLE, confirmed_rms_m=3e-4, history=history, band=band)


def _reach() -> ReachStudy:
    point = ReachedPoint(
        at=(0.015, 0.1), time_s=3.0, tip=(0.0151, 0.1), miss_m=1e-4, stated_error_m=2e-5,
        tolerance_m=5e-4, path=CIRCLE[:20], times=np.zeros(2), pressures=np.zeros(2), spec_text="",
        evaluations=7,
    )  # fmt: skip
    return ReachStudy("leg", (-1e3, 2e3), None, CIRCLE, CIRCLE * [1.2, 1.05], None, point, 0.0)


def _fit() -> Any:
    expected = 1.01 * CIRCLE
    kept = np.ones_like(CIRCLE, dtype=bool)
    kept[7] = False
    run = FittedRun(
        file="camera.csv", overrides=("fluid=water",), time=TIME, headers=("tip_x_m", "tip_z_m"),
        units=("m", "m"), measured=CIRCLE, expected=expected, kept=kept,
        noise=np.array([1e-4, 1e-4]), clock_offset_s=0.0, clock_deviation_s=None, driven_by=(),
    )  # fmt: skip
    return SimpleNamespace(name="leg", runs=(run,), mismatch=None)


def _figure() -> PaperFigure:
    still = made_run(bending=0.0, inlet=lambda t: 1e4 + 0 * t)
    slow = replace(made_run(lag=0.02), name="slow")
    panels = (
        FigurePanel("A", "one", "", (made_run(),)),
        FigurePanel("B", "two", "the sizes of the tubes", (made_run(), slow)),
        FigurePanel("C", "steady", "", (still,)),
    )
    check = PaperCheck(3, "A", "3.1", "the tip moves on a loop", agrees=False, found="10 mm")
    return PaperFigure(3, "Title", panels, (check,), "1")


def _plane() -> list[Any]:
    places = ((100.0, 50.0), (0.1, 0.1), (8.0, 0.02), (0.02, 30.0), (1.5, 2.0), (1.0, 12.0))
    return [
        replace(CLASSIFICATION, name=f"leg_{k}", scales=Scales(1.0, t_f, t_i, 1.0))
        for k, (t_f, t_i) in enumerate(places)
    ]


def _course(shift: float) -> PumpCourse:
    wave = np.sin(np.pi * TIME / 2 + shift)[:, None] * [1.0, -1.0]
    columns = {
        "pressure_pa": 3e4 * wave, "count": 400 + 200 * wave, "flow_m3_s": 1e-6 * wave,
        "stall_share": 0.3 * np.abs(wave),
    }  # fmt: skip
    return PumpCourse(TIME, 0.5, columns["pressure_pa"], columns["count"], columns)


def _plan() -> Any:
    run = made_run(time=TIME)
    return SimpleNamespace(
        name="leg", actuators=(), tips=lambda run: {"": run.tip}, inlets=("left", "right"), wanted=_course(0.0), achievable=_course(0.1),
        wanted_run=run, achievable_run=made_run(time=TIME, lag=0.05), infeasible=(), clipped=(),
        error_m=1e-4, validity="inside", deviation_m=2e-3, numbers={"left": {"no_load_flow_m3_s": 1e-5}},
        panels=AxDemand.panels([SimpleNamespace(
            axis=SimpleNamespace(noun="servo", unit="counts"),
            drive=SimpleNamespace(load=SimpleNamespace(name="torque"), step_name="count"),
            pump=SimpleNamespace(max_pressure=4e4, travel=(100, 700)),
            numbers=lambda: {"no_load_flow_m3_s": 1e-5},
        )]),
    )  # fmt: skip


def _poses() -> Any:
    wave = 400 + 100 * np.sin(TIME)[:, None]
    return SimpleNamespace(
        looped=True, largest_error=2.5, time=TIME, duration=4.0, requested=wave, played=wave + 1,
        error=np.cos(TIME)[:, None], move_frames=[0, 60, 60],
        sequence=SimpleNamespace(goals=lambda: [[400, 0], [480, 0], [490, 0]]),
    )  # fmt: skip


def _walk() -> Any:
    """A gait of two cycles, its feet up and down in turn."""
    step = TIME[1] - TIME[0]
    turn = np.sin(np.pi * TIME[:, None] + np.pi * np.arange(6))
    return SimpleNamespace(
        name="hexapod",
        refusal="",
        advance_per_cycle_m=0.02,
        speed_body_lengths_per_s=0.04,
        motion=RobotMotion(
            legs=("LF", "RF", "LM", "RM", "LR", "RR"), sources=("A", "B"), foot_radius=0.015,
            source_of=(0, 1, 0, 1, 0, 1),
            period=2.0, time=TIME, body=np.column_stack([step * TIME, *[0 * TIME] * 3]),
            feet=np.maximum(1e-3 * turn, 0)[..., None] * [0, 1, 0], normal=np.maximum(-turn, 0),
            friction=0.1 * np.minimum(turn, 0), slip=0 * turn, pressure=turn[:, :2],
            delivered=turn[:, :2], barrel=1e-6 * (1 + turn[:, :2]),
            rows=np.arange(len(TIME)), axes=np.zeros((len(TIME), 6, 9, 2)),
        ),
    )  # fmt: skip


def _stand() -> Any:
    def row(gauge: float, payload: float) -> Any:
        return SimpleNamespace(
            gauge_pressure_pa=gauge, payload_kg=payload, height_m=0.1 + 1e-6 * gauge - 0.02 * payload,
            sway_limit_n=25 + 5e-4 * gauge, tip_stiffness_n_per_m=20 + 1e-3 * gauge - 10 * payload,
            weight_n=6 + 10 * payload,
        )  # fmt: skip

    by_gauge = [row(g, 0.0) for g in (-1e4, 0.0, 1e4)]
    by_payload = [row(0.0, m) for m in (0.0, 0.5, 1.0)]
    return SimpleNamespace(
        name="hexapod", own=by_gauge[1], by_gauge=by_gauge, by_payload=by_payload
    )


def _comparison() -> Any:
    failed = replace(
        made_run(time=np.linspace(0, 3, 151), bending=0.8), name="bent", status="failed",
        failure="no step",
    )  # fmt: skip
    return compare(
        made_run(period=8.0), failed, replace(made_run(lag=0.02, period=8.0), name="slow")
    )


def _small_loop() -> Any:
    return made_run(inlet=lambda t: 1.4e5 + 1e4 * np.sin(np.pi * t / 2), name="small")


def _draw_sweep(sweep: Any, path: Path) -> None:
    draw_sweep(sweep, "loop_width_m", path)


Subject = tuple[Callable[[Any, Path], object], Callable[[], Any]]
EVERY: dict[str, Subject] = {
    "tip": (draw_tip, made_run),
    "tip_enlarged": (draw_tip, _small_loop),
    "pressures": (draw_pressures, lambda: with_two_inlets(made_run(), -0.5)),
    "shapes": (draw_shapes, made_run),
    "effects": (draw_effects, ablated_run),
    "failed": (draw_shapes, lambda: made_run(time=TIME, status="failed", failure="it broke")),
    "accuracy": (draw_accuracy, made_study),
    "compare": (draw_comparison, _comparison),
    "figure_3": (draw_figure, _figure),
    "plane": (draw_plane, _plane),
    "design": (draw_design, _design),
    "reach": (draw_reach, _reach),
    "fit": (draw_fit, _fit),
    "sweep_line": (_draw_sweep, lambda: sweep_over(LENGTH)),
    "sweep_map": (_draw_sweep, lambda: sweep_over(RADIUS, FLUID)),
    "sweep_keys": (_draw_sweep, lambda: sweep_over(LENGTH, RADIUS, FLUID)),
    "stand": (draw_stand, _stand),
    "walk": (draw_walk, _walk),
    "tornado": (draw_tornado, lambda: _sensitivity(True)),
    "tornado_shifts": (draw_tornado, lambda: _sensitivity(False)),
    "plan": (draw_plan, _plan),
    "poses": (lambda s, p: draw_poses(s, made_run(time=TIME), p), _poses),
}


@functools.cache
def subject(name: str) -> Any:
    """What a picture is drawn of."""
    return EVERY[name][1]()


def draw(name: str, path: Path) -> None:
    """Draw a picture into a file, in the look that is in force."""
    EVERY[name][0](subject(name), path)
