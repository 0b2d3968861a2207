"""Unknowns in blocks, each divided by its size."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field, replace

import casadi as ca
import numpy as np

from viscodesign.lazy_dataclass import dataclass

SX = ca.SX


@dataclass(frozen=True)
class Sizes:
    """Typical sizes by which unknowns are divided."""

    pressure: float
    """[Pa]"""
    time: float
    """Time scale of the rod's motion [s]."""
    swing: float
    """Time in which the inlets may change by all of the pressure [s]."""


@dataclass(frozen=True)
class SizeSymbols:
    """The same as parameters of a system."""

    pressure: SX
    time: SX
    swing: SX


@dataclass(frozen=True)
class Traits:
    """What a solver knows of a block, whatever the block means."""

    identifies_branch: bool = False
    """Whether its values tell one equilibrium of the same equations from another."""
    integrations: float = 0.0
    """How many times it is integrated on the way to a shape: within a step h, its error counts
    by that power of h. Infinite where its error need not be tested at all."""
    is_internal: bool = False
    """Whether it follows from the unknowns that identify a branch, by equations of its own."""
    is_noisy: bool = False
    """Whether error tests of algebraic unknowns should leave it out."""
    follows_from_states: bool = False
    """Whether its equation has the states and itself alone, and no other algebraic one has it."""
    of_rod: bool = False
    """Whether it belongs to the rod; all others are settled first, with the rod held."""
    is_pressure: bool = False
    """Whether it starts at the baseline pressure."""
    is_multivalued: bool = False
    """Whether its equations may have several solutions, of which the nearest counts."""
    is_amount: bool = False
    """Whether it is an amount of fluid beyond that at rest, in the order of the nodes."""
    is_integral: bool = False
    """Whether nothing depends on it: it only adds up what has passed."""


NO_TRAITS = Traits()


@dataclass(frozen=True)
class Block:
    """Consecutive unknowns of one kind; one size for all, or one for each (count,)."""

    name: str
    start: int
    count: int
    size: float | np.ndarray
    traits: Traits = NO_TRAITS

    @property
    def span(self) -> slice:
        """Where the block stands in its vector."""
        return slice(self.start, self.start + self.count)


@dataclass
class Unknowns:
    """A vector of scaled unknowns, made of blocks."""

    blocks: dict[str, Block] = field(default_factory=dict)

    def sized(self, sizes: Sequence[np.ndarray]) -> Unknowns:
        """The same with numbers for the blocks' sizes, in the order of `sizes`."""
        blocks = {
            name: replace(block, size=float(size[0]) if size.size == 1 else size)
            for (name, block), size in zip(self.blocks.items(), sizes, strict=True)
        }
        return replace(self, blocks=blocks)

    @property
    def count(self) -> int:
        """Number of unknowns."""
        return sum(block.count for block in self.blocks.values())

    @property
    def branch_span(self) -> slice | None:
        """Unknowns that tell one equilibrium from another, side by side; None without any."""
        own = [b.span for b in self.blocks.values() if b.traits.identifies_branch]
        return slice(own[0].start, own[-1].stop) if own else None

    @property
    def multivalued(self) -> list[int]:
        """Unknowns whose equations may have several solutions."""
        own = (b.span for b in self.blocks.values() if b.traits.is_multivalued)
        return [k for span in own for k in range(span.start, span.stop)]

    def physical(self, name: str, scaled: np.ndarray) -> np.ndarray:
        """Values in SI of one block out of a scaled vector or (count, T) matrix."""
        block = self.blocks[name]
        part = np.asarray(scaled)[block.span]
        size = np.asarray(block.size)
        return np.asarray(part * (size[:, None] if size.ndim and part.ndim > 1 else size))


@dataclass
class SymbolicUnknowns(Unknowns):
    """The same with symbols."""

    scaled: list[SX] = field(default_factory=list)
    symbols: list[SX] = field(default_factory=list)
    values: list[SX] = field(default_factory=list)
    sizes: list[SX] = field(default_factory=list)

    def add(self, name: str, symbol: SX, size: SX, traits: Traits = NO_TRAITS) -> None:
        """Let ``symbol`` be ``size`` times a new scaled unknown; nothing for an empty symbol.

        ``size``: one for all or one for each, a formula of the system's parameters.
        """
        flat = ca.vec(symbol)
        if not flat.numel():
            return
        scaled = SX.sym(f"{name}_scaled", flat.numel())
        self.blocks[name] = Block(name, self.count, flat.numel(), np.nan, traits)
        self.scaled.append(scaled)
        self.symbols.append(flat)
        self.values.append(size * scaled)
        self.sizes.append(SX(size))

    @property
    def vector(self) -> SX:
        """All scaled unknowns as one column."""
        return ca.vertcat(*self.scaled) if self.scaled else SX(0, 1)

    def without_symbols(self) -> Unknowns:
        """The blocks alone."""
        return Unknowns(self.blocks)


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
