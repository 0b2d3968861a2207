"""Pictures do not depend on the backend, the theme or the settings file of the desk they are drawn at."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.scenes import ROOT
from tests.trajectories import made_run
from viscodesign.report.folder import PAGE, RUN_PICTURES, RUN_TABLES
from viscodesign.report.picture_options import FORMATS, PictureOptions, picture_name
from viscodesign.report.run_folder import write_run

DRAWS = (
    "import sys\n"
    "from pathlib import Path\n"
    "from tests.trajectories import made_run\n"
    "from viscodesign.report.run_folder import write_run\n"
    "write_run(made_run(), Path(sys.argv[1]))\n"
)
BACKENDS = (
    "module://matplotlib_inline.backend_inline",
    "module://nonexistent",
    "nonsense",
    "TkAgg",
    "pdf",
    "",
)
DARK = """
axes.facecolor: black
figure.facecolor: black
text.color: white
axes.labelcolor: white
xtick.color: white
ytick.color: white
axes.edgecolor: white
"""
THEMES = {
    "dark": DARK,
    "autolayout": "figure.autolayout: True\n",
    "tight": "savefig.bbox: tight\nsavefig.transparent: True\nfigure.dpi: 40\n",
    "lines": "lines.linewidth: 9\naxes.grid: True\nfont.size: 20\n",
    "unknown keys": "no.such.key: 3\nbackend: nonsense\nfont.size: big\n",
    "latex": "text.usetex: True\naxes.formatter.use_mathtext: True\n",
}


def drawn(folder: Path, desk: Path, **environment: str) -> dict[str, bytes]:
    """The pictures that a fresh process draws at a desk."""
    done = subprocess.run(
        [sys.executable, "-c", DRAWS, str(folder)],
        capture_output=True, text=True, cwd=desk,
        env={**os.environ, "PYTHONPATH": str(ROOT), **environment},
    )  # fmt: skip
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    assert (folder / "summary.json").exists()
    return {name: (folder / name).read_bytes() for name in RUN_PICTURES}


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> dict[str, bytes]:
    """The pictures of a desk without settings."""
    return drawn(tmp_path_factory.mktemp("plain") / "run", tmp_path_factory.mktemp("desk"))


@pytest.mark.parametrize(("backend", "theme"), list(zip(BACKENDS, THEMES, strict=True)))
def test_no_backend_and_no_setting_of_a_user_shows(
    backend: str, theme: str, plain: dict[str, bytes], tmp_path: Path
) -> None:
    (tmp_path / "matplotlibrc").write_text(THEMES[theme])
    assert drawn(tmp_path / "run", tmp_path, MPLBACKEND=backend) == plain


def test_the_backend_of_a_notebook_is_kept_for_its_own_pictures(tmp_path: Path) -> None:
    lines = (
        "import os, viscodesign.report.charts.tip, matplotlib",
        "print(matplotlib.rcParams['backend'], os.environ['MPLBACKEND'])",
    )
    done = subprocess.run(
        [sys.executable, "-c", "\n".join(lines)],
        capture_output=True, text=True, check=True, cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(ROOT), "MPLBACKEND": "svg"},
    )  # fmt: skip
    assert done.stdout == "svg svg\n"


def test_figures_of_the_users_own_still_show_after_ours(tmp_path: Path) -> None:
    """A notebook's backend is loaded by the first figure, and then asks to show all of them."""
    (tmp_path / "late_backend.py").write_text(
        "import matplotlib\n"
        "from matplotlib.backends.backend_agg import *\n"
        "matplotlib.interactive(True)\n"
    )
    lines = (
        "from tests.trajectories import made_run",
        "made_run().plot.tip()",
        "import matplotlib",
        "print(matplotlib.is_interactive())",
    )
    done = subprocess.run(
        [sys.executable, "-c", "\n".join(lines)],
        capture_output=True, text=True, check=True, cwd=tmp_path,
        env={
            **os.environ, "MPLBACKEND": "module://late_backend",
            "PYTHONPATH": os.pathsep.join([str(ROOT), str(tmp_path)]),
        },
    )  # fmt: skip
    assert done.stdout == "True\n"


BEGINNINGS = {"png": b"\x89PNG", "pdf": b"%PDF", "svg": b"<?xml"}


@pytest.mark.parametrize("kind", FORMATS)
def test_pictures_in_every_format(kind: str, tmp_path: Path) -> None:
    run = made_run()
    write_run(run, tmp_path)
    chosen = next(each for each in FORMATS if each == kind)
    written = write_run(run, tmp_path, pictures=PictureOptions(chosen))
    pictures = [picture_name(name, chosen) for name in RUN_PICTURES]
    assert [file.name for file in written] == [*RUN_TABLES, *pictures, PAGE, "summary.json"]
    assert {file.name for file in tmp_path.iterdir()} == {file.name for file in written}
    for name in pictures:
        assert (tmp_path / name).read_bytes().startswith(BEGINNINGS[kind])


@pytest.mark.parametrize("kind", FORMATS)
def test_the_same_picture_is_the_same_file(kind: str, tmp_path: Path) -> None:
    chosen = next(each for each in FORMATS if each == kind)
    for folder in ("a", "b"):
        write_run(made_run(), tmp_path / folder, pictures=PictureOptions(chosen))
    name = picture_name("tip.png", chosen)
    assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()
