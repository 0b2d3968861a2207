"""What the paper says of its own model and leg, and where the scenes of this program lie."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from viscodesign import Trajectory, load, simulate

CONFIGS = Path(__file__).parent.parent / "configs"
EXTENSION, DEFLECTION = "initial extension", "largest horizontal deflection"
LENGTH = load(CONFIGS / "leg_16_straight_air.yaml").actuator.length
"""Of the leg [m]."""
STATED = {
    ("straight", EXTENSION): 0.028,
    ("crossed", EXTENSION): 0.032,
    ("straight", DEFLECTION): 0.047,
    ("crossed", DEFLECTION): 0.126,
}
"""Section 3.1: the model is within these parts of the actual values, of which none is printed."""


@dataclass(frozen=True, eq=False)
class LayoutRuns:
    """Both runs of a layout."""

    layout: str
    published: Trajectory
    called_for: Trajectory


def layout_runs() -> list[LayoutRuns]:
    """Straight and crossed, as published and with the effects that the scene calls for."""
    return [
        LayoutRuns(layout, _run(f"leg_16_{layout}_air"), _run(f"leg_16_{layout}_air_auto"))
        for layout in ("straight", "crossed")
    ]


def _run(name: str, without: str = "") -> Trajectory:
    scene = load(CONFIGS / f"{name}.yaml", {f"effects.{without}": "off"} if without else {})
    run = simulate(scene, verify=not without)
    if run.status != "complete" and not without:
        raise RuntimeError(f"{name}: {run.failure}")
    return run


def _value(run: Trajectory, what: str) -> float:
    """A compared quantity [m]."""
    if what == EXTENSION:
        return float(run.tip[0, 1]) - LENGTH
    return float(np.abs(run.tip[:, 0]).max())


def paper_rows(runs: list[LayoutRuns]) -> list[tuple[str, ...]]:
    """One row a comparison."""
    rows = []
    for (layout, what), margin in STATED.items():
        own = next(each for each in runs if each.layout == layout)
        published, found = _value(own.published, what), _value(own.called_for, what)
        low, high = published / (1 + margin), published / (1 - margin)
        verdict = "inside" if low <= found <= high else "outside"
        rows.append(
            (f"{what}, {layout}", f"{100 * margin:.1f} %", f"{1e3 * published:.1f} mm",
             f"{1e3 * low:.1f} to {1e3 * high:.1f} mm", f"{1e3 * found:.1f} mm, {verdict}")
        )  # fmt: skip
    return rows


PAPER_HEAD = ("quantity", "stated by the paper", "model as published", "then the leg's own is",
              "`effects: auto`")  # fmt: skip


def effect_rows(runs: list[LayoutRuns]) -> list[tuple[str, ...]]:
    """Largest deflection with all effects that the scenes call for but one."""
    rows = []
    for name in _added(runs):
        cells = []
        for own in runs:
            run = _run(f"leg_16_{own.layout}_air_auto", without=name)
            is_whole = run.status == "complete"
            cells.append(f"{1e3 * _value(run, DEFLECTION):.1f} mm" if is_whole else "no solution")
        rows.append((f"without `{name}`", *cells))
    return rows


def _added(runs: list[LayoutRuns]) -> list[str]:
    """Effects that a scene calls for and the published model has not."""
    found = {}
    for own in runs:
        before = {verdict.name for verdict in own.published.effects if verdict.taken}
        found |= {v.name: None for v in own.called_for.effects if v.taken and v.name not in before}
    return list(found)


EFFECT_HEAD = ("largest horizontal deflection", "straight", "crossed")
