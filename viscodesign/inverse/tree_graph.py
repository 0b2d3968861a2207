"""Networks without junctions: every bellow hangs on the inlet or on another bellow."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.graph import Graph, straight_order
from viscodesign.scene.scene import Scene

INLET = -1
"""The parent of a bellow that the inlet feeds."""


@dataclass(frozen=True)
class TreeGraph:
    """A tree over the bellows, counted R1..RS, L1..LS from 0.

    Tubes are numbered by the order in which the tree is walked from the inlet.
    """

    parents: tuple[tuple[int, int], ...]
    """Ends of every tube: the bellow at its far end, and the node that feeds it."""

    @property
    def edges(self) -> list[tuple[int, int]]:
        """Near and far end of every tube."""
        return [(near, far) for far, near in self.parents]

    @property
    def key(self) -> frozenset[tuple[int, int]]:
        """Equal for equal trees."""
        return frozenset(self.parents)

    def words(self, sections: int) -> str:
        """Its tubes in short: of a chain its bellows in order."""
        names = [name_of(far, sections) for far, _ in self.parents]
        if self.is_chain:
            return "-".join(["inlet", *names])
        ends = [(name_of(near, sections), name_of(far, sections)) for near, far in self.edges]
        return " ".join(f"{near}-{far}" for near, far in ends)

    @property
    def is_chain(self) -> bool:
        """Whether no node feeds two."""
        feeders = [near for _, near in self.parents]
        return len(set(feeders)) == len(feeders)


def chain(order: Sequence[int]) -> TreeGraph:
    """The chain from the inlet through bellows in this order."""
    return TreeGraph(tuple(zip(order, [INLET, *order[:-1]], strict=True)))


def tree(parent: Sequence[int]) -> TreeGraph:
    """The tree with this parent of every bellow, its tubes by depth first."""
    below: dict[int, list[int]] = {}
    for bellow, near in enumerate(parent):
        below.setdefault(near, []).append(bellow)
    walked, pending = [], [INLET]
    while pending:
        here = pending.pop()
        own = sorted(below.get(here, []), reverse=True)
        pending += own
        if here != INLET:
            walked.append((here, parent[here]))
    return TreeGraph(tuple(walked))


def name_of(node: int, sections: int) -> str:
    """A node's name in a spec of one inlet."""
    if node == INLET:
        return "inlet"
    return f"R{node + 1}" if node < sections else f"L{node - sections + 1}"


def tree_of(graph: Graph) -> TreeGraph | None:
    """The tree that a graph is; None where it has junctions, loops or several inlets."""
    if len(graph.inlets) != 1 or graph.junctions or len(graph.tubes) != len(graph.bellows):
        return None
    place = {name: k for k, name in enumerate(graph.bellows)} | {graph.inlets[0]: INLET}
    parents: dict[int, int] = {}
    order, pending = [], [INLET]
    while pending:
        here = pending.pop(0)
        for tube in graph.tubes:
            ends = [place[tube.start], place[tube.end]]
            other = ends[1 - ends.index(here)] if here in ends else INLET
            if other != INLET and other not in parents and parents.get(here) != other:
                parents[other] = here
                order.append(other)
                pending.append(other)
    if len(order) != len(graph.bellows):
        return None
    return TreeGraph(tuple((own, parents[own]) for own in order))


def straight(sections: int) -> TreeGraph:
    """The straight chain."""
    names = [name_of(k, sections) for k in range(2 * sections)]
    return chain([names.index(name) for name in straight_order(sections)])


def mirrored(own: TreeGraph, sections: int) -> TreeGraph:
    """The same with the columns swapped."""

    def swapped(node: int) -> int:
        return node if node == INLET else (node + sections) % (2 * sections)

    return TreeGraph(tuple((swapped(far), swapped(near)) for far, near in own.parents))


def with_tree(scene: Scene, own: TreeGraph, sizes: Sequence[tuple[float, float]]) -> Scene:
    """The scene with this network; ``sizes``: length and radius of every tube [m]."""
    sections = scene.bellows.count // 2
    inlet = next(iter(scene.inputs))
    shared_length, shared_radius = scene.network.tube_length, scene.network.tube_radius
    tubes = []
    for (near, far), (length, radius) in zip(own.edges, sizes, strict=True):
        ends = [inlet if node == INLET else name_of(node, sections) for node in (near, far)]
        tube: dict[str, Any] = {"from": ends[0], "to": ends[1]}
        if length != shared_length:
            tube["length"] = length
        if radius != shared_radius:
            tube["radius"] = radius
        tubes.append(tube)
    network = scene.network.model_dump()
    network = {k: v for k, v in network.items() if k not in ("layout", "changes", "tubes")}
    found: Scene = scene.replace({"network": {**network, "layout": "custom", "tubes": tubes}})
    return found


def sizes_of(scene: Scene, count: int) -> list[tuple[float, float]]:
    """Length and radius of so many tubes: those of the scene in order, the last one again."""
    feeding = scene.network.feed_line is not None
    own = [(t.length, t.radius) for t in scene.graph.tubes[1 if feeding else 0 :]]
    return [own[min(k, len(own) - 1)] for k in range(count)]
