"""Functions of a block of rows serve any number of rows, with the same bits."""

from __future__ import annotations

import numpy as np
import pytest

from tests.scenes import leg
from viscodesign.effects.select import select_effects
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.row_blocks import BLOCK_ROWS
from viscodesign.simulation.build_problem import build, suggest_settings
from viscodesign.solve.problem import Problem, evaluate_along, evaluate_at
from viscodesign.solve.solvers.quasi_static import QuasiStatic
from viscodesign.solve.statics import equilibrium


@pytest.fixture(scope="module")
def sealed() -> Problem:
    """Without states: a syringe and one pressure."""
    quantities = SceneQuantities(leg("effects={others: off}", config="syringe_water"))
    effects = select_effects(quantities).effects
    return build(quantities, effects, suggest_settings(quantities, effects))


@pytest.mark.parametrize("count", [1, BLOCK_ROWS - 1, BLOCK_ROWS, 2 * BLOCK_ROWS + 3])
def test_any_number_of_rows_has_the_bits_of_the_longest(sealed: Problem, count: int) -> None:
    start = equilibrium(sealed, 0.0, sealed.schedule.initial_piece)
    solver, longest = QuasiStatic(sealed, 1e-5), len(sealed.schedule.edges) - 1
    whole = solver._at_once(start, 0, longest)
    part = solver._at_once(start, 0, count)
    assert whole is not None
    assert part is not None
    assert np.array_equal(part, whole[:, :count])
    rows = evaluate_along(sealed, np.zeros((0, count)), part, first=1)
    last = np.zeros(0), part[:, -1], float(sealed.schedule.edges[count])
    alone = evaluate_at(sealed, *last, sealed.schedule.pieces[count - 1])
    for name, values in alone.items():
        assert np.array_equal(rows[name][-1:], values)
