"""What a plan of a pump's motion holds: courses, verdicts, changes, and two runs. Plain data.

Times of the courses begin with the lead-in, those of the runs behind it.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal, NamedTuple

import numpy as np

from viscodesign.errors import PumpError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.pump.profile import Profile
from viscodesign.results.findings import Notice
from viscodesign.results.trajectory import Status, Trajectory

Severity = Literal["ok", "advice", "infeasible"]


@dataclass(frozen=True)
class SuggestedChange:
    """One change that makes a verdict pass, as was tried, and what is left to do after it."""

    key: str  # a key of the spec, or "pressure", "time" or "ramp"
    words: str  # as in 'every pressure of the input times 0.62'
    settings: tuple[str, ...]  # for `--set`; none where a table of the spec holds the numbers
    leaves: tuple[str, ...]  # verdicts that are infeasible after it
    factor: float = 1.0  # of all pressures, or all times, where that is what it changes


@dataclass(frozen=True)
class PumpVerdict:
    """One limit of a pump, held against what a motion asks."""

    name: str
    inlet: str
    severity: Severity
    wanted: float  # at the worst time, in `unit`
    allowed: float
    unit: str
    ratio: float  # how much of what is allowed is asked; above 1 it is too much
    time_s: float  # the worst time, lead-in included [s]
    message: str
    changes: tuple[SuggestedChange, ...] = ()


@dataclass(frozen=True)
class PumpCourse:
    """Motion of P axes at T times from the start of the lead-in; arrays (T, P)."""

    time: np.ndarray  # (T,) [s]
    lead_s: float  # part before the scene's own t = 0: from home to what the start needs [s]
    pressure: np.ndarray  # gauge [Pa]
    steps: np.ndarray  # targets of the axis, not rounded
    columns: Mapping[str, np.ndarray]
    """All that a table shows, by the last words of its columns, as in `PumpDemand.columns`: of any
    axis ``given_m3``, to the network since it was filled [m3 at ambient density]; of a plunger
    ``plunger_m`` and ``volume_m3``, pushed in from home, and its shares of stall and speed."""


class Panel(NamedTuple):
    """One quantity of a course against time, as a picture shows it."""

    label: str
    column: str
    factor: float
    marks: tuple[tuple[str, float], ...] = ()  # levels with their names
    shows: float = 1.0  # share of a mark that brings it into the picture where a curve comes to it
    limits: tuple[float, float] = (-np.inf, np.inf)  # beyond which nothing is drawn


@dataclass(frozen=True, eq=False)
class PumpPlan:
    """A scene's pressures as plunger motion, its limits, and what the pump would do instead."""

    name: str
    version: str
    spec_sha256: str
    status: Status
    failure: str | None
    inlets: tuple[str, ...]
    axes: tuple[int, ...]  # id of each inlet's axis
    noun: str  # what an axis is called: servo
    device: str  # what drives it, as its maker calls it
    unit: str  # of several steps
    wanted: PumpCourse
    achievable: PumpCourse
    wanted_run: Trajectory
    achievable_run: Trajectory
    deviation: np.ndarray  # (T,) distance of both tips at the runs' times [m], the largest of all
    clipped: tuple[str, ...]  # what of the wanted motion the pump cannot do, in words
    sweeps: int  # solutions of the achievable motion until it and its pressure agreed
    unsettled_steps: float  # by how much the last two of them differed
    verdicts: tuple[PumpVerdict, ...]
    together: tuple[SuggestedChange, ...]  # changes that together make it feasible; or none
    numbers: Mapping[str, Mapping[str, float]]  # inlet -> its drive, by names with units
    limits: Mapping[str, float]  # what holds for all inlets, by names with units
    warnings: tuple[Notice, ...]
    words: Mapping[str, Mapping[str, str]]  # inlet -> its drive, for people: heading -> sentence
    panels: tuple[Panel, ...]  # of its picture
    resolved_sha256: str = ""
    """SHA-256 of the resolved spec, with all overrides."""
    actuators: tuple[str, ...] = ()
    """The names of several; none for one."""

    def __repr__(self) -> str:
        why = ", ".join(verdict.name for verdict in self.infeasible)
        verdict = f"infeasible ({why})" if why else "feasible"
        return f"<PumpPlan {self.name}: {self.status}, {verdict}, {self.wanted.time[-1]:g} s>"

    @property
    def infeasible(self) -> tuple[PumpVerdict, ...]:
        """The verdicts that forbid it."""
        return tuple(v for v in self.verdicts if v.severity == "infeasible")

    @property
    def is_feasible(self) -> bool:
        """Whether no verdict forbids it."""
        return not self.infeasible

    def tips(self, run: Trajectory) -> dict[str, np.ndarray]:
        """Tips of one of both runs (T, 3), x, z [m] and angle [rad], by actuator.

        A single one has an empty name.
        """
        each = np.split(run.tip, max(len(self.actuators), 1), axis=1)
        return dict(zip(self.actuators or ("",), each, strict=True))

    @property
    def deviation_m(self) -> float:
        """Largest distance of the two tips [m]."""
        return float(np.max(self.deviation, initial=0.0))

    @property
    def error_m(self) -> float | None:
        """Sum of the tip errors that both runs state [m]."""
        runs = (self.wanted_run, self.achievable_run)
        errors = [run.accuracy.estimated_tip_error_m for run in runs]
        return None if None in errors else sum(e for e in errors if e is not None)

    @property
    def error_qualifier(self) -> str:
        """The model to which that error refers, in words."""
        runs = (self.wanted_run, self.achievable_run)
        return next((run for run in runs if run.violations), self.wanted_run).error_qualifier

    @property
    def validity(self) -> str:
        """ "inside" where both runs stay within what their model describes, else "outside"."""
        runs = (self.wanted_run, self.achievable_run)
        return "outside" if "outside" in {run.validity for run in runs} else "inside"

    def profile(self, course: PumpCourse) -> Profile:
        """A course as what a board plays."""
        return Profile(self.inlets, self.axes, course.time, course.steps, course.pressure)


NOT_CLIPPED = ("voltage", "battery")
"""Limits that no smaller motion satisfies."""


def refuse_infeasible(plan: PumpPlan, achievable: bool) -> None:
    """Raise `PumpError` with every reason against a plan.

    ``achievable``: the user accepts what the pump can do instead.
    """
    if plan.status != "complete":
        raise PumpError(f"the plan is {plan.status}: {plan.failure}")
    bad = [v for v in plan.infeasible if not achievable or v.name in NOT_CLIPPED]
    if bad:
        remedy = "`pump plan` says what to change"
        remedy += (
            ""
            if achievable
            else "; --achievable (achievable=True in Python) plays what the pump can do"
        )
        reasons = (f"  {v.message}" for v in bad)
        raise PumpError("\n".join(["the pump cannot reproduce this profile:", *reasons, remedy]))
