"""What a failed integration says."""

from __future__ import annotations

import pytest

from viscodesign.solve.solvers.idas import REASONS, _last_words


@pytest.mark.parametrize("code", REASONS)
def test_a_return_code_is_told_in_words(code: str) -> None:
    text = f'.../casadi/interfaces/sundials/idas_interface.cpp:620: IDASolve returned "{code}".'
    assert _last_words(RuntimeError(text)) == f"{REASONS[code]} ({code})"


def test_other_faults_lose_their_file_names() -> None:
    text = "Error:\n.../casadi/core/function.cpp:12: something else\n"
    assert _last_words(RuntimeError(text)) == "something else"
    assert _last_words(RuntimeError("")) == "no reason given"
