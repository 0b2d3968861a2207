"""Single values of a spec are replaced in its file, and nothing else changes."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from viscodesign.errors import UsageError
from viscodesign.scene.reading.edit import with_values, write_values

VALUES = {"home": "300", "travel": "[90, 1000]"}


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("pump:\n  home: 1  # counts\n  servo: ax18a\n  travel: [1, 2] # ends\n",
         "pump:\n  home: 300  # counts\n  servo: ax18a\n  travel: [90, 1000] # ends\n"),
        ("a: 1\npump: # drive\n    servo: ax18a\nrun: 2\n",
         "a: 1\npump: # drive\n    home: 300\n    travel: [90, 1000]\n    servo: ax18a\nrun: 2\n"),
        ("pump: {servo: ax18a, travel: [1, 2]}\n",
         "pump: {home: 300, servo: ax18a, travel: [90, 1000]}\n"),
        ("pump:\n  travel:\n    - 1\n    - 2 # full\n  home: 'x'\nrun: 2\n",
         "pump:\n  travel:\n    [90, 1000] # full\n  home: 300\nrun: 2\n"),
        ("b: {pump: {home: 1}}\npump:\n  home: 4\n  travel: &t [1, 2]\n",
         "b: {pump: {home: 1}}\npump:\n  home: 300\n  travel: [90, 1000]\n"),
    ],
)  # fmt: skip
def test_values_are_replaced_or_added(before: str, after: str) -> None:
    found = with_values(before, "pump", VALUES)
    assert found.replace("&t ", "") == after
    pump = yaml.safe_load(found)["pump"]
    assert (pump["home"], pump["travel"]) == (300, [90, 1000])


@pytest.mark.parametrize("text", ["name: leg\n", "pump:\n", "pump: on\n", "x: {pump: {home: 1}}\n"])
def test_a_spec_without_the_section_is_refused(text: str) -> None:
    with pytest.raises(UsageError, match="no section `pump:`"):
        with_values(text, "pump", VALUES)


def test_line_endings_and_byte_order_mark_are_kept(tmp_path: Path) -> None:
    file = tmp_path / "leg.yaml"
    file.write_bytes("\ufeffname: é\r\npump:\r\n  home: 1\r\n  travel: [1, 2]\r\n".encode())
    write_values(file, "pump", VALUES)
    found = "\ufeffname: é\r\npump:\r\n  home: 300\r\n  travel: [90, 1000]\r\n"
    assert file.read_bytes().decode() == found
