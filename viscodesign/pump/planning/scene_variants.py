"""Scenes beside the one that is planned: its pressures scaled, slowed, or given by tables."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from viscodesign.effects.base import Trait
from viscodesign.effects.catalogue import catalogue, effect_names, names_with
from viscodesign.errors import Fault, SpecError
from viscodesign.pump.drive import Drive
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.inputs.table import TableInput
from viscodesign.scene.pump import PumpSpec
from viscodesign.scene.reading.field_lookup import quantity_of
from viscodesign.scene.scene import Scene

COUNTED = (Trait.COMPRESSIBLE_FLUID, Trait.TUBE_STORAGE)
"""What a plunger feels even where the tip does not."""


@dataclass(frozen=True)
class PlanGrid:
    """The times of a plan, and what counts as a jump between them."""

    samples_per_swing: int = 40
    finest: float = 0.005
    """[s]"""
    coarsest: float = 0.02
    """[s]; more only where there would be too many."""
    most_samples: int = 4000
    jump_width: float = 1e-6
    """Part of a run before and behind a corner at which its values are compared."""
    jump_swing: float = 0.01
    """Part of the whole swing that a jump has at least."""


GRID = PlanGrid()


def pump_of(scene: Scene) -> PumpSpec:
    """The scene's pump; raises `SpecError` with what to add or correct where it has none."""
    pump = scene.pump
    if pump is None:
        raise _fault(
            scene,
            "pump",
            "missing; the pump commands need the drive's data. Add for example\n"
            "  pump:\n    syringe_diameter: 34.9 mm\n    servo: ax18a\n"
            "or try one: --set 'pump={syringe_diameter: 34.9 mm}'",
        )
    for name, source in scene.inputs.items():
        if not source.gives_pressure:
            raise _fault(
                scene,
                "input",
                f"the inlet '{name}' is driven by a plunger already; a plan starts from the "
                "pressures that are wanted",
            )
    if isinstance(pump.servo_id, int) and len(scene.inputs) > 1:
        ids = ", ".join(f"{name}: {k}" for k, name in enumerate(scene.inputs, start=1))
        raise _fault(
            scene,
            "pump.servo_id",
            f"{pump.servo_id} is one servo for {len(scene.inputs)} inlets; give each its own, "
            f"like {{{ids}}}",
        )
    fluid = scene.fluid
    if not fluid.is_gas and fluid.bulk_modulus is None:
        raise _fault(
            scene,
            "fluid",
            f"the pump pushes {fluid.name}, whose stiffness is not known; state viscosity, "
            "density and gas_constant or bulk_modulus under fluid",
        )
    _refuse_empty_barrel(scene, Drive(pump))
    return pump


def _refuse_empty_barrel(scene: Scene, drive: Drive) -> None:
    """A travel that draws the plunger out of its barrel leaves nothing to plan with."""
    if drive.filled_at_home > 0.0:
        return
    pump, drawn = drive.pump, -drive.range[0]
    raise _fault(
        scene,
        "pump.syringe_stroke",
        f"{1e3 * pump.syringe_stroke:.4g} mm is not enough: from home ({pump.home} counts) the "
        f"travel {list(pump.travel)} draws the plunger out by {1e3 * drawn:.4g} mm. Use a longer "
        "syringe, a smaller pinion_diameter or a shorter travel, or state filled_length",
    )


def _fault(scene: Scene, key: str, message: str) -> SpecError:
    return SpecError([Fault(message, key, scene.source.file)])


def servo_ids(scene: Scene, pump: PumpSpec) -> tuple[int, ...]:
    """Id of each inlet's servo, in the order of the inlets."""
    ids = pump.servo_id
    return tuple(ids if isinstance(ids, int) else ids[name] for name in scene.inputs)


def planned(scene: Scene) -> Scene:
    """The scene with outputs as fine as a plunger needs, and what a plunger feels taken in."""
    modes = dict(scene.effects.modes)
    if scene.fluid.is_gas:
        counted = [name for trait in COUNTED for name in names_with(trait)]
        modes |= {name: "on" for name in counted if _may_switch_on(scene, name)}
    effects = scene.effects.model_copy(update={"modes": modes})
    return with_outputs(scene.model_copy(update={"effects": effects}), _times(scene))


def _may_switch_on(scene: Scene, name: str) -> bool:
    needed, choice = catalogue()[name].needs, scene.effects
    return choice.mode(name) == "auto" and (needed is None or choice.mode(needed) != "off")


def _times(scene: Scene) -> np.ndarray:
    """Even times, and the corners of all inputs."""
    duration = scene.run.duration
    swing = min(source.swing_time() for source in scene.inputs.values())
    asked = min(GRID.coarsest, max(swing / GRID.samples_per_swing, GRID.finest))
    count = int(np.clip(np.ceil(duration / asked), 8, GRID.most_samples))
    corners = [c for source in scene.inputs.values() for c in source.corners(duration)]
    times = np.unique(np.concatenate([np.linspace(0.0, duration, count + 1), corners]))
    keep = np.append(np.diff(times) > 1e-3 * duration / count, True)
    return np.asarray(times[keep])


def with_outputs(scene: Scene, times: np.ndarray) -> Scene:
    """The scene with outputs at these times (T,) [s], the last of them its end."""
    update = {"duration": float(times[-1]), "output_times": tuple(times.tolist())}
    return scene.model_copy(update={"run": scene.run.model_copy(update=update)})


def with_effects_of(scene: Scene, found: Trajectory) -> Scene:
    """The scene with just the effects that a run of it took."""
    known = effect_names()
    modes = {v.name: "on" if v.taken else "off" for v in found.effects if v.name in known}
    return scene.model_copy(
        update={"effects": scene.effects.model_copy(update={"modes": modes, "others": "auto"})}
    )


def with_inputs(scene: Scene, inputs: Mapping[str, Input]) -> Scene:
    """The scene with other inputs at its inlets."""
    if scene.several_inputs is not None:
        return scene.model_copy(update={"several_inputs": dict(inputs)})
    return scene.model_copy(update={"input": next(iter(inputs.values()))})


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
    duration = scene.run.duration
    found: set[float] = set()
    for source in scene.inputs.values():
        corners = np.array([0.0, *source.corners(duration)])
        sides = [
            source.values(np.clip(corners + s * GRID.jump_width * duration, 0, None))
            for s in (-1, 1)
        ]
        if scene.run.start == "rest":
            sides[0][0] = 0.0
        swing = float(np.ptp(np.concatenate(sides))) or 1.0
        found |= set(corners[np.abs(sides[1] - sides[0]) > GRID.jump_swing * swing].tolist())
    return sorted(found)


def ramped(scene: Scene, lasting: float) -> Scene:
    """The scene with every jump of its pressures made a ramp of some time [s]."""
    own, duration = scene.run.output_times_array(), scene.run.duration
    starts = [t for t in jumps(scene) if t < duration]
    ends = [min(t + lasting, duration) for t in starts]
    time = np.unique(np.concatenate([own, starts, ends]))
    columns = []
    for source in scene.inputs.values():
        values = source.values(time)
        for begin, end in zip(starts, ends, strict=True):
            before = source.values(np.array([max(begin - GRID.jump_width * duration, 0.0)]))[0]
            if begin == 0.0 and scene.run.start == "rest":
                before = 0.0
            inside = (time >= begin) & (time < end)
            share = (time[inside] - begin) / (end - begin)
            values[inside] = before + share * (values[inside] - before)
        columns.append(values)
    keep = np.append(np.diff(time) > GRID.jump_width * duration, True)
    pressure = scene.gauge_pressure + np.stack(columns, axis=1)
    return with_pressures(scene, time[keep], pressure[keep])


def scaled(scene: Scene, *, pressure: float = 1.0, time: float = 1.0) -> Scene:
    """The scene with every pressure of its inputs, and every time of its run, by a factor."""
    run = scene.run
    changes = {
        "duration": time * run.duration,
        "output_interval": time * run.output_interval,
        "output_times": tuple(time * t for t in run.output_times or ()) or None,
    }
    inputs = {
        name: source.model_copy(update=scaled_fields(source, pressure=pressure, time=time))
        for name, source in scene.inputs.items()
    }
    slowed = scene.model_copy(update={"run": run.model_copy(update=changes)})
    return with_inputs(slowed, inputs)


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
    return found
