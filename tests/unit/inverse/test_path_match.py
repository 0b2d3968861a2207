"""Places on a found path: exact geometry, order, and the slopes of their distances."""

from __future__ import annotations

import numpy as np
import pytest

from viscodesign.inverse.path_match import match_paths

TURN = 2 * np.pi * np.arange(64) / 64


def circle(radius: float, start: float = 0.0, count: int = 64, sense: float = 1.0) -> np.ndarray:
    angle = start + sense * 2 * np.pi * np.arange(count) / count
    return radius * np.column_stack([np.cos(angle), np.sin(angle)])


def test_a_larger_circle_is_the_difference_of_radii_away_from_wherever_it_begins() -> None:
    wanted, found = circle(1.0), circle(1.1, start=2.2, count=500)
    apart = match_paths(wanted, found, closed=True).along(found) - wanted
    assert np.linalg.norm(apart, axis=1) == pytest.approx(0.1, abs=1e-4)


def test_the_other_sense_is_no_match() -> None:
    wanted, found = circle(1.0), circle(1.0, sense=-1.0, count=200)
    apart = match_paths(wanted, found, closed=True).along(found) - wanted
    assert np.sqrt((apart**2).sum(axis=1).mean()) > 0.5


def test_a_way_is_passed_in_order() -> None:
    """Out and back along a line: each half belongs to its own half, as order decides."""
    out = np.linspace(0.0, 1.0, 101)
    line = np.concatenate([out, out[::-1]])
    found = np.column_stack([line, np.where(np.arange(202) < 101, 0.0, 0.01)])
    wanted = np.column_stack([[0.1, 0.5, 0.9, 0.9, 0.5, 0.1], [0, 0, 0, 0.01, 0.01, 0.01]])
    match = match_paths(wanted, found, closed=False)
    places = match.before + match.share
    assert np.all(np.diff(places) >= 0)
    assert np.abs(match.along(found) - wanted).max() < 1e-9


def test_slopes_of_the_distance_are_those_of_differences() -> None:
    """An ellipse that grows and turns: the sum of squares by matching anew each time."""
    wanted = circle(1.0, count=40)

    def ellipse(width: float, turn: float) -> np.ndarray:
        angle = 2 * np.pi * np.arange(300) / 300 + 0.1
        x, z = width * np.cos(angle), 0.7 * np.sin(angle)
        return np.column_stack(
            [x * np.cos(turn) - z * np.sin(turn), x * np.sin(turn) + z * np.cos(turn)]
        )

    def squares(values: np.ndarray) -> float:
        found = ellipse(*values)
        return float(((match_paths(wanted, found, closed=True).along(found) - wanted) ** 2).sum())

    here, step = np.array([1.3, 0.2]), 1e-6
    rows = [np.eye(2)[k] * step for k in range(2)]
    slopes = np.stack(
        [(ellipse(*(here + own)) - ellipse(*(here - own))) / (2 * step) for own in rows], axis=2
    )
    match = match_paths(wanted, ellipse(*here), closed=True)
    apart = match.along(ellipse(*here)) - wanted
    exact = 2 * np.einsum("nc,ncf->f", apart, match.across(match.along(slopes)))
    differences = [(squares(here + own) - squares(here - own)) / (2 * step) for own in rows]
    assert exact == pytest.approx(differences, rel=1e-5)
