"""The arrays of a motion, by quantity."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import replace
from typing import Self

import numpy as np

from viscodesign.errors import ViscodesignError, did_you_mean
from viscodesign.lazy_dataclass import dataclass


class AbsentQuantityError(ViscodesignError, KeyError):
    """A quantity that a motion has no array of."""

    exit_code = 2

    def __init__(self, quantity: str, known: list[str]) -> None:
        hint = did_you_mean(quantity, known) or "."
        super().__init__(
            f"this run has no '{quantity}'{hint} It has "
            f"{', '.join(known)}. One that was read from its folder has what its files have; "
            "simulate its spec again for the others"
        )

    def __str__(self) -> str:
        return str(self.args[0])  # that of a KeyError would be in quotes


class QuantityArrays(ABC):
    """Arrays of a motion by quantity; those that are asked for most are attributes.

    T output times, B bellows, Q tubes; SI, pressures gauge. What every array holds says the table
    in `results.channels`.
    """

    @abstractmethod
    def __getitem__(self, quantity: str) -> np.ndarray:
        """An array (T, ...)."""

    @property
    def time(self) -> np.ndarray:
        """(T,) [s]."""
        return self["time"]

    @property
    def tip(self) -> np.ndarray:
        """(T, 3): x [m], z [m], angle from +z [rad], never wrapped; of several rods in a row."""
        return self["tip"]

    @property
    def pressure(self) -> np.ndarray:
        """(T, B) gauge [Pa]."""
        return self["pressure"]

    @property
    def volume(self) -> np.ndarray:
        """(T, B) [m3]."""
        return self["volume"]

    @property
    def flow(self) -> np.ndarray:
        """(T, Q) [m3/s], positive from the tube's first end to its second."""
        return self["flow"]


@dataclass(frozen=True, kw_only=True, eq=False)
class MotionArrays(QuantityArrays):
    """The arrays of a whole motion, with K points of the axis."""

    arrays: Mapping[str, np.ndarray]
    """Quantity -> (T, ...); ``shape`` has N of these times only."""
    arc: np.ndarray
    """(K,) reference arc length of the shape's points [m], from the clamp."""
    shape_every: int = 1
    """Rows from one shape to the next."""

    def __getitem__(self, quantity: str) -> np.ndarray:
        try:
            return self.arrays[quantity]
        except KeyError:
            raise AbsentQuantityError(quantity, list(self.arrays)) from None

    def with_arrays(self, **arrays: np.ndarray) -> Self:
        """The same with some quantities replaced or added."""
        return replace(self, arrays={**self.arrays, **arrays})

    def tips(self, rows: slice) -> np.ndarray:
        """x and z of every rod's tip (T, rods, 2) [m] at some of the times."""
        return np.asarray(self.tip[rows].reshape(len(self.tip[rows]), -1, 3)[..., :2])

    @property
    def shape(self) -> np.ndarray:
        """(N, K, 2): x, z of the axis [m], at the rows of `shape_rows`."""
        return self["shape"]

    @property
    def shape_rows(self) -> np.ndarray:
        """Which rows (N,) of ``time`` have a shape: every ``shape_every``-th, and the last."""
        last = len(self.time) - 1
        rows = np.arange(0, last + 1, self.shape_every)
        return rows if last % self.shape_every == 0 or last < 0 else np.append(rows, last)
