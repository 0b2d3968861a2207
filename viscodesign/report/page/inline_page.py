"""The page of a run within the output of a notebook's cell."""

from __future__ import annotations

import html

from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.page.page import page_bytes
from viscodesign.results.trajectory import Trajectory


@dataclass(frozen=True)
class FramedPage:
    """A self-contained page that a notebook shows in a frame of its own."""

    title: str
    content: bytes
    height: int
    """[pixel]"""

    def _repr_html_(self) -> str:
        """The frame with the whole page in it: nothing is fetched, and no file has to stay.

        Sandboxed: the page's script runs, but reaches nothing of the notebook around it.
        """
        return (
            f'<iframe title="{html.escape(self.title)}" sandbox="allow-scripts" '
            f'style="border: 0; width: 100%; height: {self.height}px" '
            f'srcdoc="{html.escape(self.content.decode())}"></iframe>'
        )

    def __repr__(self) -> str:
        return f"<{self.title}: {len(self.content) / 1e6:.2f} MB>"


def inline_page(run: Trajectory, height: int) -> FramedPage:
    """The page of a run, made now; `Trajectory.page`."""
    return FramedPage(f"page of the run {run.name}", page_bytes(run), height)
