"""Things that take long to make, kept for the next who asks, in whichever thread."""

from __future__ import annotations

import threading
from collections import OrderedDict
from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager
from typing import Generic, TypeVar

Made = TypeVar("Made")

ONE_AT_A_TIME = threading.RLock()
"""Held while formulas are made: CasADi lets go of Python's own lock meanwhile."""


class LruCache(Generic[Made]):
    """What was made by key; of more than ``most`` the one longest unused is dropped.

    What it holds is shared between threads, hence must have no state. What has one is lent.
    """

    def __init__(self, most: int) -> None:
        self.most = most
        self._kept: OrderedDict[Hashable, Made] = OrderedDict()
        self._lendable: OrderedDict[Hashable, list[Made]] = OrderedDict()

    def get(self, key: Hashable, make: Callable[[], Made]) -> Made:
        """The thing of this key, made if it is not there."""
        with ONE_AT_A_TIME:
            if key not in self._kept:
                self._kept[key] = make()
                if len(self._kept) > self.most:
                    self._kept.popitem(last=False)
            self._kept.move_to_end(key)
            return self._kept[key]

    @contextmanager
    def lend(self, key: Hashable, make: Callable[[], Made]) -> Iterator[Made]:
        """A thing of this key that is nobody else's inside; afterwards it may be lent again.

        What failed inside is not: nobody knows the state that it is in.
        """
        with ONE_AT_A_TIME:
            free = self._lendable.get(key)
            thing = free.pop() if free else make()
        yield thing
        with ONE_AT_A_TIME:
            self._lendable.setdefault(key, []).append(thing)
            self._lendable.move_to_end(key)
            while sum(map(len, self._lendable.values())) > self.most:
                oldest = next(iter(self._lendable))
                self._lendable[oldest].pop(0)
                if not self._lendable[oldest]:
                    del self._lendable[oldest]

    def clear(self) -> None:
        """Forget everything."""
        with ONE_AT_A_TIME:
            self._kept.clear()
            self._lendable.clear()

    def __len__(self) -> int:
        return len(self._kept)
