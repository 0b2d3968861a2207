"""The figures of the paper, made again from bundled specs: `compare --figure`."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import yaml

from viscodesign._version import __version__
from viscodesign.checks.classify import classify
from viscodesign.comparison.paper_statements import checks_of
from viscodesign.comparison.paper_timescales import LITERATURE, PRINTED, timescale_checks
from viscodesign.comparison.simulated_operands import Progress, runs_of
from viscodesign.errors import UsageError, not_among
from viscodesign.lazy_dataclass import dataclass
from viscodesign.loading import load
from viscodesign.results.paper_figure import FigurePanel, PaperFigure
from viscodesign.results.trajectory import Trajectory
from viscodesign.scene.scene import Scene

FIGURES = (1, 3, 4)


@dataclass(frozen=True)
class FigurePlan:
    """What a figure is made of: `configs/figures/figure_N.yaml`."""

    number: int
    title: str
    panels: tuple[dict[str, Any], ...]
    folder: Path
    """Folder of the specs."""

    @property
    def specs(self) -> list[str]:
        """Names of all specs, each once."""
        return list(dict.fromkeys(name for panel in self.panels for name in panel["specs"]))

    def scenes(self, overrides: Sequence[str]) -> dict[str, Scene]:
        """All of them, with other values of some keys."""
        return {name: load(self.folder / f"{name}.yaml", overrides) for name in self.specs}


def figure_plan(number: int, configs: Path) -> FigurePlan:
    """The plan of a figure in the folder of the bundled specs. Raises `UsageError`."""
    if number not in FIGURES:
        raise UsageError(f"--figure: {not_among(number, map(str, FIGURES))}")
    file = configs / "figures" / f"figure_{number}.yaml"
    found = yaml.safe_load(file.read_text(encoding="utf-8"))
    return FigurePlan(number, found["title"], tuple(found["panels"]), configs)


def paper_figure(
    plan: FigurePlan,
    *,
    overrides: Sequence[str] = (),
    verify: bool = True,
    folder: Path | None = None,
    progress: Progress | None = None,
) -> PaperFigure:
    """Simulate the scenes of a figure and check what the paper says of it.

    The parameters are those of `compare`. Ctrl-C raises `KeyboardInterrupt`; runs that are done
    are in the folder.
    """
    scenes = plan.scenes(overrides)
    changes = tuple(overrides)
    if plan.number == 1:
        places = {name: classify(scene) for name, scene in scenes.items()}
        return PaperFigure(
            plan.number, plan.title, (), timescale_checks(places), __version__,
            (PRINTED, *places.values()), LITERATURE, changes,
        )  # fmt: skip
    runs: dict[str, Trajectory] = {}
    found = runs_of(list(scenes.values()), folder, verify=verify, progress=progress)
    for name, one in zip(scenes, found, strict=False):
        if one.run.status == "interrupted":
            raise KeyboardInterrupt
        runs[name] = one.run
    return PaperFigure(
        plan.number, plan.title, tuple(_panel(p, runs) for p in plan.panels),
        checks_of(plan.number, runs), __version__, changes=changes,
    )  # fmt: skip


def _panel(planned: dict[str, Any], runs: dict[str, Trajectory]) -> FigurePanel:
    shown = tuple(runs[name] for name in planned["specs"] if len(runs[name].time))
    return FigurePanel(planned["panel"], planned["title"], planned.get("assumed", ""), shown)
