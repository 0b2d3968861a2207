"""From the spec of a robot to its scene; all faults of the file are reported at once."""

from __future__ import annotations

from typing import TypeVar

from pydantic import ValidationError

from viscodesign.errors import Fault, SpecError, did_you_mean
from viscodesign.scene.effects_choice import KnownEffects
from viscodesign.scene.reading.document import ROBOT_KEY
from viscodesign.scene.reading.fault_messages import explain_validation
from viscodesign.scene.reading.read import (
    Overrides,
    apply_overrides,
    context_of,
    in_order,
    read_keys,
    refuse_other_version,
    with_provenance,
)
from viscodesign.scene.reading.sources import ReadSpec
from viscodesign.scene.robot_scene import RobotScene
from viscodesign.scene.spec_part import SpecPart


def is_robot(spec: ReadSpec) -> bool:
    """Whether a spec is one of a robot."""
    return ROBOT_KEY in spec.document.data


_INSTEAD = "`viscodesign simulate`, `check` and `classify` take specs without one"
"""What takes a spec that has no robot."""


def robot_of(
    spec: ReadSpec, overrides: Overrides = (), known: KnownEffects | None = None
) -> RobotScene:
    """The robot of a spec with some keys overridden. Raises `SpecError` with all faults."""
    if not is_robot(spec):
        file, _ = spec.document.place((ROBOT_KEY,))
        slips = [key for key in spec.document.data if did_you_mean(key, [ROBOT_KEY])]
        meant = f" ('{slips[0]}' is none)" if slips else ""
        message = f"not a robot: no key '{ROBOT_KEY}'{meant}; {_INSTEAD}"
        raise SpecError([Fault(message, file=file)])
    return with_provenance(read_as(RobotScene, spec, overrides, known), spec)


PartT = TypeVar("PartT", bound=SpecPart)


def read_as(
    model: type[PartT], spec: ReadSpec, overrides: Overrides, known: KnownEffects | None
) -> PartT:
    """A spec read into a model of its own. Raises `SpecError` with all faults."""
    document = spec.document
    document.model = model
    apply_overrides(document, overrides)
    refuse_other_version(document)
    try:
        found = model.model_validate(read_keys(document), context=context_of(spec, known))
    except ValidationError as error:
        faults = explain_validation(error, document)
        raise SpecError(in_order([*document.faults, *faults])) from None
    if document.faults:
        raise SpecError(in_order(document.faults))
    return found
