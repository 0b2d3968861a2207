"""A spec of several actuators, each of which is a scene of its own.

Inputs of given pressure couple nothing. A syringe that equal actuators share gives each of them an
even part, since all of them move alike.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Literal

from pydantic import (
    Field,
    ValidationError,
    ValidationInfo,
    field_validator,
    model_validator,
)
from pydantic_core import PydanticCustomError

from viscodesign.scene.effects_choice import EffectsChoice
from viscodesign.scene.fed_actuator import INLET, FedActuator, by_inlet, inherited
from viscodesign.scene.fluid import Fluid
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.later_input import own_inputs
from viscodesign.scene.loads import Loads
from viscodesign.scene.network import TubeEntry
from viscodesign.scene.read_only import ReadOnlyDict
from viscodesign.scene.run import RunSettings
from viscodesign.scene.scene import (
    DEFAULT_ACCURACY,
    LEAST_ACCURACY,
    STANDARD_ATMOSPHERE,
    Scene,
)
from viscodesign.scene.several import OwnOrSameInput, same_input_faults, unlike
from viscodesign.scene.several_faults import (
    later_faults,
    own_tube_faults,
    plunger_faults,
    source_faults,
    tube_faults,
)
from viscodesign.scene.spec_part import KeyFault, KeyPath, faults_of, raise_faults
from viscodesign.scene.spec_version import SPEC_VERSION
from viscodesign.scene.uncertainty import Uncertainty
from viscodesign.scene.whole_spec import WholeSpec
from viscodesign.storage.cached_property import cached_property
from viscodesign.units import AbsolutePressure, Fraction, GaugePressure, Temperature

OF_DESIGN = {"actuator": "actuator", "sections": "section_changes", "bellows": "bellows",
             "network": "network"}  # fmt: skip
"""Keys of a scene that an actuator states, and their fields."""
SHARED = (
    *("temperature", "gauge_pressure", "ambient_pressure", "accuracy", "effects", "uncertainty"),
    "run",
)
"""Keys of a scene that all actuators share, and whose fields are called the same."""


class SeveralScene(WholeSpec):
    """A validated spec of several actuators, in SI units."""

    spec: Literal[1] = Field(SPEC_VERSION, description="Version of the keys; absent: 1")
    name: str = Field(min_length=1, max_length=100, description="Name of the run and its folder")
    actuators: dict[str, FedActuator] = Field(min_length=1, description="The actuators, by name")
    tubes: tuple[TubeEntry, ...] | None = Field(
        None, description="Tubes between actuators: not supported yet"
    )
    fluid_choice: Fluid = Field(alias="fluid", description="A named fluid, or its properties")
    temperature: Temperature = Field(
        293.15, gt=0, description="Temperature of fluid and surroundings"
    )
    gauge_pressure: GaugePressure = Field(
        0.0, description="Baseline gauge pressure, to which the inputs add"
    )
    ambient_pressure: AbsolutePressure = Field(
        STANDARD_ATMOSPHERE, gt=0, description="Absolute ambient pressure"
    )
    accuracy: Fraction = Field(
        DEFAULT_ACCURACY,
        ge=LEAST_ACCURACY,
        le=0.2,
        description="Allowed tip error relative to the length of each actuator",
    )
    inputs: dict[str, OwnOrSameInput] = Field(
        min_length=1, description="The inputs by name: one may feed several actuators"
    )
    loads: Loads = Field(default_factory=Loads, description="Loads of every actuator")
    effects: EffectsChoice = Field(
        default_factory=EffectsChoice, description="auto, or effect: auto | on | off"
    )
    uncertainty: Uncertainty | None = Field(None, description="How well numbers are known")
    run: RunSettings = Field(description="Duration, outputs and initial state")

    @field_validator("name")
    @classmethod
    def _usable_as_folder(cls, name: str) -> str:
        return Scene._usable_as_folder(name)

    @field_validator("actuators")
    @classmethod
    def _usable_as_folders(cls, given: dict[str, FedActuator]) -> dict[str, FedActuator]:
        raise_faults(
            KeyFault((name,), "not a valid name; use letters, digits and '_', a letter first")
            for name in given
            if not (name.isidentifier() and name.isascii())
        )
        return given

    @field_validator("loads", mode="before")
    @classmethod
    def _no_loads(cls, given: Any) -> Any:
        return {} if given is None else given

    @field_validator("fluid_choice", mode="before")
    @classmethod
    def _named(cls, given: Any) -> Any:
        return {"name": given} if isinstance(given, str) else given

    @field_validator("inputs", mode="before")
    @classmethod
    def _prepared(cls, given: Any, info: ValidationInfo) -> Any:
        """Inputs with what they refer to in other keys worked in, as those of a scene."""
        return Scene._prepared(given, info) if isinstance(given, dict) else given

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
        yield from found
        if not found:
            yield from plunger_faults(self)
            yield from self._scene_faults()

    def _scene_faults(self) -> Iterator[KeyFault]:
        told: set[KeyFault] = set()
        for name in self.actuators:
            try:
                self._scene(name)
            except ValidationError as error:
                for fault in self._own_faults(name, error):
                    if fault not in told:
                        told.add(fault)
                        yield fault

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
        """The input that feeds each inlet of an actuator."""
        source = inherited(actuator, self.actuators, "source")
        return by_inlet(next(iter(self.inputs)) if source is None else source)

    def fed_by(self, name: str) -> list[str]:
        """The actuators that an input feeds."""
        return [own for own in self.actuators if name in self.sources_of(own).values()]

    @cached_property
    def scenes(self) -> Mapping[str, Scene]:
        """Each actuator by itself."""
        return ReadOnlyDict({name: self._scene(name) for name in self.actuators})

    def _share(self, name: str) -> Input:
        """What one actuator has of an input."""
        source = self.sources[name]
        return source.shared_by(len(self.fed_by(name))) or source

    def _scene(self, name: str) -> Scene:
        design, own = unlike(self.actuators)[name], self.sources_of(name)
        loads = inherited(name, self.actuators, "loads")
        inputs = {inlet: self._share(source) for inlet, source in own.items()}
        driven = {"inputs": inputs} if tuple(own) != (INLET,) else {"input": inputs[INLET]}
        return Scene.model_validate(
            {
                "name": f"{self.name}.{name}"[:100],
                **({"spec": self.spec} if "spec" in self.model_fields_set else {}),
                **{key: getattr(design, field) for key, field in OF_DESIGN.items()},
                "fluid": self.fluid_choice,
                "loads": self.loads if loads is None else loads,
                **{key: getattr(self, key) for key in SHARED},
                **driven,
            }
        ).with_source(self._source)

    def __repr__(self) -> str:
        return f"<SeveralScene {self.name}: {', '.join(self.actuators)}>"

    def __str__(self) -> str:
        return repr(self)
