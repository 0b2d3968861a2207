"""Parts of a spec that are given once, or per inlet by its name."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, TypeVar

from pydantic import BaseModel, Discriminator, Field, Tag

ONE, EACH = "<one>", "<each>"
"""Union tags that pydantic puts into the location of a fault; no inlet has such a name."""
PartT = TypeVar("PartT")


def is_by_inlet(given: Any) -> bool:
    """Whether a value is a mapping of inlets, whose values are mappings themselves."""
    return isinstance(given, Mapping) and any(
        isinstance(value, Mapping | BaseModel) for value in given.values()
    )


ByInlet = Annotated[
    Annotated[PartT, Tag(ONE)] | Annotated[dict[str, PartT], Field(min_length=1), Tag(EACH)],
    Discriminator(lambda given: EACH if is_by_inlet(given) else ONE),
]
"""One part, for the first or only inlet; or one part per inlet."""


def named(given: Any) -> dict[str, Any]:
    """The parts by inlet name; a single part has the name ''."""
    return dict(given) if isinstance(given, Mapping) else {"": given}


def each(given: PartT | Mapping[str, PartT] | None, count: int) -> tuple[PartT | None, ...]:
    """The parts of ``count`` inlets in their order; None for an inlet without one.

    Mappings must be in the order of the inlets, as those of a scene's pump are.
    """
    values = tuple(given.values()) if isinstance(given, Mapping) else (given,)
    return (*values, *(None,) * (count - len(values)))


def in_order(given: Any, inlets: tuple[str, ...]) -> Any:
    """A mapping sorted in the order of the inlets, unknown names last; a single part as it is."""
    if not isinstance(given, Mapping):
        return given
    known = {name: given[name] for name in inlets if name in given}
    return {**known, **{name: value for name, value in given.items() if name not in known}}
