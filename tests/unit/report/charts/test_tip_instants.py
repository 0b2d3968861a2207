"""Times at the shapes of the tip's picture: each once, on the page, none over another."""

from __future__ import annotations

import re
from itertools import combinations

import pytest
from matplotlib.text import Text

from tests.trajectories import made_run
from tests.unit.report.cases import CASES
from tests.unit.report.charts.conftest import Save, assert_on_page
from viscodesign.report.charts.tip import MAX_INSTANTS, draw_tip
from viscodesign.report.layout.snapshots import spread_instants

RUNS = {
    "leg": made_run,
    "small": lambda: made_run(bending=0.2),
    "failed": CASES["failed"],
    "one_time": CASES["one_time"],
}


@pytest.mark.parametrize("name", RUNS)
def test_every_shape_has_its_time(save: Save, name: str) -> None:
    run = RUNS[name]()
    figure = save(draw_tip, run)
    times = [t for t in figure.findobj(Text) if re.fullmatch(r"[\d.]+ s", t.get_text())]
    rows = run.shape_rows[spread_instants(run, MAX_INSTANTS)]
    told = sorted(float(text.get_text()[:-2]) for text in times)
    assert told == pytest.approx(sorted(run.time[rows]), abs=0.006)
    boxes = [text.get_window_extent() for text in times]
    assert not any(one.overlaps(other) for one, other in combinations(boxes, 2))
    assert_on_page(figure)
