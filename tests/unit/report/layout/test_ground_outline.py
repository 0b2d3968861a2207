"""The ground as it is drawn: every point of its line lies on the surface."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import simulate
from viscodesign.report.ground_outline import ground_outline
from viscodesign.scene.ground import Ground

PLACE = "input={kind: constant, value: 0}"


def stated(text: str) -> Ground:
    ground = leg(f"loads.ground={text}").loads.ground
    assert ground is not None
    return ground


def test_a_line_is_drawn_where_it_stands() -> None:
    line = ground_outline(
        stated("{kind: line, point: {x: 10 mm}, normal: -90 deg, friction: 0}"), 0.2
    )
    assert line == pytest.approx(np.array([[0.01, -0.2], [0.01, 0.2]]))
    floor = ground_outline(
        stated("{kind: line, point: {z: 12 cm}, normal: 180 deg, friction: 0}"), 0.2
    )
    assert floor[:, 1] == pytest.approx(0.12)


def test_a_circle_is_drawn_around_its_centre() -> None:
    text = "{kind: circle, centre: {x: 4 cm, z: 5 cm}, radius: 1 cm, friction: 0}"
    ring = ground_outline(stated(text), 0.2)
    assert np.hypot(*(ring - np.array([0.04, 0.05])).T) == pytest.approx(0.01)


def test_the_picture_of_a_run_shows_it(monkeypatch: pytest.MonkeyPatch) -> None:
    from viscodesign.report.charts import tip

    drawn = []
    monkeypatch.setattr(
        tip, "ground_outline", lambda *given: drawn.append(given) or np.zeros((2, 2))
    )
    wall = "loads.ground={kind: line, point: {x: 4 cm}, normal: -90 deg, friction: 0}"
    short = (
        "run={duration: 10 ms, output_interval: 5 ms}",
        "bellows.count=4",
        "effects={others: off}",
    )
    for overrides in ((wall,), (wall, "effects.ground=off"), ()):
        simulate(leg(PLACE, *short, *overrides), verify=False).plot.tip()
    assert len(drawn) == 1
