"""Numbers of a scene from recordings of its motion: `fit`."""

from __future__ import annotations

import math
import time as clock
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from viscodesign._version import __version__
from viscodesign.calibration.clocks import guessed_lateness, is_late
from viscodesign.calibration.description import mismatch_of
from viscodesign.calibration.driving import RecordedDrive, driven
from viscodesign.calibration.estimate import Estimate, Search, estimated, polished, refined
from viscodesign.calibration.findings import (
    edge_warnings,
    fitted_numbers,
    fitted_products,
    fitted_runs,
    not_identified,
)
from viscodesign.calibration.fitted_spec import fitted_scene, spec_text
from viscodesign.calibration.misfit import Misfit, Unknown, first_levels
from viscodesign.calibration.pattern import Pattern, pattern_of
from viscodesign.calibration.profile_likelihood import Profiles
from viscodesign.calibration.recording import Recording, read_recording
from viscodesign.calibration.resolution import ResolutionCheck, first_solving, resolved
from viscodesign.calibration.run_model import RunModel, Solving
from viscodesign.calibration.spread import Spread, spread_of
from viscodesign.calibration.unknowns import (
    DEFAULT_KEYS,
    ranges_of,
    run_unknowns,
    scene_unknowns,
)
from viscodesign.errors import Fault, SpecError
from viscodesign.interrupt import StopRequest, gentle_interrupt
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.fit_result import Experiment, Fit, FittedNumber, RunStatus
from viscodesign.results.mismatch import Mismatch
from viscodesign.scene.reading.markers_file import MarkersFile, read_markers
from viscodesign.scene.reading.sources import SpecSource
from viscodesign.scene.reading.write import resolved_sha256
from viscodesign.scene.scene import Scene
from viscodesign.studies.least_squares import BestSoFar, FitStatus

Progress = Callable[[float], None]
TYPICAL_EVALUATIONS = 60.0
LOWER = 0.5
"""Fall of the squares on a profile from which the search had not ended at the least: 0.7 standard
deviations of a number."""
MAX_RETURNS = 2
"""Searches that go on from where a profile has led to."""


def fit(
    scene: Scene,
    data: str | Path | Sequence[str | Path],
    free: Sequence[str] | str | None = None,
    *,
    markers: SpecSource | MarkersFile | None = None,
    next_experiment: bool | None = None,
    progress: Progress | None = None,
) -> Fit:
    """Numbers of a scene by what was measured of its motion, with 95 % intervals.

    ``data``: files with columns ``time_s``, ``inlet_pressure_pa``, ``syringe_volume_m3``,
    ``m1_x_m``, ``m1_z_m``, ... (markers at the ends of the sections) or ``tip_x_m``, ``tip_z_m``,
    some of them; ``DATA.csv@KEY=VALUE`` has another value of a key. ``free``: keys of the spec, by
    default the bellows' coefficients, the fluid's viscosity and the damping time.

    ``markers``: of recordings in space, a file or a mapping with the places of the clamp's markers
    and the names of the tip's.

    Noise, gross samples and late clocks are found in the data. ``next_experiment``: whether to tell
    which experiment would be most informative; by default where a number is not identified.
    ``progress`` is called with the fraction done. Ctrl-C raises nothing once a first solution
    is there: the best so far is returned. Where the model leaves far more than
    noise, ``status`` is ``mismatch``, and no number is identified.

    Raises `SpecError` for files and keys that are none, `SolveError` where the scene has no
    solution.
    """
    began = clock.perf_counter()
    if not isinstance(scene, Scene):
        raise SpecError.plain(f"scene: needs a scene, such as load({scene!r}); got {scene!r}")
    sources = [data] if isinstance(data, (str, Path)) else list(data)
    if not sources:
        raise SpecError.plain("no data; give at least one file, such as data.csv")
    places = None if markers is None else read_markers(markers)
    recordings = [read_recording(source, scene, places) for source in sources]
    with gentle_interrupt(second_raises=True) as stop:
        fitting = _Fitting(scene, recordings, free, stop, progress)
        found = fitting.found()
        # Of a model that is wrong, no experiment tells the numbers.
        is_unsure = found.status != "mismatch" and any(
            not number.is_identified for number in found.numbers
        )
        if not stop.asked and (is_unsure if next_experiment is None else next_experiment):
            found = replace(found, next_experiment=fitting.next_experiment(found))
    return replace(found, wall_s=clock.perf_counter() - began)


@dataclass(frozen=True)
class _FitIntervals:
    """The intervals of an estimate, and what they follow from."""

    best: Estimate
    pattern: Pattern
    misfit: Misfit
    """With noise as large as the pattern calls for."""
    spread: Spread
    numbers: tuple[FittedNumber, ...]


class _Fitting:
    """One fit, from recordings to numbers."""

    def __init__(
        self,
        scene: Scene,
        recordings: Sequence[Recording],
        free: Sequence[str] | str | None,
        stop: StopRequest,
        progress: Progress | None,
    ) -> None:
        self.scene, self.recordings = scene, list(recordings)
        given = DEFAULT_KEYS if free is None else [free] if isinstance(free, str) else list(free)
        unknowns = scene_unknowns(scene, given)
        self.names = [own.name for own in unknowns]
        self._are_defaults = free is None
        self._progress, self._evaluations = progress, 0
        self.search = Search(stop, self._report_progress)
        self.drives = [self._drive(own) for own in self.recordings]
        self.clocks = [True] * len(self.recordings)
        self.all_effects = False
        self.solving = Solving()
        self.left_out: dict[str, str] = {}

    def _report_progress(self, best: BestSoFar) -> None:
        del best
        self._evaluations += 1
        if self._progress is not None:
            self._progress(1 - np.exp(-self._evaluations / TYPICAL_EVALUATIONS))

    def _drive(self, recording: Recording) -> RecordedDrive:
        """What drives a recording, in the scene with its overrides."""
        scene = self.scene
        if recording.overrides:
            pairs = (text.partition("=") for text in recording.overrides)
            changes = {key.strip(): value.strip() for key, _, value in pairs}
            if both := [name for name in self.names if name in changes]:
                message = f"is free and cannot have a value of its own in {recording.file}"
                raise SpecError([Fault(message, both[0])])
            scene = with_overrides(scene, changes, recording.file)
        return driven(scene, recording)

    # -- models -------------------------------------------------------------------

    def models(self, solving: Solving) -> list[RunModel]:
        """Models of all recordings, solved so finely."""
        return [
            RunModel(
                recording,
                drive,
                self.names,
                solving,
                clock_is_free=is_free,
                all_effects=self.all_effects,
            )
            for recording, drive, is_free in zip(
                self.recordings, self.drives, self.clocks, strict=True
            )
        ]

    def _first_models(self) -> list[RunModel]:
        """Models, after numbers that nothing measured depends on are left out, or refused."""
        models = self.models(self.solving)
        for name in list(self.names):
            reasons = [own.unmoved[name] for own in models if name in own.unmoved]
            if len(reasons) < len(models):
                continue
            if not self._are_defaults:
                raise SpecError([Fault(reasons[0], name)])
            self.left_out[name] = reasons[0].removeprefix("cannot be free: ")
            self.names.remove(name)
        self.solving = first_solving(models)
        return self.models(self.solving)

    def _unknowns(self, models: Sequence[RunModel]) -> list[Unknown]:
        own = [unknown for k, model in enumerate(models) for unknown in run_unknowns(model, k)]
        return [*scene_unknowns(self.scene, self.names), *own]

    # -- steps of the fit ---------------------------------------------------------

    def found(self) -> Fit:
        """The whole fit."""
        models = self._first_models()
        misfit = Misfit(
            models,
            self._unknowns(models),
            [first_levels(own) for own in models],
            [np.isfinite(own.measured) for own in models],
        )
        best = estimated(self.search, misfit, self._start(misfit))
        if best.status != "interrupted":
            best = self._with_certain_clocks(best)
        best, check = resolved(self.search, best, self.models, self.solving)
        if not self.search.stop.asked and self._lacks_effects(best):
            best, check = self._with_all_effects(best)
        return self._told(best, check)

    def _lacks_effects(self, best: Estimate) -> bool:
        """Whether effects that the spec's numbers do not call for are felt at the fitted ones."""
        return any(
            own.lacks_effects(best.misfit.free_values(best.values, k))
            for k, own in enumerate(best.misfit.models)
        )

    def _with_all_effects(self, best: Estimate) -> tuple[Estimate, ResolutionCheck]:
        """The fit again with every effect, from where it was."""
        self.all_effects, before = True, best.misfit
        models = self.models(self.solving)
        misfit = Misfit(models, before.unknowns, before.levels, before.kept)
        again = refined(self.search, misfit, best.values)
        return resolved(self.search, again, self.models, self.solving)

    def next_experiment(self, found: Fit) -> Experiment | None:
        """The most informative experiment beside the recordings."""
        from viscodesign.calibration.next_experiment import best_experiment

        scene = fitted_scene(self.scene, found.numbers)
        return best_experiment(scene, self.best.misfit, self.spread, self.search.stop)

    def _start(self, misfit: Misfit) -> np.ndarray:
        """The spec's numbers, and clocks as late as the motion looks."""
        start = np.array([own.start for own in misfit.unknowns])
        for k, own in enumerate(misfit.unknowns):
            if own.is_clock and own.run is not None:
                model, levels = misfit.models[own.run], misfit.levels[own.run]
                free = model.function.values[: model.free_count]
                start[k] = guessed_lateness(model, free, levels)
        return start

    def _with_certain_clocks(self, best: Estimate) -> Estimate:
        """The fit again with clocks on time, but those that are late beyond doubt."""
        deviations = spread_of(best.misfit, best.values)
        kept = np.ones(len(best.values), dtype=bool)
        for k, own in enumerate(best.misfit.unknowns):
            if own.is_clock and own.run is not None:
                sd = float(deviations.deviations[k] * deviations.sizes[k])
                kept[k] = self.clocks[own.run] = is_late(float(best.values[k]), sd)
        if kept.all():
            return best
        models = self.models(self.solving)
        before = best.misfit
        misfit = Misfit(models, self._unknowns(models), before.levels, before.kept)
        return polished(self.search, Estimate(best.values[kept], misfit, best.status), misfit)

    def _with_intervals(self, best: Estimate) -> _FitIntervals:
        """The intervals of an estimate; of a better one where a profile has led to it."""
        for turn in range(MAX_RETURNS + 1):
            pattern = pattern_of(best.misfit, best.values)
            pairs = zip(best.misfit.levels, pattern.widening, strict=True)
            widened = best.misfit.with_(levels=[level * factor for level, factor in pairs])
            spread, stop = spread_of(widened, best.values), self.search.stop
            ranges = ranges_of(widened.models, widened.unknowns)
            profiles = Profiles(widened, spread, ranges, stop)
            numbers = fitted_numbers(widened, spread, profiles, stop)
            if profiles.lowest.rise > -LOWER or stop.asked or turn == MAX_RETURNS:
                break
            best = refined(self.search, best.misfit, profiles.lowest.values, best.status)
        return _FitIntervals(best, pattern, widened, spread, numbers)

    def _told(self, best: Estimate, check: ResolutionCheck) -> Fit:
        found = self._with_intervals(best)
        best, pattern, widened, numbers = found.best, found.pattern, found.misfit, found.numbers
        self.best, self.spread = best, found.spread
        stop = self.search.stop
        products = fitted_products(widened, self.spread, numbers)
        scene = fitted_scene(self.scene, numbers)
        is_stopped = stop.asked or best.status == "interrupted"
        mismatch = (
            None
            if is_stopped
            else mismatch_of(self.scene, best.misfit, best.values, pattern.groups)
        )
        if mismatch is not None and mismatch.leaves_numbers_unknown:
            numbers, products = not_identified(numbers), ()
        mesh = {
            "edges_per_section": check.edges_per_section,
            "tolerance": check.tolerance,
            "bias_sd": check.bias,
            "bias_key": check.key or None,
        }
        return Fit(
            name=self.scene.name,
            version=__version__,
            spec_sha256=self.scene.source.sha256,
            status=_status("interrupted" if is_stopped else best.status, mismatch),
            numbers=numbers,
            products=products,
            runs=fitted_runs(best.misfit, self.spread, best.values),
            chi2_per_dof=pattern.chi2_per_dof,
            effects=frozenset().union(*(m.function.effects for m in best.misfit.models)),
            mesh=mesh,
            spec=spec_text(scene, numbers),
            resolved_sha256=resolved_sha256(self.scene),
            left_out=tuple(self.left_out.items()),
            warnings=(
                *_search_warnings(best.status),
                *self._warnings(check, pattern.channels),
                *edge_warnings(numbers),
            ),
            mismatch=mismatch,
            evaluations=self.search.evaluations,
        )

    def _warnings(self, check: ResolutionCheck, patterned: Sequence[str]) -> list[str]:
        found = [f"{own.file}: {notice}" for own in self.recordings for notice in own.notices]
        if any(own.is_exact for own in self.drives):
            found.append(
                "the measured pressure counts as exact where it is followed in many pieces: its "
                "noise is in no interval, and some may be far too narrow; give the spec the input "
                "that was commanded"
            )
        if patterned:
            found.append(
                f"what the model leaves of {', '.join(patterned)} follows a pattern: it misses "
                "something that the data show; the intervals are widened, and may still be too "
                "narrow"
            )
        if not math.isfinite(check.bias):
            found.append("how far a finer mesh or tolerance would move numbers is unknown")
        elif not check.is_sufficient:
            found.append(
                f"a finer mesh or tolerance would move {check.key or 'numbers'} by about "
                f"{check.bias:.2g} standard deviations"
            )
        return found


def _search_warnings(status: FitStatus) -> Iterator[str]:
    if status == "unfinished":
        yield (
            "the search ended before it had settled: numbers and intervals may be off; go on from "
            "spec.yaml as the spec"
        )


def _status(search: FitStatus, mismatch: Mismatch | None) -> RunStatus:
    """Status of a fit, by how its search ended and what its model leaves."""
    if search == "interrupted":
        return "interrupted"
    if mismatch is not None and mismatch.leaves_numbers_unknown:
        return "mismatch"
    return "unfinished" if search == "unfinished" else "complete"


def with_overrides(scene: Scene, changes: dict[str, str], file: str) -> Scene:
    """The scene of one recording. Raises `SpecError` that names its file."""
    try:
        return scene.replace(changes)
    except SpecError as error:
        raise SpecError([replace(fault, file=file) for fault in error.faults]) from None
