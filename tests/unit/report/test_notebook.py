"""What scripts and notebooks see of a run: a line, a table, figures, a dataset."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib import pyplot

from tests.scenes import leg
from tests.studies import made_study
from tests.trajectories import made_run, with_two_inlets
from viscodesign import Trajectory
from viscodesign.errors import UsageError
from viscodesign.report.notebook import tip_svg
from viscodesign.results.findings import Notice

RUN = made_run()
SHORT = made_run(time=np.array([0.0]))
FAILED = made_run(status="failed", failure="<b>stretch</b> below 0.2")
OUTSIDE = made_run(violations=(Notice("choking", "too fast"),))
VERIFIED = replace(RUN, accuracy=replace(RUN.accuracy, estimated_tip_error_m=1.79e-4))
ALL = {"plain": RUN, "short": SHORT, "failed": FAILED, "outside": OUTSIDE, "verified": VERIFIED}


@pytest.fixture(autouse=True)
def figures() -> Iterator[None]:
    yield
    pyplot.close("all")


@pytest.mark.parametrize("name", ALL)
def test_a_run_is_one_short_line(name: str) -> None:
    line = repr(ALL[name])
    assert line.startswith("<Trajectory leg_made_up: ")
    assert len(line) < 160
    assert "\n" not in line
    assert f"{len(ALL[name].time)} times" in line


def test_the_line_says_what_the_error_is() -> None:
    assert "tip error 0.179 mm (requested 0.545 mm)" in repr(VERIFIED)
    assert "tip error not estimated" in repr(RUN)
    assert "failed" in repr(FAILED)


def test_a_study_is_one_short_line() -> None:
    assert len(repr(made_study())) < 160


class Tags(HTMLParser):
    """Checks that all tags are closed, in order."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: Any) -> None:
        if tag not in ("polyline", "circle", "img"):
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        if tag not in ("polyline", "circle", "img"):
            assert self.open.pop() == tag


@pytest.mark.parametrize("name", ALL)
def test_a_notebook_shows_a_table_and_the_path(name: str) -> None:
    page = ALL[name]._repr_html_()
    tags = Tags()
    tags.feed(page)
    assert tags.open == []
    for words in ("<table>", "<svg", "tip error", "quadrant", "included"):
        assert words in page
    assert "<b>" not in page
    assert len(page) < 20_000


def test_the_notebook_shows_what_matters() -> None:
    assert "outside of the model: choking" in OUTSIDE._repr_html_()
    assert "&lt;b&gt;stretch&lt;/b&gt; below 0.2" in FAILED._repr_html_()
    assert "warning: cavitation" in RUN._repr_html_()


def test_a_scene_is_shown_by_its_keys() -> None:
    page = leg()._repr_html_()
    for key in ("actuator.length", "network.tube_length", "effects.others", "run.duration"):
        assert f'">{key}</th>' in page


@pytest.mark.parametrize("run", [RUN, SHORT, with_two_inlets(RUN, 0.5)])
def test_the_path_in_the_picture_is_that_of_the_tip(run: Trajectory) -> None:
    picture = ElementTree.fromstring(tip_svg(run))
    words = picture.find("polyline")
    assert words is not None
    points = np.array([float(x) for x in re.findall(r"[-\d.]+", words.attrib["points"])])
    drawn = points.reshape(-1, 2) - 8.0
    tip = run.tip[:: max(1, len(run.tip) // 400), :2]
    extent = max(float(np.ptp(tip, axis=0).max()), 1e-9)
    np.testing.assert_allclose(drawn * extent / 180, tip - tip.min(axis=0), atol=0.1 * extent / 180)
    assert float(picture.attrib["width"]) <= 200


def test_figures_are_drawn_for_pyplot(tmp_path: Path) -> None:
    tip, (left, right), shapes = RUN.plot.tip(), RUN.plot.pressures(), RUN.plot.shapes()
    assert len(pyplot.get_fignums()) == 3
    assert tip.get_xlabel() == "x [mm]"
    assert left.get_title(loc="left").startswith("left column")
    assert right.get_title(loc="left").startswith("right column")
    assert shapes.figure is not tip.figure
    tip.set_title("mine")
    file = tmp_path / "tip.png"
    tip.figure.savefig(file)
    assert file.stat().st_size > 1000


def test_figures_leave_the_users_settings_alone() -> None:
    before = dict(mpl.rcParams)
    with pyplot.style.context("dark_background"):
        dark = dict(mpl.rcParams)
        axes = RUN.plot.tip()
        assert dict(mpl.rcParams) == dark
        assert axes.figure.get_facecolor() == (1.0, 1.0, 1.0, 1.0)
        assert axes.xaxis.label.get_color() == "black"
    assert dict(mpl.rcParams) == before


def test_a_dataset_has_every_quantity_with_its_unit() -> None:
    run = with_two_inlets(RUN, 0.5)
    found = run.to_xarray()
    assert dict(found.sizes) == {
        "time": 401, "inlet": 2, "bellow": 16, "tube": 16, "shape_time": 401, "arc": 65,
    }  # fmt: skip
    np.testing.assert_array_equal(found.pressure.sel(bellow="L3"), run.pressure[:, 10])
    np.testing.assert_array_equal(
        found.inlet_pressure.sel(inlet="right"), run["inlet_pressure"][:, 1]
    )
    np.testing.assert_array_equal(found.tip_x, run.tip[:, 0])
    np.testing.assert_array_equal(found.z.isel(shape_time=-1), run.shape[-1, :, 1])
    assert found.pressure.attrs["units"] == "Pa"
    assert found.pressure.attrs["reference"] == "gauge"
    assert found.time.attrs["units"] == "s"
    assert found.attrs["name"] == "leg_made_up"
    assert "junction" not in found.sizes
    assert all("units" in found[name].attrs for name in found.data_vars)


def test_without_xarray_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "xarray", None)
    with pytest.raises(UsageError, match=r"pip install 'viscodesign\[xarray\]'"):
        RUN.to_xarray()
