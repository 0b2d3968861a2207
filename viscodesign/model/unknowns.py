"""Unknowns in blocks, each divided by its size."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import casadi as ca
import numpy as np

SX = ca.SX


@dataclass(frozen=True)
class Sizes:
    """Typical sizes by which unknowns are divided."""

    pressure: float
    """[Pa]"""
    time: float
    """Of the rod's motion [s]."""
    swing: float
    """Time in which the inlets may change by all of the pressure [s]."""


@dataclass(frozen=True)
class SizeSymbols:
    """The same as parameters of a system."""

    pressure: SX
    time: SX
    swing: SX


@dataclass(frozen=True)
class Block:
    """A run of unknowns of one kind; one size for all, or one for each (count,)."""

    name: str
    start: int
    count: int
    size: float | np.ndarray

    @property
    def span(self) -> slice:
        """Where the block stands in its vector."""
        return slice(self.start, self.start + self.count)


@dataclass
class Unknowns:
    """A vector of scaled unknowns, made of blocks."""

    hats: list[SX] = field(default_factory=list)
    blocks: dict[str, Block] = field(default_factory=dict)
    symbols: list[SX] = field(default_factory=list)
    values: list[SX] = field(default_factory=list)
    sizes: list[SX] = field(default_factory=list)

    def add(self, name: str, symbol: SX, size: SX) -> None:
        """Let ``symbol`` be ``size`` times a new scaled unknown; nothing for no symbol.

        ``size``: one for all or one for each, a formula of the system's parameters.
        """
        flat = ca.vec(symbol)
        if not flat.numel():
            return
        hat = SX.sym(f"{name}_hat", flat.numel())
        self.blocks[name] = Block(name, self.count, flat.numel(), np.nan)
        self.hats.append(hat)
        self.symbols.append(flat)
        self.values.append(size * hat)
        self.sizes.append(SX(size))

    def sized(self, sizes: Sequence[np.ndarray]) -> Unknowns:
        """The same with numbers for the blocks' sizes, in the order of `sizes`."""
        blocks = {
            name: replace(block, size=float(size[0]) if size.size == 1 else size)
            for (name, block), size in zip(self.blocks.items(), sizes, strict=True)
        }
        return replace(self, blocks=blocks)

    @property
    def vector(self) -> SX:
        """All scaled unknowns as one column."""
        return ca.vertcat(*self.hats) if self.hats else SX(0, 1)

    @property
    def count(self) -> int:
        """Number of unknowns."""
        return sum(block.count for block in self.blocks.values())

    def physical(self, name: str, hats: np.ndarray) -> np.ndarray:
        """Values in SI of one block out of a scaled vector or (count, T) matrix."""
        block = self.blocks[name]
        part = np.asarray(hats)[block.span]
        size = np.asarray(block.size)
        return np.asarray(part * (size[:, None] if size.ndim and part.ndim > 1 else size))


def column(parts: list[SX]) -> SX:
    """Parts below each other; an empty column for none."""
    return ca.vertcat(*parts) if parts else SX(0, 1)


def substitute(expressions: list[SX], pairs: list[tuple[SX, SX]]) -> list[SX]:
    """Replace symbols by values in all expressions, all at once."""
    if not pairs:
        return expressions
    symbols = ca.vertcat(*(ca.vec(symbol) for symbol, _ in pairs))
    values = ca.vertcat(*(ca.vec(value) for _, value in pairs))
    return list(ca.substitute(expressions, [symbols], [values]))
