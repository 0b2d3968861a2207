"""Which numbers of a scene a user may set free, by the keys of its spec.

A key is a dotted path as `--set` takes it, with three additions:

- `network.tubes[NAME].length` and `.radius`: of the tube with this name, such as ``R1-R2``, in any
  layout; `network.tubes[*].length`: of every tube but the feed lines, one number a tube;
- `input.rows[3].pressure`: of one row of a table, from 0; `input.rows[*].pressure`: of every row.
  The columns are named by what they hold: time, pressure, length, speed;
- a number that the library of a named fluid gives, such as `fluid.viscosity`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from viscodesign.errors import Fault, SpecError, did_you_mean
from viscodesign.scene.fluid import Fluid
from viscodesign.scene.network import Network, TubeChange
from viscodesign.scene.reading.field_lookup import quantity_of
from viscodesign.scene.scene import Scene
from viscodesign.scene.spec_part import KeyPath
from viscodesign.units import QuantityKind

FROZEN_SECTIONS = {
    "accuracy": "it decides how finely a scene is solved",
    "effects": "which effects are included stays as it was chosen",
    "name": "it is no number of the equations",
    "pump": "no equation contains the pump's data",
    "run": "times of the run and of its outputs stay as they are",
}
"""Keys of a spec below which nothing can be free, and why."""
FROZEN_FIELDS = {
    "transient_time": "it decides only which effects are included",
    "fraction": "the library of fluids gives no derivatives; give viscosity and density",
}
SURROUNDINGS = ("temperature", "ambient_pressure")
"""What the properties of a named fluid depend on."""
TUBE_SIZES = ("length", "radius")


@dataclass(frozen=True)
class Bounds:
    """The range of a field in the spec's model."""

    low: float = -math.inf
    high: float = math.inf
    excludes_low: bool = False
    excludes_high: bool = False

    @classmethod
    def of(cls, notes: Sequence[Any]) -> Bounds:
        """From a field's annotations."""
        found = {}
        for note in notes:
            for name, key in (("gt", "low"), ("ge", "low"), ("lt", "high"), ("le", "high")):
                limit = getattr(note, name, None)
                if limit is not None:
                    found[key] = float(limit)
                    found[f"excludes_{key}"] = name in ("gt", "lt")
        return cls(**found)  # type: ignore[arg-type]

    def contain(self, value: float) -> bool:
        """Whether a value is allowed."""
        above = value > self.low if self.excludes_low else value >= self.low
        below = value < self.high if self.excludes_high else value <= self.high
        return above and below

    def __str__(self) -> str:
        low = f"{'above' if self.excludes_low else 'at least'} {self.low:g}"
        high = f"{'below' if self.excludes_high else 'at most'} {self.high:g}"
        ends = (low, self.low), (high, self.high)
        return " and ".join(text for text, limit in ends if math.isfinite(limit))


@dataclass(frozen=True)
class FreeNumber:
    """One number of a scene that may change."""

    name: str
    path: KeyPath
    """Where it stands in the scene, by keys of the spec."""
    value: float
    unit: str
    bounds: Bounds

    def fault(self, value: float) -> Fault | None:
        """What is wrong with a value."""
        unit = "" if self.unit == "1" else f" {self.unit}"
        if not math.isfinite(value):
            return Fault(f"must be a finite number; got {value}", self.name)
        if not self.bounds.contain(value):
            return Fault(f"must be {self.bounds}{unit}; got {value:g}{unit}", self.name)
        return None


class FreeKeys:
    """The free numbers of a scene: what their keys stand for, and scenes with other values.

    Raises `SpecError` for keys that are unknown, not numbers, frozen by what they mean, or that
    overlap.
    """

    def __init__(self, scene: Scene, keys: Sequence[str]) -> None:
        self.given = keys = (keys,) if isinstance(keys, str) else tuple(keys)
        self._check_fluid(scene, keys)
        self.scene = with_fluid_numbers(scene) if _of_fluid(keys) else scene
        """The scene, its fluid's numbers spelt out where one of them is free."""
        if not keys:
            raise SpecError.plain("no key is free; give at least one, such as network.tube_length")
        self.numbers = [number for key in keys for number in self._expanded(key)]
        self._refuse_overlaps()

    @property
    def names(self) -> tuple[str, ...]:
        """Keys of all free numbers, none of which stands for several."""
        return tuple(number.name for number in self.numbers)

    def placed(self, values: Sequence[Any]) -> Scene:
        """The scene with other values, not validated; they may be any kind of number."""
        tree: dict[str, Any] = {}
        for number, value in zip(self.numbers, values, strict=True):
            here = tree
            for part in number.path[:-1]:
                here = here.setdefault(part, {})
            here[number.path[-1]] = value
        found: Scene = _replaced(self.scene, tree)
        return found

    # -- from keys to numbers -----------------------------------------------------

    def _expanded(self, key: str) -> list[FreeNumber]:
        path = _parsed(key)
        if path[0] in FROZEN_SECTIONS:
            raise _refused(key, FROZEN_SECTIONS[path[0]])
        if path[-1] in FROZEN_FIELDS:
            raise _refused(key, FROZEN_FIELDS[path[-1]])
        if path[:2] == ("network", "tubes") and len(path) == 4 and path[2].startswith("["):
            return self._tubes(key, path)
        if len(path) > 2 and path[-2].startswith("["):
            return self._rows(key, path)
        if path in self._known:
            return [self._number(key, path)]
        raise self._unknown(key, path)

    def _tubes(self, key: str, path: KeyPath) -> list[FreeNumber]:
        name, size = path[2][1:-1], path[3]
        if size not in TUBE_SIZES:
            raise SpecError([Fault(f"no such key{did_you_mean(size, TUBE_SIZES)}", key)])
        if name == "*":
            return [self._tube(n, size) for n in self._tube_paths]
        if name not in self._tube_paths:
            hint = did_you_mean(name, self._tube_paths)
            known = "" if hint else f"; the tubes are {', '.join(self._tube_paths)}"
            raise SpecError([Fault(f"no such tube{hint}{known}", key)])
        return [self._tube(name, size)]

    def _tube(self, name: str, size: str) -> FreeNumber:
        tube = next(t for t in self.scene.graph.tubes if t.name == name)
        bounds = Bounds(low=0.0, excludes_low=True)
        path = (*self._tube_paths[name], size)
        key = f"network.tubes[{name}].{size}"
        return FreeNumber(key, path, float(getattr(tube, size)), "m", bounds)

    @cached_property
    def _tube_paths(self) -> dict[str, KeyPath]:
        """Where the numbers of each tube stand, by its name; without feed lines."""
        network: Network = self.scene.network
        graph = network.model_copy(update={"feed_line": None}).graph(
            self.scene.bellows.count, tuple(self.scene.inputs)
        )
        found: dict[str, KeyPath] = {}
        for k, tube in enumerate(graph.tubes):
            turned = f"{tube.end}-{tube.start}"
            own = turned if turned in network.changes else tube.name
            is_custom = network.layout == "custom"
            found[tube.name] = ("network", *(("tubes", str(k)) if is_custom else ("changes", own)))
        return found

    def _rows(self, key: str, path: KeyPath) -> list[FreeNumber]:
        """Numbers of one column of a table, of one row or of all."""
        *table, row, column = path
        columns = self._columns(tuple(table))
        if columns is None:
            raise self._unknown(key, path)
        if column not in columns:
            hint = did_you_mean(column, columns) or f"; the columns are {', '.join(columns)}"
            raise SpecError([Fault(f"no such column{hint}", key)])
        count = len(_at(self.scene, tuple(table)))
        if row != "[*]" and not (row[1:-1].isdigit() and int(row[1:-1]) < count):
            raise SpecError([Fault(f"no such row; the rows are 0 to {count - 1}", key)])
        rows = range(count) if row == "[*]" else [int(row[1:-1])]
        shown = ".".join(table)
        return [
            self._number(f"{shown}[{k}].{column}", (*table, str(k), str(columns.index(column))))
            for k in rows
        ]

    def _columns(self, table: KeyPath) -> list[str] | None:
        """Names of the columns of the table at a place; None where there is none."""
        kinds = self._tables.get(table)
        return None if kinds is None else _column_names(kinds)

    def _number(self, name: str, path: KeyPath) -> FreeNumber:
        value, kind, bounds = self._known[path]
        if value is None:
            raise _refused(name, "the scene gives it no value to start from")
        return FreeNumber(name, path, float(value), kind.unit, bounds)

    @cached_property
    def _known(self) -> dict[KeyPath, tuple[float | None, QuantityKind, Bounds]]:
        """Every number of the scene."""
        return {path: rest for path, *rest in _numbers(self.scene, ())}  # type: ignore[misc]

    @cached_property
    def _tables(self) -> dict[KeyPath, list[QuantityKind]]:
        """Kinds of the columns of every table of the scene."""
        return dict(_tables(self.scene, ()))

    # -- refusals -----------------------------------------------------------------

    def _unknown(self, key: str, path: KeyPath) -> SpecError:
        if _exists(self.scene, path):
            return _refused(key, "it is not a number that may change by a little")
        hint = did_you_mean(key, candidates(self.scene))
        return SpecError([Fault(f"no such number in this scene{hint}", key)])

    @staticmethod
    def _check_fluid(scene: Scene, keys: Sequence[str]) -> None:
        """Refuse what a named fluid's properties depend on."""
        if scene.fluid_choice.viscosity is None:
            for key in keys:
                if key in SURROUNDINGS:
                    reason = f"the library that gives the properties of {scene.fluid.name} has no "
                    raise _refused(key, reason + "derivatives; give viscosity and density")

    def _refuse_overlaps(self) -> None:
        seen: dict[KeyPath, str] = {}
        for number in self.numbers:
            if number.path in seen:
                other = seen[number.path]
                raise SpecError([Fault(f"is free twice, as {other} and here", number.name)])
            seen[number.path] = number.name
        for size in TUBE_SIZES:
            shared = f"network.tube_{size}"
            if shared not in self.names:
                continue
            for name, path in self._tube_paths.items():
                if (*path, size) in seen and not _exists(self.scene, (*path, size)):
                    message = f"overlaps with {shared}, which gives this tube its {size}"
                    raise SpecError([Fault(message, f"network.tubes[{name}].{size}")])


def candidates(scene: Scene) -> list[str]:
    """Keys of all numbers of a scene that are worth a try; tubes and rows all together."""
    scene = with_fluid_numbers(scene)
    numbers = [
        ".".join(path)
        for path, value, *_ in _numbers(scene, ())
        if value is not None
        and path[0] not in FROZEN_SECTIONS
        and path[-1] not in FROZEN_FIELDS
        and path[:2] not in (("network", "tubes"), ("network", "changes"))
        and not path[-1].isdigit()
    ]
    tubes = [f"network.tubes[*].{size}" for size in TUBE_SIZES]
    tables = [
        f"{'.'.join(table)}[*].{column}"
        for table, kinds in _tables(scene, ())
        for column in _column_names(kinds)
        if table[0] not in FROZEN_SECTIONS
    ]
    return [*numbers, *tubes, *tables]


def _column_names(kinds: Sequence[QuantityKind]) -> list[str]:
    return [kind.name.replace(" ", "_") for kind in kinds]


def with_fluid_numbers(scene: Scene) -> Scene:
    """The scene with the numbers of its fluid spelt out."""
    known, choice = scene.fluid, scene.fluid_choice
    spelt = Fluid(
        name=known.name,
        viscosity=known.viscosity,
        density=known.density,
        gas_constant=known.gas_constant,
        bulk_modulus=known.bulk_modulus,
        vapour_pressure=known.vapour_pressure,
        polytropic_exponent=choice.polytropic_exponent,
    )
    return scene if choice.viscosity is not None else _copied(scene, {"fluid_choice": spelt})


def _of_fluid(keys: Sequence[str]) -> bool:
    return any(key.startswith("fluid.") for key in keys)


def _refused(key: str, reason: str) -> SpecError:
    return SpecError([Fault(f"cannot be free: {reason}", key)])


def _parsed(key: str) -> KeyPath:
    """The parts of a key; what stands in brackets is a part of its own, with them."""
    parts = tuple(re.findall(r"\[[^\]]*\]|[^.\[\]]+", key))
    written = "".join(part if part.startswith("[") else f".{part}" for part in parts)
    return parts if parts and written == f".{key}" else (key,)


# -- walking through a scene ------------------------------------------------------


def _numbers(
    part: BaseModel, path: KeyPath
) -> Iterator[tuple[KeyPath, float | None, QuantityKind, Bounds]]:
    """Every field of a quantity: its place, value, kind and range."""
    for name, found in type(part).model_fields.items():
        place, value = (*path, found.alias or name), getattr(part, name)
        kind = quantity_of(found)
        if kind is not None and (value is None or not isinstance(value, tuple | dict)):
            yield place, value, kind, Bounds.of(found.metadata)
            continue
        columns = _column_kinds(found)
        for k, row in enumerate(value or () if columns else ()):
            for c, (kind, entry) in enumerate(zip(columns, row, strict=True)):
                yield (*place, str(k), str(c)), entry, kind, Bounds()
        for key, inner in parts_in(value):
            yield from _numbers(inner, (*place, *key))


def _tables(part: BaseModel, path: KeyPath) -> Iterator[tuple[KeyPath, list[QuantityKind]]]:
    """Every field that holds rows of quantities."""
    for name, found in type(part).model_fields.items():
        place, value = (*path, found.alias or name), getattr(part, name)
        columns = _column_kinds(found)
        if columns and value is not None:
            yield place, columns
        for key, inner in parts_in(value):
            yield from _tables(inner, (*place, *key))


def parts_in(value: Any) -> list[tuple[KeyPath, BaseModel]]:
    """The parts of a spec that a field's value holds, and their keys below it."""
    if isinstance(value, BaseModel):
        return [((), value)]
    if isinstance(value, dict):
        return [((k,), v) for k, v in value.items() if isinstance(v, BaseModel)]
    if isinstance(value, tuple):
        return [((str(k),), v) for k, v in enumerate(value) if isinstance(v, BaseModel)]
    return []


def _column_kinds(found: FieldInfo) -> list[QuantityKind]:
    """Kinds of the columns of a field that is a tuple of rows; empty for any other."""
    for rows in (found.annotation, *get_args(found.annotation)):
        inner = get_args(rows)[0] if get_origin(rows) is tuple and get_args(rows) else None
        if get_origin(inner) is tuple:
            notes = [note for column in get_args(inner) for note in get_args(column)[1:]]
            return [note for note in notes if isinstance(note, QuantityKind)]
    return []


def _field_name(part: BaseModel, key: str) -> str | None:
    """The field of a key."""
    fields = type(part).model_fields.items()
    return next((name for name, found in fields if (found.alias or name) == key), None)


def _at(value: Any, path: KeyPath) -> Any:
    """What stands at a place of a scene; raises `LookupError` where nothing does."""
    for part in path:
        if isinstance(value, BaseModel):
            name = _field_name(value, part)
            if name is None:
                raise KeyError(part)
            value = getattr(value, name)
        elif isinstance(value, dict):
            value = value[part]
        elif isinstance(value, tuple) and part.isdigit():
            value = value[int(part)]
        else:
            raise KeyError(part)
    return value


def _exists(scene: Scene, path: KeyPath) -> bool:
    """Whether a scene has a value at a place."""
    try:
        return _at(scene, path) is not None
    except LookupError:
        return False


def _replaced(value: Any, tree: Any) -> Any:
    """A part of a scene with what a tree of keys holds in its places."""
    if not isinstance(tree, dict):
        return tree
    if isinstance(value, BaseModel):
        names = {key: _field_name(value, key) for key in tree}
        changes = {n: _replaced(getattr(value, n), tree[k]) for k, n in names.items() if n}
        return _copied(value, changes)
    if isinstance(value, tuple):
        return tuple(
            _replaced(entry, tree[str(k)]) if str(k) in tree else entry
            for k, entry in enumerate(value)
        )
    # Only changes of tubes may not stand there yet.
    return {**value, **{k: _replaced(value.get(k, TubeChange()), tree[k]) for k in tree}}


def _copied(part: BaseModel, changes: dict[str, Any]) -> Any:
    """A copy that is not validated, without what was derived from its former values."""
    copy = part.model_copy(update=changes)
    for derived in set(vars(copy)) - set(type(part).model_fields):
        del vars(copy)[derived]
    return copy
