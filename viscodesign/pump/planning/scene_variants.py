"""Scenes beside the one that is planned: its pressures scaled, slowed, or given by tables."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from viscodesign.effects.base import Trait
from viscodesign.effects.catalogue import catalogue, effect_names, names_with
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.inputs.table import TableInput
from viscodesign.scene.reading.field_lookup import quantity_of
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import copied

COUNTED = (Trait.COMPRESSIBLE_FLUID, Trait.TUBE_STORAGE)
"""What a pump feels even where the tip does not."""


@dataclass(frozen=True)
class PlanGrid:
    """The times of a plan, and what counts as a jump between them."""

    samples_per_swing: int = 40
    finest: float = 0.005  # [s]
    coarsest: float = 0.02  # [s]; more only where there would be too many samples
    max_samples: int = 4000
    jump_width: float = 1e-6  # share of a run around a corner at which values are compared
    jump_swing: float = 0.01  # smallest share of the whole swing that is a jump


GRID = PlanGrid()


def planned(scene: Scene) -> Scene:
    """The scene with outputs as fine as a pump needs, and what a pump feels taken in."""
    choice = scene.effects
    modes = dict(choice.modes)
    for name in (name for trait in COUNTED for name in names_with(trait)):
        needed = catalogue()[name].needs
        possible = choice.mode(name) == "auto" and all(choice.mode(n) != "off" for n in needed)
        if scene.fluid.is_gas and possible:
            modes[name] = "on"
    effects = copied(choice, {"modes": modes})
    return with_outputs(copied(scene, {"effects": effects}), _times(scene))


def _times(scene: Scene) -> np.ndarray:
    """Even times, and the corners of all inputs."""
    duration = scene.run.duration
    swing = min(source.swing_time_within(duration) for source in scene.inputs.values())
    asked = min(GRID.coarsest, max(swing / GRID.samples_per_swing, GRID.finest))
    count = int(np.clip(np.ceil(duration / asked), 8, GRID.max_samples))
    corners = [c for source in scene.inputs.values() for c in source.corners(duration)]
    times = np.unique(np.concatenate([np.linspace(0.0, duration, count + 1), corners]))
    keep = np.append(np.diff(times) > 1e-3 * duration / count, True)
    return np.asarray(times[keep])


def with_outputs(scene: Scene, times: np.ndarray) -> Scene:
    """The scene with outputs at these times (T,) [s], the last of them its end."""
    update = {"duration": float(times[-1]), "output_times": tuple(times.tolist())}
    return copied(scene, {"run": copied(scene.run, update)})


def with_effects_of(scene: Scene, found: Trajectory) -> Scene:
    """The scene with just the effects that a run of it took."""
    known = effect_names()
    modes = {v.name: "on" if v.taken else "off" for v in found.effects if v.name in known}
    return copied(scene, {"effects": scene.effects.with_modes(modes)})


def with_inputs(scene: Scene, inputs: Mapping[str, Input]) -> Scene:
    """The scene with other inputs at its inlets."""
    if scene.several_inputs is not None:
        return copied(scene, {"several_inputs": dict(inputs)})
    return copied(scene, {"input": next(iter(inputs.values()))})


def with_pressures(scene: Scene, time: np.ndarray, pressure: np.ndarray) -> Scene:
    """The scene driven by tables of gauge pressure (T, P) [Pa]; its outputs at their times."""
    above = pressure - scene.gauge_pressure
    tables = {
        name: TableInput(kind="table", rows=tuple(zip(time.tolist(), column.tolist(), strict=True)))
        for name, column in zip(scene.inputs, above.T, strict=True)
    }
    return with_inputs(with_outputs(scene, time), tables)


def jumps(scene: Scene) -> list[float]:
    """Times at which the pressure of an input jumps [s]."""
    width, found = GRID.jump_width * scene.run.duration, set()
    for source in scene.inputs.values():
        corners = np.array([0.0, *source.corners(scene.run.duration)])
        before, behind = _before(scene, source, corners), source.values(corners + width)
        swing = float(np.ptp([before, behind])) or 1.0
        found |= set(corners[np.abs(behind - before) > GRID.jump_swing * swing].tolist())
    return sorted(found)


def _before(scene: Scene, source: Input, times: np.ndarray) -> np.ndarray:
    """Values of an input just before some times; a run from rest comes from the baseline."""
    values = source.values(np.maximum(times - GRID.jump_width * scene.run.duration, 0.0))
    return np.where(times > 0.0, values, 0.0) if scene.run.start == "rest" else values


def ramped(scene: Scene, lasting: float) -> Scene:
    """The scene with every jump of its pressures made a ramp of some time [s]."""
    duration = scene.run.duration
    starts = np.array([t for t in jumps(scene) if t < duration])
    ends = np.minimum(starts + lasting, duration)
    time = np.unique(np.concatenate([scene.run.output_times_array(), starts, ends]))
    time = time[np.append(np.diff(time) > GRID.jump_width * duration, True)]
    last = np.searchsorted(starts, time, side="right") - 1  # -1 before the first
    risen = np.minimum((time - starts[last]) / (ends - starts)[last], 1.0)
    share = np.where(last < 0, 1.0, risen)
    columns = []
    for source in scene.inputs.values():
        before = _before(scene, source, starts)[last]
        columns.append(before + share * (source.values(time) - before))
    return with_pressures(scene, time, scene.gauge_pressure + np.stack(columns, axis=1))


def scaled(scene: Scene, *, pressure: float = 1.0, time: float = 1.0) -> Scene:
    """The scene with every pressure of its inputs, and every time of its run, by a factor."""
    inputs = {
        name: copied(source, scaled_fields(source, pressure=pressure, time=time))
        for name, source in scene.inputs.items()
    }
    return with_inputs(with_outputs(scene, time * scene.run.output_times_array()), inputs)


def scaled_fields(source: Input, *, pressure: float = 1.0, time: float = 1.0) -> dict[str, Any]:
    """Fields of an input that change when its pressures and times do, with their new values."""
    factors = {"pressure": pressure, "time": time, "frequency": 1 / time}
    found: dict[str, Any] = {}
    for name, field in type(source).model_fields.items():
        value, kind = getattr(source, name), quantity_of(field)
        if isinstance(value, float) and kind is not None and factors.get(kind.name, 1.0) != 1.0:
            found[name] = value * factors[kind.name]
    if isinstance(source, TableInput) and source.rows is not None:
        found["rows"] = tuple((time * t, pressure * p) for t, p in source.rows)
        found["measured"] = None
    return found
