"""Random networks: chains, trees, junctions, loops, several inlets, sealed islands."""

from __future__ import annotations

from random import Random
from typing import Any

from tests.fuzz.random_numbers import around, chance_of, share, size

Spec = dict[str, Any]
SEALED = 0.1
"""Chance that a bellow is left without a way to an inlet."""


def network(rng: Random, sections: int, inlets: list[str]) -> Spec:
    """The `network:` section of a spec with these inlets."""
    found: Spec = {
        "tube_radius": size(rng, 3.25e-4, -0.5, 0.5),
        "tube_length": size(rng, 0.0375, -1, 1),
    }
    if len(inlets) == 1 and chance_of(rng, 0.4):
        crossed = sections % 2 == 0 and chance_of(rng, 0.5)
        found["layout"] = "crossed" if crossed else "straight"
        if chance_of(rng, 0.3):
            found["changes"] = {"inlet-R1": _tube(rng)}
    else:
        found |= {"layout": "custom", "tubes": _tubes(rng, sections, inlets)}
    return found | _extras(rng)


def _extras(rng: Random) -> Spec:
    """Walls, lines and losses."""
    found: Spec = {}
    if chance_of(rng, 0.2):
        found["tube_wall"] = {
            "youngs_modulus": size(rng, 2e6, -1, 3),
            "thickness": size(rng, 5e-4, -1, 1),
            "poissons_ratio": share(rng, 0.0, 0.5),
        }
    if chance_of(rng, 0.2):
        found["feed_line"] = {
            "length": size(rng, 0.5, -1, 1),
            "radius": size(rng, 1e-3, -0.5, 0.5),
        }
    for key in ("entrance_loss", "exit_loss"):
        if chance_of(rng, 0.2):
            found[key] = share(rng, 0.0, 10.0)
    return found


def _tubes(rng: Random, sections: int, inlets: list[str]) -> list[Spec]:
    """A tree from every inlet, perhaps islands, and perhaps more tubes across."""
    bellows = [f"{side}{j}" for side in "RL" for j in range(1, sections + 1)]
    rng.shuffle(bellows)
    free = [b for b in bellows[len(inlets) :] if chance_of(rng, SEALED)]
    fed = [b for b in bellows if b not in free]
    tubes, nodes = [], list(inlets)
    make = _junction_tree if chance_of(rng, 0.3) else _tree
    tubes += make(rng, inlets, fed, nodes)
    if len(free) > 1 and chance_of(rng, 0.5):
        tubes += _tree(rng, free[:1], free[1:], [])  # an island
    for k in range(rng.choice([0, 0, 1, 2])):
        tubes += [_between(rng, end, f"j{k}") for end in rng.sample(nodes, 2)]
    for _ in range(rng.choice([0, 0, 1, 2])):
        tubes.append(_between(rng, *rng.sample(nodes, 2)))
    rng.shuffle(tubes)
    return tubes


def _tree(rng: Random, roots: list[str], fed: list[str], nodes: list[str]) -> list[Spec]:
    """Every one of ``fed`` hangs on a root or on one before it; a chain or a bush."""
    tubes, reached = [], list(roots)
    bushy = rng.random()
    for k, node in enumerate(fed):
        origin = rng.choice(reached) if chance_of(rng, bushy) else reached[-1]
        tubes.append(_between(rng, roots[k] if k < len(roots) else origin, node))
        reached.append(node)
        nodes.append(node)
    return tubes


def _junction_tree(rng: Random, roots: list[str], fed: list[str], nodes: list[str]) -> list[Spec]:
    """A trunk of T-junctions behind every root; bellows are leaves."""
    tubes, trunks = [], {root: [root] for root in roots}
    for k, node in enumerate(fed):
        root = roots[k % len(roots)]
        junction = f"t{k}"
        tubes.append(_between(rng, rng.choice(trunks[root][-3:]), junction))
        tubes.append(_between(rng, junction, node))
        trunks[root].append(junction)
        nodes += [junction, node]
    return tubes


def _between(rng: Random, start: str, end: str) -> Spec:
    ends = (start, end) if chance_of(rng, 0.5) else (end, start)
    return {"from": ends[0], "to": ends[1], **_tube(rng)}


def _tube(rng: Random) -> Spec:
    found = {"length": around(rng, 0.0375, -2, 2)} if chance_of(rng, 0.7) else {}
    if chance_of(rng, 0.2):
        found["radius"] = size(rng, 3.25e-4, -0.7, 0.7)
    return found
