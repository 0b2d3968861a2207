"""Pressures at the ends of tubes."""

from __future__ import annotations

import numpy as np

from viscodesign.model.graph import Graph
from viscodesign.results.motion_arrays import MotionArrays


def end_pressures(
    graph: Graph, motion: MotionArrays, inlets: tuple[str, ...], rows: slice
) -> tuple[np.ndarray, np.ndarray]:
    """Gauge pressures of the nodes at each tube's start and end in some outputs (T, Q) [Pa]."""
    columns = {
        **dict(zip(graph.bellows, motion.pressure[rows].T, strict=True)),
        **dict(zip(inlets, motion["inlet_pressure"][rows].T, strict=True)),
        **dict(zip(graph.junctions, motion["junction_pressure"][rows].T, strict=True)),
    }
    shape = len(motion.time[rows]), len(graph.tubes)
    start = np.array([columns[t.start] for t in graph.tubes]).T.reshape(shape)
    end = np.array([columns[t.end] for t in graph.tubes]).T.reshape(shape)
    return start, end
