"""`pump: {kind: stepper}`: the section of a syringe that a stepper motor drives by a lead screw.

docs/extending.md has the contract of a kind of pump; `stepper_pump.py` is its other file.
"""

from __future__ import annotations

from typing import ClassVar, Literal

from pydantic import Field, model_validator

from viscodesign.scene.pumps.base import PumpSpec
from viscodesign.scene.spec_part import invalid_at
from viscodesign.units import Force, Length, Speed, Volume


class StepperPumpSpec(PumpSpec):
    """A syringe driven by a stepper motor with a lead screw."""

    name: ClassVar[str] = "stepper"

    kind: Literal["stepper"] = Field("stepper", description="The principle of the pump")
    syringe_diameter: Length = Field(gt=0, description="Inner diameter of the barrel")
    syringe_stroke: Length = Field(0.1045, gt=0, description="Usable stroke of the plunger")
    filled_length: Length | None = Field(None, gt=0, description="Filled barrel length at home")
    dead_volume: Volume = Field(5e-6, ge=0, description="Volume that the plunger cannot displace")
    plunger_friction: Force = Field(5.0, ge=0, description="Kinetic friction of the plunger")
    lead: Length = Field(2e-3, gt=0, description="Travel of the nut per turn of the screw")
    steps_per_turn: int = Field(3200, ge=1, description="Microsteps per turn of the motor")
    thrust: Force = Field(120.0, gt=0, description="Force at which the motor loses steps, slowly")
    top_speed: Speed = Field(
        20e-3, gt=0, description="Speed at which it loses steps without any load"
    )
    home: int = Field(0, ge=0, description="Steps with the plunger at its start")
    travel: tuple[int, int] = Field((0, 160_000), description="Lowest and highest steps")
    push: Literal["up", "down"] = Field("up", description="Direction in which steps push in")

    @model_validator(mode="after")
    def _check_travel(self) -> StepperPumpSpec:
        low, high = self.travel
        if not low <= self.home <= high:
            raise invalid_at("home", f"must be within travel, {low} to {high}; got {self.home}")
        if low == high:
            raise invalid_at("travel", f"must have two different ends; got [{low}, {high}]")
        return self
