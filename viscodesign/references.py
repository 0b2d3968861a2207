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

    @property
    def text(self) -> str:
        """The work as a list of references has it, one line."""
        own = {name: _plain(value) for name, value in self.fields.items()}
        authors = own["author"].replace(" and others", " et al.").replace(" and ", "; ")
        volume = own.get("volume", "") + (f"({own['number']})" if "number" in own else "")
        if self.kind == "book" and volume:
            volume = f"vol. {volume}"
        place = " ".join(filter(None, (own.get("journal", own.get("publisher")), volume)))
        pages = f", {own['pages']}" if "pages" in own else ""
        doi = f", https://doi.org/{own['doi']}" if "doi" in own else ""
        return f"{authors} ({own['year']}). {own['title']}. {place}{pages}{doi}"


LETTERS = {"--": "-", "\\&": "&", '\\"a': "\u00e4", "\\ss": "\u00df", "{": "", "}": ""}
"""Marks of BibTeX, and what they stand for."""


def _plain(value: str) -> str:
    """A field without the marks of BibTeX."""
    for mark, letter in LETTERS.items():
        value = value.replace(mark, letter)
    return value


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
