"""The study: from a scene's pressures to a pump's motion, its limits, and what comes of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from viscodesign._version import __version__
from viscodesign.pump.planning.achievable import SWEEPS, AchievableMotion, achievable_motion
from viscodesign.pump.planning.demand import PumpDemand, course_of, feed_line_at
from viscodesign.pump.planning.demand_kinds import demand_kind, pump_of
from viscodesign.pump.planning.fixes import Trials, combined_fix, fixes_for
from viscodesign.pump.planning.limits import verdicts
from viscodesign.pump.planning.motion import (
    RequestedMotion,
    active_effects,
    inlets_of,
    run_verified,
    shares_a_network,
)
from viscodesign.pump.planning.result import PumpPlan
from viscodesign.pump.planning.scene_variants import planned, with_effects_of
from viscodesign.results.findings import Notice
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.pressure_levels import levels_of, stated_reference
from viscodesign.scene.reading.write import resolved_sha256
from viscodesign.scene.scene import Scene
from viscodesign.simulation.solve_once import Progress

CAP_REL_TOL = 0.01
"""Share of the cap by which it may be passed without a warning."""


def plan(scene: Scene, *, progress: Progress | None = None) -> PumpPlan:
    """Plan a pump's motion for the pressures that a scene asks for.

    The scene is simulated with its own coupled model, which says what every inlet gives; where its
    axis is then follows. That is held against what the pump can do at each pressure, and what the
    pump does instead is simulated again. ``progress`` is given the part that is done. Raises
    `SpecError` where the scene has no pump or no pressures to plan for, `SolveError` where a run
    breaks off.
    """
    pump = pump_of(scene)
    run, requested = requested_motion(scene, progress)
    demands = requested.demands(pump)
    trials = Trials(requested, pump)
    found = tuple(
        v if v.severity == "ok" else replace(v, changes=fixes_for(trials, v))
        for d in demands
        for v in verdicts(d)
    )
    achieved = achievable_motion(requested, pump, progress)
    failed = next((r for r in (run, achieved.run) if r.status != "complete"), run)
    return PumpPlan(
        name=scene.name,
        version=__version__,
        spec_sha256=scene.source.sha256,
        status=failed.status,
        failure=failed.failure,
        inlets=tuple(scene.inputs),
        axes=pump.axes(len(scene.inputs)),
        noun=demands[0].axis.noun,
        device=demands[0].device,
        unit=demands[0].axis.unit,
        wanted=course_of(demands),
        achievable=course_of(achieved.demands),
        wanted_run=run,
        achievable_run=achieved.run,
        actuators=tuple(scene.members),
        deviation=_distance(run.tip, achieved.run.tip),
        clipped=achieved.clipped,
        sweeps=achieved.sweeps,
        unsettled_steps=achieved.unsettled_steps,
        verdicts=found,
        together=combined_fix(trials, found),
        numbers={d.inlet: d.numbers() for d in demands},
        words={d.inlet: d.words() for d in demands},
        panels=requested.kind.panels(demands),
        limits=requested.kind.limit_numbers(demands),
        warnings=(*_notices(requested.scene, demands, achieved), *run.warnings),
        resolved_sha256=resolved_sha256(scene),
    )


def requested_motion(
    scene: Scene, progress: Progress | None = None
) -> tuple[Trajectory, RequestedMotion]:
    """The run of the pressures that a scene asks for, and what it asks of the pumps."""
    run = run_verified(planned(scene), progress)
    settled, active = with_effects_of(planned(scene), run), active_effects(run)
    inlets = inlets_of(scene, run)
    lines = {name: feed_line_at(settled, name, active) for name in scene.inputs}
    kind = demand_kind(pump_of(scene))
    requested = RequestedMotion(kind, settled, active, lines, inlets, inlets.until(0))
    return run, requested.with_lead_in(pump_of(scene))


def _distance(tip: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Largest distance of tips (T, 3 R) of R actuators at the times that both have [m]."""
    both = min(len(tip), len(other))
    apart = (tip[:both] - other[:both]).reshape(both, -1, 3)
    return np.asarray(np.max(np.hypot(apart[..., 0], apart[..., 1]), axis=1))


def _notices(
    scene: Scene, demands: tuple[PumpDemand, ...], achieved: AchievableMotion
) -> Iterator[Notice]:
    """Warnings that belong to the plan as a whole."""
    yield from type(demands[0]).notices(demands)
    ambient = scene.ambient_pressure
    highest = max(float(d.pressure.max()) for d in demands)
    stated = [stated_reference(v) for s in scene.inputs.values() for _, v in levels_of(s)]
    if highest > ambient and not any(stated):
        yield Notice(
            "gauge_or_absolute",
            f"the input reaches {highest / 1e3:.4g} kPa, taken as gauge; if absolute was meant, "
            f"{highest / 1e3:.4g} kPa abs is {(highest - ambient) / 1e3:.4g} kPa gauge",
            "input",
        )
    if shares_a_network(scene) and demands[0].lead_s > 0.0:
        yield Notice(
            "shared_start",
            "several inlets feed one network: the flow between them before t = 0 is that of a "
            f"lead-in of {demands[0].lead_s:.4g} s",
        )
    for demand in achieved.demands:
        over = float(demand.pressure.max()) - demand.pump.max_pressure
        if over > CAP_REL_TOL * demand.pump.max_pressure:
            yield Notice(
                "cap_passed",
                f"rounding to whole {demand.axis.unit} briefly takes the pressure "
                f"{over / 1e3:.3g} kPa above the cap, where a monitored pump would stop",
                demand.inlet,
                float(demand.time[int(np.argmax(demand.pressure))]),
            )
    if achieved.unsettled_steps > SWEEPS.agreement_steps:
        yield Notice(
            "unsettled",
            f"after {achieved.sweeps} solutions the achievable motion still changes by "
            f"{achieved.unsettled_steps:.3g} {demands[0].axis.unit}",
        )
