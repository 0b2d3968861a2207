"""What functions of the free numbers of any spec tell of these numbers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Generic, Protocol, TypeVar

import numpy as np

from viscodesign.compiled.free_number import FreeNumber


class NumberKeys(Protocol):
    """Free numbers of a spec."""

    @property
    def names(self) -> tuple[str, ...]: ...

    @property
    def values(self) -> np.ndarray: ...

    @property
    def numbers(self) -> Sequence[FreeNumber]: ...


Keys = TypeVar("Keys", bound=NumberKeys)


class KeyedFunction(Generic[Keys]):
    """A function of free numbers, made again from its arguments where it was pickled."""

    _keys: Keys
    _made_of: tuple[Any, ...]
    """Arguments, the scene first."""

    def __reduce__(self) -> tuple[Callable[..., Any], tuple[Any, ...]]:
        return type(self), self._made_of

    def __repr__(self) -> str:
        count, name = len(self.names), self._made_of[0].name
        return f"<viscodesign function of {count} number{'s' * (count > 1)} of {name}>"

    @property
    def names(self) -> tuple[str, ...]:
        """Keys of the free numbers, one each, in order."""
        return self._keys.names

    @property
    def values(self) -> np.ndarray:
        """(f,) The spec's own numbers [SI]."""
        return self._keys.values.copy()

    @property
    def units(self) -> tuple[str, ...]:
        """SI units of the free numbers, "1" for a ratio."""
        return tuple(number.unit for number in self._keys.numbers)
