"""`network:` which bellow is joined to which, and by what tube."""

from __future__ import annotations

import itertools
import re
from collections import Counter
from typing import Literal

from pydantic import Field, model_validator

from viscodesign.model.graph import Graph, Tube, bellow_names, crossed_order, straight_order
from viscodesign.scene.base import Part, did_you_mean, refuse, refuse_at
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
        if self.layout == "custom":
            if self.tubes is None:
                raise refuse_at("tubes", "missing; a custom layout lists its tubes")
            if self.changes:
                raise refuse_at("changes", "given, but only named layouts have changes")
            if len(self.tubes) > MOST_TUBES:
                raise refuse_at("tubes", f"{len(self.tubes)} tubes; at most {MOST_TUBES}")
            for k, tube in enumerate(self.tubes):
                self._check_entry(k, tube)
            return self
        if self.tubes is not None:
            raise refuse_at(
                "tubes", f"given, but the layout is {self.layout}; use 'custom' or 'changes'"
            )
        for key in ("tube_radius", "tube_length"):
            if getattr(self, key) is None:
                raise refuse_at(key, "missing; a length is wanted, like '37.5 mm'")
        return self

    def _check_entry(self, k: int, tube: TubeEntry) -> None:
        if tube.start == tube.end:
            raise refuse_at(
                f"tubes.{k}", f"the tube leads from {tube.start} to itself; join two nodes"
            )
        for own, shared in (("length", "tube_length"), ("radius", "tube_radius")):
            if getattr(tube, own) is None and getattr(self, shared) is None:
                raise refuse_at(
                    f"tubes.{k}.{own}", f"missing, and there is no network.{shared} to fall back on"
                )

    def graph(self, count: int, inlets: tuple[str, ...]) -> Graph:
        """The network of ``count`` bellows; a fault names its node or tube."""
        if self.layout == "custom":
            return _custom_graph(self, count // 2, inlets)
        return _chain_graph(self, count // 2, inlets)


def _chain_graph(network: Network, sections: int, inlets: tuple[str, ...]) -> Graph:
    if len(inlets) != 1:
        raise refuse_at(
            "layout",
            f"a {network.layout} chain has one inlet, but {len(inlets)} inputs are given "
            f"({', '.join(inlets)}); use a custom layout",
        )
    if network.layout == "crossed" and sections % 2:
        raise refuse_at(
            "layout",
            f"a crossed chain swaps at mid-length and needs an even number of sections, not "
            f"{sections}; use {2 * (sections - 1)} or {2 * (sections + 1)} bellows",
        )
    order = straight_order if network.layout == "straight" else crossed_order
    nodes = [inlets[0], *order(sections)]
    ends = list(itertools.pairwise(nodes))
    names = {f"{a}-{b}": f"{a}-{b}" for a, b in ends} | {f"{b}-{a}": f"{a}-{b}" for a, b in ends}
    changed: dict[str, TubeChange] = {}
    for key, change in network.changes.items():
        if key not in names:
            raise refuse_at(
                f"changes.{key}",
                f"the {network.layout} layout has no such tube{did_you_mean(key, names)}",
            )
        if names[key] in changed:
            raise refuse_at(f"changes.{key}", "the same tube is changed twice")
        changed[names[key]] = change
    tubes = tuple(_tube(network, f"{a}-{b}", a, b, changed.get(f"{a}-{b}")) for a, b in ends)
    return Graph(sections, inlets, bellow_names(sections), (), tubes)


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
    bellows = bellow_names(sections)
    known = {*bellows, *inlets}
    ends = Counter(end for tube in entries for end in (tube.start, tube.end))
    for k, tube in enumerate(entries):
        for end in (tube.start, tube.end):
            _check_node(f"tubes.{k}", end, sections, known, ends)
    for inlet in inlets:
        if not ends[inlet]:
            raise refuse_at("tubes", f"no tube leads from the inlet '{inlet}', which has an input")
    junctions = tuple(dict.fromkeys(end for end in ends if end not in known))
    seen: Counter[str] = Counter()
    tubes = []
    for entry in entries:
        name = f"{entry.start}-{entry.end}"
        seen[name] += 1
        full = name if seen[name] == 1 else f"{name}#{seen[name]}"
        tubes.append(_tube(network, full, entry.start, entry.end, entry))
    graph = Graph(sections, inlets, bellows, junctions, tuple(tubes))
    for component in graph.components():
        if component.junctions and not component.bellows and not component.inlets:
            raise refuse_at(
                "tubes",
                f"{', '.join(component.junctions)}: only junctions joined to each other; "
                "join them to a bellow or an inlet, or leave them out",
            )
    return graph


def _check_node(key: str, node: str, sections: int, known: set[str], ends: Counter[str]) -> None:
    """A node that is neither bellow nor inlet is a junction, unless it looks like a slip."""
    if node in known:
        return
    bellow = re.fullmatch(r"([RLrl])(\d+)", node)
    if bellow is not None:
        side, number = bellow.group(1).upper(), int(bellow.group(2))
        if 1 <= number <= sections:
            raise refuse_at(key, f"unknown node '{node}'; did you mean '{side}{number}'?")
        raise refuse_at(
            key, f"bellow {node}: the actuator has {sections} sections, {side}1 to {side}{sections}"
        )
    if ends[node] == 1 or node.lower().startswith("inlet"):
        hint = did_you_mean(node, known)
        if hint or node.lower().startswith("inlet"):
            raise refuse_at(
                key,
                f"unknown node '{node}'{hint or '; an inlet needs an entry under inputs'}",
            )
    if not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_.]*", node):
        raise refuse_at(
            key, f"'{node}' is no name for a node; use letters, digits, '_' and '.', a letter first"
        )
