"""Films: their frames, their formats, and what cannot be filmed."""

from __future__ import annotations

import itertools
import shutil
import subprocess
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from tests.scenes import CONFIGS
from tests.trajectories import made_run, with_two_inlets
from viscodesign.cli.main import main
from viscodesign.errors import UsageError
from viscodesign.report.film import encode
from viscodesign.report.film.film_frames import film_frames
from viscodesign.report.film.film_plan import FilmOptions, film_rows, usual_speed
from viscodesign.report.run_folder import write_run
from viscodesign.results.findings import Notice

SMALL = {"width": 240, "frames_per_second": 2, "speed": 1.0}


def frames(file: Path) -> list[np.ndarray]:
    found = []
    with Image.open(file) as film:
        for k in range(getattr(film, "n_frames", 1)):
            film.seek(k)
            found.append(np.asarray(film.convert("RGBA")))
    return found


@pytest.mark.parametrize("kind", ["gif", "webp"])
def test_a_film_shows_the_motion_on_white(tmp_path: Path, kind: str) -> None:
    run = made_run(time=np.linspace(0, 4, 201))
    film = frames(run.film(tmp_path / f"leg.{kind}", **SMALL))
    assert len(film) == 9  # 4 s, two a second, both ends
    assert {frame.shape for frame in film} == {(136, 240, 4)}  # both even, as MP4 needs it
    assert film[0][1, 1].min() >= 254  # WebP rounds
    moved = [np.mean(np.abs(a[:, :110].astype(int) - b[:, :110])) for a, b in pairwise(film)]
    assert max(moved) > 1
    left = film[4][20:110, :110, :3].astype(int)
    assert (left[..., 2] - left[..., 0] > 60).sum() > 20, "no bellow is blue under vacuum"


def test_a_dark_film_is_light_on_dark(tmp_path: Path) -> None:
    run = made_run(time=np.linspace(0, 1, 51))
    film = frames(run.film(tmp_path / "leg.gif", dark=True, **SMALL))
    for frame in film:
        assert frame[1, 1, :3].max() < 40
        assert (frame[..., :3].min(axis=2) > 180).mean() > 0.005


@pytest.mark.parametrize("kind", ["gif", "webp"])
@pytest.mark.parametrize("dark", [False, True])
def test_a_transparent_film_has_no_ground(tmp_path: Path, kind: str, dark: bool) -> None:
    run = made_run(time=np.linspace(0, 1, 26))
    film = frames(run.film(tmp_path / f"leg.{kind}", transparent=True, dark=dark, **SMALL))
    for frame in film:
        assert frame[1, 1, 3] == 0
        within = frame[28:114, 132:228]  # the plot of pressures
        assert (within[..., 3] == 0).mean() > 0.5
        assert 0.02 < (frame[..., 3] > 128).mean() < 0.4


def test_a_gif_keeps_the_colours_of_the_data(tmp_path: Path) -> None:
    """Against the pixels as they were drawn, of a later frame than the one a palette is made of."""
    run, options = made_run(time=np.linspace(0, 4, 101)), FilmOptions(**{**SMALL, "width": 480})
    rows = film_rows(run.time, options)
    drawn = [frame[..., :3].astype(int) for frame in film_frames(run, [], rows, options)]
    film = frames(run.film(tmp_path / "leg.gif", **{**SMALL, "width": 480}))
    for own, true in list(zip(film, drawn, strict=True))[3:7]:
        flat = np.ones(true.shape[:2], dtype=bool)  # away from edges
        for axis, step in itertools.product((0, 1), (-1, 1)):
            flat &= (np.roll(true, step, axis=axis) == true).all(axis=2)
        coloured = flat & (np.ptp(true, axis=2) > 30)
        assert coloured.sum() > 300
        assert np.abs(own[..., :3][coloured] - true[coloured]).max() <= 8


def test_a_film_of_a_run_outside_of_its_model_says_so(tmp_path: Path) -> None:
    part = np.linspace(0, 1, 11)
    outside = made_run(time=part, violations=(Notice("choking", "it chokes", "inlet-R1", 0.5),))
    film = frames(outside.film(tmp_path / "o.webp", **SMALL))
    top = film[0][8:22, :160, :3].astype(int)
    assert int((top[..., 0] - top[..., 2] > 100).sum()) > 100


@pytest.mark.skipif(shutil.which("ffprobe") is None, reason="needs ffmpeg: apt-get install ffmpeg")
def test_an_mp4_is_what_players_expect(tmp_path: Path) -> None:
    run = made_run(time=np.linspace(0, 1, 51))
    file = run.film(tmp_path / "leg.mp4", width=241, frames_per_second=10, speed=1.0)
    told = subprocess.run(
        ["ffprobe", "-v", "error", "-show_entries", "stream=width,height,nb_frames,pix_fmt", "-of", "csv=p=0", file],
        capture_output=True, text=True, check=True,
    )  # fmt: skip
    assert told.stdout.strip() == "240,136,yuv420p,16"  # 11, and the last is held for half a second


def test_without_ffmpeg_mp4_is_refused_and_nothing_is_left(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(encode.shutil, "which", lambda _: None)
    with pytest.raises(UsageError, match=r"needs the program ffmpeg.*use \.webp or \.gif"):
        made_run(time=np.linspace(0, 1, 3)).film(tmp_path / "leg.mp4", **SMALL)
    assert list(tmp_path.iterdir()) == []


def test_a_program_that_fails_says_why(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    broken = tmp_path / "ffmpeg"
    broken.write_text("#!/bin/sh\necho 'no such codec' >&2\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setattr(encode.shutil, "which", lambda _: str(broken))
    with pytest.raises(UsageError, match="ffmpeg failed: no such codec"):
        made_run(time=np.linspace(0, 1, 3)).film(tmp_path / "out" / "leg.mp4", **SMALL)
    assert list(tmp_path.iterdir()) == [broken]


def test_a_failed_run_says_so_in_every_frame(tmp_path: Path) -> None:
    part = np.linspace(0, 1, 51)
    failed = made_run(time=part, status="failed", failure="it broke").film(
        tmp_path / "f.webp", **SMALL
    )
    whole = made_run(time=part).film(tmp_path / "w.webp", **SMALL)

    def banner(frame: np.ndarray) -> int:
        top = frame[8:22, :120, :3].astype(int)
        return int((top[..., 0] - top[..., 2] > 100).sum())

    assert min(banner(frame) for frame in frames(failed)) > 100
    assert max(banner(frame) for frame in frames(whole)) == 0


@pytest.mark.parametrize(
    "case",
    [
        {"time": np.zeros(1)},
        {"bellows": 2},
        {"bellows": 128, "lag": 1e-3},
        {"shape_every": 7},
    ],
    ids=["one_time", "two_bellows", "many_bellows", "few_shapes"],
)
def test_every_run_can_be_filmed(tmp_path: Path, case: dict[str, object]) -> None:
    run = made_run(**{"time": np.linspace(0, 1, 43), **case})  # type: ignore[arg-type]
    if run.shape_every > 1:
        run = run.with_arrays(shape=run.shape[run.shape_rows])
    two = with_two_inlets(
        run, -0.5, spec_text=(CONFIGS / "antagonistic_two_inlets.yaml").read_text()
    )
    assert len(frames(two.film(tmp_path / "leg.webp", **SMALL))) in (1, 3)


@pytest.mark.parametrize(
    ("name", "options", "told"),
    [
        ("leg.avi", {}, "is .gif, .webp or .mp4; got '.avi'"),
        ("leg", {}, "got no suffix"),
        ("leg.mp4", {"transparent": True}, "MP4 has no transparent ground"),
        ("leg.gif", {"speed": 0.0}, r"speed \(--speed\) must be a number above 0; got 0.0"),
        ("leg.gif", {"speed": float("nan")}, r"speed \(--speed\) must be a number above 0"),
        ("leg.gif", {"frames_per_second": 51}, r"\(--fps\) must be 1 to 50; got 51"),
        ("leg.gif", {"width": 10}, r"width \(--width\) must be 160 to 3840 pixels; got 10"),
        ("leg.gif", {"speed": 1e-3}, "at most 3,000 are made. Use a speed of"),
    ],
)
def test_what_cannot_be_filmed_is_refused(
    tmp_path: Path, name: str, options: dict[str, object], told: str
) -> None:
    with pytest.raises(UsageError, match=told):
        made_run(time=np.linspace(0, 1, 5)).film(tmp_path / name, **{"speed": 1.0, **options})  # type: ignore[arg-type]
    assert list(tmp_path.iterdir()) == []


@pytest.fixture
def run_folder(tmp_path: Path) -> Path:
    text = (CONFIGS / "leg_16_straight_air.yaml").read_text()
    write_run(made_run(spec_text=text), tmp_path / "run", plots=False, report=False)
    return tmp_path / "run"


def interrupted(frames: int) -> object:
    """Frames of a film of which Ctrl-C comes after a few."""

    def made(
        run: object, tubes: object, rows: object, options: FilmOptions
    ) -> Iterator[np.ndarray]:
        for _ in range(frames):
            yield np.zeros((*options.size[::-1], 4), dtype=np.uint8)
        raise KeyboardInterrupt

    return made


@pytest.mark.parametrize("kind", ["gif", "webp"])
@pytest.mark.parametrize("earlier", [b"", b"an earlier film"])
def test_an_interrupted_film_says_what_is_kept(
    run_folder: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    kind: str,
    earlier: bytes,
) -> None:
    monkeypatch.setattr("viscodesign.report.film.film_frames.film_frames", interrupted(2))
    film = run_folder.parent / "films" / f"leg.{kind}"
    if earlier:
        film.parent.mkdir()
        film.write_bytes(earlier)
    assert main(["report", str(run_folder), "--film", str(film)]) == 130
    told = capsys.readouterr()
    state = f"{film} is still the earlier one" if earlier else f"there is no {film}"
    assert told.err == f"interrupted; written before: {run_folder / 'report.html'}; {state}\n"
    assert told.out == ""
    assert (run_folder / "report.html").exists()
    assert film.parent.exists() == bool(earlier)
    assert not earlier or [file.read_bytes() for file in film.parent.iterdir()] == [earlier]


@pytest.mark.parametrize(
    ("place", "told"),
    [
        ("file/leg.gif", "Part of the path is a file"),
        ("file/deep/leg.gif", "Part of the path is a file"),
        ("folder.gif", "is a folder; name a file"),
        ("n" * 300 + "/leg.gif", "Use a shorter name"),
        ("/proc/nosuch/leg.gif", "cannot write /proc/nosuch/leg.gif"),
    ],
)
def test_a_film_with_no_place_is_refused_before_anything_is_written(
    run_folder: Path, capsys: pytest.CaptureFixture[str], place: str, told: str
) -> None:
    (run_folder.parent / "file").write_text("")
    (run_folder.parent / "folder.gif").mkdir()
    assert main(["report", str(run_folder), "--film", str(run_folder.parent / place)]) == 2
    assert told in capsys.readouterr().err
    assert not (run_folder / "report.html").exists()
    assert {file.name for file in run_folder.parent.iterdir()} == {"file", "folder.gif", "run"}


def test_frames_are_the_nearest_output_times() -> None:
    time = np.array([0.0, 0.1, 0.35, 1.0, 2.0, 2.04])
    rows = film_rows(time, FilmOptions(speed=1.0, frames_per_second=2))
    assert list(rows) == [0, 2, 3, 3, 4, 5]  # the last is added: it ends the run


def test_a_film_lasts_some_seconds_whatever_the_run() -> None:
    assert [usual_speed(span) for span in (0.0, 2.0, 8.0, 20.0)] == [1.0] * 4
    for span in (1e-9, 0.3, 21.0, 1e5):
        assert 4 < span / usual_speed(span) < 13


def test_the_command_writes_page_and_film(tmp_path: Path) -> None:
    text = (CONFIGS / "leg_16_straight_air.yaml").read_text()
    write_run(made_run(spec_text=text), tmp_path, plots=False, report=False)
    words = ["report", str(tmp_path), "-q", "--film", str(tmp_path / "leg.gif")]
    assert main([*words, "--width", "240", "--fps", "1"]) == 0
    assert len(frames(tmp_path / "leg.gif")) == 9
    assert (tmp_path / "report.html").exists()
    assert main(["report", str(tmp_path), "-q", "--film", str(tmp_path / "leg.avi")]) == 2
    assert (
        main(["report", str(tmp_path), "-q", "--pictures", "--style", "paper", "--format", "svg"])
        == 0
    )
    assert {file.name for file in tmp_path.glob("*.svg")} == {
        "tip.svg",
        "pressures.svg",
        "shapes.svg",
    }
    assert "leg_made_up" not in (tmp_path / "tip.svg").read_text()
