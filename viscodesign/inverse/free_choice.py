"""What a design task sets free: numbers within bounds, the graph, and the input."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

import numpy as np

from viscodesign.compiled.free_keys import FreeKeys
from viscodesign.errors import Fault, SpecError, described, not_among
from viscodesign.inverse.free_range import FreeRange, bounds
from viscodesign.inverse.harmonic_input import HarmonicChoice
from viscodesign.inverse.target_spec import FREE_FORM, ReadTarget
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.scene import Scene
from viscodesign.studies.least_squares import NumberRanges

GRAPH, INPUT, HARMONICS = "network.graph", "input", "harmonics"
GraphChoice = Literal["keep", "chain", "tree"]
EVERY_TUBE = "network.tubes[*]"
GRAPHS: tuple[GraphChoice, ...] = ("keep", "chain", "tree")


@dataclass(frozen=True)
class FreeChoice:
    """All that is free."""

    ranges: tuple[FreeRange, ...]
    graph: GraphChoice = "keep"
    harmonics: HarmonicChoice | None = None
    """Where the input is free; its numbers are among the ranges."""

    @property
    def keys(self) -> list[str]:
        """Keys of all ranges."""
        return [own.key for own in self.ranges]

    @property
    def moves_period(self) -> bool:
        """Whether the period of the input is free."""
        return any(key in ("input.period", "input.frequency") for key in self.keys)

    def numbers(self, scene: Scene) -> tuple[FreeKeys, NumberRanges] | None:
        """The numbers that are free in a scene, one by one, and their bounds."""
        if not self.ranges:
            return None
        keys = FreeKeys(scene, self.keys)
        counts = [len(FreeKeys(scene, [own.key]).numbers) for own in self.ranges]
        low = np.repeat([own.low for own in self.ranges], counts)
        high = np.repeat([own.high for own in self.ranges], counts)
        return keys, NumberRanges.of(low, high)


def free_choice(read: ReadTarget, scene: Scene) -> FreeChoice:
    """What is free in a task on a scene. Raises `SpecError` with all faults by their lines."""
    named = _named_tubes(read.spec.free)
    faults = [_placed(_fault_of_names(named), named[0], read)] if named else []
    ranges: list[FreeRange] = []
    graph: GraphChoice = "keep"
    harmonics: HarmonicChoice | None = None
    for key, given in read.spec.free.items():
        if key in named:
            continue
        try:
            if key == GRAPH:
                graph = _graph(given)
            elif key == INPUT and isinstance(given, Mapping) and HARMONICS in given:
                harmonics = HarmonicChoice.of(given, input_size(scene))
                ranges += harmonics.ranges()
            elif key == INPUT:
                ranges += [_range(scene, f"input.{own}", b) for own, b in _own_keys(given).items()]
            else:
                ranges.append(_range(scene, key, given))
        except SpecError as error:
            faults += [_placed(fault, key, read) for fault in error.faults]
    if faults:
        raise SpecError(faults)
    if harmonics is not None:
        if len(scene.inputs) != 1 or scene.input is None:
            raise SpecError([_placed(Fault("harmonics need a spec with one `input`"), INPUT, read)])
        scene = harmonics.placed(scene)
    if ranges:
        try:
            FreeKeys(scene, [own.key for own in ranges])
        except SpecError as error:  # keys that overlap
            raise SpecError([_placed(fault, fault.key, read) for fault in error.faults]) from None
    if not ranges and harmonics is None and graph == "keep":
        raise SpecError([_placed(Fault(f"keep leaves nothing free; {FREE_FORM}"), GRAPH, read)])
    return FreeChoice(tuple(ranges), graph, harmonics)


def input_size(scene: Scene) -> float:
    """Largest pressure of the spec's own inputs above the baseline [Pa]; 0 without one."""
    sources = [own for own in scene.inputs.values() if own.gives_pressure]
    ends = [abs(end) for own in sources for end in own.extremes(scene.run.duration)]
    return max(ends, default=0.0)


def _named_tubes(free: Mapping[str, Any]) -> list[str]:
    """Keys of tubes of the spec's own graph, where a free graph replaces it."""
    if free.get(GRAPH) not in GRAPHS[1:]:
        return []
    return [k for k in free if k.startswith("network.tubes[") and not k.startswith(EVERY_TUBE)]


def _fault_of_names(keys: list[str]) -> Fault:
    sizes = dict.fromkeys(key.rpartition("]")[2] for key in keys)
    every = " and ".join(f"{EVERY_TUBE}{size}" for size in sizes)
    more = f" (one of {len(keys)} such keys)" if len(keys) > 1 else ""
    return Fault(
        f"names a tube of the spec's own graph{more}, which a free network.graph replaces; "
        f"write {every} for one number a tube, or network.graph: keep",
        keys[0],
    )


def _placed(fault: Fault, key: str, read: ReadTarget) -> Fault:
    """A fault of a key under `free`, with its line."""
    file, line = read.document.place(("free", key))
    own = fault.key or key
    if key == INPUT and not own.startswith(INPUT):
        own = f"{INPUT}.{own}"
    return Fault(fault.message, f"free.{own}", file, line, read.spec.free.get(key))


def _graph(given: Any) -> GraphChoice:
    found = next((choice for choice in GRAPHS if choice == given), None)
    if found is None:
        raise SpecError.plain(not_among(given, GRAPHS))
    return found


def _own_keys(given: Any) -> Mapping[str, Any]:
    if not isinstance(given, Mapping) or not given:
        raise SpecError.plain(
            f"expected the input's keys with bounds, such as {{drop: [10 kPa, 60 kPa]}}, or "
            f"{{harmonics: 6, period: [5 s, 400 s], limits: [-25 kPa, 30 kPa]}}; "
            f"got {described(given)}"
        )
    return given


def _range(scene: Scene, key: str, given: Any) -> FreeRange:
    """Bounds of one key. Raises `SpecError`."""
    numbers = FreeKeys(scene, [key]).numbers
    unit = numbers[0].unit
    own = max((abs(number.value) for number in numbers), default=0.0)
    low, high = bounds(key, unit, given, own)
    for value in (low, high):
        if fault := numbers[0].fault(value):
            raise SpecError([Fault(fault.message, key)])
    return FreeRange(key, low, high)
