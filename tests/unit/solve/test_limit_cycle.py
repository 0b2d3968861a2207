"""The search for states that come back after a period, for periods given by a formula."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from viscodesign.errors import SolveError
from viscodesign.model.unknowns import Block, Traits, Unknowns
from viscodesign.solve import limit_cycle as module
from viscodesign.solve.limit_cycle import CYCLE, LimitCycle, limit_cycle
from viscodesign.solve.statics import Start

PeriodOf = Callable[[np.ndarray], np.ndarray]
TOLERANCE = 1e-8


@pytest.fixture
def search(monkeypatch: pytest.MonkeyPatch) -> Callable[..., LimitCycle]:
    """Search the fixed point of a formula of the states, of which the last may be integrals."""

    def found(formula: PeriodOf, begin: list[float], integrals: int = 0) -> LimitCycle:
        count = len(begin) - integrals
        states = Unknowns({
            "amount": Block("amount", 0, count, 1.0),
            "inflow": Block("inflow", count, integrals, 1.0, Traits(is_integral=True)),
        })  # fmt: skip
        equations = SimpleNamespace(states=states, algebraics=Unknowns())
        schedule = SimpleNamespace(edges=np.array([0.0, 2.0]))
        problem: Any = SimpleNamespace(equations=equations, schedule=schedule)

        def integrate(_: Any, start: Start, *__: Any, **___: Any) -> Any:
            end = np.column_stack([start.states, formula(start.states)])
            return SimpleNamespace(
                states=end, algebraics=np.zeros((0, 2)), failure=None, asked_to_stop=False
            )

        monkeypatch.setattr(module, "integrate", integrate)
        return limit_cycle(problem, Start(np.array(begin), np.zeros(0)), TOLERANCE, "any")

    return found


def test_linear_states_need_as_many_periods_as_there_are(
    search: Callable[..., LimitCycle],
) -> None:
    factors, drive = np.linspace(0.1, 0.999, 8), np.arange(1.0, 9.0)
    found = search(lambda x: factors * x + drive, [0.0] * 8)
    assert found.start.states == pytest.approx(drive / (1 - factors), rel=1e-6)
    assert found.periods <= 8 + 4 + 2 * CYCLE.fading_periods


def test_what_a_period_keeps_stays_as_it_was(search: Callable[..., LimitCycle]) -> None:
    mixing = np.array([[0.7, 0.2, 0.1], [0.2, 0.7, 0.3], [0.1, 0.1, 0.6]])
    found = search(lambda x: mixing @ x, [3.0, 0.0, 0.0])
    assert found.start.states.sum() == pytest.approx(3.0, rel=1e-12)
    assert mixing @ found.start.states == pytest.approx(found.start.states, rel=1e-7)


def test_integrals_need_not_come_back(search: Callable[..., LimitCycle]) -> None:
    found = search(lambda x: np.array([0.5 * x[0] + 1, x[1] + x[0]]), [0.0, 0.0], integrals=1)
    assert found.start.states == pytest.approx([2.0, 0.0], abs=1e-8)


def test_states_that_drift_have_no_cycle(search: Callable[..., LimitCycle]) -> None:
    with pytest.raises(SolveError, match=r"repeats every 2 s.*amount still changes.*run\.duration"):
        search(lambda x: x + 0.1, [0.0])


def test_a_cycle_of_two_periods_is_no_cycle(search: Callable[..., LimitCycle]) -> None:
    # The logistic map: its fixed point exists, but all goes to two states in turn.
    with pytest.raises(SolveError, match="unstable"):
        search(lambda x: 3.3 * x * (1 - x), [0.3])


def test_a_jump_between_branches_settles_before_the_search_ends(
    search: Callable[..., LimitCycle],
) -> None:
    found = search(lambda x: np.where(x < 1.0, x + 0.4, 0.5 * x + 1.0), [0.0])
    assert found.start.states == pytest.approx([2.0], abs=1e-7)
