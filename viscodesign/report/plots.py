"""Pictures of a run as figures to look at and to go on with."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from viscodesign.report.layout.drawing_library import import_matplotlib
from viscodesign.report.picture_options import Style, picture_options
from viscodesign.results.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from viscodesign.report.layout.style import Screen


class TrajectoryPlots:
    """The pictures of a run, each drawn into a new figure of matplotlib's `pyplot`.

    The axes that come back belong to it: change them, or save `axes.figure`. ``style`` and
    ``width`` are those of `--style` and `--width`.
    """

    def __init__(self, trajectory: Trajectory) -> None:
        self._trajectory = trajectory

    def tip(self, *, style: Style = "plain", width: str | float | None = None) -> Axes:
        """The path of the tip [mm], coloured by time, and the actuator at several times."""
        import_matplotlib()
        from viscodesign.report.charts.tip import draw_tip

        return self._drawn(draw_tip, style, width)[0]

    def pressures(
        self, *, style: Style = "plain", width: str | float | None = None
    ) -> tuple[Axes, Axes]:
        """Gauge pressures [kPa] against time [s]: the left column's axes, and the right one's."""
        import_matplotlib()
        from viscodesign.report.charts.pressures import draw_pressures

        left, right = self._drawn(draw_pressures, style, width)[:2]
        return left, right

    def shapes(self, *, style: Style = "plain", width: str | float | None = None) -> Axes:
        """The actuator at up to eight instants [mm], every bellow coloured by its pressure."""
        import_matplotlib()
        from viscodesign.report.charts.shapes import draw_shapes

        return self._drawn(draw_shapes, style, width)[0]

    def _drawn(
        self,
        draw: Callable[[Trajectory, Screen], None],
        style: Style,
        width: str | float | None,
    ) -> list[Axes]:
        from viscodesign.report.layout.look import drawn_as
        from viscodesign.report.layout.style import Screen

        screen = Screen()
        with drawn_as(picture_options("png", style, width)):
            draw(self._trajectory, screen)
        return screen.axes

    def __repr__(self) -> str:
        return "<plots of a run: tip(), pressures(), shapes()>"
