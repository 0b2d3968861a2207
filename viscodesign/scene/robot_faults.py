"""Faults of a robot's spec as a whole: sources, designs and legs against each other."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from pydantic import ValidationError
from pydantic_core import PydanticCustomError

from viscodesign.errors import did_you_mean
from viscodesign.scene.several import ActuatorDesign, SameInput, same_input_faults, unlike
from viscodesign.scene.several_faults import later_faults, own_tube_faults
from viscodesign.scene.spec_part import KeyFault, KeyPath, faults_of

if TYPE_CHECKING:
    from viscodesign.scene.robot_scene import RobotScene


def robot_faults(scene: RobotScene) -> Iterator[KeyFault]:
    """Everything that a robot of valid parts cannot be."""
    if not scene.inputs:
        yield KeyFault(("inputs",), "empty; the legs need at least one source")
    unknown = list(same_input_faults(scene.inputs))
    yield from unknown or later_faults(scene.inputs, scene.sources)
    yield from _run_faults(scene)
    yield from _pressure_faults(scene)
    yield from _unsupported(scene)
    try:
        designs = unlike(scene.actuators)
    except PydanticCustomError as error:
        yield from (f._replace(path=("actuators", *f.path)) for f in faults_of(error))
        return
    abroad = list(own_tube_faults(scene.actuators))
    yield from abroad or _design_faults(scene, designs)
    yield from _leg_faults(scene, designs)


def _run_faults(scene: RobotScene) -> Iterator[KeyFault]:
    """Keys of a run that a gait has no use for."""
    if scene.run.start != "equilibrium":
        yield KeyFault(
            ("run", "start"),
            f"'{scene.run.start}', but a robot stands at the start, or falls from "
            "robot.hip_height; remove it",
        )
    if scene.run.output_times is not None:
        yield KeyFault(
            ("run", "output_times"), "a gait is written by steps; give run.output_interval"
        )


def _pressure_faults(scene: RobotScene) -> Iterator[KeyFault]:
    for name, given in scene.inputs.items():
        if not isinstance(given, SameInput) and not given.gives_pressure:
            yield KeyFault(
                ("inputs", name, "kind"),
                "a robot's sources give pressures; use a kind such as sine or trapezoid",
            )


def _design_faults(scene: RobotScene, designs: Mapping[str, ActuatorDesign]) -> Iterator[KeyFault]:
    for name in designs:
        if scene.actuators[name].like is not None:
            continue
        try:
            scene.hanging(designs[name])
        except ValidationError as error:
            for detail in error.errors(include_url=False):
                for fault in (detail.get("ctx") or {}).get("faults", ()):
                    yield fault._replace(path=("actuators", name, *fault.path))


def _unsupported(scene: RobotScene) -> Iterator[KeyFault]:
    """What the equations of a leg do not have: a leg would be computed without it."""
    for name, own in scene.actuators.items():
        parts = {"bellows": own.bellows, "network": own.network}
        given: list[KeyPath] = [("sections",)] if own.section_changes else []
        given += [
            (part, key)
            for part, key in (
                ("bellows", "changes"),
                ("bellows", "curve"),
                ("network", "tube_wall"),
            )
            if getattr(parts[part], key, None)
        ]
        for path in given:
            yield KeyFault(
                ("actuators", name, *path),
                "a robot's legs have equal sections, linear bellows and rigid tubes; remove "
                "it. Pillars are robot.stiff_sections",
            )


def _leg_faults(scene: RobotScene, designs: Mapping[str, ActuatorDesign]) -> Iterator[KeyFault]:
    for name, leg in scene.robot.legs.items():
        place = ("robot", "legs", name)
        for key, given, known, kind in (
            ("actuator", leg.actuator, scene.actuators, "actuator"),
            ("source", leg.source, scene.inputs, "input"),
        ):
            if given not in known:
                hint = did_you_mean(given, known)
                listed = ", ".join(known)
                yield KeyFault((*place, key), f"no such {kind}{hint}; there are {listed}")
    for name in dict.fromkeys(leg.actuator for leg in scene.robot.legs.values()):
        bellows = designs[name].bellows if name in designs else None
        count = 0 if bellows is None else bellows.count // 2
        if bellows is not None and scene.robot.stiff_sections[-1:] > (count - 1,):
            yield KeyFault(
                ("robot", "stiff_sections"),
                f"actuator '{name}' has sections 1 to {count}, one of which must bend; "
                f"got {list(scene.robot.stiff_sections)}",
            )
