"""The spec of a robot: actuators by name, the inputs that feed them, and the body they carry."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from pydantic import (
    Field,
    field_validator,
    model_validator,
)

from viscodesign.scene.common_period import common_period, no_period
from viscodesign.scene.effects_choice import EffectsChoice
from viscodesign.scene.fluids.base import FluidProperties
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.later_input import own_inputs
from viscodesign.scene.read_only import ReadOnlyDict
from viscodesign.scene.robot import Robot
from viscodesign.scene.robot_faults import robot_faults
from viscodesign.scene.run import RunSettings
from viscodesign.scene.scene import Scene
from viscodesign.scene.several import (
    ActuatorDesign,
    OwnOrSameInput,
    unlike,
)
from viscodesign.scene.spec_part import (
    invalid,
    raise_faults,
)
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

LEG_INLET = "inlet"
"""What the inlet of a leg's network is called."""


class RobotScene(WholeSpec):
    """A validated spec of a robot, in SI units."""

    actuators: dict[str, ActuatorDesign] = Field(min_length=1, description="The actuators, by name")
    fluid_choice: FluidChoice
    temperature: FluidTemperature = STANDARD_TEMPERATURE
    gauge_pressure: Baseline = 0.0
    ambient_pressure: Ambient = STANDARD_ATMOSPHERE
    accuracy: Accuracy = Field(
        DEFAULT_ACCURACY,
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

    @field_validator("effects")
    @classmethod
    def _fixed(cls, effects: EffectsChoice) -> EffectsChoice:
        if effects != EffectsChoice():
            raise invalid("the equations of a robot's legs are fixed; remove 'effects', or auto")
        return effects

    @model_validator(mode="after")
    def _cross_check(self) -> RobotScene:
        raise_faults(robot_faults(self))
        return self

    def hanging(self, design: ActuatorDesign, blocked: Sequence[int] = ()) -> Scene:
        """A design by itself at the baseline pressure, with some sections blocked, from 1."""
        return Scene.model_validate(
            {
                "name": self.name,
                "actuator": design.actuator,
                "sections": {str(k): {"blocked": True} for k in blocked} or None,
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
        """An actuator by itself, hanging at the baseline pressure, with the robot's pillars."""
        return self.hanging(unlike(self.actuators)[actuator], self.robot.stiff_sections)

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
