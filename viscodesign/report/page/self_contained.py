"""HTML pages that need no file beside them and fetch nothing."""

from __future__ import annotations

import base64
import hashlib
import json
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from viscodesign.results.findings import json_ready
from viscodesign.storage.atomic_files import write_bytes, write_errors_as_usage

ASSETS = Path(__file__).parent / "assets"
STYLE = "page.css"
FRAME, PLAYER = "frame.html", "player.html"
"""What every page has around its body, and what bodies put at `{{player}}`."""


def write_html(path: Path, content: bytes) -> Path:
    """Write a page, in a new folder where there is none; returns its path.

    Raises `UsageError` where the file cannot be written.
    """
    with write_errors_as_usage(path):
        path.parent.mkdir(parents=True, exist_ok=True)
    write_bytes(path, content)
    return path


def self_contained(template: str, scripts: tuple[str, ...], data: Mapping[str, Any]) -> bytes:
    """A whole page: a template of `assets` in the common frame, its scripts in order, and its data.

    The first line of a template is its title, the others are its body. Texts of the user's
    are in the JSON document alone, which the browser never reads as HTML; the policy lets no script
    and no style run but those of the page.
    """
    # `<` would be where a script element may end.
    text = json.dumps(json_ready(dict(data)), separators=(",", ":")).replace("<", "\\u003c")
    before, after = _frame(template, scripts)
    return before + text.encode("ascii") + after


@cache
def _frame(template: str, scripts: tuple[str, ...]) -> tuple[bytes, bytes]:
    """What comes before and after the data, the same for every page of a kind."""
    style = _asset(STYLE)
    script = "\n".join(_asset(name) for name in scripts)
    policy = (
        f"default-src 'none'; script-src '{_digest(script)}'; style-src '{_digest(style)}'; "
        "base-uri 'none'; form-action 'none'"
    )
    title, body = _asset(template).split("\n", 1)
    text = _asset(FRAME)
    for mark, part in (
        *(("title", title), ("body", body), ("player", _asset(PLAYER))),
        *(("policy", policy), ("style", style), ("script", script)),
    ):
        text = text.replace(f"{{{{{mark}}}}}", part)
    before, after = text.split("{{data}}")
    return before.encode(), after.encode()


def _digest(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def _asset(name: str) -> str:
    return (ASSETS / name).read_text(encoding="utf-8").strip()
