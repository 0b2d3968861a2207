"""Reads the header that `pump upload --export` writes."""

from __future__ import annotations

import re

from viscodesign.errors import PumpError
from viscodesign.pump.poses.engine import Move, PoseSequence

_POSE = re.compile(r"uint16_t pose_(\d+)\[\] = \{([\d, ]+)\};")
_MOVE = re.compile(r"\{\(unsigned int \*\) pose_(\d+), (\d+)\}")


def read_poses_h(text: str) -> PoseSequence:
    """The sequence that a header holds; raises `PumpError` where it is not whole."""
    rows = {int(n): [int(v) for v in values.split(",")] for n, values in _POSE.findall(text)}
    moves = tuple(Move(int(pose), int(ms)) for pose, ms in _MOVE.findall(text))
    count = re.search(r"\{0, (\d+)\}", text)
    whole = (
        count is not None
        and int(count[1]) == len(moves)
        and sorted(rows) == list(range(len(rows)))
        and all(row[0] == len(row) - 1 for row in rows.values())
        and all(move.pose in rows for move in moves)
    )
    if not whole:
        raise PumpError("the header is not a whole one of viscodesign's")
    return PoseSequence(tuple(tuple(rows[n][1:]) for n in sorted(rows)), moves)
