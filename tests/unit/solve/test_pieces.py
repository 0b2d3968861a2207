"""Coefficients of intervals, stored once for equal neighbours."""

from __future__ import annotations

import numpy as np

from viscodesign.solve.problem import Pieces


def test_pieces_index_like_an_array_of_all_intervals() -> None:
    values, firsts = np.array([[1.0, 2.0], [3.0, 4.0], [3.0, 4.0], [5.0, 6.0]]), [0, 2, 3, 5]
    each = values[[0, 0, 1, 2, 2, 3, 3]]
    pieces = Pieces(values, np.array(firsts), len(each))
    assert len(pieces) == 7
    assert np.array_equal(pieces[:], each)
    assert np.array_equal(pieces[2:6], each[2:6])
    assert np.array_equal(pieces[4], each[4])
    assert np.array_equal(pieces[[6, 0, 0]], each[[6, 0, 0]])
    assert list(pieces.changes) == [2, 5]


def test_refining_edges_keeps_the_coefficients_in_time() -> None:
    edges, finer = np.arange(5.0), np.array([0.0, 0.5, 1.0, 2.0, 3.0, 3.2, 3.4, 4.0])
    pieces = Pieces(np.array([[1.0], [2.0]]), np.array([0, 3]), 4)
    assert pieces.among(edges, finer)[:].ravel().tolist() == [1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0]
