"""The page of licences lists what the program can install, and agrees with what is installed."""

from __future__ import annotations

import re
import tomllib
from importlib.metadata import PackageNotFoundError, metadata

from tests.scenes import ROOT

ROW = re.compile(r"^\| (\S+) \| ([^|]+?) \| (?:`(\w+)` )?\|$", re.MULTILINE)
NOT_LISTED = {"dev", "peers"}
"""Extras of those who develop and compare, about which the page has a sentence."""


def listed() -> dict[str, tuple[str, str]]:
    page = (ROOT / "docs" / "licences.md").read_text(encoding="utf-8")
    return {name: (licence, extra) for name, licence, extra in ROW.findall(page)}


def test_every_dependency_is_listed_under_its_extra() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    groups = {"": project["dependencies"], **project["optional-dependencies"]}
    wanted = {
        (re.split(r"[^\w.-]", word)[0], extra)
        for extra, words in groups.items()
        for word in words
        if extra not in NOT_LISTED
    }
    assert {(name, extra) for name, (_, extra) in listed().items()} == wanted


def test_what_packages_state_of_themselves_is_on_the_page() -> None:
    checked = 0
    for name, (licence, _) in listed().items():
        try:
            told = metadata(name).get("License-Expression")
        except PackageNotFoundError:
            continue
        if told and " " not in told:
            assert licence == told, name
            checked += 1
    assert checked >= 5
