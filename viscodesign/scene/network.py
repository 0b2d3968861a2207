"""`network:` the tubes that connect the bellows."""

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
from viscodesign.scene.spec_part import KeyFault, SpecPart, invalid, invalid_at, raise_faults
from viscodesign.units import Fraction, Length, Pressure

MAX_TUBES = 20_000


class TubeChange(SpecPart):
    """Changed dimensions of one tube of a named layout."""

    length: Length | None = Field(None, gt=0, description="Length, instead of tube_length")
    radius: Length | None = Field(None, gt=0, description="Inner radius, instead of tube_radius")


class TubeEntry(SpecPart):
    """One tube of a custom layout."""

    start: str = Field(alias="from", min_length=1, description="Node at its first end")
    end: str = Field(alias="to", min_length=1, description="Node at its second end")
    length: Length | None = Field(None, gt=0, description="Default: network.tube_length")
    radius: Length | None = Field(None, gt=0, description="Default: network.tube_radius")


class TubeWall(SpecPart):
    """The elastic wall of all tubes."""

    youngs_modulus: Pressure = Field(
        gt=0, description="Young's modulus of the tubes", examples=["10 MPa"]
    )
    thickness: Length = Field(gt=0, description="Wall thickness", examples=["1 mm"])
    poissons_ratio: Fraction = Field(
        0.5, ge=0, le=0.5, description="Poisson's ratio", examples=["0.5"]
    )


class FeedLineSpec(SpecPart):
    """A tube from the pump to each inlet of the actuator."""

    length: Length = Field(gt=0, description="Length of the line")
    radius: Length = Field(gt=0, description="Inner radius of the line")


class Network(SpecPart):
    """A named chain with changes to single tubes, or any graph."""

    layout: Literal["straight", "crossed", "custom"] = Field(
        description="How the bellows are joined: one chain down the right side and up the left, "
        "one that crosses over after every pair, or the tubes that are listed"
    )
    tube_radius: Length | None = Field(
        None, gt=0, description="Inner radius of the tubes", examples=["0.325 mm"]
    )
    tube_length: Length | None = Field(None, gt=0, description="Length of each tube")
    changes: dict[str, TubeChange] = Field(
        default_factory=dict, description="Changed tubes of a named layout, such as 'R1-R2'"
    )
    tubes: tuple[TubeEntry, ...] | None = Field(None, description="All tubes of a custom layout")
    feed_line: FeedLineSpec | None = Field(None, description="Tube from the pump to each inlet")
    tube_wall: TubeWall | None = Field(None, description="Elastic wall of the tubes")
    entrance_loss: Fraction = Field(
        0.5,
        ge=0,
        le=10,
        description="Entrance loss of a tube, in dynamic pressures",
        examples=["0.5"],
    )
    exit_loss: Fraction = Field(
        1.0, ge=0, le=10, description="Exit loss of a tube, in dynamic pressures", examples=["1.0"]
    )

    @model_validator(mode="after")
    def _check_layout(self) -> Network:
        raise_faults(self._custom_faults() if self.layout == "custom" else self._chain_faults())
        return self

    def _custom_faults(self) -> Iterator[KeyFault]:
        if self.tubes is None:
            yield KeyFault(("tubes",), "missing; a custom layout needs a list of tubes")
        if self.changes:
            yield KeyFault(
                ("changes",), "given, but a custom layout has no changes; edit its tubes"
            )
        if len(self.tubes or ()) > MAX_TUBES:
            count = len(self.tubes or ())
            yield KeyFault(("tubes",), f"{count} tubes; at most {MAX_TUBES} are allowed")
        for k, tube in enumerate(self.tubes or ()):
            for own, shared in (("length", "tube_length"), ("radius", "tube_radius")):
                if getattr(tube, own) is None and getattr(self, shared) is None:
                    yield KeyFault(
                        ("tubes", str(k), own),
                        f"missing, and network.{shared} is not given either; "
                        "expected a length, such as '37.5 mm'",
                    )

    def _chain_faults(self) -> Iterator[KeyFault]:
        if self.tubes is not None:
            yield KeyFault(
                ("tubes",),
                f"given, but the layout is {self.layout}; use layout 'custom' or 'changes'",
            )
        for key in ("tube_radius", "tube_length"):
            if getattr(self, key) is None:
                yield KeyFault((key,), "missing; expected a length, such as '37.5 mm'")

    def graph(self, count: int, inlets: tuple[str, ...]) -> Graph:
        """The network of ``count`` bellows; raises faults by node and tube."""
        make = _custom_graph if self.layout == "custom" else _chain_graph
        graph = make(self, count // 2, inlets)
        return graph if self.feed_line is None else _with_feed_lines(graph, self.feed_line)


def _with_feed_lines(graph: Graph, line: FeedLineSpec) -> Graph:
    """The graph with a feed line and a junction between each inlet and its tubes."""
    joints = {name: "feed" if len(graph.inlets) == 1 else f"feed_{name}" for name in graph.inlets}
    if taken := sorted(set(joints.values()) & set(graph.nodes)):
        raise invalid_at(
            "feed_line", f"the network already has a node named '{taken[0]}'; rename it"
        )
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
    raise_faults(chain_faults(network.layout, sections, inlets))
    order = straight_order if network.layout == "straight" else crossed_order
    nodes = [inlets[0], *order(sections)]
    raise_faults(change_faults(network.layout, network.changes, nodes))
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
        raise invalid(f"tube {name} has no length or no radius")
    return Tube(name, start, end, length, radius)


def _custom_graph(network: Network, sections: int, inlets: tuple[str, ...]) -> Graph:
    entries = network.tubes or ()
    ends = [(tube.start, tube.end) for tube in entries]
    raise_faults(node_faults(ends, sections, inlets))
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
    raise_faults(island_faults(graph))
    return graph
