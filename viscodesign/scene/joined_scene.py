"""Actuators that share fluid as one scene: their sections and bellows counted in a row."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from pydantic import Field

from viscodesign.model.graph import Graph
from viscodesign.scene.bellow_changes import BellowChange
from viscodesign.scene.fluid_links import LinkedGroup, LinkedTube
from viscodesign.scene.scene import Scene
from viscodesign.scene.sections import SectionChange
from viscodesign.storage.cached_property import cached_property


class JoinedScene(Scene):
    """One scene of several actuators, which `members` has one by one.

    What stands under a scene's own keys is of all: bellows and sections in a row, those of the
    first actuator first, and the tubes of all of them. The body is that of the first.
    """

    actuators: dict[str, Scene] = Field(description="Each actuator by itself, by name")
    tube_names: tuple[str, ...] = Field(description="Of all tubes, in order")

    @property
    def members(self) -> Mapping[str, Scene]:
        return self.actuators

    @cached_property
    def graph(self) -> Graph:
        """The network of all; bellows are named after their actuator: `left.R1`."""
        own = super().graph
        nodes = dict(zip(own.bellows, _bellows_of(self.actuators), strict=True))
        named = zip(own.tubes, self.tube_names, strict=True)
        return replace(
            own,
            bellows=tuple(nodes.values()),
            tubes=tuple(
                replace(
                    t, name=name, start=nodes.get(t.start, t.start), end=nodes.get(t.end, t.end)
                )
                for t, name in named
            ),
        )

    def section_name(self, number: int) -> str:
        """What a section, counted in the row of all from 1, is called: `section 2 of left`."""
        for name, own in self.actuators.items():
            count = own.bellows.count // 2
            if number <= count:
                return f"section {number} of {name}"
            number -= count
        raise KeyError(number)


def _bellows_of(actuators: Mapping[str, Scene]) -> Iterator[str]:
    """The bellows of all actuators in the order of a graph: the right ones, then the left ones."""
    for side in "RL":
        for name, own in actuators.items():
            yield from (f"{name}.{side}{j + 1}" for j in range(own.bellows.count // 2))


def joined_keys(
    group: LinkedGroup, actuators: Mapping[str, Scene], inputs: Mapping[str, Any]
) -> dict[str, Any]:
    """The keys of a joined scene that depend on what it consists of."""
    first = next(iter(actuators.values()))
    return {
        "actuator": first.actuator,
        "actuators": dict(actuators),
        "tube_names": tuple(tube.name for tube in group.tubes),
        "bellows": _bellows(actuators),
        "sections": _sections(actuators) or None,
        "network": {
            "layout": "custom",
            "tubes": _tubes(group),
            **{key: getattr(first.network, key) for key in OF_ALL_TUBES},
        },
        "inputs": {name: inputs[name] for name in group.inputs},
        "loads": first.loads,
    }


OF_ALL_TUBES = ("tube_wall", "entrance_loss", "exit_loss")
"""Keys of a network that hold of all tubes that are joined."""


def _tubes(group: LinkedGroup) -> list[dict[str, Any]]:
    numbered: dict[str, str] = {}
    before = 0
    for own in group.actuators:
        for side in "RL":
            numbered |= {
                f"{own.name}.{side}{j + 1}": f"{side}{before + j + 1}" for j in range(own.count)
            }
        before += own.count
    return [_entry(tube, numbered) for tube in group.tubes]


def _entry(tube: LinkedTube, numbered: Mapping[str, str]) -> dict[str, Any]:
    ends = (numbered.get(node, node) for node in (tube.start, tube.end))
    return {
        **dict(zip(("from", "to"), ends, strict=True)),
        "length": tube.length,
        "radius": tube.radius,
    }


def _bellows(actuators: Mapping[str, Scene]) -> dict[str, Any]:
    """The keys of all bellows: those of the first, and what is otherwise."""
    scenes = list(actuators.values())
    first = scenes[0].bellows
    keys = {n: getattr(first, n) for n in type(first).model_fields if n not in ("count", "changes")}
    changes: dict[str, dict[str, Any]] = {}
    for name in BellowChange.model_fields:
        before = 0
        for own in scenes:
            count = own.bellows.count // 2
            values = _each_bellow(own, name, 2 * count)
            for k, value in enumerate(values):
                if value is not None and not _same(value, keys[name]):
                    changes.setdefault(f"{'RL'[k // count]}{before + k % count + 1}", {})[name] = (
                        value
                    )
            before += count
    total = sum(own.bellows.count for own in scenes)
    return {**keys, "count": total, "changes": changes or None}


def _each_bellow(scene: Scene, name: str, count: int) -> Sequence[Any]:
    if name == "curve":
        curves = scene.bellows.curves
        return (curves * (count // len(curves))) if curves else [None] * count
    return _list(scene.bellows.each(name), count)


def _same(value: Any, usual: Any) -> bool:
    return bool(value == usual)


def _list(values: Any, count: int) -> list[Any]:
    return values.tolist() if isinstance(values, np.ndarray) else [values] * count


def _sections(actuators: Mapping[str, Scene]) -> dict[str, dict[str, Any]]:
    """What sections have otherwise than the body of the first actuator."""
    usual = next(iter(actuators.values())).actuator
    found: dict[str, dict[str, Any]] = {}
    before = 0
    for own in actuators.values():
        count = own.bellows.count // 2
        for name in SectionChange.model_fields:
            for j, value in enumerate(_each_section(own, name, count)):
                if value is not None and not _same(value, getattr(usual, name, False)):
                    found.setdefault(str(before + j + 1), {})[name] = value
        before += count
    return found


def _each_section(scene: Scene, name: str, count: int) -> list[Any]:
    if name == "blocked":
        blocked = scene.sections.blocked
        return [False] * count if blocked is None else blocked.tolist()
    values = _list(scene.sections.each(name), count)
    if name == "shear_factor":
        usual = _list(scene.sections.each("extension_factor"), count)
        return [b if a is None else a for a, b in zip(values, usual, strict=True)]
    return values
