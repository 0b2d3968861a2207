"""`effects:` which effects a scene asks for, forbids, or leaves to its numbers."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

from pydantic import Field, ValidationInfo, model_validator

from viscodesign.scene.section import Complaint, Part, did_you_mean, refuse, refuse_any, switch

Mode = Literal["auto", "on", "off"]
MODES = ("auto", "on", "off")
OTHERS = "others"


class EffectsChoice(Part):
    """A mode for each named effect, and one for all others."""

    modes: dict[str, Mode] = Field(default_factory=dict)
    others: Mode = "auto"

    @model_validator(mode="before")
    @classmethod
    def _spread(cls, given: Any, info: ValidationInfo) -> Any:
        if isinstance(given, EffectsChoice):
            return given
        if not isinstance(given, dict):
            if (mode := _mode(given)) is None:
                raise refuse(
                    f"{given!r} is given; allowed are auto, or a mapping effect: auto|on|off"
                    f"{_hint(given)}"
                )
            return {"modes": {}, "others": mode}
        refuse_any(_complaints(given, info.context or {}))
        modes = {str(k): _mode(v) for k, v in given.items()}
        return {"others": modes.pop(OTHERS, "auto"), "modes": modes}

    def mode(self, name: str) -> Mode:
        """What the scene says of an effect."""
        return self.modes.get(name, self.others)


def _mode(given: Any) -> str | None:
    """The mode that a YAML value stands for, or None."""
    words = {True: "on", False: "off", "auto": "auto"}
    given = switch(given)
    return words.get(given) if isinstance(given, (bool, str)) else None


def _hint(given: Any) -> str:
    return did_you_mean(given, MODES) if isinstance(given, str) else ""


def _complaints(given: dict[Any, Any], context: dict[str, Any]) -> Iterator[Complaint]:
    """Unknown names and modes; names are judged where the caller said which there are."""
    known = context.get("effect_names")
    for name, value in given.items():
        mode, path = _mode(value), (str(name),)
        if known is not None and name not in (*known, OTHERS):
            yield Complaint(path, f"no such effect{did_you_mean(str(name), known)}")
        elif mode is None:
            yield Complaint(path, f"{value!r} is given; allowed are auto, on and off{_hint(value)}")
