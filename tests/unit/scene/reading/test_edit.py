"""Single values of a spec are replaced in its file, and nothing else changes."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from viscodesign.errors import UsageError
from viscodesign.scene.reading.edit import with_value, with_values, write_values

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


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_line_endings_and_byte_order_mark_are_kept(tmp_path: Path, encoding: str) -> None:
    file = tmp_path / "leg.yaml"
    text = "name: é\r\npump:\r\n  home: 1\r\n  travel: [1, 2]\r\n"
    file.write_bytes(text.encode(encoding))
    write_values(file, "pump", VALUES)
    found = "name: é\r\npump:\r\n  home: 300\r\n  travel: [90, 1000]\r\n"
    assert file.read_bytes() == found.encode(encoding)


@pytest.mark.parametrize(
    ("before", "key", "value", "after"),
    [
        ("a: 1 # one\nb: 2\n", "a", "3", "a: 3 # one\nb: 2\n"),
        ("a: 1\n", "b", "2 m", "a: 1\n\nb: 2 m\n"),
        ("a:\n  b: 1  # one\n", "a.b", "2", "a:\n  b: 2  # one\n"),
        ("a:\n  b: 1\nc: 4\n", "a.d", "2", "a:\n  d: 2\n  b: 1\nc: 4\n"),
        ("a: {b: 1}\n", "a.d", "2", "a: {d: 2, b: 1}\n"),
        ("a:\n  g: on # hangs\n", "a.g.tilt", "1", "a:\n  g: {tilt: 1} # hangs\n"),
        ("a:\n  b: 1\n", "a.x.y.z", "{w: 1}", "a:\n  x: {y: {z: {w: 1}}}\n  b: 1\n"),
        ("a: 1\n", "x.y", "2", "a: 1\n\nx: {y: 2}\n"),
        ("a: {}\n", "a.b", "1", "a: {b: 1}\n"),
    ],
)  # fmt: skip
def test_one_value_is_set_wherever_it_is(before: str, key: str, value: str, after: str) -> None:
    found = with_value(before, key.split("."), value)
    assert found == after
    here = yaml.safe_load(found)
    for part in key.split("."):
        here = here[part]
    assert here == yaml.safe_load(value)
