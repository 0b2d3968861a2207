"""`markers.yaml`: which markers of recordings in space are at the clamp, and which at the tip."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from pydantic import Field, ValidationError, field_validator

from viscodesign.errors import Fault, SpecError
from viscodesign.scene.reading.fault_messages import explain_validation
from viscodesign.scene.reading.sources import SpecSource, read_spec
from viscodesign.scene.spec_part import SpecPart, invalid
from viscodesign.scene.tables.clamp_frame import FEWEST_MARKERS, are_on_a_line
from viscodesign.scene.tables.space_markers import (
    MarkerPlaces,
    TipInSpace,
    is_in_space,
    tip_in_space,
)
from viscodesign.units import Length, Time


class MarkersFile(SpecPart):
    """What is said of recordings in space."""

    clamp: dict[str, tuple[Length, Length, Length]] = Field(
        description="Markers at the clamp: x, y, z in the actuator's frame, right-handed, "
        "x in the plane of motion, z from the clamp along the actuator"
    )
    tip: tuple[str, ...] = Field(
        min_length=1, description="Markers whose mean is the middle of the tip"
    )
    time_zero: Time | dict[str, Time] | None = Field(
        None, description="Time of a recording at which the run begins, or one by file name"
    )
    tip_before: tuple[Length, Length] | None = Field(
        None, description="x and z of the tip in the rows before time_zero"
    )

    @field_validator("clamp")
    @classmethod
    def _span_a_plane(
        cls, clamp: dict[str, tuple[float, float, float]]
    ) -> dict[str, tuple[float, float, float]]:
        if len(clamp) < FEWEST_MARKERS or are_on_a_line(np.array(list(clamp.values()))):
            raise invalid(
                f"needs {FEWEST_MARKERS} markers or more that are not on one line; got {len(clamp)}"
            )
        return clamp

    def places_for(self, file: str) -> MarkerPlaces:
        """What holds for a recording. Raises `SpecError` where no time zero is given for it."""
        zero = self.time_zero
        if isinstance(zero, dict):
            stem = Path(file).stem
            if stem not in zero:
                known = ", ".join(zero) or "none"
                message = f"has no time for {stem}, of {file}; it has {known}"
                raise SpecError([Fault(message, "time_zero")])
            zero = zero[stem]
        return MarkerPlaces(self.clamp, self.tip, zero, self.tip_before)


def recorded_tip(
    header: Sequence[str], file: str, markers: MarkersFile | None
) -> TipInSpace | None:
    """The tip of a recording with this header; None where its markers are in the plane already.

    Raises `SpecError` for a recording in space of whose markers nothing is said.
    """
    if not is_in_space(header):
        return None
    if markers is None:
        message = (
            "is a recording in space, with x, y and z of its markers; say with --markers FILE "
            "(markers= in Python) which of them are at the clamp and which at the tip"
        )
        raise SpecError([Fault(message, file=file)])
    return tip_in_space(file, markers.places_for(file))


def read_markers(source: SpecSource | MarkersFile) -> MarkersFile:
    """The markers of a file, or of a mapping. Raises `SpecError` with all faults."""
    if isinstance(source, MarkersFile):
        return source
    document = read_spec(source).document
    document.model = MarkersFile
    try:
        found = MarkersFile.model_validate(document.data)
    except ValidationError as error:
        raise SpecError([*document.faults, *explain_validation(error, document)]) from None
    if document.faults:
        raise SpecError(document.faults)
    return found
