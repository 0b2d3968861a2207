"""What a film shows when: its speed, its frames and their rows of the run."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from viscodesign.errors import UsageError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.report.picture_options import Style

FORMATS = (".gif", ".webp", ".mp4")
MAX_PICTURES = 3000
REAL_TIME = (2.0, 20.0)
"""Runs of this length are shown in real time unless told otherwise [s]."""
USUAL_LENGTH = 8.0
"""Length of the film of any other run, roughly [s]."""
DOTS_PER_INCH, INCHES = 100, (6.4, 9.6)
"""Usual resolution of a frame, and limits of the width of its figure: letters, whose size is in
points, would be too small in a small film, or would leave no room in it."""
TITLE_CHARACTERS = 5
"""Of the name above a film, for an inch of the width."""
LAST_FRAME_HOLD = 0.5
"""The film rests on its last frame before it begins again [s]."""


@dataclass(frozen=True)
class FilmOptions:
    """How a film is made."""

    speed: float | None = None
    """Seconds of motion in a second of film; None: real time, or about eight seconds in all."""
    frames_per_second: int = 25
    width: int = 960
    """[pixel]; an odd one is made even, as films need it; the height is 9/16 of it, and even."""
    transparent: bool = False
    """Instead of a ground."""
    dark: bool = False
    """A dark ground with light lines; where it is transparent, for one."""
    pressures: bool = True
    """Whether the pressures are drawn against time beside the actuator."""

    def checked(self, file: Path) -> FilmOptions:
        """The same; raises `UsageError` where it cannot be made in the format of ``file``."""
        kind = file.suffix.lower()
        if kind not in FORMATS:
            given = f"'{kind}'" if kind else "no suffix"
            raise UsageError(f"{file.name}: a film is .gif, .webp or .mp4; got {given}")
        if kind == ".mp4" and self.transparent:
            raise UsageError("MP4 has no transparent ground; use .webp or .gif")
        self._check("speed", self.speed is None or (math.isfinite(self.speed) and self.speed > 0))
        self._check("frames_per_second", 1 <= self.frames_per_second <= 50)
        self._check("width", 160 <= self.width <= 3840)
        return self

    def _check(self, name: str, fits: bool) -> None:
        allowed = {
            "speed": "a number above 0",
            "frames_per_second": "1 to 50",
            "width": "160 to 3840 pixels",
        }
        if not fits:
            option = "--fps" if name == "frames_per_second" else f"--{name}"
            told = f"{name} ({option}) must be {allowed[name]}; got {getattr(self, name)}"
            raise UsageError(told)

    @property
    def size(self) -> tuple[int, int]:
        """Width and height [pixel], both even."""
        wide = self.width // 2 * 2
        return wide, 2 * round(wide * 9 / 32)

    @property
    def figure_size(self) -> tuple[float, float]:
        """Width and height of a figure [inch], a little more than whole pixels, which are counted
        by rounding down."""
        wide, high = (side / self.dots_per_inch + 1e-6 for side in self.size)
        return wide, high

    @property
    def dots_per_inch(self) -> float:
        """Resolution of a figure."""
        wide, (low, high) = self.size[0], INCHES
        return wide / min(max(wide / DOTS_PER_INCH, low), high)

    @property
    def style(self) -> Style:
        """That of its pictures."""
        return "dark" if self.dark else "plain"


def film_rows(time: np.ndarray, options: FilmOptions) -> np.ndarray:
    """Rows (n,) of the frames, the nearest output time each; raises `UsageError` for too many."""
    if not len(time):
        raise UsageError("the run has no output time, so there is nothing to film")
    span = float(time[-1] - time[0])
    speed = options.speed or usual_speed(span)
    count = math.floor(span / speed * options.frames_per_second) + 1
    if count > MAX_PICTURES:
        enough = span * options.frames_per_second / (MAX_PICTURES - 1)
        raise UsageError(
            f"{count:,} frames at {speed:g} times real time; at most {MAX_PICTURES:,} are made. "
            f"Use a speed of {enough:.3g} or more, or fewer frames per second"
        )
    wanted = time[0] + np.arange(count) * speed / options.frames_per_second
    after = np.clip(np.searchsorted(time, wanted), 1, max(len(time) - 1, 1))
    if len(time) == 1:
        return np.zeros(1, dtype=int)
    rows = after - (wanted - time[after - 1] <= time[after] - wanted)
    return np.append(rows, len(time) - 1) if rows[-1] != len(time) - 1 else rows


def usual_speed(span: float) -> float:
    """Seconds of motion in a second of film for a run of ``span`` [s]."""
    if span <= 0 or REAL_TIME[0] <= span <= REAL_TIME[1]:
        return 1.0
    wanted = span / USUAL_LENGTH
    power = 10.0 ** math.floor(math.log10(wanted))
    return min((m * power for m in (1.0, 2.0, 5.0, 10.0)), key=lambda m: abs(math.log(m / wanted)))
