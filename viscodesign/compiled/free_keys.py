"""Which numbers of a spec a user may set free, by its keys."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any, Generic, Protocol, Self, TypeVar

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
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.graph import Tube
from viscodesign.scene.effects_choice import EFFECTS, MODE
from viscodesign.scene.fluid import Fluid
from viscodesign.scene.network import Network
from viscodesign.scene.robot_scene import RobotScene
from viscodesign.scene.scene import Scene
from viscodesign.scene.several import ActuatorDesign
from viscodesign.scene.several_scene import SeveralScene
from viscodesign.scene.spec_part import KeyPath, copied
from viscodesign.storage.cached_property import cached_property

FROZEN_SECTIONS = {
    "accuracy": "it decides how finely a scene is solved",
    "effects": "which effects are included stays as it was chosen",
    "name": "the equations do not contain it",
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


SpecT = TypeVar("SpecT", bound=Scene | SeveralScene | RobotScene)
ManyT = TypeVar("ManyT", bound=SeveralScene | RobotScene)


@dataclass(frozen=True)
class TubePlace:
    """A tube of a spec."""

    tube: Tube
    path: KeyPath
    """Where its numbers stand."""


class FreeNumbers(Generic[SpecT]):
    """The free numbers of a spec: what their keys stand for, and specs with other values.

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

    def __init__(self, scene: SpecT, keys: Sequence[str]) -> None:
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
        """The spec with what it leaves unsaid spelt out where a number of it is free: the numbers
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
        """(f,) The spec's own numbers [SI]."""
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

    def with_values(self, values: Sequence[Any] | np.ndarray) -> SpecT:
        """The spec with other values, not validated; they may be any kind of number."""
        tree: dict[str, Any] = {}
        for number, value in zip(self.numbers, values, strict=True):
            here = tree
            for part in number.path[:-1]:
                here = here.setdefault(part, {})
            here[number.path[-1]] = value
        found: SpecT = replaced(self.scene, tree)
        return found

    def _networks(self) -> Mapping[KeyPath, Mapping[str, TubePlace]]:
        """Tubes whose numbers may be free, by name, of each part of the spec that has some."""
        raise NotImplementedError

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
        for network, tubes in self._tubes_known.items():
            count = len(network)
            is_tube = path[:count] == network and path[count : count + 1] in (TUBES, CHANGES)
            if is_tube and len(path) == count + 3:
                name = path[-2].strip("[]")
                if path[-2].startswith("[") or name in tubes:
                    return self._tubes(key, network, name, path[-1])
        for table in self._tables:
            count = len(table.path)
            if path[:count] == table.path and path[count : count + 1] and path[count][0] == "[":
                return self._rows(key, table, path[count][1:-1], ".".join(path[count + 1 :]))
        if path in self._known:
            return [self._number(key, path)]
        if is_given(self.scene, path):
            raise _refused(key, "it is not a number that may change by a little")
        raise SpecError([Fault(self._unknown(key), key)])

    def _unknown(self, key: str) -> str:
        """What is said of a key at which no number stands."""
        known = [".".join(path) for path, found in self._known.items() if found.value is not None]
        return f"no such number in this spec{did_you_mean(key, known)}"

    def _tubes(self, key: str, network: KeyPath, name: str, size: str) -> list[FreeNumber]:
        if size not in TUBE_SIZES:
            raise SpecError([Fault(f"no such key{did_you_mean(size, TUBE_SIZES)}", key)])
        known = self._tubes_known[network]
        if name == EVERY:
            return [self._tube(network, each, size) for each in known]
        if name not in known:
            listed = f"; the tubes are {', '.join(known)}"
            raise SpecError([Fault(f"no such tube{did_you_mean(name, known) or listed}", key)])
        return [self._tube(network, name, size)]

    def _tube(self, network: KeyPath, name: str, size: str) -> FreeNumber:
        own = self._tubes_known[network][name]
        value = float(getattr(own.tube, size))
        return FreeNumber(_tube_key(network, name, size), (*own.path, size), value, "m", ABOVE_ZERO)

    @cached_property
    def _tubes_known(self) -> Mapping[KeyPath, Mapping[str, TubePlace]]:
        return self._networks()

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
        for network, tubes in self._tubes_known.items():
            for size in TUBE_SIZES:
                shared = ".".join((*network, f"tube_{size}"))
                for name, place in tubes.items() if shared in self.names else ():
                    own = (*place.path, size)
                    if own in seen and not is_given(self.scene, own):
                        message = f"overlaps with {shared}, which gives this tube its {size}"
                        raise SpecError([Fault(message, _tube_key(network, name, size))])


class SceneKeys(Protocol):
    """Free numbers of a scene, whatever spec they are keys of."""

    given: tuple[str, ...]

    @property
    def scene(self) -> Scene:
        """The scene with its own numbers."""

    @property
    def names(self) -> tuple[str, ...]: ...

    @property
    def values(self) -> np.ndarray: ...

    @property
    def numbers(self) -> list[FreeNumber]: ...

    def only(self, keys: Sequence[str]) -> SceneKeys:
        """Some of them, by their keys as given."""

    def are_allowed(self, values: np.ndarray) -> np.ndarray:
        """Whether rows of values (m, f) are finite and within the ranges of the spec (m,)."""

    def placed(self, values: Sequence[Any] | np.ndarray) -> Scene:
        """The scene with other values, not validated; they may be any kind of number."""

    def validated(self, values: Sequence[float] | np.ndarray) -> Scene:
        """The scene with other values, validated like a loaded one."""


class FreeKeys(FreeNumbers[Scene]):
    """The free numbers of a scene; see `FreeNumbers` for the keys."""

    def __init__(self, scene: Scene, keys: Sequence[str], *, one_period: bool = False) -> None:
        self.one_period = one_period
        """Whether runs last one period of their single input, whichever it has."""
        super().__init__(scene, keys)

    def only(self, keys: Sequence[str]) -> Self:
        """Some of them, by their keys as given."""
        return type(self)(self.scene, keys, one_period=self.one_period)

    def placed(self, values: Sequence[Any] | np.ndarray) -> Scene:
        """The scene with other values, not validated; they may be any kind of number."""
        found = self.with_values(values)
        return over_one_period(found) if self.one_period else found

    def validated(self, values: Sequence[float] | np.ndarray) -> Scene:
        """The scene with other values, validated like a loaded one."""
        from viscodesign.loading import checked

        return checked(self.placed([float(value) for value in values]))

    def _unknown(self, key: str) -> str:
        return f"no such number in this scene{did_you_mean(key, candidates(self.scene))}"

    def _networks(self) -> Mapping[KeyPath, Mapping[str, TubePlace]]:
        inlets = tuple(self.scene.inputs)
        return {NETWORK: tube_places(self.scene.network, self.scene.bellows.count, inlets, NETWORK)}


ACTUATORS = "actuators"
NETWORK: KeyPath = ("network",)
TUBES, CHANGES = ("tubes",), ("changes",)


def tube_places(
    network: Network, bellows: int, inlets: tuple[str, ...], path: KeyPath
) -> dict[str, TubePlace]:
    """Where the numbers of each tube of a network at a path stand, by its name; no feed lines."""
    graph = copied(network, {"feed_line": None}).graph(bellows, inlets)
    found: dict[str, TubePlace] = {}
    for k, tube in enumerate(graph.tubes):
        turned = f"{tube.end}-{tube.start}"
        own = turned if turned in network.changes else tube.name
        is_custom = network.layout == "custom"
        place = (*TUBES, str(k)) if is_custom else (*CHANGES, own)
        found[tube.name] = TubePlace(tube, (*path, *place))
    return found


class FreeActuatorNumbers(FreeNumbers[ManyT]):
    """The free numbers of a spec that has actuators by name.

    Those of an actuator have ``actuators.NAME.`` before them: ``actuators.left.bellows.height``,
    ``actuators.left.network.tubes[R1-R2].length``. They hold for all that are `like` it.
    """

    def _expanded(self, key: str) -> list[FreeNumber]:
        root, _, rest = key.partition(".")
        name, _, below = rest.partition(".")
        actuators: Mapping[str, ActuatorDesign] = self.scene.actuators
        like = actuators[name].like if name in actuators else None
        if root == ACTUATORS and like is not None and below.partition(".")[0] != "loads":
            message = f"'{name}' is like '{like}'; set {ACTUATORS}.{like}.{below} free"
            raise SpecError([Fault(message, key)])
        return super()._expanded(key)

    def _inlets_of(self, actuator: str) -> tuple[str, ...]:
        """Inlets of an actuator's own network."""
        raise NotImplementedError

    def _networks(self) -> Mapping[KeyPath, Mapping[str, TubePlace]]:
        found: dict[KeyPath, Mapping[str, TubePlace]] = {}
        actuators: Mapping[str, ActuatorDesign] = self.scene.actuators
        for name, own in actuators.items():
            if own.network is not None and own.bellows is not None:
                path = (ACTUATORS, name, *NETWORK)
                inlets = self._inlets_of(name)
                found[path] = tube_places(own.network, own.bellows.count, inlets, path)
        return found


def _tube_key(network: KeyPath, name: str, size: str) -> str:
    return f"{'.'.join((*network, *TUBES))}[{name}].{size}"


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


def with_fluid_numbers(scene: SpecT) -> SpecT:
    """The spec with the numbers of its fluid spelt out."""
    choice = scene.fluid_choice
    if choice.viscosity is not None:
        return scene
    known = choice.properties(scene.temperature, scene.ambient_pressure)
    spelt = Fluid(
        name=known.name,
        viscosity=known.viscosity,
        density=known.density,
        gas_constant=known.gas_constant,
        bulk_modulus=known.bulk_modulus,
        vapour_pressure=known.vapour_pressure,
        polytropic_exponent=choice.polytropic_exponent,
    )
    found: SpecT = copied(scene, {"fluid_choice": spelt})
    return found


def _frozen(path: KeyPath) -> str:
    """Why the number at a place cannot be free; empty where it may be."""
    if path[0] == EFFECTS and len(path) > 2 and path[2] != MODE:
        return ""
    single = ("input", *path[2:]) if path[0] == "inputs" else path
    return FROZEN_SECTIONS.get(path[0], "") or FROZEN_FIELDS.get(single[:2], "")


def _refuse_surroundings(scene: Scene | SeveralScene | RobotScene, keys: Sequence[str]) -> None:
    """Refuse what a named fluid's properties depend on."""
    for key in keys if scene.fluid_choice.viscosity is None else ():
        if key in SURROUNDINGS:
            library = f"the library that gives the properties of {scene.fluid_choice.name}"
            raise _refused(key, f"{library} has no derivatives; give viscosity and density")


def _refused(key: str, reason: str) -> SpecError:
    return SpecError([Fault(f"cannot be free: {reason}", key)])


def _parsed(key: str) -> KeyPath:
    """The parts of a key; what stands in brackets is a part of its own, with them."""
    parts = tuple(re.findall(r"\[[^\]]*\]|[^.\[\]]+", key))
    written = "".join(part if part.startswith("[") else f".{part}" for part in parts)
    return parts if parts and written == f".{key}" else (key,)
