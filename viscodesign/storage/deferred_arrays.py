"""Arrays by name, one of which is made when it is first asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

import numpy as np


class DeferredArrays(Mapping[str, np.ndarray]):
    """Arrays that are known, and one more under ``name``, which ``make`` gives."""

    def __init__(
        self, known: Mapping[str, np.ndarray], name: str, make: Callable[[], np.ndarray]
    ) -> None:
        self._known, self._name, self._make = dict(known), name, make

    def __getitem__(self, name: str) -> np.ndarray:
        if name == self._name and name not in self._known:
            self._known[name] = self._make()
        return self._known[name]

    def __iter__(self) -> Iterator[str]:
        return iter({**dict.fromkeys(self._known), self._name: None})

    def __len__(self) -> int:
        return len(self._known.keys() | {self._name})
