"""The run of actuators that share fluid, taken apart: one trajectory for each of them."""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from viscodesign.checks.classify import classification
from viscodesign.checks.motion_warnings import motion_notices
from viscodesign.checks.scene_warnings import inlet_violations
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.graph import Graph
from viscodesign.results import channels
from viscodesign.results.channels import Per
from viscodesign.results.coefficient_band import NO_SHARED_BAND
from viscodesign.results.coupled_motion import CoupledMotion
from viscodesign.results.findings import Notice
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.alone import Alone
from viscodesign.scene.fluid_links import LinkedGroup, owner_of
from viscodesign.scene.inputs.table import TableInput
from viscodesign.scene.joined_scene import JoinedScene
from viscodesign.scene.reading.write import resolved_yaml
from viscodesign.scene.scene import Scene
from viscodesign.scene.several_scene import SeveralScene
from viscodesign.simulation.assemble import motion_blocks


def member_runs(scene: SeveralScene, joined: JoinedScene, run: Trajectory) -> dict[str, Trajectory]:
    """The run of each actuator of a joined scene, by name.

    Its spec is that of the actuator by itself, with the pressures at its inlets as they were in
    this run. Error, costs and balances are those of all together.
    """
    run = replace(run, failure=with_section_names(joined, run.failure) if run.failure else None)
    pressures = _node_pressures(joined.graph, run)
    found = {}
    for place, name in enumerate(joined.members):
        own = scene.alone[name]
        inputs = {
            inlet: _input(joined, node, run.time, pressures[node])
            for inlet, node in own.inlets.items()
        }
        alone = scene.alone_driven_by(name, inputs)
        arrays = _arrays(joined, run, place, own, alone.graph, pressures)
        points = tuple(p.partition(".")[2] for p in run.contacts if owner_of(p, [name]) is not None)
        found[name] = _member(run, alone, arrays, points)
    return found


def coupled_motion(group: LinkedGroup, joined: JoinedScene, run: Trajectory) -> CoupledMotion:
    """What belongs to none of the actuators alone."""
    tubes = [tube.name for tube in group.shared]
    pressures = _node_pressures(joined.graph, run)
    return CoupledMotion(
        actuators=group.names,
        time=run.time,
        inflow=run.inflow,
        inlet_pressure=run.inlet_pressure,
        junction_pressure={node: pressures[node] for node in group.junctions},
        flow={name: run.flow[:, run.tubes.index(name)] for name in tubes},
    )


def _node_pressures(graph: Graph, run: Trajectory) -> dict[str, np.ndarray]:
    """Gauge pressure of every node of the network (T,) [Pa]."""
    return {
        **dict(zip(run.bellows, run.pressure.T, strict=True)),
        **dict(zip(graph.junctions, run["junction_pressure"].T, strict=True)),
        **run.inlet_pressure,
    }


def _input(scene: JoinedScene, node: str, time: np.ndarray, pressure: np.ndarray) -> Any:
    """The input that gives an inlet the pressure of a node as it was."""
    source = scene.inputs.get(node)
    if source is not None and source.gives_pressure:
        return source
    above = (pressure - scene.gauge_pressure).tolist()
    return TableInput.model_validate(
        {"kind": "table", "rows": list(zip(time.tolist(), above, strict=True))}
    )


def _arrays(
    joined: JoinedScene,
    run: Trajectory,
    place: int,
    own: Alone,
    graph: Graph,
    pressures: Mapping[str, np.ndarray],
) -> dict[str, np.ndarray]:
    """The arrays of one actuator out of those of all."""
    times, name = len(run.time), list(joined.members)[place]
    touching = [k for k, point in enumerate(run.contacts) if owner_of(point, [name]) is not None]
    bellows = [run.bellows.index(own.nodes[name]) for name in graph.bellows]
    tubes = [run.tubes.index(name) for name in own.tubes]
    counts = [one.bellows.count // 2 for one in joined.members.values()]
    sections = slice(sum(counts[:place]), sum(counts[: place + 1]))
    points = _points(run.arc)[place]

    def of_nodes(names: Sequence[str]) -> np.ndarray:
        values = [pressures[own.nodes[name]] for name in names]
        return np.array(values).T.reshape(times, len(names))

    columns: dict[Per, list[int] | slice] = {
        Per.BELLOW: bellows,
        Per.TUBE: tubes,
        Per.SECTION: sections,
        Per.CONTACT: touching,
    }
    stored = [row for row in channels.CHANNELS if row.read is None and row.per in columns]
    return {
        "time": run.time,
        **{row.quantity: run[row.quantity][:, columns[row.per]] for row in stored},
        "inlet_pressure": of_nodes(tuple(own.inlets)),
        "junction_pressure": of_nodes(graph.junctions),
        "tip": run.tip[:, 3 * place : 3 * place + 3],
        "inflow": _inflow(joined, run, own, graph),
        "shape": run.shape[:, points],
        "arc": run.arc[points],
    }


def _points(arc: np.ndarray) -> list[slice]:
    """Which points of a shape belong to which rod: each begins at its clamp."""
    starts = [*np.flatnonzero(arc == 0.0).tolist(), len(arc)]
    return [slice(a, b) for a, b in itertools.pairwise(starts)]


def _inflow(joined: JoinedScene, run: Trajectory, own: Alone, graph: Graph) -> np.ndarray:
    """What came through every inlet of an actuator (T, inlets) [m3 at ambient density].

    Together it is what its nodes hold. Several inlets share what they held at the start equally;
    then each has its part of the flow, as far as the outputs resolve it.
    """
    nodes = (*joined.graph.bellows, *joined.graph.junctions)
    mine = [nodes.index(own.nodes[name]) for name in (*graph.bellows, *graph.junctions)]
    total = run["content"][:, mine].sum(axis=1)
    inlets = tuple(own.inlets)
    through = np.zeros((len(total), len(inlets)))
    for k, tube in enumerate(graph.tubes):
        flow = run.flow[:, run.tubes.index(own.tubes[k])]
        for node, sign in ((tube.start, 1.0), (tube.end, -1.0)):
            if node in inlets:
                through[:, inlets.index(node)] += sign * _integral(run.time, flow)
    rest = total - through.sum(axis=1)
    return np.asarray(through + rest[:, None] / max(len(inlets), 1))


def _integral(time: np.ndarray, flow: np.ndarray) -> np.ndarray:
    steps = np.diff(time) * (flow[1:] + flow[:-1]) / 2
    return np.concatenate([[0.0], np.cumsum(steps)])[: len(time)]


def _member(
    run: Trajectory, alone: Scene, arrays: dict[str, np.ndarray], contacts: tuple[str, ...]
) -> Trajectory:
    """The trajectory of one actuator with what is known of it by itself."""
    quantities, graph = SceneQuantities(alone), alone.graph
    active = frozenset(verdict.name for verdict in run.effects if verdict.taken)
    found = classification(quantities, active)
    arc = arrays.pop("arc")
    own = replace(
        run,
        name=alone.name,
        arrays=arrays,
        arc=arc,
        inlets=tuple(alone.inputs),
        bellows=graph.bellows,
        tubes=tuple(tube.name for tube in graph.tubes),
        junctions=graph.junctions,
        contacts=contacts,
        length=alone.actuator.length,
        width=alone.actuator.height,
        section_widths=alone.sections.heights,
        classification=found,
        spec_text=resolved_yaml(alone),
        notes=(*run.notes, NO_SHARED_BAND),
        period=alone.period,
    )
    exceeded = tuple(motion_notices(quantities, active, motion_blocks(quantities, own)))
    of_all = [n for n in run.warnings if n not in run.classification.warnings]
    violations = dict.fromkeys([*inlet_violations(quantities), *exceeded])
    return replace(
        own,
        warnings=tuple(dict.fromkeys([*_new(found.warnings, exceeded), *exceeded, *of_all])),
        violations=tuple(violations),
    )


def _new(before: Sequence[Notice], met: Sequence[Notice]) -> Iterator[Notice]:
    """What a run shows replaces what the scene only announced."""
    codes = {notice.code for notice in met}
    yield from (notice for notice in before if notice.code not in codes)


def with_section_names(scene: Scene, text: str) -> str:
    """A message on a joined scene, its sections called by their actuators instead of counted."""
    if not isinstance(scene, JoinedScene):
        return text
    return re.sub(r"\bsection (\d+)", lambda found: scene.section_name(int(found[1])), text)
