"""Random changes of a network: a chain stays a chain, a tree a tree."""

from __future__ import annotations

import random

from viscodesign.inverse.tree_graph import INLET, TreeGraph, chain, tree


def changed_chain(graph: TreeGraph, chance: random.Random) -> TreeGraph:
    """Two bellows swapped, one moved, or a stretch turned round."""
    order = [far for far, _ in graph.parents]
    a, b = sorted(chance.sample(range(len(order)), 2))
    kind = chance.randrange(3)
    if kind == 0:
        order[a], order[b] = order[b], order[a]
    elif kind == 1:
        here, there = (a, b) if chance.random() < 0.5 else (b, a)
        order.insert(there, order.pop(here))
    else:
        order[a : b + 1] = order[a : b + 1][::-1]
    return chain(order)


def changed_tree(graph: TreeGraph, chance: random.Random) -> TreeGraph:
    """A branch hung on another node, or two bellows swapped."""
    count = len(graph.parents)
    parent = [INLET] * count
    for far, near in graph.parents:
        parent[far] = near
    if chance.random() < 0.35:
        a, b = chance.sample(range(count), 2)
        swap = {a: b, b: a}
        named = {swap.get(k, k): swap.get(parent[k], parent[k]) for k in range(count)}
        return tree([named[k] for k in range(count)])
    moved = chance.randrange(count)
    below = _branch(parent, moved)
    places = [node for node in range(-1, count) if node not in below and node != parent[moved]]
    if places:
        parent[moved] = chance.choice(places)
    return tree(parent)


def _branch(parent: list[int], root: int) -> set[int]:
    """A bellow and all that hang on it."""
    found, grew = {root}, True
    while grew:
        more = {k for k, near in enumerate(parent) if near in found} - found
        found |= more
        grew = bool(more)
    return found
