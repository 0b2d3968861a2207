"""Graphs that are tried in processes: the same design for any number, and what is told of losses."""

from __future__ import annotations

import itertools
import multiprocessing
import os
import signal
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.unit.inverse.tasks import small, task
from viscodesign import design
from viscodesign.errors import UsageError
from viscodesign.inverse.quick_fit import QuickCandidate, QuickFit

ORDER = ["inlet", "L1", "R2", "L2", "R1"]
LENGTHS = {"network.tubes[*].length": ["20 mm", "80 mm"]}


@pytest.fixture
def chain_task(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A task of too many graphs to try them all, that no graph meets."""
    monkeypatch.setattr("viscodesign.inverse.graph_search.FEW_GRAPHS", 10)
    wanted = small(network__tubes=[{"from": a, "to": b} for a, b in itertools.pairwise(ORDER)])
    free = {"network.graph": "tree", **LENGTHS}
    monkeypatch.setattr("viscodesign.inverse.graph_evolution.CHANGES_PER_S", 0.4)
    return task(tmp_path, free, wanted, tolerance="0.005 mm")


def test_one_process_finds_what_two_find(chain_task: Path) -> None:
    alone, both = (design(chain_task, workers=workers) for workers in (1, 2))
    assert not alone.ended_by_budget
    assert not both.ended_by_budget
    assert alone.graph == both.graph
    assert alone.parameters == both.parameters
    assert [row.rms_m for row in alone.history] == [row.rms_m for row in both.history]


def test_a_process_that_dies_costs_its_graphs_and_is_told(
    chain_task: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    fitted, once = QuickFit.fitted, chain_task.parent / "died"

    def deadly(fit: QuickFit, graph: Any, start: np.ndarray, evaluations: int) -> QuickCandidate:
        if multiprocessing.parent_process() is not None and not once.exists():
            once.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return fitted(fit, graph, start, evaluations)

    monkeypatch.setattr(QuickFit, "fitted", deadly)
    found = design(chain_task, workers=2)
    assert 1 <= found.lost_graphs <= 8  # both processes may begin before the file is there
    assert found.document()["lost_graphs"] == found.lost_graphs
    assert found.graph


def test_a_budget_that_ends_the_search_is_told(chain_task: Path) -> None:
    found = design(chain_task, budget=0.05)
    assert found.ended_by_budget
    assert "ended by its budget of 0.05 s" in found.reason
    assert found.parameters


def test_no_process_is_no_number_of_them(chain_task: Path) -> None:
    with pytest.raises(UsageError, match="workers: must be 1 or more; got 0"):
        design(chain_task, workers=0)
