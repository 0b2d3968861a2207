"""The network as a graph: inlets, bellows and junctions connected by tubes."""

from __future__ import annotations

from collections import Counter
from dataclasses import field

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.scene_number import SCENE_NUMBER
from viscodesign.storage.cached_property import cached_property


@dataclass(frozen=True)
class Tube:
    """A slender tube between two nodes; lengths in m."""

    name: str
    start: str
    end: str
    length: float = field(metadata=SCENE_NUMBER)
    radius: float = field(metadata=SCENE_NUMBER)


@dataclass(frozen=True)
class Component:
    """A connected part of the network."""

    inlets: tuple[str, ...]
    bellows: tuple[str, ...]
    junctions: tuple[str, ...]
    tubes: tuple[Tube, ...]

    @property
    def nodes(self) -> tuple[str, ...]:
        """All of its nodes: bellows, junctions, inlets."""
        return (*self.bellows, *self.junctions, *self.inlets)

    @property
    def fed(self) -> bool:
        """Whether it has an inlet; if not, it is sealed."""
        return bool(self.inlets)


@dataclass(frozen=True)
class Graph:
    """Nodes and tubes. Bellows are R1..RS, then L1..LS, section 1 at the clamp."""

    sections: int
    inlets: tuple[str, ...]
    bellows: tuple[str, ...]
    junctions: tuple[str, ...]
    tubes: tuple[Tube, ...]

    @property
    def nodes(self) -> tuple[str, ...]:
        """All nodes: inlets, bellows, junctions."""
        return (*self.inlets, *self.bellows, *self.junctions)

    @cached_property
    def tubes_at(self) -> dict[str, list[Tube]]:
        """The tubes that end at each node, in their order."""
        at: dict[str, list[Tube]] = {node: [] for node in self.nodes}
        for tube in self.tubes:
            at[tube.start].append(tube)
            at[tube.end].append(tube)
        return at

    def bellows_along_tubes(self) -> tuple[str, ...]:
        """All bellows, in the order in which the tubes reach them.

        In this order the unknowns do not depend on which column is called right: swapping
        the columns of a scene mirrors its motion to the last digit.
        """
        own = set(self.bellows)
        reached = (end for tube in self.tubes for end in (tube.start, tube.end) if end in own)
        return tuple(dict.fromkeys((*reached, *self.bellows)))

    def components(self) -> list[Component]:
        """Connected parts, in the order of their first node."""
        roots = self._roots()
        groups: dict[str, list[str]] = {}
        for node in self.nodes:
            groups.setdefault(roots[node], []).append(node)
        tubes: dict[str, list[Tube]] = {root: [] for root in groups}
        for tube in self.tubes:
            tubes[roots[tube.start]].append(tube)
        return [self._component(members, tubes[root]) for root, members in groups.items()]

    def _component(self, members: list[str], tubes: list[Tube]) -> Component:
        own = set(members)
        return Component(
            tuple(n for n in self.inlets if n in own),
            tuple(n for n in self.bellows if n in own),
            tuple(n for n in self.junctions if n in own),
            tuple(tubes),
        )

    def _roots(self) -> dict[str, str]:
        """A representative of every node's component, by union-find.

        `scipy.sparse.csgraph` would give the same, but its import takes longer than reading a
        spec does, which needs the components.
        """
        parent = {node: node for node in self.nodes}

        def find(node: str) -> str:
            while parent[node] != node:
                parent[node] = parent[parent[node]]
                node = parent[node]
            return node

        for tube in self.tubes:
            parent[find(tube.start)] = find(tube.end)
        return {node: find(node) for node in self.nodes}

    def remarks(self) -> list[str]:
        """Legal but noteworthy: dead ends, parallel tubes, bellows without a tube."""
        degree = Counter(end for tube in self.tubes for end in (tube.start, tube.end))
        pairs = Counter(frozenset((tube.start, tube.end)) for tube in self.tubes)
        remarks = [
            f"{name} has no tube: a sealed bellow" for name in self.bellows if not degree[name]
        ]
        remarks += [
            f"junction {name} joins only one tube: nothing flows through it"
            for name in self.junctions
            if degree[name] == 1
        ]
        remarks += [
            f"{count} parallel tubes join {' and '.join(sorted(pair))}: their conductances add"
            for pair, count in pairs.items()
            if count > 1
        ]
        return remarks


def bellow_names(sections: int) -> tuple[str, ...]:
    """R1..RS, then L1..LS."""
    numbers = range(1, sections + 1)
    return (*(f"R{j}" for j in numbers), *(f"L{j}" for j in numbers))


def straight_order(sections: int) -> list[str]:
    """Chain of the straight layout: down the right column, up the left."""
    down = [f"R{j}" for j in range(1, sections + 1)]
    return down + [f"L{j}" for j in range(sections, 0, -1)]


def crossed_order(sections: int) -> list[str]:
    """Chain of the crossed layout: the columns swap at mid-length, down and up."""
    half = sections // 2
    upper, lower = range(1, half + 1), range(half + 1, sections + 1)
    return (
        [f"R{j}" for j in upper]
        + [f"L{j}" for j in lower]
        + [f"R{j}" for j in reversed(lower)]
        + [f"L{j}" for j in reversed(upper)]
    )
