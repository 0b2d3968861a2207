"""`effects:` which effects a scene includes, excludes or leaves to automatic selection."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Literal

from pydantic import Field, ValidationInfo, model_serializer, model_validator

from viscodesign.errors import did_you_mean, not_among
from viscodesign.scene.spec_part import KeyFault, SpecPart, invalid, raise_faults, switch

Mode = Literal["auto", "on", "off"]
MODES = ("auto", "on", "off")
OTHERS = "others"


class EffectsChoice(SpecPart):
    """A mode for each named effect, and one for all others."""

    modes: dict[str, Mode] = Field(default_factory=dict, description="Mode of each named effect")
    others: Mode = Field("auto", description="Mode of all other effects")

    @model_validator(mode="before")
    @classmethod
    def _normalize(cls, given: Any, info: ValidationInfo) -> Any:
        if isinstance(given, EffectsChoice):
            return given
        if not isinstance(given, dict):
            if (mode := _mode(given)) is None:
                raise invalid(not_among(given, MODES, "a mapping of effect: mode"))
            return {"modes": {}, "others": mode}
        raise_faults(_faults(given, info.context or {}))
        modes = {str(k): _mode(v) for k, v in given.items()}
        return {"others": modes.pop(OTHERS, "auto"), "modes": modes}

    def mode(self, name: str) -> Mode:
        """The mode of an effect."""
        return self.modes.get(name, self.others)

    def _keys_with(self, fields: Mapping[str, Any]) -> dict[str, Any]:
        modes, others = fields.get("modes", self.modes), fields.get("others", self.others)
        return {**modes, OTHERS: others}

    @model_serializer
    def _as_in_a_spec(self) -> dict[str, str]:
        return {**self.modes, OTHERS: self.others}


def _mode(given: Any) -> str | None:
    """The mode that a YAML value means, or None."""
    words = {True: "on", False: "off", "auto": "auto"}
    given = switch(given)
    return words.get(given) if isinstance(given, (bool, str)) else None


def _faults(given: dict[Any, Any], context: dict[str, Any]) -> Iterator[KeyFault]:
    """Unknown names and modes; names are checked only if the known ones are in the context."""
    known = context.get("effect_names")
    for name, value in given.items():
        mode, path = _mode(value), (str(name),)
        if known is not None and name not in (*known, OTHERS):
            allowed = f"one of the effects {', '.join(known)}"
            yield KeyFault(path, f"no such effect{did_you_mean(name, known)}", allowed)
        elif mode is None:
            yield KeyFault(path, not_among(value, MODES), f"one of {', '.join(MODES)}")
