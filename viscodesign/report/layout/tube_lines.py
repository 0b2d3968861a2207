"""Tubes as lines between the ports of bellows, inlets and junctions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

BULGE = 0.22
"""How far a tube along a column stands out, of the width."""
INLET_HEIGHT, INLET_SIDE = 0.36, 0.62
"""Place of an inlet above the clamp and beside the axis, of the width."""
JUNCTION_PASSES = 4
"""Times that junctions move to the middle of their neighbours."""
MAX_TUBE_LINES = 256
"""With more tubes than this none could be told from another."""
TUBE_POINTS = 9

Ports = Mapping[str, np.ndarray]


def inlet_places(
    inlets: Sequence[str], tubes: Sequence[Sequence[str]], width: float
) -> dict[str, np.ndarray]:
    """Where the inlets (2,) are: beside the column that they feed first."""
    found = {}
    for k, name in enumerate(inlets):
        ends = next((pair for pair in tubes if name in pair), ())
        side = -1.0 if any(end[:1] == "L" and end[1:].isdigit() for end in ends) else 1.0
        across = (k - (len(inlets) - 1) / 2) * 0.5 if len(inlets) > 2 else INLET_SIDE * side
        found[name] = np.array((across * width, -INLET_HEIGHT * width))
    return found


def tube_lines(
    blocks: np.ndarray,
    bellows: Sequence[str],
    inlets: Ports,
    tubes: Sequence[Sequence[str]],
    width: float,
) -> list[np.ndarray]:
    """Lines (n, 2) of tubes at an instant, from the outlines (B, 4, 2) of its bellows."""
    ports, outwards = _ports(blocks, bellows, inlets, tubes)
    return [
        _line(ports, outwards, a, b, BULGE * width) for a, b in tubes if a in ports and b in ports
    ]


def _ports(
    blocks: np.ndarray, bellows: Sequence[str], inlets: Ports, tubes: Sequence[Sequence[str]]
) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray]]:
    """Where every node is, and the unit vector out of each bellow."""
    outer, inner = blocks[:, 2:].mean(axis=1), blocks[:, :2].mean(axis=1)
    out = outer - inner
    out = out / np.maximum(np.hypot(*out.T), 1e-300)[:, None]
    ports = {**dict(zip(bellows, outer, strict=True)), **inlets}
    near: dict[str, list[str]] = {}
    for a, b in tubes:
        for own, other in ((a, b), (b, a)):
            if own not in ports:
                near.setdefault(own, []).append(other)
    ports.update({name: np.zeros(2) for name in near})
    for _ in range(JUNCTION_PASSES):
        for name, others in near.items():
            ports[name] = np.mean([ports[other] for other in others], axis=0)
    return ports, dict(zip(bellows, out, strict=True))


def _line(ports: Ports, outwards: Ports, a: str, b: str, bulge: float) -> np.ndarray:
    """Straight, or an arc outwards between bellows of one column."""
    along = np.linspace(0.0, 1.0, TUBE_POINTS)[:, None]
    straight = (1 - along) * ports[a] + along * ports[b]
    if a not in outwards or b not in outwards or a[0] != b[0]:
        return straight
    out = (outwards[a] + outwards[b]) / 2
    return straight + 2 * along * (1 - along) * bulge * out
