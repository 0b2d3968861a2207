"""The study: from a scene's pressures to a plunger's motion, its limits, and what comes of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from viscodesign._version import __version__
from viscodesign.effects.base import Trait
from viscodesign.effects.catalogue import names_with
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.physics import gas
from viscodesign.pump.planning.achievable import SWEEPS, AchievableMotion, achievable_motion
from viscodesign.pump.planning.barrel import feed_line_at
from viscodesign.pump.planning.demand import PumpDemand, course_of
from viscodesign.pump.planning.fixes import combined_fix, fixes_for
from viscodesign.pump.planning.limits import verdicts
from viscodesign.pump.planning.motion import (
    RequestedMotion,
    active_effects,
    inlets_of,
    run_verified,
    shares_a_network,
)
from viscodesign.pump.planning.result import PumpPlan
from viscodesign.pump.planning.scene_variants import planned, pump_of, with_effects_of
from viscodesign.pump.planning.trials import Trials
from viscodesign.pump.servo_motor import STEADY_SHARE
from viscodesign.results.findings import Notice
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.per_inlet import each
from viscodesign.scene.pressure_levels import levels_of, stated_reference
from viscodesign.scene.reading.write import resolved_sha256
from viscodesign.scene.scene import Scene
from viscodesign.simulation.solve_once import Progress

CAP_REL_TOL = 0.01
"""Share of the cap by which it may be passed without a warning."""


def plan(scene: Scene, *, progress: Progress | None = None) -> PumpPlan:
    """Plan a pump's motion for the pressures that a scene asks for.

    The scene is simulated with its own coupled model, which says what every inlet gives; barrel
    and dead volume say where its plunger is then. That is held against what the pump can do at
    each pressure, and what the pump does instead is simulated again. ``progress`` is given the
    part that is done. Raises `SpecError` where the scene has no pump or no pressures to plan
    for, `SolveError` where a run breaks off.
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
        axes=tuple(
            servo for servo in each(pump.servo_id, len(scene.inputs)) if servo is not None
        ),
        device=demands[0].drive.servo.title,
        wanted=course_of(demands),
        achievable=course_of(achieved.demands),
        wanted_run=run,
        achievable_run=achieved.run,
        deviation=_distance(run.tip, achieved.run.tip),
        clipped=achieved.clipped,
        sweeps=achieved.sweeps,
        unsettled_counts=achieved.unsettled_counts,
        verdicts=found,
        together=combined_fix(trials, found),
        numbers={d.inlet: _numbers(d) for d in demands},
        limits=_limits(demands),
        warnings=(*_notices(requested.scene, demands, achieved), *run.warnings),
        resolved_sha256=resolved_sha256(scene),
    )


def requested_motion(
    scene: Scene, progress: Progress | None = None
) -> tuple[Trajectory, RequestedMotion]:
    """The run of the pressures that a scene asks for, and what it asks of the pumps."""
    run = run_verified(planned(scene), progress)
    settled, active, inlets = (
        with_effects_of(planned(scene), run),
        active_effects(run),
        inlets_of(run),
    )
    lines = {name: feed_line_at(settled, name, active) for name in scene.inputs}
    requested = RequestedMotion(settled, active, lines, inlets, inlets.until(0))
    return run, requested.with_lead_in(pump_of(scene))


def _distance(tip: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Distance of two tips (T, 3) at the times that both have [m]."""
    both = min(len(tip), len(other))
    return np.asarray(np.hypot(*(tip[:both, :2] - other[:both, :2]).T))


def _limits(demands: tuple[PumpDemand, ...]) -> dict[str, float]:
    """Limits that apply to the pumps of all inlets."""
    drive, pump = demands[0].drive, demands[0].pump
    return {
        "fifth_nm": STEADY_SHARE * drive.stall_torque,
        "stall_nm": drive.stall_torque,
        "travel_low_counts": float(pump.travel[0]),
        "travel_high_counts": float(pump.travel[1]),
        "cap_pa_gauge": pump.max_pressure,
        "battery_life_s": drive.battery_life(sum(d.mean_current for d in demands)),
    }


def _numbers(demand: PumpDemand) -> dict[str, float]:
    """What the drive of an inlet is, and what the plan takes of it."""
    pump, drive, barrel = demand.pump, demand.drive, demand.barrel
    slow = barrel.compliance(demand.scene.gauge_pressure, 0.0) + _network_compliance(demand)
    fast = demand.least_compliance
    speed, torque = (float(np.max(np.abs(v))) for v in (demand.velocity, demand.torque))
    return {
        "stall_pressure_pa_gauge": drive.stall_pressure,
        "steady_pressure_pa_gauge": STEADY_SHARE * drive.stall_pressure,
        "no_load_flow_m3_s": float(drive.speed_left(0.0)) * drive.area,
        "travel_volume_m3": (pump.travel[1] - pump.travel[0]) * drive.volume_per_count,
        "volume_per_count_m3": drive.volume_per_count,
        "counts_per_ml": 1e-6 / drive.volume_per_count,
        "counts_per_kpa_fast": 1e3 * fast / drive.volume_per_count,
        "counts_per_kpa_slow": 1e3 * slow / drive.volume_per_count,
        "kpa_per_count_fast": 1e-3 * drive.volume_per_count / fast,
        "filled_length_m": drive.filled_at_home,
        "highest_pressure_pa_gauge": float(demand.pressure.max()),
        "lowest_pressure_pa_gauge": float(demand.pressure.min()),
        "largest_torque_nm": torque,
        "largest_flow_m3_s": speed * drive.area,
        "largest_current_a": float(drive.current(torque)),
        "mean_current_a": demand.mean_current,
        "fastest_speed_register": float(drive.speed_register(speed)),
        "lead_in_s": demand.lead_s,
    }


def _network_compliance(demand: PumpDemand) -> float:
    """Of all bellows that an inlet feeds, wall and gas, by the linear law [m3/Pa]."""
    scene, bellow = demand.scene, SceneQuantities(demand.scene).bellow
    part = next(c for c in scene.graph.components() if demand.inlet in c.inlets)
    one = bellow.compliance
    if not _gas_effects_off(scene):
        absolute = scene.ambient_pressure + scene.gauge_pressure
        one += gas.gas_compliance(bellow.rest_volume, absolute, scene.fluid.polytropic_exponent)
    return len(part.bellows) * one / len(part.inlets)


def _gas_effects_off(scene: Scene) -> list[str]:
    """Names of the effects that make the gas compressible and are not switched on."""
    names = names_with(Trait.COMPRESSIBLE_FLUID)
    return [name for name in names if scene.effects.mode(name) != "on"]


def _notices(
    scene: Scene, demands: tuple[PumpDemand, ...], achieved: AchievableMotion
) -> Iterator[Notice]:
    """Warnings that belong to the plan as a whole."""
    ambient = scene.ambient_pressure
    if scene.fluid.is_gas and (off := _gas_effects_off(scene)):
        swing = max(float(np.ptp(d.pressure)) for d in demands)
        rest = len(scene.graph.bellows) * SceneQuantities(scene).bellow.rest_volume
        yield Notice(
            "gas_not_counted",
            f"effects.{off[0]} is off, so the gas in the bellows counts as incompressible: up to "
            f"{1e6 * rest * swing / ambient:.3g} mL that the plunger would have to move for its "
            "compression are left out",
        )
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
                f"rounding to whole counts briefly takes the pressure {over / 1e3:.3g} kPa above "
                "the cap, where a monitored pump would stop",
                demand.inlet,
                float(demand.time[int(np.argmax(demand.pressure))]),
            )
    if achieved.unsettled_counts > SWEEPS.agreement_counts:
        yield Notice(
            "unsettled",
            f"after {achieved.sweeps} solutions the achievable motion still changes by "
            f"{achieved.unsettled_counts:.3g} counts",
        )
