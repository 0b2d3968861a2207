"""The page of a run in a notebook: in a frame of its own, with all that it does."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tests.trajectories import made_run
from viscodesign.report.page.page import page_bytes

HOSTILE = '"></iframe><script>document.title = "broken out"</script>'


def test_the_page_runs_in_a_frame_and_reaches_nothing_else(browser: Any, tmp_path: Path) -> None:
    run = made_run(name=HOSTILE)
    shown = run.page(height=500)._repr_html_()
    notebook = tmp_path / "notebook.html"
    notebook.write_text(f"<title>notebook</title>{shown}<p>after</p>", encoding="utf-8")
    context = browser.new_context()
    page = context.new_page()
    told: list[str] = []
    page.on("console", lambda message: told.append(message.text))
    page.on("pageerror", lambda error: told.append(str(error)))
    page.goto(notebook.as_uri())
    frame = page.frames[1]
    frame.wait_for_selector("svg[data-domain] path.curve")
    assert frame.evaluate("player.row") == 0
    frame.evaluate("row => seek(player, row)", 7)
    assert frame.evaluate("player.row") == 7
    assert page.title() == "notebook"
    assert page.locator("iframe").count() == 1
    assert page.locator("iframe").bounding_box()["height"] == 500
    assert told == []
    context.close()


def test_a_frame_holds_the_same_page_as_the_file() -> None:
    run = made_run()
    assert run.page().content == page_bytes(run)
    assert repr(run.page()).startswith("<page of the run leg_made_up: 0.")
