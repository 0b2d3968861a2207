"""References to the literature, as BibTeX has them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

from viscodesign.lazy_dataclass import dataclass


@dataclass(frozen=True)
class LiteratureReference:
    """One work. What of it has not been checked is left out."""

    key: str
    """Author and year, one of a kind."""
    kind: Literal["article", "book", "software"]
    fields: Mapping[str, str]
    """Fields of BibTeX, in the order in which they are written."""

    @property
    def bibtex(self) -> str:
        """The entry, several lines."""
        rows = [f"  {name} = {{{value}}}," for name, value in self.fields.items()]
        return "\n".join([f"@{self.kind}{{{self.key},", *rows, "}"])


PAPER = LiteratureReference(
    "matia2023",
    "article",
    {
        "author": "Matia, Yoav and others",
        "title": "Harnessing Nonuniform Pressure Distributions in Soft Robotic Actuators",
        "journal": "Advanced Intelligent Systems",
        "year": "2023",
    },
)
"""The paper whose model this package began with."""
