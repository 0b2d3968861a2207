"""Pictures as they were saved."""

from __future__ import annotations

from typing import Any

import pytest
from matplotlib.figure import Figure
from matplotlib.text import Text

from viscodesign.report.layout.style import RC


@pytest.fixture
def figures(monkeypatch: pytest.MonkeyPatch) -> list[Figure]:
    """The figures that were saved, at a low resolution."""
    kept: list[Figure] = []
    save = Figure.savefig

    def keep(figure: Figure, *words: Any, **options: Any) -> None:
        kept.append(figure)
        save(figure, *words, **options)

    monkeypatch.setattr(Figure, "savefig", keep)
    monkeypatch.setitem(RC, "savefig.dpi", 40)
    return kept


def words(figure: Figure) -> list[str]:
    """Everything that is written in a figure."""
    texts: list[Text] = figure.findobj(Text)
    return [text.get_text() for text in texts]
