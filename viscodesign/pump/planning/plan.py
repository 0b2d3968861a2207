"""The study: from a scene's pressures to a plunger's motion, its limits, and what comes of it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from viscodesign._version import __version__
from viscodesign.effects.base import Trait
from viscodesign.effects.catalogue import names_with
from viscodesign.physics import gas
from viscodesign.pump import syringe
from viscodesign.pump.planning.achievable import SWEEPS, AchievableMotion, achievable_motion
from viscodesign.pump.planning.barrel import feed_line_at
from viscodesign.pump.planning.demand import PumpDemand, course_of
from viscodesign.pump.planning.fixes import combined_fix, fixes_for
from viscodesign.pump.planning.limits import verdicts
from viscodesign.pump.planning.model_runs import InletHistory, active_effects, run_verified
from viscodesign.pump.planning.requested import RequestedMotion, lead_in, shares_a_network
from viscodesign.pump.planning.result import PumpPlan, PumpVerdict
from viscodesign.pump.planning.scene_variants import planned, pump_of, servo_ids, with_effects_of
from viscodesign.pump.planning.trials import Trials
from viscodesign.pump.servo_motor import STEADY_SHARE
from viscodesign.results.findings import Notice
from viscodesign.results.trajectory import Status, Trajectory
from viscodesign.scene.scene import Scene
from viscodesign.simulation.solve_once import Progress

CAP_REL_TOL = 0.01
"""Part of the cap by which it may be passed without a word."""


def plan(scene: Scene, *, progress: Progress | None = None) -> PumpPlan:
    """Plan a pump's motion for the pressures that a scene asks for.

    The scene is simulated with its own coupled model, which says what every inlet gives; barrel
    and dead volume say where its plunger is then. That is held against what the pump can do at
    each pressure, and what the pump does instead is simulated again. ``progress`` is given the
    part that is done. Raises `SpecError` where the scene has no pump or no pressures to plan
    for, `SolveError` where a run breaks off.
    """
    pump = pump_of(scene)
    first = planned(scene)
    run = run_verified(first, progress)
    settled, active = with_effects_of(first, run), active_effects(run)
    inlets = InletHistory.of(run)
    lines = {name: feed_line_at(settled, name, active) for name in scene.inputs}
    lead = lead_in(settled, pump, lines, inlets, active)
    requested = RequestedMotion(settled, inlets, active, lines, lead)
    demands = requested.demands(pump)
    trials = Trials(settled, requested, pump)
    found = tuple(_with_changes(trials, v) for d in demands for v in verdicts(d))
    achieved = achievable_motion(requested, pump, progress)
    status, failure = _status(run, achieved.run)
    return PumpPlan(
        name=scene.name,
        version=__version__,
        spec_sha256=scene.source.sha256,
        status=status,
        failure=failure,
        inlets=tuple(scene.inputs),
        servos=servo_ids(scene, pump),
        servo=demands[0].servo.title,
        wanted=course_of(demands),
        achievable=course_of(achieved.demands),
        wanted_run=run,
        achievable_run=achieved.run,
        deviation=_deviation(run, achieved.run),
        clipped=achieved.clipped,
        sweeps=achieved.sweeps,
        unsettled_counts=achieved.unsettled_counts,
        verdicts=found,
        together=combined_fix(trials, found),
        numbers={d.inlet: _numbers(d) for d in demands},
        limits=_limits(demands),
        warnings=(*_notices(settled, demands, achieved), *run.warnings),
    )


def _with_changes(trials: Trials, verdict: PumpVerdict) -> PumpVerdict:
    if verdict.severity == "ok":
        return verdict
    return replace(verdict, changes=fixes_for(trials, verdict))


def _status(*runs: Trajectory) -> tuple[Status, str | None]:
    bad = (run for run in runs if run.status != "complete")
    return next(((run.status, run.failure) for run in bad), ("complete", None))


def _deviation(run: Trajectory, other: Trajectory) -> np.ndarray:
    """Distance of two tips at the times that both have (T,) [m]."""
    both = min(len(run.tip), len(other.tip))
    apart = run.tip[:both, :2] - other.tip[:both, :2]
    return np.asarray(np.hypot(apart[:, 0], apart[:, 1]))


def _limits(demands: tuple[PumpDemand, ...]) -> dict[str, float]:
    """Limits that apply to the pumps of all inlets."""
    first, pump = demands[0], demands[0].pump
    current = sum(d.mean_current for d in demands)
    return {
        "fifth_nm": STEADY_SHARE * first.stall_torque,
        "stall_nm": first.stall_torque,
        "travel_low_counts": float(pump.travel[0]),
        "travel_high_counts": float(pump.travel[1]),
        "cap_pa_gauge": pump.max_pressure,
        "battery_life_s": syringe.battery_life(pump.battery_capacity, current),
    }


def _numbers(demand: PumpDemand) -> dict[str, float]:
    """What the drive of an inlet is, and what the plan takes of it."""
    pump, drive, barrel = demand.pump, demand.drive, demand.barrel
    slow = barrel.compliance(barrel.baseline, 0.0) + _network_compliance(demand)
    shape = (pump.syringe_diameter, pump.pinion_diameter)
    per_pressure = syringe.counts_per_pressure(demand.least_compliance, *shape)
    free = float(syringe.speed_left(demand.servo, pump.supply_voltage, 0.0))
    low, high = pump.travel
    speed, torque = (float(np.max(np.abs(v))) for v in (demand.velocity, demand.torque))
    return {
        "stall_pressure_pa_gauge": demand.stall_pressure,
        "steady_pressure_pa_gauge": STEADY_SHARE * demand.stall_pressure,
        "no_load_flow_m3_s": float(syringe.flow_rate(free, *shape)),
        "travel_volume_m3": (high - low) * drive.volume_per_count,
        "volume_per_count_m3": drive.volume_per_count,
        "counts_per_ml": 1e-6 * syringe.counts_per_volume(*shape),
        "counts_per_kpa_fast": 1e3 * per_pressure,
        "counts_per_kpa_slow": 1e3 * syringe.counts_per_pressure(slow, *shape),
        "kpa_per_count_fast": 1e-3 / per_pressure,
        "filled_length_m": drive.filled_at_home,
        "highest_pressure_pa_gauge": float(demand.pressure.max()),
        "lowest_pressure_pa_gauge": float(demand.pressure.min()),
        "largest_torque_nm": torque,
        "largest_flow_m3_s": speed * drive.area,
        "largest_current_a": float(np.max(syringe.servo_current(demand.servo, demand.torque))),
        "mean_current_a": demand.mean_current,
        "fastest_speed_register": float(syringe.speed_register(speed * 2 / pump.pinion_diameter)),
        "lead_in_s": demand.lead_s,
    }


def _network_compliance(demand: PumpDemand) -> float:
    """Of all bellows that an inlet feeds, wall and gas, by the linear law [m3/Pa]."""
    scene = demand.scene
    part = next(c for c in scene.graph.components() if demand.inlet in c.inlets)
    bellows, absolute = scene.bellows, scene.ambient_pressure + scene.gauge_pressure
    one = bellows.length * bellows.area_per_pressure
    if not _gas_effects_off(scene):
        rest = bellows.height * bellows.width * bellows.length
        one += gas.gas_compliance(rest, absolute, scene.fluid.polytropic_exponent)
    return len(part.bellows) * one / len(part.inlets)


def _gas_effects_off(scene: Scene) -> list[str]:
    """Names of the effects that make the gas compressible and are not switched on."""
    names = names_with(Trait.COMPRESSIBLE_FLUID)
    return [name for name in names if scene.effects.mode(name) != "on"]


def _notices(
    scene: Scene, demands: tuple[PumpDemand, ...], achieved: AchievableMotion
) -> Iterator[Notice]:
    """Warnings that belong to the plan as a whole."""
    if scene.fluid.is_gas and (off := _gas_effects_off(scene)):
        rest = scene.bellows.height * scene.bellows.width * scene.bellows.length
        swing = max(float(np.ptp(d.pressure)) for d in demands)
        missing = len(scene.graph.bellows) * rest * swing / scene.ambient_pressure
        yield Notice(
            "gas_not_counted",
            f"effects.{off[0]} is off, so the gas in the bellows counts as "
            f"incompressible: up to {1e6 * missing:.3g} mL that the plunger would have to move "
            "for its compression are left out",
        )
    highest, ambient = max(float(d.pressure.max()) for d in demands), scene.ambient_pressure
    if highest > ambient:
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
                f"whole counts bring the pressure {over / 1e3:.3g} kPa above the cap for "
                "moments: a pump that monitors it would stop there",
                demand.inlet,
                float(demand.time[int(np.argmax(demand.pressure))]),
            )
    if achieved.unsettled_counts > SWEEPS.agreement_counts:
        yield Notice(
            "unsettled",
            f"after {achieved.sweeps} solutions the achievable motion still changes by "
            f"{achieved.unsettled_counts:.3g} counts",
        )
