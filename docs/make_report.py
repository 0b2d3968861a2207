"""Make `docs/leg.webp` and `docs/report.png`: a film of the paper's leg, and the page of its run.

Run `python docs/make_report.py`; it needs playwright and Chromium (`pip install -e '.[dev]'`,
`apt-get install chromium`).
"""

from __future__ import annotations

import shutil
import tempfile
from pathlib import Path

from playwright.sync_api import sync_playwright

from viscodesign import Trajectory, load, simulate

DOCS = Path(__file__).parent
SPEC = DOCS.parent / "configs" / "leg_16_crossed_air_auto.yaml"
INSTANT = 100
"""Row that the picture of the page shows."""
VIEW = {"width": 1180, "height": 960}


def picture(run: Trajectory, file: Path) -> None:
    """The top of the page of a run, as a browser shows it."""
    program = shutil.which("chromium") or shutil.which("google-chrome")
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as driver:
        page_file = run.report(Path(folder) / "report.html")
        browser = driver.chromium.launch(executable_path=program, args=["--no-sandbox"])
        page = browser.new_page(viewport=VIEW)
        page.goto(page_file.as_uri())
        page.evaluate("row => seek(player, row)", INSTANT)
        page.screenshot(path=file)
        browser.close()


def main() -> None:
    """Both files."""
    run = simulate(load(SPEC))
    run.film(DOCS / "leg.webp", width=560, frames_per_second=10, speed=1.0)
    picture(run, DOCS / "report.png")


if __name__ == "__main__":
    main()
