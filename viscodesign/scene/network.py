"""`network:` which bellow is joined to which, and by what tube."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Iterator
from typing import Literal

from pydantic import Field, model_validator

from viscodesign.model.graph import Graph, Tube, bellow_names, crossed_order, straight_order
from viscodesign.scene.base import Complaint, Part, refuse, refuse_any
from viscodesign.scene.network_faults import (
    chain_faults,
    change_faults,
    island_faults,
    node_faults,
)
from viscodesign.units import Length

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


class Network(Part):
    """A named chain with single changes, or any graph."""

    layout: Literal["straight", "crossed", "custom"]
    tube_radius: Length | None = Field(None, gt=0, description="Inner radius of the tubes")
    tube_length: Length | None = Field(None, gt=0, description="Length of each tube")
    changes: dict[str, TubeChange] = Field(
        default_factory=dict, description="Single tubes of a named layout, as 'R1-R2'"
    )
    tubes: tuple[TubeEntry, ...] | None = Field(None, description="All tubes of a custom layout")

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
        if self.layout == "custom":
            return _custom_graph(self, count // 2, inlets)
        return _chain_graph(self, count // 2, inlets)


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
