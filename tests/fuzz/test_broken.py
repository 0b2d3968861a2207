"""Damaged specs are refused with their place, or are valid after all; never a traceback."""

from __future__ import annotations

import contextlib
from random import Random

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from pydantic_core import PydanticCustomError

from tests.fuzz.broken_outcome import outcome_of
from tests.fuzz.broken_specs import broken_spec
from tests.fuzz.damage_values import grammar_slip
from tests.fuzz.long import broken_of
from viscodesign import units

SEED = "every change"
SPECS = 200


def test_independent_damages() -> None:
    """One again: python -m tests.fuzz.long --seed "every change" --only-broken NUMBER."""
    outcomes = {k: outcome_of(broken_of(SEED, k), solve=False) for k in range(SPECS)}
    assert not {k: o.problems for k, o in outcomes.items() if o.problems}
    assert {o.ending for o in outcomes.values()} == {"refused", "loaded"}


@settings(
    max_examples=100,
    derandomize=True,
    deadline=None,
    database=None,
    suppress_health_check=list(HealthCheck),
)
@given(rng=st.randoms(use_true_random=False))
def test_damages_that_hypothesis_seeks_and_shrinks(rng: Random) -> None:
    assert not outcome_of(broken_spec(rng), solve=False).problems


def test_no_slip_of_the_grammar_is_read_as_a_number() -> None:
    """Not one way of writing two numbers or an odd one gets through, in any kind of quantity."""
    kinds = [note for alias in vars(units).values() for note in getattr(alias, "__metadata__", ())]
    rng, read = Random(7), []
    for _ in range(2000):
        text, kind = grammar_slip(rng), rng.choice(kinds)
        with contextlib.suppress(PydanticCustomError):
            read.append((kind.name, text, kind.parse(text)))
    assert len(kinds) > 20
    assert not read
