"""Messages and exit codes."""

from __future__ import annotations

import pytest

from viscodesign import errors
from viscodesign.errors import Fault, SolveError, SpecError, ViscodesignError


@pytest.mark.parametrize(
    ("fault", "words"),
    [
        (Fault("is odd", "bellows.count", "leg.yaml", 14), "leg.yaml:14: bellows.count: is odd"),
        (Fault("is empty", file="leg.yaml"), "leg.yaml: is empty"),
        (Fault("missing", "run", "leg.yaml"), "leg.yaml: run: missing"),
        (Fault("is odd", "bellows.count"), "bellows.count: is odd"),
    ],
)
def test_a_fault_names_file_line_and_key(fault: Fault, words: str) -> None:
    assert str(fault) == words


def test_a_spec_error_lists_one_fault_per_line() -> None:
    error = SpecError([Fault("one", "a", "f", 1), Fault("two", "b", "f", 2)])
    assert str(error).splitlines() == ["f:1: a: one", "f:2: b: two"]
    assert [fault.key for fault in error.faults] == ["a", "b"]


def test_a_solve_error_includes_its_remedy() -> None:
    error = SolveError(
        "stretch of section 3 is 0.1 at 1.5 s",
        quantity="stretch",
        where="section 3",
        time_s=1.5,
        remedy="Lower the pressure",
    )
    assert str(error) == "stretch of section 3 is 0.1 at 1.5 s. Lower the pressure"
    assert (error.quantity, error.where, error.time_s) == ("stretch", "section 3", 1.5)


def test_exit_codes() -> None:
    kinds = [kind for kind in vars(errors).values() if isinstance(kind, type)]
    codes = {k.__name__: k.exit_code for k in kinds if issubclass(k, ViscodesignError)}
    assert codes == {
        "ViscodesignError": 1,
        "SpecError": 2,
        "UsageError": 2,
        "OutputError": 3,
        "SolveError": 3,
        "RunFailedError": 3,
        "PumpError": 4,
        "InterruptedRunError": 130,
    }


def test_messages_are_readable_for_any_spec() -> None:
    fault = Fault(
        f"'{'x' * 9000}' is no number; expected a length", "k" * 9000, "--set " + "y" * 9000
    )
    assert len(str(fault)) < 1500
    assert str(fault).endswith("expected a length")


def test_a_message_lists_the_first_faults_and_counts_the_rest() -> None:
    error = SpecError([Fault("no such key", f"k{k}") for k in range(30_000)])
    assert len(error.faults) == 30_000
    assert str(error).splitlines()[-1] == "and 29940 more errors"
    assert len(str(error).splitlines()) == 61
