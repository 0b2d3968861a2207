"""Figure 1's plane: every spec is on it, named, and nothing hides anything."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import combinations
from pathlib import Path

import pytest
from matplotlib.figure import Figure

from tests.trajectories import CLASSIFICATION
from tests.unit.report.charts.conftest import words
from viscodesign.errors import UsageError
from viscodesign.report.charts.quadrants import draw_plane, power_of_ten
from viscodesign.report.layout.label_placement import place_labels, text_box
from viscodesign.results.findings import Classification, Scales


def spec(name: str, t_f: float, t_i: float, t_s: float = 1.0) -> Classification:
    return replace(CLASSIFICATION, name=name, scales=Scales(t_s, t_f, t_i, 1.0))


def markers(figure: Figure) -> list[str]:
    return [
        str(line.get_marker())
        for line in figure.axes[0].lines
        if line.get_marker() not in ("None", "")
    ]


def assert_on_page(figure: Figure) -> None:
    box = figure.get_tightbbox()
    width, height = figure.get_size_inches()
    assert min(box.x0, box.y0) >= -0.01
    assert box.x1 <= width + 0.01
    assert box.y1 <= height + 0.01


def test_four_quadrants_and_few_specs_by_name(figures: list[Figure], tmp_path: Path) -> None:
    draw_plane([spec("slow", 100, 50), spec("fast", 0.1, 0.1)], tmp_path / "plane.png")
    found = words(figures[0])
    assert {"slow", "fast"} <= set(found)
    for quadrant in ("I  ", "II  ", "III  ", "IV  "):
        assert any(text.startswith(quadrant) for text in found)
    assert_on_page(figures[0])


def test_specs_at_one_place_share_a_label(figures: list[Figure], tmp_path: Path) -> None:
    draw_plane([spec("a", 10, 10), spec("b", 10, 10.1)], tmp_path / "plane.png")
    assert "a\nb" in words(figures[0])
    assert markers(figures[0]) == ["o"]


def test_specs_at_two_places_are_two_marks(figures: list[Figure], tmp_path: Path) -> None:
    told = ["1 of 2 statements agree", "DIFFERS: t_i = 0.74 s: 0.67 s"]
    specs = [spec("a", 10, 10), spec("b", 10, 11.1)]
    draw_plane(specs, tmp_path / "plane.png", told=told)
    assert markers(figures[0]) == ["o", "o"]
    assert {"a", "b", *told} <= set(words(figures[0]))
    assert_on_page(figures[0])


def test_what_lies_outside_is_an_arrow_at_the_edge(figures: list[Figure], tmp_path: Path) -> None:
    draw_plane(
        [
            spec("constant", 10, math.inf),
            spec("jump", 10, 0.0),
            spec("blocked", math.inf, 1),
            spec("free", 0.0, 1),
            spec("absurd", 1e30, 1),
        ],
        tmp_path / "plane.png",
    )
    assert sorted(markers(figures[0])) == ["<", ">", "^", "v"]
    assert_on_page(figures[0])


def test_many_specs_are_numbered_with_a_key(figures: list[Figure], tmp_path: Path) -> None:
    many = [spec(f"spec_{k}", 10 ** (k / 3), 10 ** (k % 5)) for k in range(20)]
    draw_plane(many, tmp_path / "plane.png")
    assert {f"spec_{k}" for k in range(20)} <= set(words(figures[0]))
    assert {str(k + 1) for k in range(20)} <= set(words(figures[0]))
    assert_on_page(figures[0])


@pytest.mark.parametrize("count", [0, 1, 100])
def test_any_number_of_specs(figures: list[Figure], tmp_path: Path, count: int) -> None:
    names = "a $name$ \N{PILE OF POO} that is rather long and goes on and on"
    draw_plane([spec(f"{k} {names}", 1.1**k, 1.2**k) for k in range(count)], tmp_path / "p.png")
    assert_on_page(figures[0])


@pytest.mark.parametrize("ending", ["png", "pdf", "svg", "PNG"])
def test_the_suffix_selects_the_format(tmp_path: Path, ending: str) -> None:
    draw_plane([CLASSIFICATION], tmp_path / f"plane.{ending}")
    start = (tmp_path / f"plane.{ending}").read_bytes()[:5]
    assert start in (b"\x89PNG\r", b"%PDF-", b"<?xml")


def test_a_folder_at_the_path_of_the_picture_is_refused(tmp_path: Path) -> None:
    (tmp_path / "plane.png").mkdir()
    with pytest.raises(UsageError, match=r"plane\.png: Is a directory"):
        draw_plane([CLASSIFICATION], tmp_path / "plane.png")
    assert [file.name for file in tmp_path.iterdir()] == ["plane.png"]


def test_labels_hide_neither_points_nor_each_other() -> None:
    points = [(0.5 + 0.03 * (k % 3), 0.5 + 0.03 * (k // 3)) for k in range(6)]
    texts = [f"label_{k}" for k in range(6)]
    labels = place_labels(points, texts, [], size=8.0, side=4.6)
    boxes = [
        text_box(label.text, (label.x, label.y), label.across, label.upright, 8.0, 4.6)
        for label in labels
    ]
    assert all(a.overlap(b) == 0 for a, b in combinations(boxes, 2))
    for box in boxes:
        assert not any(box.left < x < box.right and box.bottom < y < box.top for x, y in points)


def test_powers_of_ten() -> None:
    assert [power_of_ten(k) for k in (-12, 0, 3)] == ["10⁻¹²", "10⁰", "10³"]
