"""Parts of a spec that are given once, or for each inlet by its name."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, TypeVar

from pydantic import BaseModel, Discriminator, Field, Tag

ONE, EACH = "<one>", "<each>"
"""What pydantic puts between the keys of a fault; no inlet is called so."""
Given = TypeVar("Given")


def is_by_inlet(given: Any) -> bool:
    """Whether it is a mapping by inlets: one part has numbers and words for its values."""
    return isinstance(given, Mapping) and any(
        isinstance(value, Mapping | BaseModel) for value in given.values()
    )


ByInlet = Annotated[
    Annotated[Given, Tag(ONE)] | Annotated[dict[str, Given], Field(min_length=1), Tag(EACH)],
    Discriminator(lambda given: EACH if is_by_inlet(given) else ONE),
]
"""One part, for the first of several inlets or the only one; or one for each inlet."""


def named(given: Any) -> dict[str, Any]:
    """By the inlets' names; one that is given without has the name ''."""
    return dict(given) if isinstance(given, Mapping) else {"": given}


def each(given: Given | Mapping[str, Given] | None, count: int) -> tuple[Given | None, ...]:
    """One for each of so many inlets, in their order; None where an inlet has none.

    Mappings have to be in the order of the inlets, as those of a scene's pump are.
    """
    values = tuple(given.values()) if isinstance(given, Mapping) else (given,)
    return (*values, *(None,) * (count - len(values)))


def in_order(given: Any, inlets: tuple[str, ...]) -> Any:
    """The same with a mapping in the order of the inlets; names that are none come last."""
    if not isinstance(given, Mapping):
        return given
    known = {name: given[name] for name in inlets if name in given}
    return {**known, **{name: value for name, value in given.items() if name not in known}}
