"""The page of ten designs: its targets are tasks, and what is refused is refused at once."""

from __future__ import annotations

import importlib
from types import ModuleType

import pytest

from tests.scenes import ROOT

DOCS = ROOT / "docs"


@pytest.fixture
def page(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(DOCS)
    return importlib.import_module("make_designs")


def test_there_are_ten_and_the_page_has_a_row_for_each(page: ModuleType) -> None:
    rows = (DOCS / "designs.md").read_text(encoding="utf-8").splitlines()
    assert len(page.TARGETS) == 10
    for target in page.TARGETS:
        assert sum(row.startswith(f"| {target.name} | {target.words} |") for row in rows) == 1


@pytest.mark.parametrize(
    ("name", "why"),
    [("circle, counter-clockwise", "wrong sense"), ("circle that is too far", "32.5 mm too far")],
)
def test_what_no_numbers_can_follow_is_refused(page: ModuleType, name: str, why: str) -> None:
    (target,) = (own for own in page.TARGETS if own.name == name)
    found = page.designed(target)
    assert found.status == "refused"
    assert why in page.reason(found)
