"""What keeps several actuators from being independent of each other, and from being fed."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from viscodesign.errors import did_you_mean
from viscodesign.model.graph import bellow_names
from viscodesign.scene.fed_actuator import INLET, by_inlet, inherited
from viscodesign.scene.fluid_links import LinkedGroup, ends_of, lost_nodes, reached_by_tubes
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.joined_scene import OF_ALL_TUBES
from viscodesign.scene.network import TubeEntry
from viscodesign.scene.network_faults import foreign_bellow
from viscodesign.scene.several import ActuatorDesign, SameInput, unlike
from viscodesign.scene.spec_part import KeyFault

if TYPE_CHECKING:
    from viscodesign.scene.several_scene import SeveralScene

ELSEWHERE = (
    "a tube that leads to another actuator stands under the 'tubes' of the whole spec, where "
    "nodes of actuators have their names before them"
)


def tube_faults(tubes: Sequence[TubeEntry] | None, names: Collection[str]) -> Iterator[KeyFault]:
    """Tubes between actuators, and those of actuators that do not exist."""
    for k, tube in enumerate(tubes or ()):
        for node in (tube.start, tube.end):
            name, dot, _ = node.partition(".")
            if dot and name not in names:
                yield KeyFault(("tubes", str(k)), _no_such_actuator(name, names))


def own_tube_faults(actuators: Mapping[str, ActuatorDesign]) -> Iterator[KeyFault]:
    """Tubes of an actuator's own network that lead to another actuator."""
    for own, design in actuators.items():
        for k, tube in enumerate((design.network and design.network.tubes) or ()):
            path = ("actuators", own, "network", "tubes", str(k))
            for node in (tube.start, tube.end):
                if message := _elsewhere(own, node, actuators):
                    yield KeyFault(path, message)


def _elsewhere(own: str, node: str, names: Collection[str]) -> str:
    """The fault of a node by the name of an actuator; empty for nodes of its own network."""
    name, dot, within = node.partition(".")
    if not dot:
        return ""
    if name == own:
        return f"'{node}': nodes of its own network have no prefix; use '{within}'"
    if name in names:
        return f"'{node}': {ELSEWHERE}"
    is_meant = foreign_bellow(node) is not None or did_you_mean(name, names)
    return _no_such_actuator(name, names) if is_meant else ""


def _no_such_actuator(name: str, names: Collection[str]) -> str:
    return f"no such actuator: '{name}'{did_you_mean(name, names)}; there are {', '.join(names)}"


def source_faults(scene: SeveralScene) -> Iterator[KeyFault]:
    """Actuators that no input feeds, and inputs that do not exist."""
    listed = ", ".join(scene.inputs)
    for name in scene.actuators:
        source, place = inherited(name, scene.actuators, "source"), ("actuators", name, "source")
        reached = name in reached_by_tubes(scene)
        if source is None and len(scene.inputs) > 1 and not reached:
            yield KeyFault(place, f"missing; name the input that feeds it: {listed}")
        for key, given in by_inlet(source).items():
            if given not in scene.inputs:
                hint = did_you_mean(given, scene.inputs)
                below = (key,) if isinstance(source, dict) else ()
                message = f"no such input: '{given}'{hint}; there are {listed}"
                yield KeyFault((*place, *below), message)


def later_faults(inputs: Mapping[str, Any], sources: Mapping[str, Input]) -> Iterator[KeyFault]:
    """Inputs of kinds that cannot be later: ``sources`` has none of them."""
    for name, given in inputs.items():
        if isinstance(given, SameInput) and name not in sources:
            kind = inputs[given.source].name
            yield KeyFault(
                ("inputs", name, "delay"),
                f"'{given.source}' is of the kind {kind}, which cannot be delayed; give '{name}' "
                "rows of its own (kind: table)",
            )


def link_faults(scene: SeveralScene) -> Iterator[KeyFault]:
    """Tubes between actuators whose ends or sizes cannot be."""
    for k, tube in enumerate(scene.tubes or ()):
        place = ("tubes", str(k))
        if tube.start == tube.end:
            yield KeyFault(
                place, f"the tube joins {tube.start} to itself; give two different nodes"
            )
        for key in ("length", "radius"):
            if getattr(tube, key) is None:
                yield KeyFault(
                    (*place, key),
                    "missing; tubes between actuators have no default. Expected a length, such "
                    "as '37.5 mm'",
                )
        ends = (tube.start, tube.end)
        for node in ends:
            yield from (KeyFault(place, why) for why in _node_faults(scene, node))
        if all(node in scene.sources and scene.sources[node].gives_pressure for node in ends):
            yield KeyFault(place, "it joins two inputs of given pressure, and feeds no actuator")


def lost_faults(scene: SeveralScene) -> Iterator[KeyFault]:
    """Nodes between actuators that lead to none of them, and inputs that feed nothing."""
    followed = {own.source for own in scene.inputs.values() if isinstance(own, SameInput)}
    used = {*ends_of(scene.tubes), *followed}
    for name in scene.inputs:
        if name not in used and not scene.fed_by(name):
            yield KeyFault(
                ("inputs", name),
                "feeds nothing; name it as the source of an actuator, lead a tube from it, or "
                "remove it",
            )
    if lost := lost_nodes(scene):
        some = next(iter(scene.actuators))
        yield KeyFault(
            ("tubes",),
            f"no actuator is connected to {', '.join(lost)}; lead a tube from there to a node of "
            f"one, such as {some}.{INLET}, or remove what leads there",
        )


def _node_faults(scene: SeveralScene, node: str) -> Iterator[str]:
    """What is wrong with the end of a tube between actuators."""
    names = scene.actuators
    name, dot, within = node.partition(".")
    if not dot:
        if node in names:
            yield f"'{node}' is an actuator; name a node of it, such as '{node}.{INLET}'"
        elif re.fullmatch(r"[RLrl]\d+", node):
            own = next(iter(names))
            yield f"'{node}' is a bellow of which actuator? Write it as '{own}.{node}'"
        elif not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", node):
            yield f"'{node}' is not a valid node name; use letters, digits, '_', a letter first"
        return
    if name not in names:
        return  # told already
    design = unlike(names)[name]
    if design.bellows is None or design.network is None:
        return
    stated = inherited(name, names, "source") is not None
    known = {*bellow_names(design.bellows.count // 2)}
    known |= {*ends_of(design.network.tubes)}
    known -= set(scene.sources_of(name))
    known |= set() if stated else {INLET}
    if within not in known:
        fed = f"; its source feeds its {INLET}" if within == INLET and stated else ""
        hint = did_you_mean(within, known) or f"; it has {', '.join(sorted(known)[:6])}, ..."
        yield f"{name} has no node '{within}' for a tube{fed or hint}"


def group_faults(scene: SeveralScene, group: LinkedGroup) -> Iterator[KeyFault]:
    """What actuators that share fluid cannot have each of its own."""
    designs = [own.design for own in group.actuators]
    first, *others = (design.network for design in designs)
    for name, network in zip(group.names[1:], others, strict=True):
        for key in OF_ALL_TUBES:
            if getattr(network, key) != getattr(first, key):
                yield KeyFault(
                    ("actuators", name, "network", key),
                    f"differs from that of {group.names[0]}, with which it shares fluid; give "
                    "both the same",
                )
    curved = [bool(design.bellows and design.bellows.curves) for design in designs]
    if any(curved) and not all(curved):
        name = group.names[curved.index(False)]
        yield KeyFault(
            ("actuators", name, "bellows", "curve"),
            f"missing; {group.names[curved.index(True)]} has one, and they share fluid. Give all "
            "of them a curve, or none",
        )
    if not group.inputs:
        listed = ", ".join(scene.inputs)
        yield KeyFault(
            ("tubes",),
            f"no input feeds {' and '.join(group.names)}; lead a tube from one ({listed}) to them, "
            "or give one of them a source",
        )
    for name in group.names:
        loads = inherited(name, scene.actuators, "loads") or scene.loads
        ground = getattr(loads, "ground", None)
        if ground is not None and ground.foot_radius:
            yield KeyFault(
                ("actuators", name, "loads", "ground", "foot_radius"),
                "a round tip of actuators that share fluid is not supported yet; leave it out (0: "
                "a point), or give each a source of its own",
            )
    if scene.uncertainty is not None:
        yield KeyFault(
            ("uncertainty",),
            f"bands of actuators that share fluid ({', '.join(group.names)}) are not supported "
            "yet; remove it",
        )
