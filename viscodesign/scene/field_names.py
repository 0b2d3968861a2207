"""Names that the fields of a part of a spec may have."""

from __future__ import annotations

import inspect

from pydantic import BaseModel

from viscodesign.errors import UsageError


def refuse_shadowing(part: type[BaseModel]) -> None:
    """Raise `UsageError` where a new field has the name of an attribute that a base class has.

    The attribute would be taken for the default of the field, and the field for the attribute.
    """
    for name, annotation in inspect.get_annotations(part).items():
        if name.startswith("_") or "ClassVar" in str(annotation):
            continue
        if owner := _owner(part, name):
            raise UsageError(
                f"{part.__module__}: {part.__name__}.{name}: a field cannot have the name of "
                f"an attribute of {owner.__name__}; give it another name and '{name}' as its "
                f"key, such as own_{name}: ... = Field(alias={name!r})"
            )


def _owner(part: type, name: str) -> type | None:
    """The base class that has an attribute of this name which is not a field."""
    for base in part.__mro__[1:]:
        if name in getattr(base, "__pydantic_fields__", {}):
            return None
        if name in vars(base) or "ClassVar" in str(inspect.get_annotations(base).get(name, "")):
            return base
    return None
