"""What the live sketch needs of a spec: a linear network, and what pressures do to sections."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np

from viscodesign.errors import ViscodesignError
from viscodesign.model.graph import Tube, crossed_order, straight_order
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.bellow_numbers import bellow_laws
from viscodesign.scene.ground import Ground
from viscodesign.scene.reading.read import parse_scene
from viscodesign.scene.scene import Scene

COMPRESSIBLE = "compressible_fluid"
"""Trait of the effect with which the fluid of a run stores itself."""
MAX_SKETCHED_BELLOWS = 256
"""Beyond these a sketch no longer follows a slider at once."""


def scene_of(run: Trajectory) -> Scene | None:
    """The scene of a run; None where its spec is not one of this version."""
    try:
        return parse_scene(run.spec_text.encode("utf-8", "backslashreplace"))
    except ViscodesignError:
        return None


def ground_of(run: Trajectory) -> Ground | None:
    """The ground that a run's actuator may touch, where there is one."""
    scene = scene_of(run) if run.contacts else None
    return None if scene is None else scene.loads.ground


def why_not(run: Trajectory, scene: Scene | None) -> str:
    """Why there is no sketch of a run; empty where there is one."""
    if scene is None:
        return "its spec is not one of this version"
    if len(run.time) < 2:
        return "it has one output time only"
    if not all(source.gives_pressure for source in scene.inputs.values()):
        return "a syringe prescribes its volume, and the pressure follows from the design"
    if scene.bellows.curves:
        return "its bellows follow a measured curve, and the sketch is linear"
    if len(run.bellows) > MAX_SKETCHED_BELLOWS:
        return f"it has more than {MAX_SKETCHED_BELLOWS} bellows"
    return ""


def sketch_numbers(run: Trajectory, scene: Scene, *, from_start: bool) -> dict[str, Any]:
    """The numbers of `sketch_model.js`, in SI.

    ``from_start``: whether the first output time is shown; else the shown part is taken to
    repeat itself.
    """
    graph = scene.graph
    stores_gas = any(COMPRESSIBLE in row.traits and row.taken for row in run.effects)
    return {
        "length": scene.actuator.length,
        "sections": graph.sections,
        **_bellows(scene),
        "polytropic_exponent": scene.fluid.polytropic_exponent if stores_gas else None,
        "viscosity": scene.fluid.viscosity,
        "ambient": scene.ambient_pressure,
        "gauge": scene.gauge_pressure,
        "start": scene.run.start if from_start else "periodic",
        "inlets": list(graph.inlets),
        "bellows": list(graph.bellows),
        "junctions": list(graph.junctions),
        "layout": scene.network.layout,
        "tubes": _layouts(scene),
    }


def _bellows(scene: Scene) -> dict[str, list[float]]:
    """Numbers of all bellows, each in the order of the graph."""
    laws = bellow_laws(scene)
    names = ("curvature_per_pressure", "stretch_per_pressure", "compliance", "rest_volume")
    every = np.ones(len(scene.graph.bellows))
    return {name: (getattr(laws, name) * every).tolist() for name in names}


def _layouts(scene: Scene) -> dict[str, list[list[Any]]]:
    """Tubes [from, to, length, radius] of the spec's layout, and of the other named one."""
    own, graph = scene.network.layout, scene.graph
    found: dict[str, list[list[Any]]] = {own: _ends(graph.tubes)}
    if own == "custom":
        return found
    orders = {"straight": straight_order, "crossed": crossed_order}
    lines = graph.tubes[: -len(graph.bellows)]
    chain = graph.tubes[-len(graph.bellows) :]
    for name, order in orders.items():
        nodes = [chain[0].start, *order(graph.sections)]
        sizes = [(tube.length, tube.radius) for tube in chain]
        swapped = [[*ends, *size] for ends, size in zip(pairwise(nodes), sizes, strict=True)]
        found.setdefault(name, [*_ends(lines), *swapped])
    return found


def _ends(tubes: Sequence[Tube]) -> list[list[Any]]:
    return [[tube.start, tube.end, tube.length, tube.radius] for tube in tubes]
