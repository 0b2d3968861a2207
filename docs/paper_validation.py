"""What the paper says of its own model and leg, and where the scenes of this program lie."""

from __future__ import annotations

from collections.abc import Mapping
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


def _run(name: str, changes: Mapping[str, object] | None = None) -> Trajectory:
    """A bundled scene, verified where nothing is changed of it."""
    run = simulate(load(CONFIGS / f"{name}.yaml", changes or {}), verify=not changes)
    if run.status != "complete" and not changes:
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
            run = _run(f"leg_16_{own.layout}_air_auto", {f"effects.{name}": "off"})
            cells.append(_cell(run, DEFLECTION))
        rows.append((f"without `{name}`", *cells))
    return rows


def _cell(run: Trajectory, what: str) -> str:
    return f"{1e3 * _value(run, what):.1f} mm" if run.status == "complete" else "no solution"


def _amplitude(factor: float) -> dict[str, object]:
    """The input's pressures, larger by a factor."""
    own = load(CONFIGS / "leg_16_straight_air.yaml").model_dump(by_alias=True)["input"]
    return {f"input.{key}": factor * float(own[key]) for key in ("start", "drop")}


ASSUMED = {
    "amplitude -5 %": _amplitude(0.95),
    "amplitude +5 %": _amplitude(1.05),
    "collapse fraction 0.05": {"bellows.collapse_fraction": 0.05},
    "collapse fraction 0.2": {"bellows.collapse_fraction": 0.2},
}
"""Changes of what the paper does not print, or what was reconstructed."""


def assumption_rows(runs: list[LayoutRuns]) -> list[tuple[str, ...]]:
    """How far both models' quantities depend on what is assumed of the leg."""
    rows = []
    for own in runs:
        for model, base, tail in (
            ("as published", own.published, ""),
            ("`effects: auto`", own.called_for, "_auto"),
        ):
            name = f"leg_16_{own.layout}_air{tail}"
            changed = [_run(name, changes) for changes in ASSUMED.values()]
            for what in (EXTENSION, DEFLECTION):
                cells = [_cell(run, what) for run in (base, *changed)]
                rows.append((f"{what}, {own.layout}", model, *cells))
    return rows


ASSUMED_HEAD = ("quantity", "model", "as bundled", *ASSUMED)


def _added(runs: list[LayoutRuns]) -> list[str]:
    """Effects that a scene calls for and the published model has not."""
    found = {}
    for own in runs:
        before = {verdict.name for verdict in own.published.effects if verdict.taken}
        found |= {v.name: None for v in own.called_for.effects if v.taken and v.name not in before}
    return list(found)


EFFECT_HEAD = ("largest horizontal deflection", "straight", "crossed")
