"""What a notebook shows of a scene or a run: tables and a picture, as HTML."""

from __future__ import annotations

import html
from collections.abc import Iterable
from typing import Any

from viscodesign.scene.reading.write import plain_part
from viscodesign.scene.scene import Scene

MOST_SHOWN = 200
"""Characters of a value: a table of measured rows is not listed."""


def scene_html(scene: Scene) -> str:
    """The resolved spec, a row for each key."""
    return _table(repr(scene), _rows(plain_part(scene)))


def _rows(keys: dict[str, Any], above: str = "") -> Iterable[tuple[str, str]]:
    for key, value in keys.items():
        if isinstance(value, dict):
            yield from _rows(value, f"{above}{key}.")
        else:
            yield f"{above}{key}", str(value)


def _table(title: str, rows: Iterable[tuple[str, str]]) -> str:
    lines = [f"<tr><th>{_shown(key)}</th><td>{_shown(value)}</td></tr>" for key, value in rows]
    return f"<table><caption>{_shown(title)}</caption>{''.join(lines)}</table>"


def _shown(text: str) -> str:
    short = text if len(text) <= MOST_SHOWN else f"{text[: MOST_SHOWN - 4]} ..."
    return html.escape(short)
