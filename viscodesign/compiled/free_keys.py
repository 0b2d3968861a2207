"""Which numbers of a scene a user may set free, by the keys of its spec."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import numpy as np

from viscodesign.compiled.free_number import ABOVE_ZERO, FreeNumber
from viscodesign.compiled.scene_fields import (
    NumberField,
    TableField,
    is_given,
    number_fields,
    replaced,
    table_fields,
)
from viscodesign.effects.catalogue import effect_names, with_default_options
from viscodesign.errors import Fault, SpecError, did_you_mean
from viscodesign.scene.effects_choice import EFFECTS, MODE
from viscodesign.scene.fluid import Fluid
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import KeyPath, copied
from viscodesign.storage.cached_property import cached_property

FROZEN_SECTIONS = {
    "accuracy": "it decides how finely a scene is solved",
    "effects": "which effects are included stays as it was chosen",
    "name": "it is no number of the equations",
    "pump": "no equation contains the pump's data",
    "uncertainty": "it says how well other numbers are known",
    "spec": "it is the version of the keys",
    "run": "times of the run and of its outputs stay as they are",
}
"""Keys of a spec below which nothing can be free, and why; but for options of effects."""
FROZEN_FIELDS: dict[KeyPath, str] = {
    ("fluid", "fraction"): "the library of fluids has no derivatives; give viscosity and density",
    ("input", "transient_time"): "it decides only which effects are included",
}
"""Single keys; those of `input` stand for `inputs.NAME` as well."""
SURROUNDINGS = ("temperature", "ambient_pressure")
"""What the properties of a named fluid depend on."""
TUBE_SIZES = ("length", "radius")
EVERY = "*"


class FreeKeys:
    """The free numbers of a scene: what their keys stand for, and scenes with other values.

    A key is a dotted path as ``--set`` takes it, with these additions:

    - ``network.tubes[NAME].length`` and ``.radius``: of the tube with this name, such as R1-R2, in
      any layout; ``network.tubes[*].length``: of every tube but the feed lines, one number a tube;
    - ``input.rows[3].pressure``: of one row of a table, counted from 0, ``input.rows[*].pressure``
      of every row; columns are named by what they hold: time, pressure, length, speed. Lists of
      numbers likewise, without a column;
    - the numbers that a library gives of a named fluid, such as ``fluid.viscosity``.

    Raises `SpecError` for keys that are unknown, no numbers, frozen by what they mean, or that
    overlap.
    """

    def __init__(self, scene: Scene, keys: Sequence[str], *, one_period: bool = False) -> None:
        self.one_period = one_period
        """Whether runs last one period of their single input, whichever it has."""
        self.given = (keys,) if isinstance(keys, str) else tuple(keys)
        if not self.given:
            raise SpecError.plain("no key is free; give at least one, such as network.tube_length")
        if not all(key.strip() for key in self.given):
            raise SpecError.plain("a free key is empty; name a number, such as network.tube_length")
        _refuse_surroundings(scene, self.given)
        is_of_fluid = any(key.startswith("fluid.") for key in self.given)
        own = with_fluid_numbers(scene) if is_of_fluid else scene
        named = [path[1] for path in map(_parsed, self.given) if path[0] == EFFECTS and path[1:]]
        self.scene = with_default_options(own, named)
        """The scene with what it leaves unsaid spelt out where a number of it is free: the numbers
        of its fluid, and options of effects."""
        self.numbers_of = self._all_expanded()
        """The numbers that each of the given keys stands for, in their order."""
        self.numbers = [number for own in self.numbers_of for number in own]
        self._refuse_overlaps()

    @property
    def names(self) -> tuple[str, ...]:
        """Keys of all free numbers, none of which stands for several."""
        return tuple(number.name for number in self.numbers)

    @property
    def values(self) -> np.ndarray:
        """(f,) The scene's own numbers [SI]."""
        return np.array([number.value for number in self.numbers])

    def are_allowed(self, values: np.ndarray) -> np.ndarray:
        """Whether rows of values (m, f) are finite and within the ranges of the spec (m,)."""
        low, high, excludes_low, excludes_high = self._bounds
        above = np.where(excludes_low, values > low, values >= low)
        below = np.where(excludes_high, values < high, values <= high)
        return np.asarray(np.all(above & below & np.isfinite(values), axis=1))

    @cached_property
    def _bounds(self) -> tuple[np.ndarray, ...]:
        """Of all free numbers (f,) each: low, high, and whether these are excluded."""
        bounds = [number.bounds for number in self.numbers]
        ends = [(b.low, b.high, b.excludes_low, b.excludes_high) for b in bounds]
        return tuple(np.array(part) for part in zip(*ends, strict=True))

    def placed(self, values: Sequence[Any] | np.ndarray) -> Scene:
        """The scene with other values, not validated; they may be any kind of number."""
        tree: dict[str, Any] = {}
        for number, value in zip(self.numbers, values, strict=True):
            here = tree
            for part in number.path[:-1]:
                here = here.setdefault(part, {})
            here[number.path[-1]] = value
        found: Scene = replaced(self.scene, tree)
        return over_one_period(found) if self.one_period else found

    def validated(self, values: Sequence[float] | np.ndarray) -> Scene:
        """The scene with other values, validated like a loaded one."""
        from viscodesign.loading import checked

        return checked(self.placed([float(value) for value in values]))

    # -- from keys to numbers -----------------------------------------------------

    def _all_expanded(self) -> list[list[FreeNumber]]:
        found, faults = [], list[Fault]()
        for key in self.given:
            try:
                found.append(self._expanded(key))
            except SpecError as error:
                faults += error.faults
        if faults:
            raise SpecError(faults)
        return found

    def _expanded(self, key: str) -> list[FreeNumber]:
        path = _parsed(key)
        if reason := _frozen(path):
            raise _refused(key, reason)
        if path[:2] in (("network", "tubes"), ("network", "changes")) and len(path) == 4:
            name, size = path[2].strip("[]"), path[3]
            if path[2].startswith("[") or name in self._tube_paths:
                return self._tubes(key, name, size)
        for table in self._tables:
            count = len(table.path)
            if path[:count] == table.path and path[count : count + 1] and path[count][0] == "[":
                return self._rows(key, table, path[count][1:-1], ".".join(path[count + 1 :]))
        if path in self._known:
            return [self._number(key, path)]
        if is_given(self.scene, path):
            raise _refused(key, "it is not a number that may change by a little")
        hint = did_you_mean(key, candidates(self.scene))
        raise SpecError([Fault(f"no such number in this scene{hint}", key)])

    def _tubes(self, key: str, name: str, size: str) -> list[FreeNumber]:
        if size not in TUBE_SIZES:
            raise SpecError([Fault(f"no such key{did_you_mean(size, TUBE_SIZES)}", key)])
        if name == EVERY:
            return [self._tube(each, size) for each in self._tube_paths]
        if name not in self._tube_paths:
            known = f"; the tubes are {', '.join(self._tube_paths)}"
            raise SpecError(
                [Fault(f"no such tube{did_you_mean(name, self._tube_paths) or known}", key)]
            )
        return [self._tube(name, size)]

    def _tube(self, name: str, size: str) -> FreeNumber:
        tube = next(t for t in self.scene.graph.tubes if t.name == name)
        path, key = (*self._tube_paths[name], size), f"network.tubes[{name}].{size}"
        return FreeNumber(key, path, float(getattr(tube, size)), "m", ABOVE_ZERO)

    @cached_property
    def _tube_paths(self) -> dict[str, KeyPath]:
        """Where the numbers of each tube stand, by its name; without feed lines."""
        network = self.scene.network
        graph = copied(network, {"feed_line": None}).graph(
            self.scene.bellows.count, tuple(self.scene.inputs)
        )
        found: dict[str, KeyPath] = {}
        for k, tube in enumerate(graph.tubes):
            turned = f"{tube.end}-{tube.start}"
            own = turned if turned in network.changes else tube.name
            is_custom = network.layout == "custom"
            found[tube.name] = ("network", *(("tubes", str(k)) if is_custom else ("changes", own)))
        return found

    def _rows(self, key: str, table: TableField, row: str, column: str) -> list[FreeNumber]:
        """Numbers of one column of a table, of one row or of all."""
        if column not in table.columns:
            known = ", ".join(table.columns)
            hint = did_you_mean(column, table.columns) or f"; the columns are {known}"
            raise SpecError([Fault(f"no such column{hint}", key)])
        if row != EVERY and not (row.isdigit() and int(row) < table.count):
            raise SpecError([Fault(f"no such row; the rows are 0 to {table.count - 1}", key)])
        rows = range(table.count) if row == EVERY else [int(row)]
        shown, tail = ".".join(table.path), f".{column}" if column else ""
        return [self._number(f"{shown}[{k}]{tail}", table.entry(k, column)) for k in rows]

    def _number(self, name: str, path: KeyPath) -> FreeNumber:
        found = self._known[path]
        if found.value is None:
            raise _refused(name, "the scene gives it no value to start from")
        return FreeNumber(name, path, float(found.value), found.unit, found.bounds)

    @cached_property
    def _known(self) -> dict[KeyPath, NumberField]:
        return {found.path: found for found in number_fields(self.scene)}

    @cached_property
    def _tables(self) -> list[TableField]:
        return list(table_fields(self.scene))

    def _refuse_overlaps(self) -> None:
        seen: dict[KeyPath, str] = {}
        for number in self.numbers:
            if number.path in seen:
                message = f"stands for the same number as {seen[number.path]}"
                raise SpecError([Fault(message, number.name)])
            seen[number.path] = number.name
        for size in TUBE_SIZES:
            shared = f"network.tube_{size}"
            for name, path in self._tube_paths.items() if shared in self.names else ():
                own = (*path, size)
                if own in seen and not is_given(self.scene, own):
                    message = f"overlaps with {shared}, which gives this tube its {size}"
                    raise SpecError([Fault(message, f"network.tubes[{name}].{size}")])


def over_one_period(scene: Scene) -> Scene:
    """The scene run over one period of its only input, with as many output times."""
    run, (source,) = scene.run, scene.inputs.values()
    period: Any = source.period
    steps = round(run.duration / run.output_interval)
    changes = {"duration": period, "output_interval": period / steps, "output_times": None}
    found: Scene = copied(scene, {"run": copied(run, changes)})
    return found


def candidates(scene: Scene) -> list[str]:
    """Keys of all numbers of a scene that are worth a try; tubes and rows all together."""
    scene = with_default_options(with_fluid_numbers(scene), effect_names())
    tables = [table for table in table_fields(scene) if not _frozen(table.path)]
    entries = {
        table.entry(k, c) for table in tables for k in range(table.count) for c in table.columns
    }
    numbers = [
        ".".join(found.path)
        for found in number_fields(scene)
        if found.value is not None
        and not _frozen(found.path)
        and found.path not in entries
        and found.path[:2] not in (("network", "tubes"), ("network", "changes"))
    ]
    tubes = [f"network.tubes[{EVERY}].{size}" for size in TUBE_SIZES]
    rows = [
        f"{'.'.join(table.path)}[{EVERY}]{column and f'.{column}'}"
        for table in tables
        for column in table.columns
    ]
    return [*numbers, *tubes, *rows]


def with_fluid_numbers(scene: Scene) -> Scene:
    """The scene with the numbers of its fluid spelt out."""
    known, choice = scene.fluid, scene.fluid_choice
    if choice.viscosity is not None:
        return scene
    spelt = Fluid(
        name=known.name,
        viscosity=known.viscosity,
        density=known.density,
        gas_constant=known.gas_constant,
        bulk_modulus=known.bulk_modulus,
        vapour_pressure=known.vapour_pressure,
        polytropic_exponent=choice.polytropic_exponent,
    )
    found: Scene = copied(scene, {"fluid_choice": spelt})
    return found


def _frozen(path: KeyPath) -> str:
    """Why the number at a place cannot be free; empty where it may be."""
    if path[0] == EFFECTS and len(path) > 2 and path[2] != MODE:
        return ""
    single = ("input", *path[2:]) if path[0] == "inputs" else path
    return FROZEN_SECTIONS.get(path[0], "") or FROZEN_FIELDS.get(single[:2], "")


def _refuse_surroundings(scene: Scene, keys: Sequence[str]) -> None:
    """Refuse what a named fluid's properties depend on."""
    for key in keys if scene.fluid_choice.viscosity is None else ():
        if key in SURROUNDINGS:
            library = f"the library that gives the properties of {scene.fluid.name}"
            raise _refused(key, f"{library} has no derivatives; give viscosity and density")


def _refused(key: str, reason: str) -> SpecError:
    return SpecError([Fault(f"cannot be free: {reason}", key)])


def _parsed(key: str) -> KeyPath:
    """The parts of a key; what stands in brackets is a part of its own, with them."""
    parts = tuple(re.findall(r"\[[^\]]*\]|[^.\[\]]+", key))
    written = "".join(part if part.startswith("[") else f".{part}" for part in parts)
    return parts if parts and written == f".{key}" else (key,)
