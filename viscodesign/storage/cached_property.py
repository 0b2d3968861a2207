"""A property computed once per object, without a lock: `functools.cached_property` of Python 3.12.

Before 3.12 one lock of a property serves all objects of its class. A thread that computes the
property of one object then waits for another that computes that of a second object, and both wait
for ever where the second needs a lock that the first one holds. Two threads that ask for the
property of the same object at once may both compute it; either result is kept.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING or sys.version_info >= (3, 12):
    from functools import cached_property
else:
    import functools

    class cached_property(functools.cached_property):  # noqa: N801
        """`cached_property` of Python 3.12, for 3.11."""

        def __get__(self, instance: Any, owner: Any = None) -> Any:
            if instance is None:
                return self
            kept = instance.__dict__
            if self.attrname not in kept:
                kept[self.attrname] = self.func(instance)
            return kept[self.attrname]


__all__ = ["cached_property"]
