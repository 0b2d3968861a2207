"""Pictures of a run as figures to look at and to go on with."""

from __future__ import annotations

from typing import TYPE_CHECKING

from viscodesign.report.layout.drawing_library import import_matplotlib
from viscodesign.results.trajectory import Trajectory

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class TrajectoryPlots:
    """The pictures of a run, each drawn into a new figure of matplotlib's `pyplot`.

    The axes that come back belong to it: change them, or save `axes.figure`.
    """

    def __init__(self, trajectory: Trajectory) -> None:
        self._trajectory = trajectory

    def tip(self) -> Axes:
        """The path of the tip [mm], coloured by time, and the actuator at several times."""
        import_matplotlib()
        from viscodesign.report.charts.tip import draw_tip
        from viscodesign.report.layout.style import Screen

        screen = Screen()
        draw_tip(self._trajectory, screen)
        return screen.axes[0]

    def pressures(self) -> tuple[Axes, Axes]:
        """Gauge pressures [kPa] against time [s]: the left column's axes, and the right one's."""
        import_matplotlib()
        from viscodesign.report.charts.pressures import draw_pressures
        from viscodesign.report.layout.style import Screen

        screen = Screen()
        draw_pressures(self._trajectory, screen)
        return screen.axes[0], screen.axes[1]

    def shapes(self) -> Axes:
        """The actuator at up to eight instants [mm], every bellow coloured by its pressure."""
        import_matplotlib()
        from viscodesign.report.charts.shapes import draw_shapes
        from viscodesign.report.layout.style import Screen

        screen = Screen()
        draw_shapes(self._trajectory, screen)
        return screen.axes[0]

    def __repr__(self) -> str:
        return "<plots of a run: tip(), pressures(), shapes()>"
