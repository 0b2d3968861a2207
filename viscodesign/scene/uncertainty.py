"""`uncertainty:` how well the numbers of a spec are known."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Literal

from pydantic import Field, model_serializer, model_validator

from viscodesign.errors import described, not_among
from viscodesign.scene.spec_part import KeyFault, KeyPath, SpecPart, invalid, raise_faults

TYPICAL: Literal["typical"] = "typical"
NONE: Literal["none"] = "none"
OTHERS = "others"
ALLOWED = "a standard deviation, such as 5 % or 0.01 mm, or a range [low, high]"
FORM = f"write {ALLOWED}"

Spread = str | tuple[str | float, str | float]
"""A standard deviation as text, or both ends of a range."""


class Uncertainty(SpecPart):
    """Standard deviations or ranges of numbers by their keys, and whether others are as usual."""

    spreads: dict[str, Spread] = Field(
        default_factory=dict,
        description="Of the number with this key: one standard deviation, or [low, high]",
    )
    others: Literal["typical", "none"] = Field(
        NONE, description="Of all other coefficients: as is typical, or none"
    )

    @model_validator(mode="before")
    @classmethod
    def _normalize(cls, given: Any) -> Any:
        if isinstance(given, Uncertainty):
            return given
        if given == TYPICAL:
            return {"spreads": {}, "others": TYPICAL}
        if given in (NONE, "off") or given is False:
            return {"spreads": {}, "others": NONE}
        if not isinstance(given, dict):
            choices = f"{TYPICAL}, {NONE} or a mapping of key: 5 %"
            raise invalid(f"must be {choices}; got {described(given)}")
        written = list(_flat(given, ()))
        raise_faults(_faults(written))
        flat = {".".join(path): own for path, own in written}
        others = flat.pop(OTHERS, NONE)
        return {"spreads": {key: _spread(own) for key, own in flat.items()}, "others": others}

    def _keys_with(self, fields: Mapping[str, Any]) -> dict[str, Any]:
        spreads, others = fields.get("spreads", self.spreads), fields.get(OTHERS, self.others)
        return {**spreads, OTHERS: others}

    @model_serializer
    def as_in_a_spec(self) -> dict[str, Any]:
        """The keys and what is said of them."""
        others = {} if self.others == NONE else {OTHERS: self.others}
        return {**{k: list(v) if isinstance(v, tuple) else v for k, v in self.spreads.items()},
                **others}  # fmt: skip


def _flat(given: Mapping[Any, Any], path: KeyPath) -> Iterator[tuple[KeyPath, Any]]:
    """What is given by keys as they are written, dotted or nested."""
    for key, own in given.items():
        place = (*path, str(key))
        if isinstance(own, dict):
            yield from _flat(own, place)
        else:
            yield place, own


def _spread(given: Any) -> Spread:
    return tuple(given) if isinstance(given, list) else given


def _faults(written: Iterable[tuple[KeyPath, Any]]) -> Iterator[KeyFault]:
    for path, own in written:
        if path == (OTHERS,):
            if own not in (TYPICAL, NONE):
                yield KeyFault(path, not_among(own, (TYPICAL, NONE)), f"{TYPICAL} or {NONE}")
        elif isinstance(own, (list, tuple)):
            if len(own) != 2 or not all(_is_value(end) for end in own):
                message = f"a range has two ends, [low, high]; got {described(own)}"
                yield KeyFault(path, message, ALLOWED)
        elif not isinstance(own, str):
            yield KeyFault(path, f"{FORM}; got {described(own)}", ALLOWED)


def _is_value(given: Any) -> bool:
    return isinstance(given, (str, float, int)) and not isinstance(given, bool)
