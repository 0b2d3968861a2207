"""`report.html`: the page put together from its parts."""

from __future__ import annotations

import base64
import hashlib
import json
from functools import cache
from pathlib import Path

from viscodesign.report.page.page_data import page_data
from viscodesign.results.findings import json_ready
from viscodesign.results.trajectory import Trajectory
from viscodesign.storage.atomic_files import write_bytes, write_errors_as_usage

ASSETS = Path(__file__).parent / "assets"
SCRIPTS = (
    "data.js",
    "svg.js",
    "actuator.js",
    "charts.js",
    "tip_path.js",
    "player.js",
    "tables.js",
    "sketch_model.js",
    "sketch.js",
    "main.js",
)
"""In the order in which they run; those before `main.js` only define functions."""


def write_page(run: Trajectory, file: str | Path) -> Path:
    """Write the page of a run, in a new folder where there is none; `Trajectory.report`.

    Raises `UsageError` where the file cannot be written.
    """
    path, content = Path(file), page_bytes(run)
    with write_errors_as_usage(path):
        path.parent.mkdir(parents=True, exist_ok=True)
    write_bytes(path, content)
    return path


def page_bytes(run: Trajectory) -> bytes:
    """The whole page: no file beside it is needed, and nothing is fetched.

    Texts of the user's are in the JSON document alone, which the browser never reads as HTML;
    the policy lets no script and no style run but those of the page.
    """
    # `<` would be where a script element may end.
    data = json.dumps(json_ready(page_data(run)), separators=(",", ":")).replace("<", "\\u003c")
    before, after = _frame()
    return before + data.encode("ascii") + after


@cache
def _frame() -> tuple[bytes, bytes]:
    """What comes before and after the data, the same for every run."""
    style = _asset("page.css")
    script = "\n".join(_asset(name) for name in SCRIPTS)
    policy = (
        f"default-src 'none'; script-src '{_digest(script)}'; style-src '{_digest(style)}'; "
        "base-uri 'none'; form-action 'none'"
    )
    text = _asset("page.html")
    for mark, part in (("policy", policy), ("style", style), ("script", script)):
        text = text.replace(f"{{{{{mark}}}}}", part)
    before, after = text.split("{{data}}")
    return before.encode(), after.encode()


def _digest(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def _asset(name: str) -> str:
    return (ASSETS / name).read_text(encoding="utf-8").strip()
