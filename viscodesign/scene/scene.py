"""The whole spec."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar, Self

from pydantic import Field, ValidationInfo, field_validator, model_validator

from viscodesign.lazy_names import module_above
from viscodesign.model.graph import Graph
from viscodesign.scene.actuator import Actuator
from viscodesign.scene.bellows import Bellows
from viscodesign.scene.common_period import common_period
from viscodesign.scene.cross_checks import SINGLE_INLET, cross_check
from viscodesign.scene.effects_choice import EFFECTS_WORDS, EffectsChoice
from viscodesign.scene.fluids.base import FluidProperties
from viscodesign.scene.input import AnyInput
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.loads import Loads
from viscodesign.scene.network import Network
from viscodesign.scene.pump import AnyPump
from viscodesign.scene.pumps.base import PumpSpec
from viscodesign.scene.read_only import ReadOnlyDict
from viscodesign.scene.run import RunSettings
from viscodesign.scene.sections import SectionChange, Sections
from viscodesign.scene.spec_part import raise_faults
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


class Scene(WholeSpec):
    """A validated scene in SI units; the keys are those of the YAML spec."""

    section: ClassVar[str] = ""

    actuator: Actuator = Field(description="The elastomer body: size, stiffness, mass")
    bellows: Bellows = Field(description="Number, size and measured coefficients of the bellows")
    section_changes: dict[str, SectionChange] | None = Field(
        None,
        alias="sections",
        description="Sections that differ, by number or range from the clamp: 3, 1-2",
    )
    network: Network = Field(description="The tubes that connect the bellows")
    fluid_choice: FluidChoice
    temperature: FluidTemperature = STANDARD_TEMPERATURE
    gauge_pressure: Baseline = 0.0
    ambient_pressure: Ambient = STANDARD_ATMOSPHERE
    accuracy: Accuracy = Field(
        DEFAULT_ACCURACY,
        description="Allowed tip error relative to the actuator length",
        examples=["0.5 %"],
    )
    input: AnyInput | None = Field(None, description="The input of a single inlet")
    several_inputs: dict[str, AnyInput] | None = Field(
        None, alias="inputs", description="One input per inlet, by name"
    )
    loads: Loads = Field(default_factory=Loads, description="Gravity, tip force and payload")
    effects: EffectsChoice = Field(default_factory=EffectsChoice, description=EFFECTS_WORDS)
    uncertainty: Uncertainty | None = Field(
        None,
        description="How well numbers are known: key: 5 % (one standard deviation) or key: "
        "[low, high]; or typical, for all coefficients",
    )
    run: RunSettings = Field(description="Duration, outputs and initial state")
    pump: AnyPump | None = Field(None, description="The pump, for the pump commands")

    @field_validator("pump")
    @classmethod
    def _resolved(cls, pump: PumpSpec | None, info: ValidationInfo) -> PumpSpec | None:
        """Its inlets in order and its pressures as gauge, as far as these are valid."""
        if pump is None:
            return None
        pump = pump.in_order_of(tuple(info.data.get("several_inputs") or ()))
        ambient = info.data.get("ambient_pressure")
        return pump if ambient is None else pump.with_gauge_pressures(ambient)

    @field_validator("section_changes", mode="before")
    @classmethod
    def _numbered(cls, given: Any) -> Any:
        return {str(key): own for key, own in given.items()} if isinstance(given, dict) else given

    @model_validator(mode="after")
    def _cross_check(self) -> Scene:
        raise_faults(cross_check(self._fields()))
        return self

    def _fields(self) -> dict[tuple[str, str | None], Any]:
        parts: dict[tuple[str, str | None], Any] = {
            ("Scene", name): getattr(self, name) for name in type(self).model_fields
        }
        return {
            **parts,
            ("RunSettings", "duration"): self.run.duration,
            ("RunSettings", "start"): self.run.start,
            ("Bellows", "count"): self.bellows.count,
        }

    @property
    def inputs(self) -> Mapping[str, Input]:
        """Input of each inlet by its name."""
        if self.several_inputs is not None:
            return self.several_inputs
        return ReadOnlyDict({SINGLE_INLET: self.input} if self.input is not None else {})

    @property
    def members(self) -> Mapping[str, Scene]:
        """Each of several actuators that share fluid, by name; empty for a single one."""
        return ReadOnlyDict({})

    @property
    def loads_of_rods(self) -> tuple[Loads, ...]:
        """The loads of every actuator."""
        return tuple(own.loads for own in self.members.values()) or (self.loads,)

    @property
    def period(self) -> float | None:
        """Time after which all inputs repeat together [s]; None where they do not."""
        return common_period(self.inputs.values())

    @cached_property
    def fluid(self) -> FluidProperties:
        """The fluid at the scene's temperature and ambient pressure."""
        return self.fluid_choice.properties(self.temperature, self.ambient_pressure)

    @cached_property
    def sections(self) -> Sections:
        """The numbers of all sections."""
        return Sections(self.actuator, self.bellows.count // 2, self.section_changes)

    @cached_property
    def graph(self) -> Graph:
        """The network as a graph."""
        return self.network.graph(self.bellows.count, tuple(self.inputs))

    def replace(self, changes: Mapping[str, Any]) -> Scene:
        """A new scene with other values of some keys, checked like a loaded one.

        ``changes``: values by key, such as ``{"network.tube_length": 0.2}``; a number is SI, a
        text may have a unit. Raises `SpecError` with all faults.
        """
        found: Scene = module_above("loading").replaced(self, changes)
        return found

    def _updated(self, fields: Mapping[str, Any]) -> Self:
        keys = {name: found.alias or name for name, found in type(self).model_fields.items()}
        found: Self = module_above("loading").replaced(
            self, {keys[name]: value for name, value in fields.items()}
        )
        return found

    def __repr__(self) -> str:
        fluid, network = self.fluid_choice.name, self.network.layout
        driven = " and ".join(source.name for source in self.inputs.values())
        return (
            f"<Scene {self.name}: {self.bellows.count} bellows, {network}, {fluid}, "
            f"{driven} for {self.run.duration:g} s>"
        )

    def _repr_html_(self) -> str:
        """What a notebook shows: the resolved spec, section by section."""
        shown: str = module_above("report.notebook").scene_html(self)
        return shown
