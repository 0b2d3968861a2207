"""The free numbers of a spec of several actuators, and what each of its scenes has of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from viscodesign.compiled.free_keys import ACTUATORS, TUBES, FreeActuatorNumbers, TubePlace
from viscodesign.errors import Fault, SpecError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.graph import Tube
from viscodesign.scene.fed_actuator import INLET
from viscodesign.scene.fluid_links import LinkedGroup, linked_groups
from viscodesign.scene.joined_scene import JoinedScene
from viscodesign.scene.rederived import rederived, rederived_group
from viscodesign.scene.scene import Scene
from viscodesign.scene.several import SameInput
from viscodesign.scene.several_scene import SeveralScene
from viscodesign.scene.spec_part import KeyPath, copied

UNEQUAL_FACTOR = 1.0 + 2.0**-7
"""By which numbers are multiplied to see whether anything that was equal still is."""


class SeveralKeys(FreeActuatorNumbers[SeveralScene]):
    """The free numbers of a spec of several actuators.

    As of `FreeActuatorNumbers`; tubes between actuators are ``tubes[A-tee].length``.
    """

    def validated(self, values: Sequence[float] | np.ndarray) -> SeveralScene:
        """The spec with other values, validated like a loaded one."""
        from viscodesign.loading import checked_several

        return checked_several(self.with_values([float(value) for value in values]))

    def shifted(self) -> SeveralScene:
        """The spec with every free number at a value that none has, not validated."""
        shifts = UNEQUAL_FACTOR * (1.0 + 1e-3 * np.arange(1, len(self.numbers) + 1))
        return self.with_values([(v or 1.0) * s for v, s in zip(self.values, shifts, strict=True)])

    def _inlets_of(self, actuator: str) -> tuple[str, ...]:
        return tuple(self.scene.sources_of(actuator)) or (INLET,)

    def _networks(self) -> Mapping[KeyPath, Mapping[str, TubePlace]]:
        shared: dict[str, TubePlace] = {}
        for k, entry in enumerate(self.scene.tubes or ()):
            assert entry.length is not None
            assert entry.radius is not None
            ends, sizes = (entry.start, entry.end), (entry.length, entry.radius)
            tube = Tube("-".join(ends), *ends, *sizes)
            shared.setdefault(tube.name, TubePlace(tube, (*TUBES, str(k))))
        return {**super()._networks(), **({(): shared} if shared else {})}


@dataclass(frozen=True, eq=False)
class ScenePart:
    """A scene of a spec of several actuators: one of them alone, or some that share fluid."""

    names: tuple[str, ...]
    scene: Scene
    group: LinkedGroup | None

    def rederived(self, former: SeveralScene, spec: SeveralScene) -> Scene:
        """The same in another spec that differs in numbers alone."""
        if self.group is None:
            return rederived(self.scene, self.names[0], former, spec)
        assert isinstance(self.scene, JoinedScene)
        return rederived_group(self.scene, self.group, former, spec)

    def of(self, spec: SeveralScene) -> Scene:
        """The same in a validated spec."""
        if self.group is None:
            return spec.scenes[self.names[0]]
        return next(own for own in spec.joined if tuple(own.members) == self.names)


def parts_of(keys: SeveralKeys) -> dict[str, ScenePart]:
    """The scene that each actuator belongs to, by name: equal ones have one together.

    Raises `SpecError` where other values would let actuators share fluid that now do not.
    """
    spec, other = keys.scene, keys.shifted()
    if [group.names for group in linked_groups(other)] != [group.names for group in spec.groups]:
        raise SpecError([_uneven_fault(keys)])
    found: dict[str, ScenePart] = {}
    first: dict[tuple[bytes, bytes], ScenePart] = {}
    for name, own in spec.scenes.items():
        part = ScenePart((name,), own, None)
        both = own, part.rederived(spec, other)
        digests = [copied(scene, {"name": "any"}).digest for scene in both]
        found[name] = first.setdefault((digests[0], digests[1]), part)
    for group, joined in zip(spec.groups, spec.joined, strict=True):
        found |= dict.fromkeys(group.names, ScenePart(group.names, joined, group))
    return {name: found[name] for name in spec.actuators}


def _uneven_fault(keys: SeveralKeys) -> Fault:
    of_one = [name for name in keys.names if name.startswith(f"{ACTUATORS}.")]
    return Fault(
        "cannot be free: a syringe feeds several actuators alike, since they are equal, and other "
        "values would make them differ. Let the others be `like` the one whose number is free",
        ", ".join(of_one) or ", ".join(keys.names),
    )


class PartKeys:
    """The free numbers of one scene of a spec of several actuators, as `FreeKeys` are of a scene.

    All numbers are of the whole spec; ``given`` are those that the scene may depend on.
    """

    def __init__(self, spec: SeveralScene, part: ScenePart, given: Sequence[str]) -> None:
        self.given, self._part = tuple(given), part
        self._keys = SeveralKeys(spec, self.given)
        self.names, self.values = self._keys.names, self._keys.values
        self.numbers = self._keys.numbers
        self.scene = part.rederived(spec, self._keys.scene)

    def only(self, keys: Sequence[str]) -> PartKeys:
        """Some of them, by their keys as given."""
        return PartKeys(self._keys.scene, self._part, keys)

    def are_allowed(self, values: np.ndarray) -> np.ndarray:
        """As of `FreeKeys`."""
        return self._keys.are_allowed(values)

    def placed(self, values: Sequence[Any] | np.ndarray) -> Scene:
        """The scene with other values, not validated; they may be any kind of number."""
        return self._part.rederived(self._keys.scene, self._keys.with_values(values))

    def validated(self, values: Sequence[float] | np.ndarray) -> Scene:
        """The scene with other values, validated like a loaded one."""
        return self._part.of(self._keys.validated(values))


def may_matter(spec: SeveralScene, part: ScenePart, path: KeyPath) -> bool:
    """Whether anything of a scene may follow from the number at a place of the spec."""
    if path[0] == ACTUATORS:
        return any(path[1] in _likes(spec, name) for name in part.names)
    if path[0] == "inputs":
        return any(path[1] in _inputs_behind(spec, name) for name in _fed_by(spec, part))
    return part.group is not None or path[0] != "tubes"


def _likes(spec: SeveralScene, name: str) -> list[str]:
    """An actuator, the one that it is like, and so on."""
    found = [name]
    while (other := spec.actuators[found[-1]].like) is not None:
        found.append(other)
    return found


def _fed_by(spec: SeveralScene, part: ScenePart) -> set[str]:
    """The inputs that a scene has."""
    if part.group is not None:
        return set(part.group.inputs)
    return set(spec.sources_of(part.names[0]).values())


def _inputs_behind(spec: SeveralScene, name: str) -> set[str]:
    """An input, and the one that it is as, later."""
    own = spec.inputs[name]
    return {name, own.source} if isinstance(own, SameInput) else {name}
