"""One random scene by its number, checked and compared with a second run."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path

from tests.fuzz.commands import check_commands
from tests.fuzz.invariants import Verdict, check_scene
from tests.fuzz.metamorphic import TWINS, compared
from tests.fuzz.random_numbers import rng_of
from tests.fuzz.scenes import Draft, draft

SECOND_LOOKS = (*TWINS, "commands", *("none",) * 7)
"""Scenes use them in turn, some use none."""


def drawn(seed: object, number: int) -> Draft:
    """Scene ``number`` of a seed."""
    return draft(rng_of(seed, number))


def check_trial(scene: Draft, number: int) -> Verdict:
    """Verdict on a scene, without its run."""
    look = SECOND_LOOKS[number % len(SECOND_LOOKS)]
    with tempfile.TemporaryDirectory() as folder:
        first = check_scene(scene, Path(folder))
        if look == "none":
            verdict = first
        elif look == "commands":
            verdict = check_commands(scene, Path(folder), first)
        else:
            verdict = compared(look, rng_of("twin", number), scene, first)
    return replace(verdict, run=None)
