"""`actuators:` several in one spec, by name; `inputs:` one that is another one, later."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any

from pydantic import Discriminator, Field, Tag, field_validator, model_validator

from viscodesign.errors import did_you_mean
from viscodesign.scene.actuator import Actuator
from viscodesign.scene.bellows import Bellows
from viscodesign.scene.input import AnyInput
from viscodesign.scene.network import Network
from viscodesign.scene.sections import SectionChange
from viscodesign.scene.spec_part import KeyFault, SpecPart, invalid, raise_faults
from viscodesign.units import Time


class ActuatorDesign(SpecPart):
    """One of several actuators: its own body, bellows and network, or those of another one."""

    like: str | None = Field(None, description="Name of the actuator that this one is like")
    actuator: Actuator | None = Field(None, description="The elastomer body")
    section_changes: dict[str, SectionChange] | None = Field(
        None, alias="sections", description="Its sections that differ"
    )
    bellows: Bellows | None = Field(None, description="Its bellows")
    network: Network | None = Field(None, description="The tubes that connect them")

    @field_validator("section_changes", mode="before")
    @classmethod
    def _numbered(cls, given: Any) -> Any:
        return {str(key): own for key, own in given.items()} if isinstance(given, dict) else given

    @model_validator(mode="after")
    def _whole(self) -> ActuatorDesign:
        parts = ("actuator", "bellows", "network")
        given = [name for name in parts if getattr(self, name) is not None]
        others = [*given, *(["sections"] if self.section_changes is not None else [])]
        if self.like is not None and others:
            raise invalid(f"'like' and {others[0]} are both given; give only one of them")
        if self.like is None:
            raise_faults(
                KeyFault((name,), "missing; or give 'like' with the name of another actuator")
                for name in parts
                if name not in given
            )
        return self


def unlike(designs: Mapping[str, ActuatorDesign]) -> Mapping[str, ActuatorDesign]:
    """Every actuator by its own parts. Raises faults for names that lead nowhere."""
    faults: list[KeyFault] = []
    found = {name: _followed(name, designs, faults) for name in designs}
    raise_faults(faults)
    return found


def _followed(
    name: str, designs: Mapping[str, ActuatorDesign], faults: list[KeyFault]
) -> ActuatorDesign:
    """The parts of an actuator that is like another one."""
    own, seen = designs[name], {name}
    while (other := own.like) is not None:
        if other not in designs or other in seen:
            problem = (
                f"no such actuator{did_you_mean(other, designs)}; there are {', '.join(designs)}"
                if other not in designs
                else f"'{other}' is like itself; one of them needs an actuator of its own"
            )
            faults.append(KeyFault((name, "like"), problem))
            return own
        seen.add(other)
        own = designs[other]
    return own


class SameInput(SpecPart):
    """An input that is another one, later."""

    source: str = Field(alias="as", min_length=1, description="Name of the other input")
    delay: Time = Field(0.0, ge=0, description="By how much it is later")


OWN, SAME = "<own>", "<same>"
"""Tags of both forms in the locations of errors."""


def _form(given: Any) -> str:
    is_same = "as" in given if isinstance(given, dict) else isinstance(given, SameInput)
    return SAME if is_same else OWN


OwnOrSameInput: Any = Annotated[
    Annotated[AnyInput, Tag(OWN)] | Annotated[SameInput, Tag(SAME)], Discriminator(_form)
]
"""An input, or `{as: A, delay: ...}`."""


def same_input_faults(inputs: Mapping[str, Any]) -> list[KeyFault]:
    """Inputs that are as one that does not exist, or that is itself as another one."""
    own = [name for name, given in inputs.items() if not isinstance(given, SameInput)]
    return [
        KeyFault(
            ("inputs", name, "as"),
            f"no input '{given.source}' with values of its own{did_you_mean(given.source, own)}; "
            f"there are {', '.join(own) or 'none'}",
        )
        for name, given in inputs.items()
        if isinstance(given, SameInput) and given.source not in own
    ]
