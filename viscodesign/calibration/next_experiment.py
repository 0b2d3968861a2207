"""Which experiment would be most informative: a payload, a faster pulse, one more sensor.

What an experiment would determine follows from the derivatives of its channels at the fitted
numbers, with the noise of the instruments in use and its pressures taken as known. It adds to
the data at hand.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from viscodesign.calibration.driving import RecordedDrive
from viscodesign.calibration.misfit import Misfit
from viscodesign.calibration.profile_likelihood import NORMAL_95
from viscodesign.calibration.recorded_columns import Measured
from viscodesign.calibration.recording import RecordedChannel, Recording
from viscodesign.calibration.run_model import RunModel, Solving
from viscodesign.calibration.spread import UNKNOWN_DEVIATION, Spread
from viscodesign.effects.catalogue import catalogue
from viscodesign.errors import ViscodesignError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.interrupt import StopRequest
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.fit_result import Experiment
from viscodesign.scene.cross_checks import SINGLE_INLET
from viscodesign.scene.scene import Scene


@dataclass(frozen=True)
class ExperimentRules:
    """Experiments that are weighed, and what one must be worth."""

    payloads: tuple[float, ...] = (2.0, 7.0)
    """In masses of the actuator."""
    pulse_times: float = 3.0
    """Duration of a fast pulse's flanks, relative to the body's own motion."""
    pulse_at: tuple[float, ...] = (0.1, 0.6)
    """When the pressure falls and when it rises again, as parts of the run."""
    volume_noise: float = 0.005
    """Noise of a syringe's volume, relative to what it delivers, where none was measured."""
    well_known_number: float = 0.01
    """Standard deviation below which it is of no more use to know a number better."""
    most_planned_times: int = 240


RULES = ExperimentRules()
EFFORT = 0.15
"""Mean gain, in the logarithm of a standard deviation, that one more change must be worth."""


@dataclass(frozen=True)
class Candidate:
    """An experiment that could be made."""

    scene: Scene
    overrides: tuple[str, ...]
    words: tuple[str, ...]
    """What is changed, each in words."""


def best_experiment(
    scene: Scene, misfit: Misfit, spread: Spread, stop: StopRequest
) -> Experiment | None:
    """The experiment after which the numbers of a fitted scene would be known best.

    None where the user asked to stop, or where none can be solved.
    """
    known = np.linalg.inv(spread.by_data[np.ix_(misfit.pulled, misfit.pulled)])
    found: list[tuple[float, Experiment]] = []
    for candidate in _candidates(scene, misfit.models[0]):
        if stop.asked:
            return None
        try:
            options = list(_judged(candidate, misfit, spread, known))
        except ViscodesignError:
            continue  # This one has no solution.
        found += options
    return min(found, key=lambda own: own[0])[1] if found else None


# -- what could be made -----------------------------------------------------------


def _candidates(scene: Scene, model: RunModel) -> Iterator[Candidate]:
    """Payloads and pulses in all combinations, nothing changed first."""
    for payload, pulse in itertools.product([(), *_payloads(scene)], [(), *_pulses(scene, model)]):
        changes = dict([*payload[:-1], *pulse[:-1]])
        words = tuple(str(own[-1][1]) for own in (payload, pulse) if own)
        try:
            own = scene.replace(changes) if changes else scene
        except ViscodesignError:
            continue
        overrides = tuple(f"{key}={_written(value)}" for key, value in changes.items())
        yield Candidate(own, overrides, words)


WEIGHT = "loads.gravity"
Changes = tuple[tuple[str, object], ...]
"""Keys with values; the last one is "words" with the words."""


def _payloads(scene: Scene) -> Iterator[Changes]:
    """Masses at the tip, and gravity where the scene had none."""
    body = SceneQuantities(scene).body
    for ratio in RULES.payloads:
        mass = _rounded(ratio * body.mass_per_length * body.length)
        if math.isclose(mass, scene.loads.payload, rel_tol=0.3):
            continue
        changes: list[tuple[str, object]] = [("loads.payload", f"{1e3 * mass:g} g")]
        hanging = ""
        if scene.loads.gravity is None:
            moved_by = (name for name, kind in catalogue().items() if WEIGHT in kind.keys)
            changes += [(WEIGHT, "on"), *((f"effects.{name}", "on") for name in moved_by)]
            hanging = ", hanging"
        yield (*changes, ("words", f"a payload of {1e3 * mass:g} g at the tip{hanging}"))


def _pulses(scene: Scene, model: RunModel) -> Iterator[Changes]:
    """A fast pulse over the range of the run's pressures."""
    source = scene.inputs.get(SINGLE_INLET)
    if source is None or not source.gives_pressure:
        return
    duration = float(model.function.times[-1])
    own = model.drive.scene.inputs[SINGLE_INLET]
    low, high = own.extremes(duration)
    flank = _rounded(RULES.pulse_times * SceneQuantities(scene).scales.t_s)
    if own.swing_time_within(duration) < 1.5 * flank or not high > low:
        return
    start = float(own.values(np.zeros(1))[0])
    begins_high = start > (low + high) / 2
    pulse = {
        "kind": "double_sigmoid",
        "start": high if begins_high else low,
        "drop": (high - low) * (1 if begins_high else -1),
        "fall_time": RULES.pulse_at[0] * duration,
        "rise_time": RULES.pulse_at[1] * duration,
        "transition": flank,
    }
    words = f"a pulse between {1e-3 * low:.3g} and {1e-3 * high:.3g} kPa with flanks of {flank:g} s"
    yield (("input", pulse), ("words", words))


def _rounded(value: float) -> float:
    """The nearest of 1, 2, 5 times a power of ten."""
    power = 10.0 ** math.floor(math.log10(value))
    steps = [step * power for step in (1.0, 2.0, 5.0, 10.0)]
    return float(f"{min(steps, key=lambda step: abs(math.log(step / value))):.3g}")


def _written(value: object) -> str:
    """A value as `--set` takes it."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{k}: {_written(v)}" for k, v in value.items()) + "}"
    return f"{value:.6g}" if isinstance(value, float) else str(value)


# -- what it would determine -----------------------------------------------------------


def _judged(
    candidate: Candidate, misfit: Misfit, spread: Spread, known: np.ndarray
) -> Iterator[tuple[float, Experiment]]:
    """The experiment with the sensors in use, and with the volume, too: scores, low is good."""
    first = misfit.models[0]
    has_volume = bool(first.recording.of(Measured.VOLUME))
    model = _model(candidate, first, misfit)
    levels = _levels(model, first, misfit.levels[0])
    slopes = model.jacobian(model.function.values[: model.free_count], model.own_values)
    for takes_volume in (False, True):
        is_same = not candidate.words and takes_volume == has_volume
        if has_volume and not takes_volume:
            continue
        if takes_volume and not np.isfinite(levels).all():
            continue
        used = [
            k
            for k, channel in enumerate(model.channels)
            if takes_volume or channel.measured is not Measured.VOLUME
        ]
        told = _information(model, slopes[:, used], levels[used], misfit, spread)
        deviations = np.sqrt(np.diag(np.linalg.inv(known + told)))
        sensors = ("syringe_volume_m3",) if takes_volume and not has_volume else ()
        effort = EFFORT * (len(candidate.words) + len(sensors))
        score = (
            float(np.mean(np.log(np.clip(deviations, RULES.well_known_number, UNKNOWN_DEVIATION))))
            + effort
        )
        yield score, _experiment(candidate, sensors, deviations, misfit, spread, is_same)


def _model(candidate: Candidate, first: RunModel, misfit: Misfit) -> RunModel:
    """The model of a run of the experiment, its rows those of the first recording."""
    time = first.recording.time - first.recording.time[0]
    time = np.linspace(0.0, time[-1], min(len(time), RULES.most_planned_times))
    nothing = np.zeros(len(time))
    channels = [replace(own, values=nothing) for own in first.recording.channels]
    outputs = {own.output for own in channels}
    for inlet in candidate.scene.inputs:
        tail = "" if inlet == SINGLE_INLET else f"_{inlet}"
        for measured, output in (
            (Measured.PRESSURE, f"inlet_pressure{tail}_pa"),
            (Measured.VOLUME, f"inflow{tail}_m3"),
        ):
            if output not in outputs:
                channels.append(RecordedChannel(output, measured, output, nothing))
    recording = Recording("", time, tuple(channels))
    pressures = tuple(recording.of(Measured.PRESSURE))
    drive = RecordedDrive(candidate.scene, (), 0.0, 0.0, pressures, ())
    names = [misfit.unknowns[k].name for k in misfit.pulled]
    return RunModel(recording, drive, names, Solving(), clock_is_free=False)


def _levels(model: RunModel, first: RunModel, levels: np.ndarray) -> np.ndarray:
    """(C,) Noise of the channels: as measured, or guessed for a syringe's volume."""
    known = {own.output: float(level) for own, level in zip(first.channels, levels, strict=True)}
    expected = model(model.function.values[: model.free_count], model.own_values)
    found = []
    for k, own in enumerate(model.channels):
        guess = RULES.volume_noise * float(np.ptp(expected[:, k])) or math.inf
        found.append(known.get(own.output, guess))
    return np.array(found)


def _information(
    model: RunModel, slopes: np.ndarray, levels: np.ndarray, misfit: Misfit, spread: Spread
) -> np.ndarray:
    """(f, f) What the channels (T, C, f + o) tell of steps of the free numbers."""
    sizes = {
        misfit.unknowns[k].name: (place, float(spread.sizes[k]))
        for place, k in enumerate(misfit.pulled)
    }
    rows = np.zeros((slopes.shape[0] * slopes.shape[1], len(misfit.pulled)))
    weighed = (slopes / levels[None, :, None]).reshape(len(rows), -1)
    for column, name in enumerate(model.free_names):
        place, size = sizes[name]
        rows[:, place] = weighed[:, column] * size
    return np.asarray(rows.T @ rows)


def _experiment(
    candidate: Candidate,
    sensors: Sequence[str],
    deviations: np.ndarray,
    misfit: Misfit,
    spread: Spread,
    is_same: bool,
) -> Experiment:
    changes = [*candidate.words, *(["the syringe's volume measured as well"] if sensors else [])]
    listed = (
        " and ".join([", ".join(changes[:-1]), changes[-1]]) if changes[1:] else "".join(changes)
    )
    words = "record the same run once more" if is_same else f"record a run with {listed}"
    widths = {}
    for k, deviation in zip(misfit.pulled, deviations, strict=True):
        scale = abs(float(spread.sizes[k] / spread.values[k]))
        widths[misfit.unknowns[k].name] = float(NORMAL_95 * deviation * scale)
    return Experiment(words, candidate.overrides, tuple(sensors), widths)
