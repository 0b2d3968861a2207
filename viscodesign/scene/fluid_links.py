"""Which of several actuators share fluid: by tubes between them, or by the volume of a syringe.

A source of given pressure couples nothing: it has its pressure whatever flows out of it.
"""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.graph import Graph, Tube
from viscodesign.scene.bellows import snaps
from viscodesign.scene.fed_actuator import INLET, inherited
from viscodesign.scene.network import TubeEntry
from viscodesign.scene.several import ActuatorDesign, unlike

if TYPE_CHECKING:
    from viscodesign.scene.several_scene import SeveralScene


@dataclass(frozen=True)
class LinkedTube:
    """A tube of actuators that share fluid."""

    name: str
    """In the network of all."""
    start: str
    end: str
    """Nodes of that network: `left.R1`, the name of an input, or a junction's own."""
    length: float
    radius: float
    owner: str | None
    """The actuator that it belongs to; None where it leads from one to another."""


@dataclass(frozen=True)
class LinkedActuator:
    """One of the actuators that share fluid, with its own network."""

    name: str
    design: ActuatorDesign
    graph: Graph
    """Its own nodes and tubes, under its own names."""
    nodes: Mapping[str, str]
    """Its own nodes -> those of the network of all."""

    @property
    def count(self) -> int:
        """Number of its sections."""
        return self.graph.sections

    @property
    def own_tubes(self) -> tuple[Tube, ...]:
        """Its tubes, under its own names."""
        return tuple(t for t in self.graph.tubes if t.start in self.nodes and t.end in self.nodes)


@dataclass(frozen=True)
class LinkedGroup:
    """Actuators that share fluid: one system of equations."""

    actuators: tuple[LinkedActuator, ...]
    inputs: tuple[str, ...]
    tubes: tuple[LinkedTube, ...]
    """All tubes: those of the actuators, then those between them."""

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the actuators."""
        return tuple(own.name for own in self.actuators)

    @property
    def junctions(self) -> tuple[str, ...]:
        """The nodes between actuators that are not inputs."""
        ends = dict.fromkeys(end for tube in self.shared for end in (tube.start, tube.end))
        return tuple(n for n in ends if n not in self.inputs and owner_of(n, self.names) is None)

    @property
    def shared(self) -> tuple[LinkedTube, ...]:
        """The tubes between actuators."""
        return tuple(tube for tube in self.tubes if tube.owner is None)


def owner_of(node: str, names: Sequence[str] | Mapping[str, object]) -> str | None:
    """The actuator that a node such as `left.R1` belongs to; None for an input or a junction."""
    name, dot, _ = node.partition(".")
    return name if dot and name in names else None


def ends_of(tubes: Sequence[TubeEntry] | None) -> tuple[str, ...]:
    """The nodes at which tubes end, each once, in their order."""
    ends = (node for tube in tubes or () for node in (tube.start, tube.end))
    return tuple(dict.fromkeys(ends))


def reached_by_tubes(scene: SeveralScene) -> frozenset[str]:
    """Actuators that tubes of the whole scene lead to."""
    owners = (owner_of(node, scene.actuators) for node in ends_of(scene.tubes))
    return frozenset(own for own in owners if own is not None)


def moves_alike(scene: SeveralScene, source: str) -> bool:
    """Whether all that a syringe feeds is equal, so that each has an even part of it."""
    fed, given = scene.fed_by(source), scene.sources[source]
    inlets = [own for one in fed for own in scene.sources_of(one).values() if own == source]
    return (
        bool(fed)
        and len(inlets) == len(fed)
        and source not in ends_of(scene.tubes)
        and not reached_by_tubes(scene) & set(fed)
        and given.shared_by(len(fed)) is not None
        and len({_digest(scene, own) for own in fed}) == 1
        and not any(_snaps(scene, own) for own in fed)
    )


def linked_groups(scene: SeveralScene) -> list[LinkedGroup]:
    """Actuators that share fluid, group by group, in the order of the spec."""
    labels = _labels(scene)
    found: list[LinkedGroup] = []
    for label in dict.fromkeys(labels[name] for name in scene.actuators):
        names = [name for name in scene.actuators if labels[name] == label]
        tubes = [t for t in scene.tubes or () if label in _labels_of(t, scene, labels)]
        feeds = [source for name in names for source in scene.sources_of(name).values()]
        many = {source for source, times in Counter(feeds).items() if times > 1}
        if tubes or any(_couples(scene, source) for source in many):
            found.append(_group(scene, names, tubes))
    return found


def whole_group(scene: SeveralScene) -> LinkedGroup:
    """All actuators as one group, also those that share no fluid: what a pump has to feed."""
    return _group(scene, list(scene.actuators), scene.tubes or ())


def regrouped(group: LinkedGroup, scene: SeveralScene) -> LinkedGroup:
    """The same group in a spec that differs in numbers alone."""
    ends = {(tube.start, tube.end) for tube in group.shared}
    tubes = [tube for tube in scene.tubes or () if (tube.start, tube.end) in ends]
    return _group(scene, group.names, tubes)


def lost_nodes(scene: SeveralScene) -> list[str]:
    """Nodes between actuators from which no tube leads to one."""
    labels = _labels(scene)
    led = {labels[name] for name in scene.actuators}
    places = ((node, _place(node, scene)) for node in ends_of(scene.tubes))
    return [node for node, place in places if place is not None and labels[place] not in led]


def _couples(scene: SeveralScene, source: str) -> bool:
    """Whether an input that feeds several inlets couples what it feeds."""
    return not scene.sources[source].gives_pressure and not moves_alike(scene, source)


def _is_ideal(scene: SeveralScene, node: str) -> bool:
    return node in scene.sources and scene.sources[node].gives_pressure


def _labels(scene: SeveralScene) -> dict[str, str]:
    """A representative of every actuator and shared node; ideal sources have none."""
    parent: dict[str, str] = {name: name for name in scene.actuators}

    def find(name: str) -> str:
        parent.setdefault(name, name)
        while parent[name] != name:
            name = parent[name]
        return name

    for tube in scene.tubes or ():
        places = [place for place in _places_of(tube, scene) if place is not None]
        for place in places:
            parent[find(place)] = find(places[0])
    for source in scene.sources:
        for name in scene.fed_by(source) if _couples(scene, source) else ():
            parent[find(name)] = find(_place(source, scene) or source)
    return {name: find(name) for name in list(parent)}


def _place(node: str, scene: SeveralScene) -> str | None:
    if _is_ideal(scene, node):
        return None
    return owner_of(node, scene.actuators) or f"{node}."  # no actuator has such a name


def _places_of(tube: TubeEntry, scene: SeveralScene) -> list[str | None]:
    return [_place(node, scene) for node in (tube.start, tube.end)]


def _labels_of(tube: TubeEntry, scene: SeveralScene, labels: Mapping[str, str]) -> set[str]:
    return {labels[place] for place in _places_of(tube, scene) if place is not None}


def _group(scene: SeveralScene, names: Sequence[str], tubes: Sequence[TubeEntry]) -> LinkedGroup:
    ends = ends_of(tubes)
    actuators = tuple(_linked(scene, name, ends) for name in names)
    feeds = {source for name in names for source in scene.sources_of(name).values()}
    return LinkedGroup(
        actuators,
        tuple(name for name in scene.inputs if name in feeds or name in ends),
        (*(tube for own in actuators for tube in _inner(own)), *_outer(tubes)),
    )


def _linked(scene: SeveralScene, name: str, ends: Sequence[str]) -> LinkedActuator:
    design = unlike(scene.actuators)[name]
    assert design.network is not None
    assert design.bellows is not None
    sources = dict(scene.sources_of(name))
    inlets = tuple(sources)
    if not sources and _names_an_inlet(design):
        inlets = (INLET,)
        joined = f"{name}.{INLET}"
        # Without a tube to it, an inlet leads nowhere, nor does its own tube.
        sources = {INLET: joined} if joined in ends else {}
    graph = design.network.graph(design.bellows.count, inlets)
    inner = {node: f"{name}.{node}" for node in (*graph.bellows, *graph.junctions)}
    dead = () if sources or not inlets else _behind(graph, inlets)
    nodes = {own: given for own, given in (inner | sources).items() if own not in dead}
    return LinkedActuator(name, design, graph, nodes)


def _names_an_inlet(design: ActuatorDesign) -> bool:
    """Whether a network has an inlet of that name, by its layout or its tubes."""
    assert design.network is not None
    return design.network.layout != "custom" or INLET in ends_of(design.network.tubes)


def _behind(graph: Graph, inlets: Sequence[str]) -> set[str]:
    """Inlets that nothing feeds, and the feed lines behind them."""
    lines = {end for t in graph.tubes if t.start in inlets for end in (t.end,)}
    return {*inlets, *(lines & set(graph.junctions))}


def _inner(own: LinkedActuator) -> Iterator[LinkedTube]:
    """The tubes of an actuator in the network of all."""
    for tube in own.own_tubes:
        ends = own.nodes[tube.start], own.nodes[tube.end]
        yield LinkedTube(f"{own.name}.{tube.name}", *ends, tube.length, tube.radius, own.name)


def _outer(tubes: Sequence[TubeEntry]) -> Iterator[LinkedTube]:
    """The tubes between actuators."""
    seen: Counter[str] = Counter()
    for tube in tubes:
        name = f"{tube.start}-{tube.end}"
        seen[name] += 1
        full = name if seen[name] == 1 else f"{name}#{seen[name]}"
        assert tube.length is not None
        assert tube.radius is not None
        yield LinkedTube(full, tube.start, tube.end, tube.length, tube.radius, None)


def _digest(scene: SeveralScene, name: str) -> bytes:
    """Equal for actuators that are equal in all but their names."""
    design = unlike(scene.actuators)[name]
    parts = (design.actuator, design.section_changes, design.bellows, design.network)
    loads = inherited(name, scene.actuators, "loads")
    whole = (parts, loads, sorted(scene.sources_of(name).items()))
    return hashlib.sha256(repr(whole).encode()).digest()


def _snaps(scene: SeveralScene, name: str) -> bool:
    bellows = unlike(scene.actuators)[name].bellows
    return bellows is not None and snaps(bellows)
