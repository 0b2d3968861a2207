"""What can be wrong with a network as a whole: layout, tubes and nodes against the bellows."""

from __future__ import annotations

import itertools
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from viscodesign.model.graph import Graph, bellow_names
from viscodesign.scene.section import Complaint, did_you_mean

Ends = tuple[str, str]


def chain_faults(layout: str, sections: int, inlets: Sequence[str]) -> Iterator[Complaint]:
    """Why there is no chain of this layout."""
    if len(inlets) != 1:
        yield Complaint(
            ("layout",),
            f"a {layout} chain has one inlet, but {len(inlets)} inputs are given "
            f"({', '.join(inlets)}); use a custom layout",
        )
    if layout == "crossed" and sections % 2:
        counts = [2 * s for s in (sections - 1, sections + 1) if s > 0]
        yield Complaint(
            ("layout",),
            f"a crossed chain swaps at mid-length and needs an even number of sections, not "
            f"{sections}; use {' or '.join(map(str, counts))} bellows",
        )


def change_faults(layout: str, changes: Iterable[str], chain: Iterable[str]) -> Iterator[Complaint]:
    """Changes of tubes that the ``chain`` of nodes lacks, or of one tube twice."""
    tubes = {f"{a}-{b}": frozenset((a, b)) for a, b in itertools.pairwise(chain)}
    either = tubes | {f"{b}-{a}": tubes[f"{a}-{b}"] for a, b in itertools.pairwise(chain)}
    seen: set[frozenset[str]] = set()
    for name in changes:
        if name not in either:
            yield Complaint(
                ("changes", name),
                f"the {layout} layout has no such tube{_nearest(name, either, tubes)}",
            )
        elif either[name] in seen:
            yield Complaint(("changes", name), "the same tube is changed twice")
        else:
            seen.add(either[name])


def _nearest(name: str, known: Iterable[str], tubes: Iterable[str]) -> str:
    """The tube that was probably meant, or the tubes that its nodes do have."""
    ends = set(name.upper().split("-"))
    own = [tube for tube in tubes if ends & set(tube.upper().split("-"))]
    near = f"; near it are {', '.join(own[:4])}" if own else ""
    return did_you_mean(name, own) or did_you_mean(name, known) or near


def node_faults(tubes: Sequence[Ends], sections: int, inlets: Sequence[str]) -> Iterator[Complaint]:
    """Nodes of a custom layout that are not there, inlets that nothing leads from."""
    known = {*bellow_names(sections), *inlets}
    count = Counter(end for ends in tubes for end in ends)
    for k, (start, end) in enumerate(tubes):
        if start == end:
            message = f"the tube leads from {start} to itself; join two nodes"
            yield Complaint(("tubes", str(k)), message)
        for node in dict.fromkeys((start, end)):
            if node not in known and (message := _node_fault(node, sections, known, count[node])):
                yield Complaint(("tubes", str(k)), message)
    for inlet in inlets:
        if not count[inlet]:
            yield Complaint(
                ("tubes",), f"no tube leads from the inlet '{inlet}', which has an input"
            )


def _node_fault(node: str, sections: int, known: set[str], tubes: int) -> str:
    """A node that is neither bellow nor inlet is a junction, unless it looks like a slip."""
    if (bellow := re.fullmatch(r"([RLrl])(\d+)", node)) is not None:
        side, number = bellow.group(1).upper(), int(bellow.group(2))
        if 1 <= number <= sections:
            return f"unknown node '{node}'; did you mean '{side}{number}'?"
        return f"bellow {node}: the actuator has {sections} sections, {side}1 to {side}{sections}"
    if not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_.]*", node):
        return f"'{node}' is no name for a node; use letters, digits, '_' and '.', a letter first"
    like_an_inlet = node.lower().startswith("inlet")
    if tubes == 1 or like_an_inlet:
        hint = did_you_mean(node, known)
        if hint or like_an_inlet:
            return f"unknown node '{node}'{hint or '; an inlet needs an entry under inputs'}"
    return ""


def island_faults(graph: Graph) -> Iterator[Complaint]:
    """Junctions that are joined to each other only."""
    for part in graph.components():
        if part.junctions and not part.bellows and not part.inlets:
            yield Complaint(
                ("tubes",),
                f"{', '.join(part.junctions)}: only junctions joined to each other; "
                "join them to a bellow or an inlet, or leave them out",
            )
