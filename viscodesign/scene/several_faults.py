"""What keeps several actuators from being independent of each other, and from being fed."""

from __future__ import annotations

import hashlib
from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from viscodesign.errors import did_you_mean
from viscodesign.scene.bellows import snaps
from viscodesign.scene.fed_actuator import by_inlet, inherited
from viscodesign.scene.inputs.base import Input
from viscodesign.scene.network import TubeEntry
from viscodesign.scene.network_faults import foreign_bellow
from viscodesign.scene.several import ActuatorDesign, SameInput, unlike
from viscodesign.scene.spec_part import KeyFault

if TYPE_CHECKING:
    from viscodesign.scene.several_scene import SeveralScene

ADVICE = (
    "Give the pressure instead, such as a recorded one (kind: table), or each actuator a syringe "
    "of its own"
)


NOT_COUPLED = (
    "tubes between actuators are not supported yet: they would make one coupled system of them. "
    "Remove them, and feed each actuator by a source of its own network"
)


def tube_faults(tubes: Sequence[TubeEntry] | None, names: Collection[str]) -> Iterator[KeyFault]:
    """Tubes between actuators, and those of actuators that do not exist."""
    for k, tube in enumerate(tubes or ()):
        for node in (tube.start, tube.end):
            name, dot, _ = node.partition(".")
            if dot and name not in names:
                yield KeyFault(("tubes", str(k)), _no_such_actuator(name, names))
    if tubes is not None:
        yield KeyFault(("tubes",), NOT_COUPLED)


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
        return f"'{node}': {NOT_COUPLED}"
    is_meant = foreign_bellow(node) is not None or did_you_mean(name, names)
    return _no_such_actuator(name, names) if is_meant else ""


def _no_such_actuator(name: str, names: Collection[str]) -> str:
    return f"no such actuator: '{name}'{did_you_mean(name, names)}; there are {', '.join(names)}"


def source_faults(scene: SeveralScene) -> Iterator[KeyFault]:
    """Actuators that no input feeds, and inputs that do not exist."""
    listed = ", ".join(scene.inputs)
    for name in scene.actuators:
        source, place = inherited(name, scene.actuators, "source"), ("actuators", name, "source")
        if source is None and len(scene.inputs) > 1:
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


def plunger_faults(scene: SeveralScene) -> Iterator[KeyFault]:
    """A plunger couples what shares its volume, unless these are actuators that move alike."""
    for name, source in scene.sources.items():
        fed = scene.fed_by(name)
        inlets = [own for one in fed for own in scene.sources_of(one).values() if own == name]
        if source.gives_pressure or len(inlets) < 2:
            continue
        listed = ", ".join(fed)
        if len(inlets) > len(fed):
            why = f"it feeds several inlets of {listed}: its volume would couple their pressures"
        elif source.shared_by(len(fed)) is None or len({_digest(scene, own) for own in fed}) > 1:
            why = f"it feeds {listed}, which differ: its volume would couple them to one system"
        elif any(_snaps(scene, own) for own in fed):
            why = f"it feeds {listed}, whose bellows snap through, one actuator before another"
        else:
            continue
        yield KeyFault(("inputs", name), f"{why}, which is not supported yet. {ADVICE}")


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
