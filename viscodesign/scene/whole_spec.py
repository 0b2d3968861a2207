"""A spec as a whole: where it was read from, and when it equals another one."""

from __future__ import annotations

import hashlib
from typing import Any, Self

from pydantic import BaseModel, PrivateAttr

from viscodesign.lazy_dataclass import dataclass
from viscodesign.scene.spec_part import SpecPart
from viscodesign.storage.cached_property import cached_property


@dataclass(frozen=True)
class Provenance:
    """The file that a scene was read from."""

    file: str = ""
    sha256: str = ""


class WholeSpec(SpecPart):
    """A spec with all of its sections. It equals another by its keys and values alone."""

    _source: Provenance = PrivateAttr(default_factory=Provenance)

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
