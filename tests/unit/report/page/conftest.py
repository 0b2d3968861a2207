"""Pages opened in headless Chromium."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from viscodesign.report.page.page import write_page

PROGRAMS = ("chromium", "chromium-browser", "google-chrome")


@dataclass
class Seen:
    """What a page did besides being shown."""

    requests: list[str] = field(default_factory=list)
    messages: list[str] = field(default_factory=list)


Open = Callable[..., Any]
Write = Callable[[Any, Path], Path]


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    """Chromium; tests are skipped where it or playwright is missing."""
    playwright = pytest.importorskip(
        "playwright.sync_api", reason="needs playwright: pip install 'viscodesign[dev]'"
    )
    program = next((found for name in PROGRAMS if (found := shutil.which(name))), None)
    if program is None:
        pytest.skip("needs Chromium: apt-get install chromium")
    with playwright.sync_playwright() as driver:
        started = driver.chromium.launch(executable_path=program, args=["--no-sandbox"])
        yield started
        started.close()


@pytest.fixture
def open_page(browser: Any, tmp_path: Path) -> Iterator[Open]:
    """Opens the page of a run; no page may ask for anything, or complain."""
    seen, contexts = Seen(), []

    def opened(run: Any, width: int = 1200, write: Write = write_page, **options: Any) -> Any:
        file = write(run, tmp_path / f"page{len(contexts)}.html")
        context = browser.new_context(viewport={"width": width, "height": 800}, **options)
        contexts.append(context)
        page = context.new_page()
        page.on("request", lambda request: seen.requests.append(request.url))
        page.on("console", lambda message: seen.messages.append(message.text))
        page.on("pageerror", lambda error: seen.messages.append(str(error)))
        page.goto(file.as_uri())
        return page

    yield opened
    for context in contexts:
        context.close()
    assert [url.rpartition("/")[2] for url in seen.requests] == [
        f"page{k}.html" for k in range(len(contexts))
    ]
    assert seen.messages == []
