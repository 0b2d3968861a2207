"""`markers.yaml`: which markers of recordings in space are at the clamp, and which at the tip."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from pydantic import Field, ValidationError, field_validator

from viscodesign.errors import Fault, SpecError, described
from viscodesign.scene.reading.fault_messages import explain_validation
from viscodesign.scene.reading.sources import SpecSource, read_spec
from viscodesign.scene.spec_part import KeyFault, SpecPart, invalid, raise_faults
from viscodesign.scene.tables.clamp_frame import MIN_MARKERS, are_on_a_line
from viscodesign.scene.tables.space_markers import (
    MarkerPlaces,
    TipInSpace,
    is_in_space,
    tip_in_space,
)
from viscodesign.units import Length, Time

CLAMP_FORM = "write x, y and z of each marker, such as m4: [16 mm, -25 mm, 6 mm]"


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

    @field_validator("clamp", mode="before")
    @classmethod
    def _have_three_coordinates(cls, clamp: Any) -> Any:
        if not isinstance(clamp, Mapping):
            raise invalid(f"{CLAMP_FORM}; got {described(clamp)}")
        raise_faults(
            KeyFault((str(name),), f"{CLAMP_FORM}; got {described(place)}")
            for name, place in clamp.items()
            if not isinstance(place, list | tuple) or len(place) != 3
        )
        return clamp

    @field_validator("tip", mode="before")
    @classmethod
    def _name_markers(cls, tip: Any) -> Any:
        if isinstance(tip, list | tuple) and tip and len(set(map(str, tip))) == len(tip):
            return tip
        raise invalid(f"write the markers at the tip, each once: [m2, m3]; got {described(tip)}")

    @field_validator("clamp")
    @classmethod
    def _span_a_plane(
        cls, clamp: dict[str, tuple[float, float, float]]
    ) -> dict[str, tuple[float, float, float]]:
        if len(clamp) < MIN_MARKERS or are_on_a_line(np.array(list(clamp.values()))):
            raise invalid(
                f"needs {MIN_MARKERS} markers or more that are not on one line; got {len(clamp)}"
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


def _has_content(file: Path) -> bool:
    try:
        return file.stat().st_size > 0
    except OSError:
        return False


def read_markers(source: SpecSource | MarkersFile) -> MarkersFile:
    """The markers of a file, or of a mapping. Raises `SpecError` with all faults."""
    if isinstance(source, MarkersFile):
        return source
    is_text = isinstance(source, str) and any(sign in source for sign in "\n{")
    if isinstance(source, str | Path) and not is_text and not _has_content(Path(source)):
        message = (
            "no such file, or an empty one; it says where markers are: clamp: {m4: [16 mm, -25 mm, "
            "6 mm], ...} and tip: [m2, m3], as docs/tables.md describes"
        )
        raise SpecError([Fault(message, file=str(source))])
    document = read_spec(source).document
    document.model = MarkersFile
    try:
        found = MarkersFile.model_validate(document.data)
    except ValidationError as error:
        raise SpecError([*document.faults, *explain_validation(error, document)]) from None
    if document.faults:
        raise SpecError(document.faults)
    return found
