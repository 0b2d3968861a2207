"""`effects:` which effects a scene asks for, forbids, or leaves to its numbers."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field, ValidationInfo, field_validator, model_validator

from viscodesign.scene.base import Part, did_you_mean, refuse, refuse_at

Mode = Literal["auto", "on", "off"]
OTHERS = "others"


class EffectsChoice(Part):
    """A mode for each named effect, and one for all others."""

    modes: dict[str, Mode] = Field(default_factory=dict)
    others: Mode = "auto"

    @model_validator(mode="before")
    @classmethod
    def _spread(cls, given: Any) -> Any:
        if isinstance(given, EffectsChoice):
            return given
        if given in ("auto", "on", "off"):
            return {"modes": {}, "others": given}
        if not isinstance(given, dict):
            raise refuse(f"{given!r} is given; allowed are auto, or a mapping effect: auto|on|off")
        modes = {str(k): _mode(str(k), v) for k, v in given.items()}
        return {"others": modes.pop(OTHERS, "auto"), "modes": modes}

    @field_validator("modes")
    @classmethod
    def _known(cls, modes: dict[str, Mode], info: ValidationInfo) -> dict[str, Mode]:
        context = info.context or {}
        known = context.get("effect_names")
        if known is None:
            return modes
        reserved = context.get("reserved_effect_names", ())
        for name, mode in modes.items():
            if name in known or (name in reserved and mode == "off"):
                continue
            if name in reserved:
                raise refuse_at(name, f"'{mode}' is given, but this version can only leave it off")
            raise refuse_at(name, f"no such effect{did_you_mean(name, (*known, *reserved))}")
        return modes

    def mode(self, name: str) -> Mode:
        """What the scene says of an effect."""
        return self.modes.get(name, self.others)


def _mode(name: str, given: Any) -> str:
    words = {True: "on", False: "off"}
    word = words.get(given, given) if isinstance(given, bool) else given
    if word not in ("auto", "on", "off"):
        raise refuse_at(name, f"{given!r} is given; allowed are auto, on and off")
    return str(word)
