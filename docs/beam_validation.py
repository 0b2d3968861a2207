"""A silicone beam that was recorded by others, beside what is predicted of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from fitted import fitted
from measured_swing import Swing

from viscodesign import Scene, Trajectory, compile, load, simulate
from viscodesign.results.coefficient_band import COVERAGE_FACTOR
from viscodesign.scene.reading.markers_file import MarkersFile, read_markers
from viscodesign.scene.tables.space_markers import tip_in_space

SPECS = Path(__file__).parent / "validation"
PAYLOADS = {
    "gravity_a": 0.0, "gravity_b": 0.0, "load52_a": 0.052, "load52_b": 0.052,
    "load101_a": 0.102, "load101_b": 0.102,
}  # fmt: skip
"""Recordings, and masses at the tip [kg]."""
FITTED = "load52_b"
KEYS = ("actuator.youngs_modulus", "actuator.damping_time")
RESTING = {"run.start": "equilibrium", "run.duration": 0.01}
MODELS = {"without shear": "off", "with shear": "on"}


@dataclass(frozen=True, eq=False)
class FittedModel:
    """The beam with a modulus and a damping time that one recording tells."""

    label: str
    scene: Scene
    modulus: float
    """[Pa]"""
    damping_time: float
    """[s]"""

    def changed(self, changes: Mapping[str, object]) -> FittedModel:
        """The same numbers with other keys."""
        return replace(self, scene=self.scene.replace(dict(changes)))


@dataclass(frozen=True, eq=False)
class BeamRun:
    """A recording and its prediction."""

    model: FittedModel
    name: str
    measured: Swing
    predicted: Swing
    run: Trajectory
    resting: Trajectory
    """In equilibrium."""

    @property
    def static(self) -> float:
        """How far down it is predicted to rest [m]."""
        return float(self.resting.tip[-1, 0])

    @property
    def static_half_width(self) -> float:
        """Half of the 95 % band of that [m]."""
        assert self.resting.uncertainty is not None
        return COVERAGE_FACTOR * float(self.resting.uncertainty.deviation[-1, 0])

    @property
    def holds(self) -> bool:
        """Whether the band holds the measured place of rest."""
        return abs(self.measured.static - self.static) <= self.static_half_width


def recorded_swings(folder: Path) -> dict[str, Swing]:
    """Every recording in a folder, as `compare` reads it."""
    markers: MarkersFile = read_markers(SPECS / "beam_markers.yaml")
    found = {}
    for name in PAYLOADS:
        file = str(folder / f"{name}.csv")
        own = tip_in_space(file, markers.places_for(file))
        found[name] = Swing(own.time, own.tip)
    return found


def fitted_models(measured: Mapping[str, Swing]) -> list[FittedModel]:
    """Both models, each with the numbers that the fitted recording tells."""
    scene = load(SPECS / "beam.yaml")
    return [_fitted(label, scene, shear, measured[FITTED]) for label, shear in MODELS.items()]


def _fitted(label: str, scene: Scene, shear: str, measured: Swing) -> FittedModel:
    """Least squares of the distances, by modulus, damping time and the time of the release."""
    own = scene.replace({"effects.shear": shear, "loads.payload": PAYLOADS[FITTED]})
    function = compile(own, free=list(KEYS), outputs=["tip_x_m", "tip_z_m"])
    start = np.array(function.values)

    def left(unknowns: np.ndarray) -> np.ndarray:
        found = function(start * np.exp(unknowns[:2]))
        tip = np.column_stack([found["tip_x_m"], found["tip_z_m"]])
        swing = Swing(np.asarray(function.times), tip)
        return 1e3 * measured.distances(swing, 1e-2 * unknowns[2]).ravel()

    modulus, damping = start * np.exp(fitted(left, np.zeros(3), [-1, -2, -3], [1, 2, 3])[:2])
    own = scene.replace({"effects.shear": shear, KEYS[0]: modulus, KEYS[1]: damping})
    return FittedModel(label, own, float(modulus), float(damping))


def predicted(model: FittedModel, name: str, measured: Swing) -> BeamRun:
    """What a model says of a recording."""
    scene = model.scene.replace({"loads.payload": PAYLOADS[name]})
    run, resting = (_complete(own, name) for own in (scene, scene.replace(RESTING)))
    return BeamRun(model, name, measured, Swing(run.time, run.tip[:, :2]), run, resting)


def _complete(scene: Scene, name: str) -> Trajectory:
    run = simulate(scene)
    if run.status != "complete":
        raise RuntimeError(f"{name}: {run.failure}")
    return run


def beam_rows(runs: list[BeamRun]) -> list[tuple[str, ...]]:
    """One row a recording: measured / predicted."""
    rows = []
    for own in runs:
        m, p = own.measured, own.predicted
        rms, shift = m.rms(p)
        swing = float(np.nanmax(m.tip[:, 0]) - np.nanmin(m.tip[:, 0]))
        used = " (fitted)" if own.name == FITTED else ""
        error = own.run.accuracy.estimated_tip_error_m
        rows.append(
            (
                f"`{own.name}`{used}",
                own.model.label,
                f"{1e3 * rms:.2f} mm, {100 * rms / swing:.1f} %",
                _pair(m.static, own.static, 1e3, "mm"),
                f"±{1e3 * own.static_half_width:.2f} mm, {'holds' if own.holds else 'misses'}",
                _pair(m.lowest, p.lowest, 1e3, "mm"),
                _pair(m.period, p.period, 1e3, "ms"),
                f"{m.decrement:.2f} / {p.decrement:.2f}",
                "unknown" if error is None else f"{1e3 * error:.2f} mm",
                f"{1e3 * shift:+.0f} ms",
            )
        )
    return rows


BEAM_HEAD = (
    "recording", "model", "rms, of the swing", "place of rest", "its 95 % band", "first swing",
    "period", "decrement", "numerical error", "clock",
)  # fmt: skip


def creep_rows(measured: Mapping[str, Swing]) -> list[tuple[str, ...]]:
    """How far the middle of the swings sinks, by recording."""
    rows = []
    for name, own in measured.items():
        early, late = own.early_middle, own.static
        cells = (f"{1e3 * early:.2f} mm", f"{1e3 * late:.2f} mm")
        rows.append(
            (f"`{name}`", f"{2 * own.period:.2f} s", *cells, f"{100 * (late / early - 1):+.1f} %")
        )
    return rows


def rest_rows(measured: Mapping[str, Swing]) -> list[tuple[str, ...]]:
    """The modulus by which the beam without shear rests where each recording does."""
    scene = load(SPECS / "beam.yaml").replace({"effects.shear": "off", **RESTING})
    rows = []
    for name, own in measured.items():
        loaded = scene.replace({"loads.payload": PAYLOADS[name]})
        modulus = 1e3 * _rest_modulus(loaded, own.static)
        rows.append((f"`{name}`", f"{1e3 * own.static:.2f} mm", f"{1e-3 * modulus:.1f} kPa"))
    return rows


def _rest_modulus(scene: Scene, static: float) -> float:
    """[kPa] By which the tip rests so far down [m]."""

    def left(unknown: np.ndarray) -> np.ndarray:
        run = simulate(scene.replace({KEYS[0]: 1e3 * float(unknown[0])}), verify=False)
        return 1e3 * (run.tip[-1:, 0] - static)

    return float(fitted(left, [260.0], [200.0], [340.0])[0])


REST_HEAD = ("recording", "place of rest", "modulus that has it")
CREEP_HEAD = ("recording", "from", "middle of the next two swings", "place of rest", "sinks by")


def _pair(measured: float, found: float, factor: float, unit: str) -> str:
    off = 100 * (found / measured - 1)
    return f"{factor * measured:.3g} / {factor * found:.3g} {unit}, {off:+.1f} %"
