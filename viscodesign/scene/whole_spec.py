"""What all kinds of spec have as a whole: common keys, a source, and equality by values."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping
from dataclasses import field, replace
from typing import Annotated, Any, Literal, Self

from pydantic import (
    BaseModel,
    BeforeValidator,
    Field,
    PrivateAttr,
    ValidationInfo,
    field_validator,
)
from pydantic_core import PydanticCustomError

from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.cross_checks import SINGLE_INLET
from viscodesign.scene.fluid import Fluid
from viscodesign.scene.input import INPUT_KINDS
from viscodesign.scene.inputs.base import Surroundings
from viscodesign.scene.pressure_levels import with_levels_above
from viscodesign.scene.spec_part import KeyPath, SpecPart, faults_below, invalid
from viscodesign.scene.spec_version import SPEC_VERSION, version_problem
from viscodesign.storage.cached_property import cached_property
from viscodesign.units import AbsolutePressure, Fraction, GaugePressure, Temperature

STANDARD_TEMPERATURE = 293.15
"""[K]"""
STANDARD_ATMOSPHERE = 101325.0
"""[Pa]"""
DEFAULT_ACCURACY = 0.005
"""Default accuracy, as a part of the actuator's length."""
_DEVICE = re.compile(r"(?:con|prn|aux|nul|com[0-9]|lpt[0-9])(?:\..*)?", re.IGNORECASE)
"""Names of Windows devices, which are files in every folder, whatever stands behind a dot."""
MIN_ACCURACY = 1e-7
"""The smallest that a spec may ask for, in lengths of the actuator."""


def _by_name(given: Any) -> Any:
    """A fluid that is given by its name alone as the mapping that it stands for."""
    return {"name": given} if isinstance(given, str) else given


FluidChoice = Annotated[
    Fluid,
    BeforeValidator(_by_name),
    Field(
        alias="fluid",
        description="A named fluid, such as air or water, or a mapping of name, viscosity, density",
    ),
]
FluidTemperature = Annotated[
    Temperature, Field(gt=0, description="Temperature of fluid and surroundings")
]
Baseline = Annotated[
    GaugePressure, Field(description="Baseline gauge pressure, to which the input adds")
]
Ambient = Annotated[AbsolutePressure, Field(gt=0, description="Absolute ambient pressure")]
Accuracy = Annotated[Fraction, Field(ge=MIN_ACCURACY, le=0.2)]


@dataclass(frozen=True)
class Provenance:
    """The file that a scene was read from. It equals another whatever the lines of its keys."""

    file: str = ""
    sha256: str = ""
    places: Mapping[str, tuple[str, int | None]] = field(
        default_factory=dict, compare=False, repr=False
    )
    """File and line of the keys that were given, by their dotted paths; an override instead of a
    line."""

    def place(self, key: str) -> tuple[str, int | None]:
        """File and line of a key, or of the nearest one that holds it."""
        while key:
            if key in self.places:
                return self.places[key]
            key = key.rpartition(".")[0]
        return self.file, None


class WholeSpec(SpecPart):
    """A spec with all of its sections. It equals another by its keys and values alone.

    Keys that several kinds have in other places of their files have a type in this module.
    """

    spec: Literal[1] = Field(SPEC_VERSION, description="Version of the keys; absent: 1")
    name: str = Field(min_length=1, max_length=100, description="Name of the run and its folder")

    _source: Provenance = PrivateAttr(default_factory=Provenance)

    @field_validator("spec", mode="before")
    @classmethod
    def _known_version(cls, given: Any) -> Any:
        if problem := version_problem(given):
            raise invalid(problem)
        return given

    @field_validator("name")
    @classmethod
    def _usable_as_folder(cls, name: str) -> str:
        if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9._+-]*( [A-Za-z0-9._+-]+)*", name):
            raise invalid(f"'{name}' cannot name a folder; use letters, digits, '_', '-', '.', '+'")
        if name.endswith(".") or _DEVICE.fullmatch(name):
            raise invalid(f"'{name}' cannot name a folder on Windows; choose another name")
        return name

    @field_validator("loads", mode="before", check_fields=False)
    @classmethod
    def _no_loads(cls, given: Any) -> Any:
        return {} if given is None else given

    @field_validator("input", "several_inputs", "inputs", mode="before", check_fields=False)
    @classmethod
    def _prepared(cls, given: Any, info: ValidationInfo) -> Any:
        """The inputs with what they refer to in other keys worked in."""
        if not isinstance(given, dict):
            return given
        around = Surroundings.of(
            info.context,
            ambient=info.data.get("ambient_pressure", STANDARD_ATMOSPHERE),
            baseline=info.data.get("gauge_pressure", 0.0),
            accuracy=info.data.get("accuracy", DEFAULT_ACCURACY),
        )
        if info.field_name == "input":
            return _prepared(replace(around, inlet=SINGLE_INLET), given, ())
        return {
            name: _prepared(replace(around, inlet=str(name)), own, (str(name),))
            for name, own in given.items()
        }

    @property
    def source(self) -> Provenance:
        """The file that the spec was read from."""
        return self._source

    def with_source(self, source: Provenance) -> Self:
        """The same spec with its provenance."""
        copy = self.model_copy()
        copy._source = source
        return copy

    @cached_property
    def digest(self) -> bytes:
        """SHA-256 of all of its keys and values, tables included: equal for equal specs alone."""
        return hashlib.sha256(BaseModel.__repr__(self).encode()).digest()

    def __eq__(self, other: Any) -> bool:
        """Whether the other has the same keys and values, wherever it was read from."""
        if not isinstance(other, WholeSpec):
            return NotImplemented
        return type(self) is type(other) and self.digest == other.digest

    def __hash__(self) -> int:
        return hash(self.digest)

    def __str__(self) -> str:
        return repr(self)


def _prepared(around: Surroundings, given: Any, path: KeyPath) -> Any:
    """An input as given, with its absolute levels above the baseline, and its file read."""
    kind = given.get("kind") if isinstance(given, dict) else None
    if not isinstance(kind, str) or kind not in INPUT_KINDS:
        return given
    own, baseline = INPUT_KINDS[kind], around.ambient + around.baseline
    try:
        return own.prepared(with_levels_above(baseline, own, given), around)
    except PydanticCustomError as error:
        raise faults_below(path, error) from None
