"""`network:` which bellow is joined to which, and by what tube."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from typing import Literal

from pydantic import Field, model_validator

from viscodesign.model.graph import Graph, Tube, bellow_names, crossed_order, straight_order
from viscodesign.scene.network_faults import (
    chain_faults,
    change_faults,
    island_faults,
    node_faults,
)
from viscodesign.scene.section import Complaint, Part, refuse, refuse_any, refuse_at
from viscodesign.units import Fraction, Length, Pressure

MOST_TUBES = 20_000


class TubeChange(Part):
    """What is different about one tube of a named layout."""

    length: Length | None = Field(None, gt=0)
    radius: Length | None = Field(None, gt=0)


class TubeEntry(Part):
    """One tube of a custom layout."""

    start: str = Field(alias="from", min_length=1, description="Node at its first end")
    end: str = Field(alias="to", min_length=1, description="Node at its second end")
    length: Length | None = Field(None, gt=0, description="Else network.tube_length")
    radius: Length | None = Field(None, gt=0, description="Else network.tube_radius")


class TubeWall(Part):
    """The wall of all tubes, where it is soft enough to give way."""

    youngs_modulus: Pressure = Field(gt=0, description="Young's modulus of the tubes")
    thickness: Length = Field(gt=0, description="Thickness of their wall")
    poissons_ratio: Fraction = Field(0.5, ge=0, le=0.5, description="Poisson's ratio")


class FeedLine(Part):
    """One more tube between each inlet and the network: from the pump to the actuator."""

    length: Length = Field(gt=0, description="Length of the line")
    radius: Length = Field(gt=0, description="Inner radius of the line")


class Network(Part):
    """A named chain with single changes, or any graph."""

    layout: Literal["straight", "crossed", "custom"]
    tube_radius: Length | None = Field(None, gt=0, description="Inner radius of the tubes")
    tube_length: Length | None = Field(None, gt=0, description="Length of each tube")
    changes: dict[str, TubeChange] = Field(
        default_factory=dict, description="Single tubes of a named layout, as 'R1-R2'"
    )
    tubes: tuple[TubeEntry, ...] | None = Field(None, description="All tubes of a custom layout")
    feed_line: FeedLine | None = Field(None, description="From the pump to the actuator")
    tube_wall: TubeWall | None = Field(None, description="Soft wall of the tubes")
    entrance_loss: Fraction = Field(
        0.5, ge=0, le=10, description="Loss at a tube's entrance, in dynamic pressures"
    )
    exit_loss: Fraction = Field(
        1.0, ge=0, le=10, description="Loss at a tube's exit, in dynamic pressures"
    )

    @model_validator(mode="after")
    def _layout_has_what_it_needs(self) -> Network:
        refuse_any(self._custom_faults() if self.layout == "custom" else self._chain_faults())
        return self

    def _custom_faults(self) -> Iterator[Complaint]:
        if self.tubes is None:
            yield Complaint(("tubes",), "missing; a custom layout lists its tubes")
        if self.changes:
            yield Complaint(("changes",), "given, but only named layouts have changes")
        if len(self.tubes or ()) > MOST_TUBES:
            count = len(self.tubes or ())
            yield Complaint(("tubes",), f"{count} tubes; at most {MOST_TUBES} are allowed")
        for k, tube in enumerate(self.tubes or ()):
            for own, shared in (("length", "tube_length"), ("radius", "tube_radius")):
                if getattr(tube, own) is None and getattr(self, shared) is None:
                    yield Complaint(
                        ("tubes", str(k), own),
                        f"missing, and there is no network.{shared} to fall back on; "
                        "a length is wanted, like '37.5 mm'",
                    )

    def _chain_faults(self) -> Iterator[Complaint]:
        if self.tubes is not None:
            yield Complaint(
                ("tubes",), f"given, but the layout is {self.layout}; use 'custom' or 'changes'"
            )
        for key in ("tube_radius", "tube_length"):
            if getattr(self, key) is None:
                yield Complaint((key,), "missing; a length is wanted, like '37.5 mm'")

    def graph(self, count: int, inlets: tuple[str, ...]) -> Graph:
        """The network of ``count`` bellows; faults name their nodes and tubes."""
        make = _custom_graph if self.layout == "custom" else _chain_graph
        graph = make(self, count // 2, inlets)
        return graph if self.feed_line is None else _with_feed_lines(graph, self.feed_line)


def _with_feed_lines(graph: Graph, line: FeedLine) -> Graph:
    """A junction behind every inlet, to which the inlet's tubes move."""
    joints = {name: "feed" if len(graph.inlets) == 1 else f"feed_{name}" for name in graph.inlets}
    if taken := sorted(set(joints.values()) & set(graph.nodes)):
        raise refuse_at("feed_line", f"the network has a node {taken[0]} already; rename it")
    moved = [
        replace(t, start=joints.get(t.start, t.start), end=joints.get(t.end, t.end))
        for t in graph.tubes
    ]
    lines = [
        Tube(f"{inlet}-{joint}", inlet, joint, line.length, line.radius)
        for inlet, joint in joints.items()
    ]
    junctions = (*joints.values(), *graph.junctions)
    return replace(graph, junctions=junctions, tubes=(*lines, *moved))


def _chain_graph(network: Network, sections: int, inlets: tuple[str, ...]) -> Graph:
    refuse_any(chain_faults(network.layout, sections, inlets))
    order = straight_order if network.layout == "straight" else crossed_order
    nodes = [inlets[0], *order(sections)]
    refuse_any(change_faults(network.layout, network.changes, nodes))
    tubes = tuple(
        _tube(network, f"{a}-{b}", a, b, _change(network, a, b))
        for a, b in itertools.pairwise(nodes)
    )
    return Graph(sections, inlets, bellow_names(sections), (), tubes)


def _change(network: Network, start: str, end: str) -> TubeChange | None:
    return network.changes.get(f"{start}-{end}") or network.changes.get(f"{end}-{start}")


def _tube(
    network: Network, name: str, start: str, end: str, own: TubeChange | TubeEntry | None
) -> Tube:
    length = own.length if own is not None and own.length is not None else network.tube_length
    radius = own.radius if own is not None and own.radius is not None else network.tube_radius
    if length is None or radius is None:
        raise refuse(f"tube {name} has no length or no radius")
    return Tube(name, start, end, length, radius)


def _custom_graph(network: Network, sections: int, inlets: tuple[str, ...]) -> Graph:
    entries = network.tubes or ()
    ends = [(tube.start, tube.end) for tube in entries]
    refuse_any(node_faults(ends, sections, inlets))
    bellows = bellow_names(sections)
    known = {*bellows, *inlets}
    junctions = tuple(dict.fromkeys(end for pair in ends for end in pair if end not in known))
    seen: Counter[str] = Counter()
    tubes = []
    for entry in entries:
        name = f"{entry.start}-{entry.end}"
        seen[name] += 1
        full = name if seen[name] == 1 else f"{name}#{seen[name]}"
        tubes.append(_tube(network, full, entry.start, entry.end, entry))
    graph = Graph(sections, inlets, bellows, junctions, tuple(tubes))
    refuse_any(island_faults(graph))
    return graph
