"""Random scenes are solved or refused by name, and what they leave is whole."""

from __future__ import annotations

import pytest

from tests.fuzz.trial import check_trial, drawn
from tests.thorough import ALL

SEED = "every change"
SCENES = 40 if ALL else 8


@pytest.mark.parametrize("number", range(SCENES))
def test_random_scene(number: int) -> None:
    """Again, with its spec: python -m tests.fuzz.long --seed "every change" --only NUMBER."""
    assert not check_trial(drawn(SEED, number), number).problems


def test_a_scene_is_told_by_its_seed_and_number() -> None:
    assert drawn(SEED, 3) == drawn(SEED, 3)
    assert len({str(drawn(SEED, k).spec) for k in range(200)}) == 200
