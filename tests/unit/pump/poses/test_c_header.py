"""The header: it compiles, holds the same sequence, and says where it comes from."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.pose_rig import swing
from tests.poses_h import read_poses_h
from viscodesign.errors import PumpError
from viscodesign.pump.poses.c_header import poses_h
from viscodesign.pump.poses.engine import MAX_MOVES, Move, PoseSequence
from viscodesign.pump.poses.fit import fit_poses

STAND_INS = {
    "avr/pgmspace.h": "#define PROGMEM\n#include <stdint.h>\n",
    "ax12.h": "int ax12GetRegister(int, int, int);\nvoid ax12SetRegister2(int, int, int);\n"
    "void delay(unsigned long);\n",
    # As the library declares them; an int of an ATmega has 16 bits.
    "BioloidController.h": """\
#include <stdint.h>
#define int int16_t
typedef struct { unsigned short * pose; int time; } transition_t;
#define unsigned_int unsigned short
class BioloidController {
 public:
  BioloidController(long);
  void loadPose(const uint16_t *);
  void readPose();
  void interpolateSetup(int);
  void interpolateStep();
  unsigned char interpolating;
  int poseSize;
  void playSeq(const transition_t *);
  void play();
  unsigned char playing;
};
#undef int
""",
}
PRINT = """
#include <stdio.h>
int main() {
  for (int i = 0; i <= profile[0].time; i++) {
    printf("%d", (int) profile[i].time);
    const uint16_t * pose = (const uint16_t *) profile[i].pose;
    if (pose) for (int k = 0; k <= pose[0]; k++) printf(" %d", (int) pose[k]);
    printf("\\n");
  }
}
"""


def header(sequence: PoseSequence, looped: bool = False, **facts: str) -> str:
    return poses_h(
        sequence,
        title="leg",
        facts={"spec sha256": "00ff", **facts},
        torque_limit=316,
        moving_speed=200,
        looped=looped,
    )


@st.composite
def sequences(draw: st.DrawFn) -> PoseSequence:
    servos = draw(st.integers(1, 3))
    poses = draw(
        st.lists(st.tuples(*[st.integers(0, 1023)] * servos), min_size=1, max_size=30, unique=True)
    )
    move = st.builds(Move, st.integers(0, len(poses) - 1), st.integers(0, 32767))
    return PoseSequence(tuple(poses), tuple(draw(st.lists(move, min_size=1, max_size=MAX_MOVES))))


@given(sequences(), st.booleans())
@settings(deadline=None)
def test_the_header_holds_the_sequence(sequence: PoseSequence, looped: bool) -> None:
    assert read_poses_h(header(sequence, looped)) == sequence


def test_a_truncated_header_is_refused() -> None:
    text = header(fit_poses(swing()).sequence)
    for part in (text[: len(text) // 2], text.replace("pose_0[]", "pose_77[]"), ""):
        with pytest.raises(PumpError, match="not a whole one"):
            read_poses_h(part)


@given(st.text(max_size=60))
def test_no_fact_can_end_the_comment(words: str) -> None:
    sequence = PoseSequence(((1, 2),), (Move(0, 32),))
    text = header(sequence, note=words + " */ int evil;")
    assert text.index("*/") > text.index("void loop()")
    assert text.isascii()


def test_the_header_states_its_source() -> None:
    text = header(PoseSequence(((1, 2),), (Move(0, 32),)), **{"largest error": "1.2 counts"})
    for words in ("spec sha256: 00ff", "largest error: 1.2 counts", "Servo 2 must not exist"):
        assert words in text


@pytest.mark.parametrize("looped", [False, True])
def test_header_and_sketch_compile_and_hold_the_sequence(tmp_path: Path, looped: bool) -> None:
    compiler = shutil.which("g++") or shutil.which("c++")
    if compiler is None:
        pytest.skip("no C++ compiler")
    sequence = fit_poses(swing((1, 2)), loop=looped).sequence
    # An int of this machine is no int of an ATmega.
    text = header(sequence, looped).replace("(unsigned int *)", "(unsigned short *)")
    (tmp_path / "avr").mkdir()
    for name, content in (*STAND_INS.items(), ("poses.h", text)):
        (tmp_path / name).write_text(content)
    sketch = re.search(r" \*   (#include <ax12.h>.*?) \*/", text, re.DOTALL)
    assert sketch is not None
    source = re.sub(r"^ \*( {3})?", "", sketch[1], flags=re.MULTILINE)
    assert ("if (bioloid.playing == 0)" in source) is looped
    (tmp_path / "sketch.cpp").write_text(source)
    (tmp_path / "print.cpp").write_text(
        '#include "BioloidController.h"\n#include "poses.h"\n' + PRINT
    )
    flags = ["-Wall", "-Wextra", "-Werror", f"-I{tmp_path}"]
    for words in (["-c", "sketch.cpp"], ["print.cpp", "-o", "print"]):
        subprocess.run([compiler, *flags, *words], cwd=tmp_path, check=True, timeout=120)
    out = subprocess.run([tmp_path / "print"], capture_output=True, text=True, check=True).stdout
    rows = [[int(word) for word in line.split()] for line in out.splitlines()]
    assert rows[0] == [len(sequence.moves)]
    pairs = zip(sequence.moves, sequence.goals(), strict=True)
    assert rows[1:] == [[move.ms, len(goal), *goal] for move, goal in pairs]
