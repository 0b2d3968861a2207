"""A solved run with all that is known of its scene, as one trajectory."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from viscodesign._version import __version__
from viscodesign.checks.classify import classification
from viscodesign.checks.motion_warnings import motion_notices
from viscodesign.checks.scene_warnings import inlet_violations, verdict_notices
from viscodesign.checks.table_cover import input_notes
from viscodesign.effects.select import Selection
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.postprocess.motion import Motion
from viscodesign.postprocess.motion_limits import MotionBlock
from viscodesign.postprocess.terminations import doubted_balance
from viscodesign.results.findings import Notice
from viscodesign.results.motion_arrays import MotionArrays
from viscodesign.results.provenance import provenance
from viscodesign.results.trajectory import Accuracy, Cost, Trajectory
from viscodesign.scene.reading.write import resolved_yaml
from viscodesign.simulation.outcome import NOT_VERIFIED
from viscodesign.simulation.solve_once import Run
from viscodesign.storage.disk_arrays import blocks


def trajectory_of(quantities: SceneQuantities, selection: Selection, run: Run) -> Trajectory:
    """The motion with its warnings; how it ended and how accurate it is come later."""
    scene, motion, graph = quantities.scene, run.motion, quantities.graph
    found = classification(quantities, selection.active)
    # Of several rods, each is judged by itself. Not at outputs alone: whether a run leaves its
    # model must not depend on when it is looked at.
    outputs = () if scene.members else motion_blocks(quantities, motion)
    has_more = motion.between and not scene.members
    solved = motion_blocks(quantities, motion.at_solved_times()) if has_more else ()
    exceeded = tuple(motion_notices(quantities, selection.active, outputs, solved))
    return Trajectory(
        name=scene.name,
        status="complete",
        arrays=dict(motion.arrays),
        arc=motion.arc,
        shape_every=motion.shape_every,
        inlets=tuple(scene.inputs),
        bellows=graph.bellows,
        tubes=tuple(t.name for t in graph.tubes),
        junctions=graph.junctions,
        contacts=run.problem.equations.contacts,
        length=scene.actuator.length,
        width=scene.actuator.height,
        section_widths=scene.sections.heights,
        classification=found,
        effects=selection.verdicts,
        accuracy=Accuracy(quantities.requested_m, None, NOT_VERIFIED),
        cost=cost_of(run),
        invariants=motion.invariants,
        warnings=_merged(
            (
                *verdict_notices(quantities, selection.verdicts),
                *found.warnings,
                *_start_notices(quantities, selection, run),
            ),
            (
                *exceeded,
                *doubted_balance(motion.invariants),
                *_thinned_shapes(motion),
            ),
        ),
        notes=tuple(input_notes(quantities)),
        violations=_merged(inlet_violations(quantities), exceeded),
        spec_text=resolved_yaml(scene),
        spec_sha256=scene.source.sha256,
        version=__version__,
        ambient_pressure=scene.ambient_pressure,
        period=scene.period,
        settings=_settings(run),
        provenance=provenance(),
    )


def cost_of(run: Run) -> Cost:
    """What one solution cost."""
    work = run.solution.work
    return Cost(
        build_s=run.build_s,
        solve_s=run.solve_s,
        read_s=run.read_s,
        steps=work.steps,
        residual_calls=work.residual_calls,
        jacobian_calls=work.jacobian_calls,
    )


def _start_notices(quantities: SceneQuantities, selection: Selection, run: Run) -> Iterator[Notice]:
    """What the effects say of the first state."""
    for effect in selection.effects:
        yield from effect.start_warnings(
            quantities, selection.active, run.problem, run.solution.beginning
        )


def motion_blocks(quantities: SceneQuantities, motion: MotionArrays) -> Iterator[MotionBlock]:
    """A motion in blocks, for the limits of its model."""
    inlets = tuple(quantities.scene.inputs)
    for rows in blocks(len(motion.time), *motion.arrays.values()):
        yield MotionBlock(motion, rows, quantities.graph, inlets)


def _thinned_shapes(motion: Motion) -> Iterator[Notice]:
    """Whether shapes were left out to keep the run's files small."""
    if motion.shape_every > 1:
        yield Notice(
            "thinned_shapes",
            f"full shapes are stored at {len(motion.shape)} of {len(motion.time)} output times "
            f"(one in {motion.shape_every} and the last; run.shape_every), the tip at all of them",
            "shape.csv",
        )


def _settings(run: Run) -> dict[str, Any]:
    equations = run.problem.equations
    return {
        "rod": equations.rod_form.value,
        "network": equations.network_form.value,
        "edges_per_section": run.settings.edges_per_section,
        "tolerance": run.settings.tolerance,
        "solver": run.solution.solver,
        "native_code": run.solution.work.native,
        "states": equations.states.count,
        "algebraic_unknowns": equations.algebraics.count,
    }


def _merged(before: Iterable[Notice], after: Iterable[Notice]) -> tuple[Notice, ...]:
    """What a run shows replaces what the scene only announced, code by code."""
    met = list(after)
    codes = {notice.code for notice in met}
    return (*(n for n in before if n.code not in codes), *met)
