"""The spec of a robot: actuators by name, the inputs that feed them, and the body they carry."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Literal

from pydantic import (
    Field,
    PrivateAttr,
    ValidationError,
    ValidationInfo,
    field_validator,
    model_validator,
)
from pydantic_core import PydanticCustomError

from viscodesign.errors import did_you_mean
from viscodesign.scene.common_period import common_period, no_period
from viscodesign.scene.effects_choice import EffectsChoice
from viscodesign.scene.fluid import Fluid
from viscodesign.scene.fluids.base import FluidProperties
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.later_input import own_inputs
from viscodesign.scene.robot import Robot
from viscodesign.scene.run import RunSettings
from viscodesign.scene.scene import (
    DEFAULT_ACCURACY,
    LEAST_ACCURACY,
    STANDARD_ATMOSPHERE,
    Provenance,
    Scene,
)
from viscodesign.scene.several import (
    ActuatorDesign,
    OwnOrSameInput,
    SameInput,
    same_input_faults,
    unlike,
)
from viscodesign.scene.several_faults import later_faults
from viscodesign.scene.spec_part import (
    KeyFault,
    KeyPath,
    SpecPart,
    faults_of,
    invalid,
    raise_faults,
)
from viscodesign.scene.spec_version import SPEC_VERSION
from viscodesign.storage.cached_property import cached_property
from viscodesign.units import AbsolutePressure, Fraction, GaugePressure, Temperature

LEG_INLET = "inlet"
"""What the inlet of a leg's network is called."""


class RobotScene(SpecPart):
    """A validated spec of a robot, in SI units."""

    spec: Literal[1] = Field(SPEC_VERSION, description="Version of the keys; absent: 1")
    name: str = Field(min_length=1, max_length=100, description="Name of the run and its folder")
    actuators: dict[str, ActuatorDesign] = Field(description="The actuators, by name")
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
        description="Error of the advance per cycle that is aimed at, relative to it",
    )
    inputs: dict[str, OwnOrSameInput] = Field(
        description="The sources by name: one may feed several legs"
    )
    robot: Robot = Field(description="The body, its legs and the ground")
    effects: EffectsChoice = Field(
        default_factory=EffectsChoice, description="auto: the equations of a robot are fixed"
    )
    run: RunSettings = Field(description="Duration and outputs")

    _source: Provenance = PrivateAttr(default_factory=Provenance)

    @field_validator("name")
    @classmethod
    def _usable_as_folder(cls, name: str) -> str:
        return Scene._usable_as_folder(name)

    @field_validator("fluid_choice", mode="before")
    @classmethod
    def _named(cls, given: Any) -> Any:
        return {"name": given} if isinstance(given, str) else given

    @field_validator("inputs", mode="before")
    @classmethod
    def _prepared(cls, given: Any, info: ValidationInfo) -> Any:
        """Inputs with what they refer to in other keys worked in, as those of a scene."""
        return Scene._prepared(given, info) if isinstance(given, dict) else given

    @field_validator("effects")
    @classmethod
    def _fixed(cls, effects: EffectsChoice) -> EffectsChoice:
        if effects.modes or effects.others != "auto":
            raise invalid("the equations of a robot's legs are fixed; remove 'effects', or auto")
        return effects

    @model_validator(mode="after")
    def _cross_check(self) -> RobotScene:
        raise_faults(self._faults())
        return self

    def _faults(self) -> Iterator[KeyFault]:
        if not self.inputs:
            yield KeyFault(("inputs",), "empty; the legs need at least one source")
        unknown = list(same_input_faults(self.inputs))
        yield from unknown or later_faults(self.inputs, self.sources)
        yield from self._run_faults()
        yield from self._pressure_faults()
        yield from self._unsupported()
        try:
            designs = unlike(self.actuators)
        except PydanticCustomError as error:
            yield from (f._replace(path=("actuators", *f.path)) for f in faults_of(error))
            return
        yield from self._design_faults(designs)
        yield from self._leg_faults(designs)

    def _run_faults(self) -> Iterator[KeyFault]:
        if self.run.start != "equilibrium":
            yield KeyFault(
                ("run", "start"),
                f"'{self.run.start}', but a robot stands at the start, or falls from "
                "robot.hip_height; remove it",
            )
        if self.run.output_times is not None:
            yield KeyFault(
                ("run", "output_times"), "a gait is written by steps; give run.output_interval"
            )

    def _pressure_faults(self) -> Iterator[KeyFault]:
        for name, given in self.inputs.items():
            if not isinstance(given, SameInput) and not given.gives_pressure:
                yield KeyFault(
                    ("inputs", name, "kind"),
                    "a robot's sources give pressures; use a kind such as sine or trapezoid",
                )

    def _design_faults(self, designs: Mapping[str, ActuatorDesign]) -> Iterator[KeyFault]:
        for name in designs:
            if self.actuators[name].like is not None:
                continue
            try:
                self._leg_scene(designs[name])
            except ValidationError as error:
                for detail in error.errors(include_url=False):
                    for fault in (detail.get("ctx") or {}).get("faults", ()):
                        yield fault._replace(path=("actuators", name, *fault.path))

    def _unsupported(self) -> Iterator[KeyFault]:
        """What the equations of a leg do not have: a leg would be computed without it."""
        for name, own in self.actuators.items():
            parts = {"bellows": own.bellows, "network": own.network}
            given: list[KeyPath] = [("sections",)] if own.section_changes else []
            given += [
                (part, key)
                for part, key in (
                    ("bellows", "changes"),
                    ("bellows", "curve"),
                    ("network", "tube_wall"),
                )
                if getattr(parts[part], key, None)
            ]
            for path in given:
                yield KeyFault(
                    ("actuators", name, *path),
                    "a robot's legs have equal sections, linear bellows and rigid tubes; remove "
                    "it. Pillars are robot.stiff_sections",
                )

    def _leg_faults(self, designs: Mapping[str, ActuatorDesign]) -> Iterator[KeyFault]:
        for name, leg in self.robot.legs.items():
            place = ("robot", "legs", name)
            for key, given, known, kind in (
                ("actuator", leg.actuator, self.actuators, "actuator"),
                ("source", leg.source, self.inputs, "input"),
            ):
                if given not in known:
                    hint = did_you_mean(given, known)
                    listed = ", ".join(known)
                    yield KeyFault((*place, key), f"no such {kind}{hint}; there are {listed}")
        for name in dict.fromkeys(leg.actuator for leg in self.robot.legs.values()):
            bellows = designs[name].bellows if name in designs else None
            count = 0 if bellows is None else bellows.count // 2
            if bellows is not None and self.robot.stiff_sections[-1:] > (count - 1,):
                yield KeyFault(
                    ("robot", "stiff_sections"),
                    f"actuator '{name}' has sections 1 to {count}, one of which must bend; "
                    f"got {list(self.robot.stiff_sections)}",
                )

    def _leg_scene(self, design: ActuatorDesign) -> Scene:
        return Scene.model_validate(
            {
                "name": self.name,
                "actuator": design.actuator,
                "sections": design.section_changes,
                "bellows": design.bellows,
                "network": design.network,
                "fluid": self.fluid_choice,
                "temperature": self.temperature,
                "gauge_pressure": self.gauge_pressure,
                "ambient_pressure": self.ambient_pressure,
                "accuracy": self.accuracy,
                "input": {"kind": "constant", "value": 0.0},
                "run": {"duration": 1.0},
            }
        )

    def leg_scene(self, actuator: str) -> Scene:
        """An actuator by itself, hanging at the baseline pressure."""
        return self._leg_scene(unlike(self.actuators)[actuator])

    def single_scene(self, actuator: str, source: str) -> Scene:
        """An actuator by itself with one of the sources, hanging, named after both of them."""
        own = {"input": self.sources[source], "run": self.run}
        return self.leg_scene(actuator).model_copy(
            update={"name": f"{self.name}.{actuator}", **own}
        )

    @cached_property
    def sources(self) -> Mapping[str, Input]:
        """What feeds the legs, by name."""
        return own_inputs(self.inputs, self.run.duration)

    @property
    def period(self) -> float | None:
        """Time after which all sources repeat together [s]; None where they do not."""
        return common_period(self.sources.values())

    def no_period(self) -> str:
        """Why the sources have no period in common; empty where they have one."""
        return no_period(self.sources)

    @cached_property
    def fluid(self) -> FluidProperties:
        """The fluid at the scene's temperature and ambient pressure."""
        return self.fluid_choice.properties(self.temperature, self.ambient_pressure)

    @property
    def source(self) -> Provenance:
        """The file that the spec was read from."""
        return self._source

    def with_source(self, source: Provenance) -> RobotScene:
        """The same with its provenance."""
        copy = self.model_copy()
        copy._source = source
        return copy

    def __repr__(self) -> str:
        legs = len(self.robot.legs)
        return f"<RobotScene {self.name}: {legs} legs, {1e3 * self.robot.mass:g} g>"

    def __str__(self) -> str:
        return repr(self)
