"""A spec of several actuators: those that share no fluid are scenes of their own.

Inputs of given pressure couple nothing. A syringe that equal actuators share gives each of them an
even part, since all of them move alike. What tubes or other syringes join is one scene.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from pydantic import (
    Field,
    ValidationError,
    field_validator,
    model_validator,
)
from pydantic_core import PydanticCustomError

from viscodesign.errors import Fault, SpecError
from viscodesign.scene.alone import Alone, alone
from viscodesign.scene.common_period import common_period
from viscodesign.scene.effects_choice import EFFECTS_WORDS, EffectsChoice
from viscodesign.scene.fed_actuator import INLET, FedActuator, by_inlet, inherited
from viscodesign.scene.fluid_links import (
    LinkedGroup,
    linked_groups,
    reached_by_tubes,
    whole_group,
)
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.joined_scene import JoinedScene, joined_keys
from viscodesign.scene.later_input import own_inputs
from viscodesign.scene.loads import Loads
from viscodesign.scene.network import TubeEntry
from viscodesign.scene.pump import AnyPump
from viscodesign.scene.read_only import ReadOnlyDict
from viscodesign.scene.run import RunSettings
from viscodesign.scene.scene import Scene
from viscodesign.scene.several import OwnOrSameInput, same_input_faults, unlike
from viscodesign.scene.several_faults import (
    group_faults,
    later_faults,
    link_faults,
    lost_faults,
    own_tube_faults,
    source_faults,
    tube_faults,
)
from viscodesign.scene.spec_part import KeyFault, KeyPath, faults_of, raise_faults
from viscodesign.scene.uncertainty import Uncertainty
from viscodesign.scene.whole_spec import (
    DEFAULT_ACCURACY,
    STANDARD_ATMOSPHERE,
    STANDARD_TEMPERATURE,
    Accuracy,
    Ambient,
    Baseline,
    FluidChoice,
    FluidTemperature,
    WholeSpec,
)
from viscodesign.storage.cached_property import cached_property

OF_DESIGN = {"actuator": "actuator", "sections": "section_changes", "bellows": "bellows",
             "network": "network"}  # fmt: skip
"""Keys of a scene that an actuator states, and their fields."""
SHARED = (
    *("temperature", "gauge_pressure", "ambient_pressure", "accuracy", "effects", "uncertainty"),
    "run",
)
"""Keys of a scene that all actuators share, and whose fields are called the same."""


NOTHING = {"kind": "constant", "value": 0.0}
"""The input of an inlet whose pressure follows from the others: none yet."""


def all_repeat(inputs: Iterable[Any]) -> bool:
    """Whether all of these inputs repeat themselves together."""
    return all(isinstance(own, Input) for own in inputs) and common_period(inputs) is not None


class SeveralScene(WholeSpec):
    """A validated spec of several actuators, in SI units."""

    actuators: dict[str, FedActuator] = Field(min_length=1, description="The actuators, by name")
    tubes: tuple[TubeEntry, ...] | None = Field(
        None,
        description="Tubes between actuators, inputs and junctions: {from: A, to: left.R1, length, "
        "radius}",
    )
    fluid_choice: FluidChoice
    temperature: FluidTemperature = STANDARD_TEMPERATURE
    gauge_pressure: Baseline = 0.0
    ambient_pressure: Ambient = STANDARD_ATMOSPHERE
    accuracy: Accuracy = Field(
        DEFAULT_ACCURACY,
        description="Allowed tip error relative to the length of each actuator",
    )
    inputs: dict[str, OwnOrSameInput] = Field(
        min_length=1, description="The inputs by name: one may feed several actuators"
    )
    loads: Loads = Field(default_factory=Loads, description="Loads of every actuator")
    effects: EffectsChoice = Field(default_factory=EffectsChoice, description=EFFECTS_WORDS)
    uncertainty: Uncertainty | None = Field(None, description="How well numbers are known")
    run: RunSettings = Field(description="Duration, outputs and initial state")
    pump: AnyPump | None = Field(
        None, description="The pump at every input, for the pump commands; it feeds all actuators"
    )

    @field_validator("actuators")
    @classmethod
    def _usable_as_folders(cls, given: dict[str, FedActuator]) -> dict[str, FedActuator]:
        raise_faults(
            KeyFault((name,), "not a valid name; use letters, digits and '_', a letter first")
            for name in given
            if not (name.isidentifier() and name.isascii())
        )
        return given

    @model_validator(mode="after")
    def _cross_check(self) -> SeveralScene:
        raise_faults(self._faults())
        return self

    # -- faults -----------------------------------------------------------------

    def _faults(self) -> Iterator[KeyFault]:
        yield from tube_faults(self.tubes, self.actuators)
        try:
            unlike(self.actuators)
        except PydanticCustomError as error:
            yield from (f._replace(path=("actuators", *f.path)) for f in faults_of(error))
            return
        found = list(same_input_faults(self.inputs)) or list(
            later_faults(self.inputs, self.sources)
        )
        found += source_faults(self)
        found += own_tube_faults(self.actuators)
        found += link_faults(self)
        found += [] if found else lost_faults(self)
        yield from found
        if not found:
            yield from self._scene_faults()

    def _scene_faults(self) -> Iterator[KeyFault]:
        told: set[KeyFault] = set()
        try:
            linked = {name: group for group in self.groups for name in group.names}
        except PydanticCustomError as error:  # of a network that has no graph
            linked = {}
            yield from faults_of(error)
        for name in self.actuators:
            try:
                _ = self._scene(name) if name not in linked else self._alone_scene(name)
            except ValidationError as error:
                for fault in self._own_faults(name, error):
                    if fault not in told:
                        told.add(fault)
                        yield fault
        if not told:
            yield from self._joined_faults()

    def _joined_faults(self) -> Iterator[KeyFault]:
        for group in self.groups:
            faults = list(group_faults(self, group))
            yield from faults
            try:
                _ = faults or self._joined(group)
            except ValidationError as error:
                for fault in self._own_faults(group.names[0], error):
                    is_tube = fault.path[:2] == ("actuators", group.names[0])
                    yield fault._replace(path=("tubes",)) if is_tube else fault

    def _own_faults(self, name: str, error: ValidationError) -> Iterator[KeyFault]:
        """The faults of an actuator's scene at the keys of this spec."""
        root = name
        while (other := self.actuators[root].like) is not None:
            root = other
        for detail in error.errors(include_url=False):
            for fault in (detail.get("ctx") or {}).get("faults", ()):
                path: KeyPath = (*map(str, detail["loc"]), *fault.path)
                first = path[0] if path else ""
                if first in OF_DESIGN:
                    path = ("actuators", root, *path)
                elif first in ("input", "inputs"):
                    path = ("actuators", name, "source")
                yield fault._replace(path=path)

    # -- what it consists of ------------------------------------------------------

    @cached_property
    def sources(self) -> Mapping[str, Input]:
        """The inputs by name, each with values of its own."""
        return ReadOnlyDict(own_inputs(self.inputs, self.run.duration))

    def sources_of(self, actuator: str) -> Mapping[str, str]:
        """The input that feeds each inlet of an actuator; none where tubes of others feed it."""
        source = inherited(actuator, self.actuators, "source")
        if source is None and actuator in reached_by_tubes(self):
            return {}
        return by_inlet(next(iter(self.inputs)) if source is None else source)

    def fed_by(self, name: str) -> list[str]:
        """The actuators that an input feeds."""
        return [own for own in self.actuators if name in self.sources_of(own).values()]

    @cached_property
    def scenes(self) -> Mapping[str, Scene]:
        """Each actuator by itself that shares no fluid with others."""
        linked = {name for group in self.groups for name in group.names}
        own = (name for name in self.actuators if name not in linked)
        return ReadOnlyDict({name: self._scene(name) for name in own})

    @cached_property
    def groups(self) -> tuple[LinkedGroup, ...]:
        """The actuators that share fluid, group by group."""
        return tuple(linked_groups(self))

    @cached_property
    def joined(self) -> tuple[JoinedScene, ...]:
        """What shares fluid, each group as one scene, in the same order."""
        return tuple(self._joined(group) for group in self.groups)

    @cached_property
    def alone(self) -> Mapping[str, Alone]:
        """The network of each actuator that shares fluid, by itself."""
        each = ((group, own) for group in self.groups for own in group.actuators)
        return ReadOnlyDict({own.name: alone(group, own) for group, own in each})

    @property
    def pumped(self) -> JoinedScene:
        """All actuators as one scene with the pump: each input feeds all that hangs on it.

        Raises `SpecError` where actuators are too unlike to be one system.
        """
        group = whole_group(self)
        if faults := list(group_faults(self, group)):
            raise SpecError([Fault(f.message, ".".join(f.path), self._source.file) for f in faults])
        return self._joined(group, self.name, pump=self.pump)

    def _share(self, name: str) -> Input:
        """What one actuator has of an input."""
        source = self.sources[name]
        return source.shared_by(len(self.fed_by(name))) or source

    def _scene(self, name: str) -> Scene:
        own = self.sources_of(name)
        inputs = {inlet: self._share(source) for inlet, source in own.items()}
        driven = {"inputs": inputs} if tuple(own) != (INLET,) else {"input": inputs[INLET]}
        network = unlike(self.actuators)[name].network
        return Scene.model_validate(self._keys(name, network) | driven).with_source(self._source)

    def _keys(self, name: str, network: Any) -> dict[str, Any]:
        """The keys of an actuator by itself, but its inputs."""
        design, loads = unlike(self.actuators)[name], inherited(name, self.actuators, "loads")
        return {
            **self._common(name),
            **{key: getattr(design, field) for key, field in OF_DESIGN.items()},
            "network": network,
            "loads": self.loads if loads is None else loads,
        }

    def _common(self, name: str) -> dict[str, Any]:
        """The keys that all have in common; ``name``: of what they are."""
        return {
            "name": f"{self.name}.{name}"[:100],
            **({"spec": self.spec} if "spec" in self.model_fields_set else {}),
            "fluid": self.fluid_choice,
            **{key: getattr(self, key) for key in SHARED},
        }

    def _alone_scene(self, name: str) -> Scene:
        """An actuator that shares fluid by itself, with nothing at its inlets yet."""
        own = self.alone[name]
        return self.alone_driven_by(name, dict.fromkeys(own.inlets, NOTHING))

    def alone_driven_by(self, name: str, inputs: Mapping[str, Any]) -> Scene:
        """An actuator that shares fluid by itself, with inputs at the inlets that it then has."""
        own = self.alone[name]
        keys = self._keys(name, own.network) | own.driven_by(inputs)
        if self.run.start == "periodic" and not all_repeat(inputs.values()):
            keys["run"] = self.run.model_copy(update={"start": "equilibrium"})
        return Scene.model_validate(keys).with_source(self._source)

    def _joined(self, group: LinkedGroup, name: str | None = None, **more: Any) -> JoinedScene:
        """A group as one scene; ``name``: unless it is that of its actuators."""
        scenes = {n: self.scenes.get(n) or self._alone_scene(n) for n in group.names}
        keys = self._common("+".join(group.names)) | joined_keys(group, scenes, self.sources)
        keys |= more | ({} if name is None else {"name": name})
        return JoinedScene.model_validate(keys).with_source(self._source)

    def __repr__(self) -> str:
        return f"<SeveralScene {self.name}: {', '.join(self.actuators)}>"
