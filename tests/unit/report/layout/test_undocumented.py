"""Matplotlib imported without its own texts draws the same pictures."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

PROGRAM = """
import sys
from pathlib import Path
from tests.trajectories import made_run
from viscodesign.report.layout.undocumented import import_undocumented
from viscodesign.report.run_folder import write_run

if sys.argv[1] == "without":
    import_undocumented()
write_run(made_run(), Path(sys.argv[2]))
from matplotlib.artist import Artist
from matplotlib.lines import Line2D

class Later(Line2D):
    pass

line = Line2D([], [])
line.set(linewidth=3.0)
assert line.get_linewidth() == 3.0
told = [bool(kind.set.__doc__ and "linewidth" in kind.set.__doc__) for kind in (Line2D, Later)]
print(*told)
"""


def test_pictures_are_the_same(tmp_path: Path) -> None:
    told = []
    for way in ("with", "without"):
        call = [sys.executable, "-c", PROGRAM, way, str(tmp_path / way)]
        told.append(subprocess.run(call, capture_output=True, text=True, check=True).stdout.split())
    assert told == [["True", "True"], ["False", "True"]]
    pictures = sorted(file.name for file in (tmp_path / "with").glob("*.png"))
    assert len(pictures) >= 3
    for name in pictures:
        assert (tmp_path / "with" / name).read_bytes() == (tmp_path / "without" / name).read_bytes()
