"""The ground as it is drawn: every point of its line lies on the surface."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import simulate
from viscodesign.report.ground_outline import feet, ground_outline, lies_beyond
from viscodesign.scene.ground import Ground

PLACE = "input={kind: constant, value: 0}"
SHORT = (
    "run={duration: 10 ms, output_interval: 5 ms}",
    "bellows.count=4",
    "effects={others: off}",
)


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
    for overrides in ((wall,), (wall, "effects.ground=off"), ()):
        simulate(leg(PLACE, *SHORT, *overrides), verify=False).plot.tip()
    assert len(drawn) == 1


WALL = "{kind: line, point: {x: 10 mm}, normal: -90 deg, friction: 0, foot_radius: 4 mm}"
PIN = "{kind: circle, centre: {x: 4 cm, z: 5 cm}, radius: 1 cm, friction: 0}"


@pytest.mark.parametrize(
    ("text", "before", "behind"), [(WALL, (0.009, 0.1), (0.012, 0.1)), (PIN, (0.02, 0.05), (0.035, 0.05))]
)  # fmt: skip
def test_what_lies_behind_a_surface_is_told(
    text: str, before: tuple[float, float], behind: tuple[float, float]
) -> None:
    ground, points = stated(text), np.array([before, behind])
    assert not lies_beyond(ground, points[:1], 0.1)
    assert lies_beyond(ground, points, 0.1)
    on = ground_outline(ground, 0.2)
    assert not lies_beyond(ground, on, 0.1)


def test_a_foot_is_a_ring_about_the_tip() -> None:
    tips = np.array([[0.0, 0.1], [0.006, 0.1]])
    rings = feet(stated(WALL), tips)
    assert np.hypot(*(rings - tips[:, None]).T) == pytest.approx(0.004)
    assert rings[1, :, 0].max() == pytest.approx(0.01)  # touches the wall
    assert len(feet(stated(PIN), tips)) == 0


@pytest.mark.parametrize(("place", "outlines"), [("10 mm", 0), ("40 mm", 1)])
def test_outlines_that_would_lie_across_the_ground_are_left_out(place: str, outlines: int) -> None:
    wall = f"loads.ground={{kind: line, point: {{x: {place}}}, normal: -90 deg, friction: 0}}"
    axes = simulate(leg(PLACE, *SHORT, wall), verify=False).plot.tip()
    shown = [own for own in axes.collections if type(own).__name__ == "PolyCollection"]
    assert len(shown) == outlines
