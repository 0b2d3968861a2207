"""Plans that nobody had to compute, or only once."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from tests.trajectories import made_run
from viscodesign.pump.planning.plan import plan as plan_pump
from viscodesign.pump.planning.result import PumpCourse, PumpPlan, PumpVerdict
from viscodesign.pump.profile import Profile
from viscodesign.scene.scene import Scene


def made_course(profile: Profile, lead: float = 0.0) -> PumpCourse:
    """A course through a profile's counts; of its other columns only what is told."""
    shape = profile.steps.shape
    return PumpCourse(
        time=profile.time,
        lead_s=lead,
        pressure=profile.pressure,
        steps=profile.steps,
        columns={
            "volume_m3": 0.0725e-6 * (profile.steps - profile.steps[0]),
            "stall_share": np.full(shape, 0.12),
            "speed_share": np.full(shape, 0.3),
        },
    )


def made_plan(profile: Profile, lead: float = 0.0, *, feasible: bool = True) -> PumpPlan:
    """A plan whose pump plays a profile."""
    run = made_run(
        name="leg",
        bellows=2,
        time=np.array([0.0, 1.0]),
    ).with_arrays(tip=np.array([[0.0, 0.109, 0.0], [0.02, 0.1, 0.4]]))
    verdict = PumpVerdict(
        name="pressure",
        inlet=profile.inlets[0],
        severity="ok" if feasible else "infeasible",
        wanted=30e3,
        allowed=25e3,
        unit="Pa",
        ratio=1.2,
        time_s=0.5,
        message="up to 30 kPa gauge; pump.max_pressure allows 25 kPa",
    )
    course = made_course(profile, lead)
    numbers = {"kpa_per_count_fast": 0.1, "volume_per_count_m3": 0.0725e-6}
    return PumpPlan(
        name="leg",
        version="0.0.0",
        spec_sha256="00ff" * 16,
        status="complete",
        failure=None,
        inlets=profile.inlets,
        axes=profile.axes,
        noun="servo",
        unit="counts",
        device="AX-18A",
        wanted=course,
        achievable=replace(course, steps=np.round(course.steps)),
        wanted_run=run,
        achievable_run=run,
        deviation=np.zeros(2),
        clipped=(),
        sweeps=1,
        unsettled_steps=0.0,
        verdicts=(verdict,),
        together=(),
        numbers={name: numbers for name in profile.inlets},
        limits={"fifth_nm": 0.36, "stall_nm": 1.8},
        warnings=(),
        words={},
        panels=(),
    )


def planner(plan: PumpPlan) -> Any:
    """Takes the place of `planning.plan.plan`."""
    return lambda scene, **_: plan


_KNOWN: dict[bytes, PumpPlan] = {}


def planned_once(scene: Scene, **more: Any) -> PumpPlan:
    """Takes the place of `planning.plan.plan`: equal scenes are planned once in a process."""
    if scene.digest not in _KNOWN:
        _KNOWN[scene.digest] = plan_pump(scene, **more)
    return _KNOWN[scene.digest]
