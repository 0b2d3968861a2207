"""A hard case: a scene, its expected outcome, and the actual one."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np

from tests.scenes import leg
from viscodesign import Scene, Trajectory, simulate
from viscodesign.effects.select import select_effects
from viscodesign.errors import ViscodesignError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.simulation.build_problem import Settings
from viscodesign.simulation.solve_once import solve

VOLUME = 1e-8
"""Allowed relative imbalance of fluid volume."""
ENERGY = 1e-4
"""Allowed imbalance of energy at the default accuracy, relative to the work done."""
UNREFINED = 1e-2
"""The same for a run that failed, whose first solution was never refined."""
OVERSHOOT = 1e-3
"""Fraction of the inlet's swing by which a pressure may leave its range, at the default accuracy."""
EXACT = "accuracy=0.0001 %"
"""The only other accuracy in the table: for criteria with many digits."""
STIR = frozenset({"feedback", "fluid_inertance"})
"""Effects with which pressures may leave the range of the inlet's."""

Ending = Literal["complete", "failed", "refused"]


@dataclass(frozen=True)
class Finding:
    """A number that was found, and the expected one."""

    what: str
    found: float
    wanted: float
    allowed: float
    """Largest absolute difference."""

    @property
    def share(self) -> float:
        """Deviation as a fraction of the allowed one; NaN where nothing was found."""
        if self.found == self.wanted:
            return 0.0
        return abs(self.found - self.wanted) / self.allowed if self.allowed else math.inf

    @property
    def holds(self) -> bool:
        """Whether the deviation is within the allowed one."""
        return self.share <= 1.0

    def __str__(self) -> str:
        return f"{self.what} = {self.found:.10g} (wanted {self.wanted:.10g} ± {self.allowed:.2g})"


def relative(what: str, found: float, wanted: float, share: float) -> Finding:
    """A finding with a relative tolerance."""
    return Finding(what, float(found), float(wanted), share * abs(float(wanted)))


def at_most(what: str, found: float, limit: float) -> Finding:
    """A finding whose magnitude has a limit."""
    return Finding(what, float(found), 0.0, limit)


def true(what: str, holds: bool) -> Finding:
    """A yes-or-no finding."""
    return Finding(what, float(bool(holds)), 1.0, 0.0)


def warned(run: Trajectory, code: str) -> Finding:
    """Whether a run gave a warning."""
    return true(f"warning '{code}'", any(notice.code == code for notice in run.warnings))


Judge = Callable[[Trajectory], Iterable[Finding]]


@dataclass(frozen=True)
class Case:
    """One row of the table: the paper's leg with single keys changed, and the expected outcome."""

    number: str
    """Its unique number."""
    name: str
    """What is hard about it."""
    must: str
    """The criterion, in words."""
    changes: tuple[str, ...] = ()
    """Spec keys that differ from the configuration, as 'key=value'."""
    judge: Judge = lambda run: ()
    """Findings beyond the invariants that every case must satisfy."""
    ending: Ending = "complete"
    says: tuple[str, ...] = ()
    """Words that the message must contain if the case fails or is refused."""
    config: str = "leg_16_straight_air"
    converges: bool = True
    """Whether to compare with a solution on half the mesh, where one is affordable."""

    def scene(self) -> Scene:
        """The scene; raises `SpecError` where the spec is refused."""
        return leg(*self.changes, config=self.config)


@dataclass(frozen=True)
class Outcome:
    """The outcome of a case."""

    case: Case
    ending: Ending
    message: str
    findings: tuple[Finding, ...]
    run: Trajectory | None = None

    @property
    def complaints(self) -> list[str]:
        """Everything that is not as expected."""
        found = [str(finding) for finding in self.findings if not finding.holds]
        if self.ending != self.case.ending:
            found.append(f"it was to be {self.case.ending}, and is {self.ending}: {self.message}")
        found += [f"'{word}' is not in: {self.message}" for word in self._unsaid()]
        return found

    def _unsaid(self) -> list[str]:
        said = self.message.lower()
        return [word for word in self.case.says if word.lower() not in said]


def outcome(case: Case) -> Outcome:
    """Solve a case with the default settings, and check it."""
    try:
        run = simulate(case.scene())
    except ViscodesignError as error:
        return Outcome(case, "refused", str(error), ())
    ending: Ending = "complete" if run.status == "complete" else "failed"
    findings = [*_whole(run), *_balanced(run), *_within_range(case, run), *case.judge(run)]
    return Outcome(case, ending, run.failure or "", tuple(findings), run)


def _whole(run: Trajectory) -> Iterator[Finding]:
    arrays = (run.time, run.tip, run.pressure, run.volume, run.flow, run.shape)
    yield true("every number is finite", all(np.isfinite(a).all() for a in arrays))


def _balanced(run: Trajectory) -> Iterator[Finding]:
    volume, energy = run.invariants.volume_imbalance_rel, run.invariants.energy_imbalance_rel
    if volume is not None:
        yield at_most("volume imbalance", volume, VOLUME)
    complete = run.status == "complete"
    if complete:
        yield true("energy is told", energy is not None)
    if energy is not None:
        yield at_most("energy imbalance", energy, ENERGY if complete else UNREFINED)


def _within_range(case: Case, run: Trajectory) -> Iterator[Finding]:
    """Without feedback and inertance, pressures stay within the range of the inlets'."""
    taken = {verdict.name for verdict in run.effects if verdict.taken}
    scene = case.scene()
    sources = [source for source in scene.inputs.values() if source.gives_pressure]
    if STIR & taken or len(sources) < len(scene.inputs):
        return
    duration = scene.run.duration
    corners = [t for s in sources for t in s.corners(duration)][:MOST_CORNERS]
    times = np.unique([*np.linspace(0.0, duration, 5000), *corners])
    told = [scene.gauge_pressure + source.values(times) for source in sources]
    history = np.concatenate([*told, run.pressure[0], *run.inlet_pressure.values()])
    low, high = float(history.min()), float(history.max())
    beyond = max(run.pressure.max() - high, low - run.pressure.min(), 0.0)
    yield at_most("pressure beyond the inlets' range", beyond, OVERSHOOT * (high - low) + 1e-9)


MOST_CORNERS = 2000


def moved_by_refinement(case: Case, run: Trajectory) -> Finding:
    """How far the tip moves at half the tolerance on half the mesh, against the stated error."""
    quantities = SceneQuantities(case.scene())
    selection = select_effects(quantities)
    used = run.settings
    finer = Settings(2 * used["edges_per_section"], used["tolerance"] / 2, used["solver"])
    effects = selection.members(frozenset(v.name for v in run.effects if v.taken))
    again = solve(quantities, effects, finer).motion
    both = min(len(again.tip), len(run.tip))
    apart = np.hypot(*(again.tip[:both, :2] - run.tip[:both, :2]).T)
    stated = run.accuracy.estimated_tip_error_m or 0.0
    return at_most("tip's move on refinement", float(apart.max()), max(stated, ROUND_OFF))


ROUND_OFF = 1e-12
"""[m]"""
