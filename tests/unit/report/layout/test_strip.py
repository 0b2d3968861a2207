"""Frames on the strip keep apart, share a scale, and stay on the page."""

from __future__ import annotations

from itertools import combinations

import pytest

from viscodesign.report.layout.strip import LARGEST_LENGTH, LARGEST_STRIP_HEIGHT, Frame, arrange

STRAIGHT = Frame(-21, -4, 21, 115)
BENT = Frame(-80, -30, 21, 40)


@pytest.mark.parametrize(
    "frames",
    [
        [STRAIGHT],
        [STRAIGHT] * 8,
        [BENT] * 8,
        [STRAIGHT, BENT, STRAIGHT, BENT, BENT],
        [Frame(-500, -500, 500, 500)] * 8,
    ],
)
def test_frames_keep_apart_and_fit(frames: list[Frame]) -> None:
    strip = arrange(frames, 109.0, 6.2)
    assert 0 < strip.scale <= LARGEST_LENGTH / 109.0 + 1e-12
    assert strip.height <= LARGEST_STRIP_HEIGHT + 1e-9
    boxes = [
        (x + f.left, z + f.top, x + f.right, z + f.bottom)
        for f, (x, z) in zip(frames, strip.origins, strict=True)
    ]
    for left, top, right, bottom in boxes:
        assert left >= -1e-9
        assert right <= 6.2 / strip.scale + 1e-9
        assert 0 <= top < bottom <= strip.height / strip.scale + 1e-9
    for a, b in combinations(boxes, 2):
        assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]


def test_words_stand_above_their_frames() -> None:
    strip = arrange([STRAIGHT, BENT] * 4, 109.0, 6.2)
    for frame, (_, z), level in zip(
        [STRAIGHT, BENT] * 4, strip.origins, strip.label_levels, strict=True
    ):
        assert level < z + frame.top


def test_the_clamps_of_a_row_are_level() -> None:
    strip = arrange([STRAIGHT, BENT], 109.0, 6.2)
    assert strip.origins[0][1] == strip.origins[1][1]
