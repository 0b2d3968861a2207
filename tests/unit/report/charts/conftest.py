"""Pictures as they were saved."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
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


Save = Callable[[Callable[[Any, Path], object], Any], Figure]


@pytest.fixture
def save(tmp_path: Path, figures: list[Figure]) -> Save:
    """Draws a subject into a file, and returns the figure as it was saved."""

    def saved(draw: Callable[[Any, Path], object], subject: Any) -> Figure:
        path = tmp_path / "picture.png"
        draw(subject, path)
        assert path.read_bytes().startswith(b"\x89PNG")
        return figures[-1]

    return saved


def words(figure: Figure) -> list[str]:
    """Everything that is written in a figure."""
    texts: list[Text] = figure.findobj(Text)
    return [text.get_text() for text in texts]


def assert_on_page(figure: Figure) -> None:
    """All that is drawn lies on the page, and no formula is left unset."""
    box, size = figure.get_tightbbox(), figure.get_size_inches()
    assert box.x0 >= -0.01
    assert box.y0 >= -0.01
    assert box.x1 <= size[0] + 0.01
    assert box.y1 <= size[1] + 0.01
    assert not any("mathdefault" in text for text in words(figure))
