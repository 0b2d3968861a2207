"""A cache of things that take long to make, shared by all threads."""

from __future__ import annotations

import os
import sys
import threading
from collections import OrderedDict
from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager
from typing import Generic, TypeVar

Made = TypeVar("Made")

ONE_AT_A_TIME = threading.RLock()
"""Held while formulas or their machine code are made; CasADi releases Python's own lock meanwhile.

One lock for all, since making one thing needs others: of several locks, two threads could each hold
one and wait for the other's.
"""
if sys.platform != "win32":
    # A process that is forked has none of the other threads, one of which might hold the lock.
    os.register_at_fork(
        before=ONE_AT_A_TIME.acquire,
        after_in_parent=ONE_AT_A_TIME.release,
        after_in_child=ONE_AT_A_TIME.release,
    )


class LruCache(Generic[Made]):
    """Results by key; beyond ``most``, the least recently used one is dropped.

    Cached results are shared between threads, hence must be stateless. Stateful ones are lent.
    """

    def __init__(self, most: int) -> None:
        self.most = most
        self._kept: OrderedDict[Hashable, Made] = OrderedDict()
        self._lendable: OrderedDict[Hashable, list[Made]] = OrderedDict()

    def get(self, key: Hashable, make: Callable[[], Made]) -> Made:
        """The result for this key, made if missing, by one thread at a time."""
        with ONE_AT_A_TIME:
            if key not in self._kept:
                return self.keep(key, make())
            self._kept.move_to_end(key)
            return self._kept[key]

    def found(self, key: Hashable) -> Made | None:
        """The result for this key; None if it is missing."""
        with ONE_AT_A_TIME:
            if key in self._kept:
                self._kept.move_to_end(key)
            return self._kept.get(key)

    def keep(self, key: Hashable, made: Made) -> Made:
        """Keep a result, and return it."""
        with ONE_AT_A_TIME:
            self._kept[key] = made
            self._kept.move_to_end(key)
            if len(self._kept) > self.most:
                self._kept.popitem(last=False)
            return made

    @contextmanager
    def lend(self, key: Hashable, make: Callable[[], Made]) -> Iterator[Made]:
        """A result for this key, used exclusively inside the context and lent again afterwards.

        One that raised inside is discarded, since its state is unknown.
        """
        with ONE_AT_A_TIME:
            free = self._lendable.pop(key, [])
            thing = free.pop() if free else make()
            if free:
                self._lendable[key] = free
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
