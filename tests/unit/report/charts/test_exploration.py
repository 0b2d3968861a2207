"""Pictures of sweeps and sensitivities, from made-up numbers: what they show, in words."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from viscodesign.report.charts.sweep import draw_sweep
from viscodesign.report.charts.tornado import draw_tornado
from viscodesign.results.metrics import METRIC_NAMES
from viscodesign.results.sensitivity_study import SensitiveNumber, SensitivityStudy
from viscodesign.results.sweep_table import COMPLETE, DesignResult, Sweep, SweptColumn

LENGTH = SweptColumn("network.tube_length", "m", (0.01, 0.1, 1.0))
RADIUS = SweptColumn("network.tube_radius", "m", (1e-3, 2e-3, 3e-3))
FLUID = SweptColumn("fluid", None, ("air", "water", "oil"))


def words_of(picture: Path) -> list[str]:
    """Texts of a picture, which SVG keeps as comments."""
    return [text.strip() for text in re.findall(r"<!--(.*?)-->", picture.read_text())]


def sweep_over(*columns: SweptColumn, sample: int | None = None) -> Sweep:
    """Three values of each key; the second row failed, the third was not computed."""
    values = [column.values or () for column in columns]
    grid = np.stack(np.meshgrid(*(np.arange(3) for _ in columns), indexing="ij"), -1)
    designs = tuple(
        tuple(own[k] for own, k in zip(values, row, strict=True))
        for row in grid.reshape(-1, len(columns))
    )
    metrics = len(METRIC_NAMES)
    results = {
        k: DesignResult(k, COMPLETE, frozenset(), [1e-3 * k] * metrics) for k in range(len(designs))
    }
    results[1] = DesignResult.failed(1, "why")
    del results[2]
    return Sweep("leg", "0", "", "incomplete", columns, designs, results, 1e-3, sample, None)


@pytest.mark.parametrize(
    ("columns", "expected"),
    [
        ((LENGTH,), {"network.tube_length [mm]", "failed"}),
        ((RADIUS, FLUID), {"network.tube_radius [mm]", "air", "water", "2"}),
        ((LENGTH, RADIUS, FLUID), {"network.tube_radius [mm]", "network.tube_length [mm]", "oil"}),
    ],
)
def test_a_sweep_names_its_keys_and_what_is_not_there(
    columns: tuple[SweptColumn, ...], expected: set[str], tmp_path: Path
) -> None:
    found = sweep_over(*columns)
    draw_sweep(found, "loop_width_m", tmp_path / "sweep.svg")
    words = words_of(tmp_path / "sweep.svg")
    assert expected <= set(words)
    (title,) = (text for text in words if text.startswith("leg: "))
    assert title == f"leg: loop_width [mm] of {len(found.designs)} designs, 1 failed, 1 missing"


@pytest.mark.parametrize("has_band", [True, False])
def test_the_number_that_moves_the_tip_most_comes_first(has_band: bool, tmp_path: Path) -> None:
    time = np.linspace(0.0, 1.0, 5)
    slopes = np.ones((5, 2, 2)) * [1e-3, 2e-3]
    study = SensitivityStudy(
        name="leg",
        version="0",
        spec_sha256="",
        time=time,
        tip=np.zeros((5, 2)),
        numbers=(SensitiveNumber("a", 1.0, "m", 1.0), SensitiveNumber("b", 1.0, "m", 1.0)),
        slopes=slopes,
        effects=frozenset(),
        variances=slopes**2 if has_band else None,
    )
    draw_tornado(study, tmp_path / "sensitivity.svg")
    words = words_of(tmp_path / "sensitivity.svg")
    assert words.index("b") < words.index("a")
    assert any("standard deviation" in text for text in words) == has_band
    largest = np.sqrt(2) * (2.0 if has_band else 0.02)
    assert f"{largest:.2g}" in words
