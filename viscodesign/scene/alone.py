"""One of the actuators that share fluid, by itself: what it meets of the others are its inlets.

Where a tube leads to it from elsewhere, the far end is an inlet of its own, whose pressure is
that of the node there. With the pressures of a run it moves as it did in it.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.fed_actuator import INLET
from viscodesign.scene.fluid_links import LinkedActuator, LinkedGroup, LinkedTube
from viscodesign.scene.joined_scene import OF_ALL_TUBES

JOINT = "joint"
"""What the inlet of a network is called where it is none, but tubes of others meet there."""


@dataclass(frozen=True)
class Alone:
    """The network of one actuator by itself."""

    network: Any
    """Its keys, or the network itself where nothing leads to it but its own inlets."""
    inlets: Mapping[str, str]
    """Inlet -> node of the network of all whose pressure it has."""
    nodes: Mapping[str, str]
    """Its own nodes -> those of the network of all."""
    tubes: tuple[str, ...]
    """Names of its tubes in the network of all, in its own order."""

    def driven_by(self, inputs: Mapping[str, Any]) -> dict[str, Any]:
        """The keys of its inputs, by what its inlets are fed with."""
        if tuple(self.inlets) == (INLET,):
            return {"input": inputs[INLET]}
        return {"inputs": {name: inputs[name] for name in self.inlets}}


def alone(group: LinkedGroup, own: LinkedActuator) -> Alone:
    """The network of one actuator of a group by itself."""
    inner = [tube for tube in group.tubes if tube.owner == own.name]
    mine = {node: name for name, node in own.nodes.items() if node.startswith(f"{own.name}.")}
    reaching = [t for t in group.shared if t.start in mine or t.end in mine]
    names = tuple(tube.name for tube in (*inner, *reaching))
    inlets = {name: node for name, node in own.nodes.items() if node not in mine}
    if not reaching and len(inner) == len(own.graph.tubes):
        return Alone(own.design.network, inlets, own.nodes, names)
    # An inlet that tubes of others feed is a junction here.
    renamed = {INLET: JOINT} if own.nodes.get(INLET) in mine else {}
    ends = {node: renamed.get(name, name) for node, name in mine.items()}
    for tube in reaching:
        for node in (tube.start, tube.end):
            if node not in ends:
                ends[node] = _inlet_name(node, {*ends.values(), *own.nodes})
                inlets[ends[node]] = node
    tubes = [
        *(
            _entry(tube, *(renamed.get(node, node) for node in (t.start, t.end)))
            for tube, t in zip(inner, own.own_tubes, strict=True)
        ),
        *(_entry(tube, ends[tube.start], ends[tube.end]) for tube in reaching),
    ]
    network = own.design.network
    keys = {key: getattr(network, key) for key in OF_ALL_TUBES}
    nodes = {
        **{name: node for name, node in own.nodes.items() if name not in renamed},
        **{name: node for node, name in ends.items()},
    }
    return Alone({"layout": "custom", "tubes": tubes, **keys}, inlets, nodes, names)


def _entry(tube: LinkedTube, start: str, end: str) -> dict[str, Any]:
    return {"from": start, "to": end, "length": tube.length, "radius": tube.radius}


def _inlet_name(node: str, taken: set[str]) -> str:
    """A name for the inlet in the place of a node elsewhere."""
    name = re.sub(r"\W", "_", node)
    if re.fullmatch(r"[RLrl]\d+", name):
        name = f"{name}_"
    while name in taken:
        name = f"{name}_"
    return name
