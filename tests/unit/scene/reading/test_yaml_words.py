"""Merge keys, keys of one's own, tabs, and numbers that are none."""

from __future__ import annotations

import io
from typing import Any

import pytest
import yaml

from tests.scenes import CONFIGS, leg
from viscodesign import load
from viscodesign.errors import SpecError
from viscodesign.scene.reading.document import read_document

GOOD = (CONFIGS / "leg_16_straight_air.yaml").read_text()


def keys(text: str) -> dict[str, Any]:
    document = read_document(text.encode(), "leg.yaml")
    assert document.faults == []
    return document.data


MERGES = [
    "a: &a {x: 1, y: 2}\nb: {<<: *a}",
    "a: &a {x: 1, y: 2}\nb: {<<: *a, x: 3}",
    "a: &a {x: 1, y: 2}\nb: {x: 3, <<: *a}",
    "a: &a {x: 1, y: 2}\nb: {<<: {x: 5}, z: 1}",
    "a: &a {x: 1}\nb: &b {x: 2, y: 2}\nc: {<<: [*a, *b], z: 3}",
    "a: &a {x: 1}\nb: &b {<<: *a, y: 2}\nc:\n  <<: *b\n  z: 3",
    "a: &a {x: {u: 1, v: 2}}\nb: {<<: *a, x: {u: 3}}",
    "a: &a {x: [1, 2]}\nb:\n- <<: *a\n- <<: *a\n  x: 3",
    "a: &a {x: 1}\nb: {'<<': 1, z: 2}",
]


@pytest.mark.parametrize("text", MERGES)
def test_merge_keys_are_read_as_by_yaml(text: str) -> None:
    assert keys(text) == yaml.safe_load(text)


@pytest.mark.parametrize(
    ("value", "words"),
    [("3", "'<<' merges mappings"), ("word", "such as '*base'"), ("[*a, 3]", "or a list of them"), ("", "'<<' merges"), ("*none", "undefined alias")],
)  # fmt: skip
def test_only_mappings_are_merged(value: str, words: str) -> None:
    with pytest.raises(SpecError) as caught:
        load(f"x-a: &a {{length: 1 mm}}\nactuator:\n  <<: {value}\n")
    assert words in str(caught.value)
    assert "<text>:3" in str(caught.value)


def test_a_merged_value_is_told_where_it_stands() -> None:
    text = GOOD.replace("actuator:\n", "x-size: &size {height: 3 kg}\nactuator:\n  <<: *size\n", 1)
    text = text.replace("  height: 30 mm", "# gone", 1)
    line = 1 + text.splitlines().index("x-size: &size {height: 3 kg}")
    with pytest.raises(SpecError, match=rf"<text>:{line}: actuator\.height: '3 kg' is a mass"):
        load(text)


def test_a_replaced_value_is_told_where_the_new_one_stands() -> None:
    text = GOOD.replace("actuator:\n", "x-size: &size {height: 1 mm}\nactuator:\n  <<: *size\n", 1)
    text = text.replace("  height: 30 mm", "  height: 3 kg", 1)
    line = 1 + next(
        k for k, words in enumerate(text.splitlines()) if words.startswith("  height: 3 kg")
    )
    with pytest.raises(SpecError, match=rf"<text>:{line}: actuator\.height"):
        load(text)


def test_a_mapping_cannot_merge_itself() -> None:
    with pytest.raises(SpecError, match="nested too deeply"):
        load("a: &a {<<: *a}\n")


def test_merging_many_times_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("viscodesign.scene.reading.document.MAX_NODES", 4000)
    lines = ["a0: &a0 {x: 1}"]
    lines += [f"a{k}: &a{k} {{<<: [{', '.join([f'*a{k - 1}'] * 9)}]}}" for k in range(1, 12)]
    with pytest.raises(SpecError, match="too large once its aliases are expanded"):
        load("\n".join(lines))


@pytest.mark.parametrize(
    "value", ["1", "{a: 1, b: [1, 2]}", "&size {length: 1 mm}", "[]", "", "text"]
)
def test_keys_of_ones_own_are_ignored(value: str) -> None:
    assert load(f"{GOOD}\nx-mine: {value}\n").digest == leg().digest


@pytest.mark.parametrize("key", ["xmine", "X-mine", "_x-mine", "-x"])
def test_others_are_not(key: str) -> None:
    with pytest.raises(SpecError, match=f"{key}: no such key"):
        load(f"{GOOD}\n{key}: 1\n")


def test_they_are_for_the_top_alone() -> None:
    told = r"actuator\.x-mine: no such key; keys that begin with 'x-' are ignored at the top level"
    with pytest.raises(SpecError, match=told):
        load(GOOD.replace("actuator:\n", "actuator:\n  x-mine: 1\n", 1))


@pytest.mark.parametrize(
    "text",
    [
        "a:\n\tb: 1\n",
        "a:\n  b: 1\n\tc: 2\n",
        "a:\n \tb: 1\n",
        "\ta: 1\n",
        "a:\n- b: 1\n\t  c: 2\n",
    ],
)
def test_a_tab_is_told_as_a_tab(text: str) -> None:
    with pytest.raises(
        SpecError, match="indented with a tab, which YAML does not allow; use spaces"
    ):
        load(text)


def test_a_tab_elsewhere_is_no_matter() -> None:
    assert load(GOOD.replace("length: 109 mm", "length:\t109 mm\t# one", 1)).digest == leg().digest


@pytest.mark.parametrize("word", [".inf", "-.inf", ".nan", ".Inf", ".NaN", "+.INF"])
@pytest.mark.parametrize("key", ["actuator.length", "loads.payload", "run.max_steps", "accuracy"])
def test_numbers_that_are_none_are_told_as_such(word: str, key: str) -> None:
    with pytest.raises(SpecError) as caught:
        load(io.StringIO(GOOD), [f"{key}={word}"])
    value = float(word.replace(".", "", 1))
    assert f"{value!r}" in str(caught.value)
    assert "finite" in str(caught.value) or "expected an integer" in str(caught.value)
