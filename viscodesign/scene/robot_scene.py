"""The spec of a robot: actuators by name, the inputs that feed them, and the body they carry."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

from pydantic import (
    Field,
    ValidationInfo,
    field_validator,
    model_validator,
)

from viscodesign.scene.common_period import common_period, no_period
from viscodesign.scene.effects_choice import EffectsChoice
from viscodesign.scene.fluid import Fluid
from viscodesign.scene.fluids.base import FluidProperties
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.later_input import own_inputs
from viscodesign.scene.read_only import ReadOnlyDict
from viscodesign.scene.robot import Robot
from viscodesign.scene.robot_faults import robot_faults
from viscodesign.scene.run import RunSettings
from viscodesign.scene.scene import (
    DEFAULT_ACCURACY,
    LEAST_ACCURACY,
    STANDARD_ATMOSPHERE,
    Scene,
)
from viscodesign.scene.several import (
    ActuatorDesign,
    OwnOrSameInput,
    unlike,
)
from viscodesign.scene.spec_part import (
    invalid,
    raise_faults,
)
from viscodesign.scene.spec_version import SPEC_VERSION
from viscodesign.scene.whole_spec import WholeSpec
from viscodesign.storage.cached_property import cached_property
from viscodesign.units import AbsolutePressure, Fraction, GaugePressure, Temperature

LEG_INLET = "inlet"
"""What the inlet of a leg's network is called."""


class RobotScene(WholeSpec):
    """A validated spec of a robot, in SI units."""

    spec: Literal[1] = Field(SPEC_VERSION, description="Version of the keys; absent: 1")
    name: str = Field(min_length=1, max_length=100, description="Name of the run and its folder")
    actuators: dict[str, ActuatorDesign] = Field(min_length=1, description="The actuators, by name")
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
        raise_faults(robot_faults(self))
        return self

    def hanging(self, design: ActuatorDesign) -> Scene:
        """A design by itself at the baseline pressure."""
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
        return self.hanging(unlike(self.actuators)[actuator])

    def single_scene(self, actuator: str, source: str) -> Scene:
        """An actuator by itself with one of the sources, hanging, named after both of them."""
        own = {"input": self.sources[source], "run": self.run}
        return self.leg_scene(actuator).model_copy(
            update={"name": f"{self.name}.{actuator}", **own}
        )

    @cached_property
    def sources(self) -> Mapping[str, Input]:
        """What feeds the legs, by name."""
        return ReadOnlyDict(own_inputs(self.inputs, self.run.duration))

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

    def __repr__(self) -> str:
        legs = len(self.robot.legs)
        return f"<RobotScene {self.name}: {legs} legs, {1e3 * self.robot.mass:g} g>"

    def __str__(self) -> str:
        return repr(self)
