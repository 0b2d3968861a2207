"""A sequence of poses as a C header, for a sketch that plays it without a computer.

The arrays are those that Bioloid's library for the ArbotiX plays: a pose begins with its number
of servos, a sequence with its number of moves.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from viscodesign.pump.poses.engine import FRAME_MS, PoseSequence, time_asking

LEAD_FRAMES = 600
"""Of the way to the first pose: at most 20 s, and 52 counts/s."""

_HEAD = """\
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
 */"""
_POINTER = "(unsigned int *) "
"""The library's type of a pose is not constant."""
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
    listed = "\n".join(f" * {name}: {_plain(words)}" for name, words in facts.items())
    head = _HEAD.format(
        title=_plain(title),
        facts=listed,
        phantom=phantom,
        servos=phantom - 1,
        again=_AGAIN if looped else _ONCE,
    )
    constants = {
        "TORQUE_LIMIT": torque_limit,
        "MOVING_SPEED": moving_speed,
        "LEAD_IN_MS": time_asking(LEAD_FRAMES),
    }
    poses = [
        f"const PROGMEM uint16_t pose_{index}[] = {{{_listed((len(pose), *pose))}}};"
        for index, pose in enumerate(sequence.poses)
    ]
    moves = ",\n".join(f"  {{{_POINTER}pose_{m.pose}, {m.ms}}}" for m in sequence.moves)
    return "\n".join(
        [
            head,
            "#ifndef POSES_H",
            "#define POSES_H",
            "",
            "#include <avr/pgmspace.h>",
            "#include <stdint.h>",
            "",
            *(f"#define {name} {value}" for name, value in constants.items()),
            "",
            *poses,
            "",
            f"/* times in ms, each one less than its frames of {FRAME_MS} ms */",
            "const PROGMEM transition_t profile[] = {",
            f"  {{0, {len(sequence.moves)}}},",
            moves,
            "};",
            "",
            "#endif",
            "",
        ]
    )


def _listed(values: tuple[int, ...]) -> str:
    return ", ".join(map(str, values))


def _plain(words: str) -> str:
    """Words that cannot end the comment they stand in."""
    return re.sub(r"\s+", " ", words).replace("*/", "* /").encode("ascii", "replace").decode()
