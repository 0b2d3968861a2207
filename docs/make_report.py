"""Make `docs/leg.webp`, `docs/tip.png` and `docs/report.png`: a film, a path and a page of legs.

Run `python docs/make_report.py`; it needs playwright and Chromium (`pip install -e '.[dev]'`,
`apt-get install chromium`).
"""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from playwright.sync_api import sync_playwright

from viscodesign import load, simulate
from viscodesign.report.charts.tip import draw_tip

DOCS = Path(__file__).parent
CONFIGS = DOCS.parent / "configs"
SHARE = 0.25
"""Part of the motion after which a picture shows the page of its run."""
VIEW = {"width": 1180, "height": 960}


def screenshot(page_file: Path, picture: Path, view: Mapping[str, int]) -> None:
    """The top of the page of a run, as a browser shows it."""
    program = shutil.which("chromium") or shutil.which("google-chrome")
    with sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=program, args=["--no-sandbox"])
        size: Any = dict(view)
        page = browser.new_page(viewport=size)
        page.goto(page_file.as_uri())
        page.evaluate("share => seek(player, Math.round(share * player.last))", SHARE)
        page.screenshot(path=picture)
        browser.close()


def main() -> None:
    """All files."""
    draw_tip(simulate(load(CONFIGS / "leg.yaml")), DOCS / "tip.png")
    run = simulate(load(CONFIGS / "leg_16_crossed_air_auto.yaml"))
    run.film(DOCS / "leg.webp", width=720, frames_per_second=10, speed=1.0)
    with tempfile.TemporaryDirectory() as folder:
        screenshot(run.report(Path(folder) / "report.html"), DOCS / "report.png", VIEW)


if __name__ == "__main__":
    main()
