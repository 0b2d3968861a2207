"""One scene by its number: drawn, judged, and held against a second run."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path

from tests.fuzz.commands import commanded
from tests.fuzz.dice import dice_of
from tests.fuzz.judge import Verdict, judged
from tests.fuzz.scenes import Draft, draft
from tests.fuzz.twins import TWINS, compared

SECOND_LOOKS = (*TWINS, "commands", *("none",) * 7)
"""Scenes get one of them in turn, and some none."""


def drawn(seed: object, number: int) -> Draft:
    """Scene ``number`` of a seed."""
    return draft(dice_of(seed, number))


def tried(scene: Draft, number: int) -> Verdict:
    """All that is found wrong with a scene, without its run."""
    look = SECOND_LOOKS[number % len(SECOND_LOOKS)]
    with tempfile.TemporaryDirectory() as folder:
        first = judged(scene, Path(folder))
        if look == "none":
            verdict = first
        elif look == "commands":
            verdict = commanded(scene, Path(folder), first)
        else:
            verdict = compared(look, dice_of("twin", number), scene, first)
    return replace(verdict, run=None)
