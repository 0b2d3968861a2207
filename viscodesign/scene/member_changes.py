"""Changes of single members: sections or bellows that have numbers of their own.

A mapping holds them by keys each of which names some members; what no key names is as usual.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from viscodesign.scene.spec_part import KeyFault, SpecPart

Changes = Mapping[str, SpecPart]
MembersOf = Callable[[str], Sequence[str]]
"""The members that a key names."""


def values_by_member(
    changes: Changes, members_of: MembersOf, members: Sequence[str], name: str, usual: Any
) -> dict[str, Any] | None:
    """What every member has under a key of the spec; None where no change names it."""
    changed = {key: getattr(own, name) for key, own in changes.items()}
    if all(value is None for value in changed.values()):
        return None
    values = dict.fromkeys(members, usual)
    for key, value in changed.items():
        values |= dict.fromkeys(members_of(key) if value is not None else (), value)
    return values


def numbers_of(values: Mapping[str, Any] | None, usual: Any) -> Any:
    """An array of all members' values, or the usual one for all."""
    return usual if values is None else np.array(list(values.values()))


def clashes(changes: Changes, members_of: MembersOf, words: str = "") -> Iterator[KeyFault]:
    """Members that two changes give different values under the same key; ``words``: before each."""
    seen: dict[tuple[str, str], tuple[str, Any]] = {}
    for key, own in changes.items():
        for name in _given(own):
            for member in members_of(key):
                value = getattr(own, name)
                other, former = seen.setdefault((member, name), (key, value))
                if former != value:
                    message = f"'{other}' gives {words}{member} another value"
                    yield KeyFault((key, name), f"{message}; let one of the two name it")
                    break


def _given(change: SpecPart) -> list[str]:
    return [name for name in type(change).model_fields if getattr(change, name) is not None]
