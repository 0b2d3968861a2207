"""A sequence of poses as a C header, for a sketch that plays it without a computer.

The arrays are those that Bioloid's library for the ArbotiX plays: a pose begins with its number
of servos, a sequence with its number of moves.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from viscodesign.pump.poses.engine import FRAME_MS, PoseSequence, time_asking

LEAD_FRAMES = 600
"""Frames of the way to the first pose: at most 20 s, and 52 counts/s."""

_HEADER = """\
/* {title}
 *
 * Made by viscodesign; changes are lost when it is made again.
{facts}
 *
 * Servo {phantom} must not exist: its moves time waits and slow moves. Nothing monitors the
 * pressure while this plays; only the torque limit caps it.
 *
 * A sketch that plays it from power-on (with the Bioloid library of the ArbotiX):
 *
 *   #include <ax12.h>
 *   #include <BioloidController.h>
 *   #include "poses.h"
 *   BioloidController bioloid = BioloidController(1000000);
 *   void setup() {{
 *     for (int id = 1; id <= {servos}; id++) ax12SetRegister2(id, 34, TORQUE_LIMIT);
 *     for (int id = 1; id <= {servos}; id++) ax12SetRegister2(id, 32, MOVING_SPEED);
 *     // A servo that cannot be read would jump: wait for each.
 *     for (int id = 1; id <= {servos}; id++) while (ax12GetRegister(id, 36, 2) < 0) delay(100);
 *     bioloid.poseSize = {phantom};
 *     bioloid.readPose();                        // begin where the plunger is
 *     bioloid.loadPose(pose_0);
 *     bioloid.interpolateSetup(LEAD_IN_MS);      // slowly to the start
 *     while (bioloid.interpolating > 0) bioloid.interpolateStep();
 *     bioloid.playSeq(profile);
 *   }}
 *   void loop() {{
 *     bioloid.play();
 *     {again}
 *   }}
 */
#ifndef POSES_H
#define POSES_H

#include <avr/pgmspace.h>
#include <stdint.h>

#define TORQUE_LIMIT {torque_limit}
#define MOVING_SPEED {moving_speed}
#define LEAD_IN_MS {lead_in_ms}

{poses}

/* times in ms, each one less than its frames of {frame_ms} ms */
const PROGMEM transition_t profile[] = {{
  {{0, {count}}},
{moves}
}};

#endif
"""
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
    return _HEADER.format(
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
