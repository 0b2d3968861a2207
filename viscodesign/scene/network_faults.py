"""Faults of a network as a whole: layout, tubes and nodes against the bellows."""

from __future__ import annotations

import itertools
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from viscodesign.errors import did_you_mean
from viscodesign.model.graph import Graph, bellow_names
from viscodesign.scene.spec_part import KeyFault

Ends = tuple[str, str]


def chain_faults(layout: str, sections: int, inlets: Sequence[str]) -> Iterator[KeyFault]:
    """Reasons why a chain of this layout does not exist."""
    if len(inlets) != 1:
        yield KeyFault(
            ("layout",),
            f"a {layout} chain has one inlet, but there are {len(inlets)} inputs "
            f"({', '.join(inlets)}); use layout 'custom'",
        )
    if layout == "crossed" and sections % 2:
        counts = [2 * s for s in (sections - 1, sections + 1) if s > 0]
        yield KeyFault(
            ("layout",),
            f"a crossed chain swaps sides at mid-length and needs an even number of sections, "
            f"not {sections}; use {' or '.join(map(str, counts))} bellows",
        )


def change_faults(layout: str, changes: Iterable[str], chain: Iterable[str]) -> Iterator[KeyFault]:
    """Changes of tubes that the ``chain`` of nodes does not have, and duplicate changes."""
    tubes = {f"{a}-{b}": frozenset((a, b)) for a, b in itertools.pairwise(chain)}
    either = tubes | {f"{b}-{a}": tubes[f"{a}-{b}"] for a, b in itertools.pairwise(chain)}
    seen: set[frozenset[str]] = set()
    for name in changes:
        if name not in either:
            yield KeyFault(
                ("changes", name),
                f"the {layout} layout has no such tube{_nearest(name, either, tubes)}",
            )
        elif either[name] in seen:
            yield KeyFault(("changes", name), "this tube is already changed by another key")
        else:
            seen.add(either[name])


def _nearest(name: str, known: Iterable[str], tubes: Iterable[str]) -> str:
    """A hint: the tube that was probably meant, or the tubes of the given nodes."""
    ends = set(name.upper().split("-"))
    own = [tube for tube in tubes if ends & set(tube.upper().split("-"))]
    near = f"; its nodes have {', '.join(own[:4])}" if own else ""
    return did_you_mean(name, own) or did_you_mean(name, known) or near


def node_faults(tubes: Sequence[Ends], sections: int, inlets: Sequence[str]) -> Iterator[KeyFault]:
    """Unknown nodes of a custom layout, and unconnected inlets."""
    known = {*bellow_names(sections), *inlets}
    count = Counter(end for ends in tubes for end in ends)
    for k, (start, end) in enumerate(tubes):
        if start == end:
            message = f"the tube connects {start} to itself; give two different nodes"
            yield KeyFault(("tubes", str(k)), message)
        for node in dict.fromkeys((start, end)):
            if node not in known and (message := _node_fault(node, sections, known, count[node])):
                yield KeyFault(("tubes", str(k)), message)
    for inlet in inlets:
        if not count[inlet]:
            yield KeyFault(("tubes",), f"the inlet '{inlet}' has an input but no tube")


def _node_fault(node: str, sections: int, known: set[str], tubes: int) -> str:
    """The fault of a node that is neither bellow nor inlet; a junction is legal unless it looks
    like a typo."""
    if (bellow := re.fullmatch(r"([RLrl])(\d+)", node)) is not None:
        side, number = bellow.group(1).upper(), int(bellow.group(2))
        if 1 <= number <= sections:
            return f"unknown node '{node}'; did you mean '{side}{number}'?"
        return (
            f"no bellow {node}; the actuator has {sections} sections, {side}1 to {side}{sections}"
        )
    if (bellow_there := foreign_bellow(node)) is not None:
        return (
            f"'{node}' is a bellow of another actuator, to which no tube leads from here; "
            f"did you mean '{bellow_there}'?"
        )
    if not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_.]*", node):
        return f"'{node}' is not a valid node name; use letters, digits, '_', '.', a letter first"
    like_an_inlet = node.lower().startswith("inlet")
    if tubes == 1 or like_an_inlet:
        hint = did_you_mean(node, known)
        if hint or like_an_inlet:
            return f"unknown node '{node}'{hint or '; an inlet needs an entry under inputs'}"
    return ""


def foreign_bellow(node: str) -> str | None:
    """The bellow in a name such as 'right.R1', which is one of another actuator."""
    found = re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*\.([RLrl]\d+)", node)
    return None if found is None else found.group(1).upper()


def island_faults(graph: Graph) -> Iterator[KeyFault]:
    """Junctions that are connected to neither bellow nor inlet."""
    for part in graph.components():
        if part.junctions and not part.bellows and not part.inlets:
            yield KeyFault(
                ("tubes",),
                f"{', '.join(part.junctions)}: junctions without a bellow or an inlet; "
                "connect them or remove them",
            )
