"""What coefficients leave open of a distance, against exact variances."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign import compare, simulate
from viscodesign.comparison.differences import tip_difference_of
from viscodesign.results.coefficient_band import COVERAGE_FACTOR, CoefficientBand, UncertainNumber

from .motions import PERIOD, chord, circle

GRID = np.linspace(0.0, PERIOD, 81)


def band(key: str, deviation_x: float, deviation_z: float) -> CoefficientBand:
    """The same at all times, without covariance."""
    rows = np.tile([deviation_x**2, deviation_z**2, 0.0], (len(GRID), 1))
    number = UncertainNumber(key, 1.0, "1", 0.1, False, 1.0)
    return CoefficientBand(rows, GRID, (number,))


def test_the_band_is_taken_along_the_distance_and_adds_up() -> None:
    """Of circles that are a little late the distance is tangential: its direction is known."""
    first = circle("a", GRID, band=band("one", 1e-4, 3e-4))
    late = 0.01
    found = tip_difference_of(first, circle("b", GRID, late=late, band=band("two", 2e-4, 2e-4)))
    middle = 2 * np.pi * (found.time - late / 2) / PERIOD
    x, z = np.sin(middle), np.cos(middle)
    variance = (1e-8 + 4e-8) * x**2 + (9e-8 + 4e-8) * z**2
    assert found.band is not None
    np.testing.assert_allclose(found.band, COVERAGE_FACTOR * np.sqrt(variance), rtol=1e-9)
    assert found.within_band == np.mean(chord(late) <= found.band)
    assert "the band holds it at" in found.band_sentence


def test_one_number_in_both_tells_nothing_of_their_distance() -> None:
    own = band("one", 1e-4, 1e-4)
    found = tip_difference_of(circle("a", GRID, band=own), circle("b", GRID, late=0.1, band=own))
    assert found.band is None
    assert found.band_sentence == ""
    assert tip_difference_of(circle("a", GRID), circle("b", GRID)).within_band is None


def test_a_measured_table_is_held_by_the_band_of_the_spec_that_made_it(tmp_path: Path) -> None:
    """Another radius, within the stated deviation, made the table."""
    coarse = "run={duration: 2 s, output_interval: 100 ms}"
    own = leg(
        *(
            "uncertainty={network.tube_radius: 3 %}",
            "effects={pressure_distribution: on, others: off}",
            coarse,
        ),
        config="leg_4_air",
    )
    radius = own.network.tube_radius
    run = simulate(own.replace({"network.tube_radius": 1.02 * radius}), uncertainty=False)
    rows = np.column_stack([run.time, run.tip[:, :2]])
    table = tmp_path / "camera.csv"
    np.savetxt(table, rows, delimiter=",", header="time_s,tip_x_m,tip_z_m", comments="")
    found = compare(table, own)
    assert found.differences[0].within_band == 1.0
    half_width = found.motions[1].band.half_width_m  # type: ignore[union-attr]
    assert found.frame()["coefficients_95_m"][1] == half_width
    assert found.document()["motions"][1]["coefficients"] == f"+-{1e3 * half_width:.3g} mm (95 %)"
    assert found.differences[0].max_m == pytest.approx(
        half_width * (0.02 / 0.03) / COVERAGE_FACTOR, rel=0.1
    )
