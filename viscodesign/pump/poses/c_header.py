"""A sequence of poses as a C header, for a sketch that plays it without a computer.

The arrays are those that Bioloid's library for the ArbotiX plays: a pose begins with its number
of servos, a sequence with its number of moves.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from string import Template

from viscodesign.pump.poses.engine import FRAME_MS, PoseSequence, time_asking

TEMPLATE = Path(__file__).with_name("poses.h.template")
LEAD_FRAMES = 600
"""Frames of the way to the first pose: at most 20 s, and 52 counts/s."""

_ONCE = "// once"
_AGAIN = "if (bioloid.playing == 0) bioloid.playSeq(profile);"


def poses_h(
    sequence: PoseSequence,
    *,
    title: str,
    facts: Mapping[str, str],
    torque_limit: int,
    moving_speed: int,
    looped: bool,
) -> str:
    """The header's text.

    ``facts``: where it comes from and how close it is, as words; ``torque_limit`` and
    ``moving_speed`` as their registers take them.
    """
    phantom = len(sequence.poses[0])
    poses = [
        f"const PROGMEM uint16_t pose_{index}[] = {{{', '.join(map(str, (len(pose), *pose)))}}};"
        for index, pose in enumerate(sequence.poses)
    ]
    # The library's type of a pose is not constant.
    moves = [f"  {{(unsigned int *) pose_{move.pose}, {move.ms}}}" for move in sequence.moves]
    template = Template(TEMPLATE.read_text(encoding="utf-8"))
    return template.substitute(
        title=_plain(title),
        facts="\n".join(f" * {name}: {_plain(words)}" for name, words in facts.items()),
        phantom=phantom,
        servos=phantom - 1,
        again=_AGAIN if looped else _ONCE,
        torque_limit=torque_limit,
        moving_speed=moving_speed,
        lead_in_ms=time_asking(LEAD_FRAMES),
        poses="\n".join(poses),
        frame_ms=FRAME_MS,
        count=len(sequence.moves),
        moves=",\n".join(moves),
    )


def _plain(words: str) -> str:
    """Words that cannot end the comment they stand in."""
    return re.sub(r"\s+", " ", words).replace("*/", "* /").encode("ascii", "replace").decode()
