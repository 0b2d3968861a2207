"""`TARGET.yaml`: what is free, which path the tip is to follow, and how well."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal

from pydantic import Field, ValidationError, field_validator

from viscodesign.errors import SpecError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.reading.document import Document
from viscodesign.scene.reading.fault_messages import explain_validation
from viscodesign.scene.reading.sources import SpecSource, read_spec
from viscodesign.scene.spec_part import SpecPart, invalid
from viscodesign.scene.table_file import FromFile
from viscodesign.units import Length, Time

DEFAULT_TOLERANCE = 0.15e-3
"""Root mean square distance that counts as met [m]."""
DEFAULT_BUDGET = 60.0
"""[s]"""
FREE_FORM = "write KEY: [low, high], such as network.tubes[*].length: [20 mm, 600 mm]"


class PathSpec(FromFile):
    """The path that the tip is to follow."""

    rows: tuple[tuple[float, ...], ...] | None = Field(
        None, description="Instead of a file: rows of x and z, or of time, x and z, in SI"
    )
    closed: bool | None = Field(
        None,
        description="Whether it is a loop, which becomes a limit cycle; default: by its ends, "
        "unless times count",
    )
    timing: Literal["free", "given"] | None = Field(
        None,
        description="given: at the times of the file; free: in the file's order, at any time; "
        "default: given for an open path with times",
    )
    sense: Literal["given", "any"] = Field(
        "given", description="any: the path may also be followed backwards"
    )


class TargetSpec(SpecPart):
    """A design task; the keys are those of `TARGET.yaml`."""

    spec: str = Field(min_length=1, description="The spec where the search starts")
    free: dict[str, Any] = Field(description="What may change: bounds by key of the spec")
    target: PathSpec = Field(description="The path that the tip is to follow")
    tolerance: Length = Field(
        DEFAULT_TOLERANCE, gt=0, description="Root mean square distance that counts as met"
    )
    budget: Time = Field(DEFAULT_BUDGET, gt=0, description="Time after which the search ends")

    @field_validator("free")
    @classmethod
    def _not_empty(cls, free: dict[str, Any]) -> dict[str, Any]:
        if not free:
            raise invalid(f"nothing is free; {FREE_FORM}")
        return free


@dataclass(frozen=True)
class ReadTarget:
    """A design task as it was read."""

    spec: TargetSpec
    document: Document
    folder: Path
    """To which the names of its files are relative."""


def read_target(source: SpecSource) -> ReadTarget:
    """Read a design task. Raises `SpecError` with all faults of its keys."""
    found = read_spec(source)
    document = found.document
    document.model = TargetSpec
    try:
        spec = TargetSpec.model_validate(document.data, context={"folder": found.folder})
    except ValidationError as error:
        raise SpecError([*document.faults, *explain_validation(error, document)]) from None
    if document.faults:
        raise SpecError(document.faults)
    return ReadTarget(spec, document, found.folder)
