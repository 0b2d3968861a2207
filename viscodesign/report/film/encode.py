"""Frames of pixels as a film."""

from __future__ import annotations

import contextlib
import io
import itertools
import shutil
import subprocess
import tempfile
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from viscodesign.errors import UsageError
from viscodesign.report.film.film_plan import LAST_FRAME_HOLD, FilmOptions
from viscodesign.report.film.palette import MAX_COLOURS, film_palette
from viscodesign.report.layout.look import LOOKS
from viscodesign.storage.atomic_files import replaced

if TYPE_CHECKING:
    from PIL.Image import Image

WEBP_QUALITY, WEBP_EFFORT = 80, 2
FFMPEG = "ffmpeg"


def write_frames(
    frames: Iterable[np.ndarray], count: int, file: Path, options: FilmOptions
) -> None:
    """Write pixels (height, width, 4), uint8, as GIF, WebP or MP4, by the suffix of ``file``."""
    kind = file.suffix.lower()
    if kind == ".mp4":
        _write_mp4(frames, file, options)
        return
    pause = round(1000 / options.frames_per_second)
    pauses = [pause] * (count - 1) + [pause + round(1000 * LAST_FRAME_HOLD)]
    pictures = _gif_pictures(frames, options) if kind == ".gif" else _pictures(frames, options)
    first = next(pictures)
    told = {"disposal": 2 if options.transparent else 1, "optimize": False}
    if kind == ".webp":
        told = {"quality": WEBP_QUALITY, "method": WEBP_EFFORT}
    content = io.BytesIO()
    first.save(
        content, kind[1:].upper(), save_all=True, append_images=pictures,
        duration=pauses if count > 1 else pause, loop=0, **told,
    )  # fmt: skip
    with replaced(file) as opened:
        opened.write(content.getbuffer())


def _pictures(frames: Iterable[np.ndarray], options: FilmOptions) -> Iterator[Image]:
    from PIL import Image

    for pixels in frames:
        yield Image.fromarray(
            np.ascontiguousarray(pixels if options.transparent else pixels[..., :3])
        )


def _gif_pictures(frames: Iterable[np.ndarray], options: FilmOptions) -> Iterator[Image]:
    """Pictures with one palette for all, or colours would flicker.

    A pixel of a GIF is transparent or not: edges are drawn on the ground of the style first.
    """
    from PIL import Image

    palette: Image.Image | None = None
    for picture in _pictures(frames, options):
        flat = _on_ground(picture, options) if options.transparent else picture
        if palette is None:
            palette = film_palette(flat, LOOKS[options.style])
        made = flat.quantize(palette=palette, dither=Image.Dither.NONE)
        yield _without_ground(made, picture) if options.transparent else made


def _on_ground(picture: Image, options: FilmOptions) -> Image:
    from PIL import Image

    ground = Image.new("RGBA", picture.size, LOOKS[options.style].ground)
    return Image.alpha_composite(ground, picture).convert("RGB")


def _without_ground(made: Image, picture: Image) -> Image:
    """A picture of a palette, transparent where less than half of a pixel is covered."""
    from PIL import Image

    solid = np.asarray(picture.getchannel("A")) >= 128
    indices = np.where(solid, np.asarray(made), MAX_COLOURS).astype(np.uint8)
    found = Image.fromarray(indices, "P")
    found.putpalette(made.getpalette() or [])
    found.info["transparency"] = MAX_COLOURS
    return found


def _write_mp4(frames: Iterable[np.ndarray], file: Path, options: FilmOptions) -> None:
    program = shutil.which(FFMPEG)
    if program is None:
        raise UsageError(
            f"{file.name}: MP4 needs the program ffmpeg, which is not installed. "
            "Install it, or use .webp or .gif"
        )
    width, height = options.size
    with tempfile.TemporaryDirectory() as folder, replaced(file) as opened:
        made = Path(folder) / "film.mp4"
        words = [
            program, "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgba",
            "-s", f"{width}x{height}", "-r", str(options.frames_per_second), "-i", "-",
            "-an", "-c:v", "libx264",
            "-pix_fmt", "yuv420p", "-crf", "20",
            "-movflags", "+faststart", str(made),
        ]  # fmt: skip
        _fed(words, frames, options)
        opened.write(made.read_bytes())


def _fed(words: list[str], frames: Iterable[np.ndarray], options: FilmOptions) -> None:
    """Run ffmpeg with the pixels on its standard input; `UsageError` with its words if it fails."""
    with tempfile.TemporaryFile() as told:
        process = subprocess.Popen(words, stdin=subprocess.PIPE, stderr=told)
        assert process.stdin is not None
        try:
            with contextlib.suppress(BrokenPipeError):  # it says why
                for pixels in _with_hold(frames, options):
                    process.stdin.write(pixels.data)
        except BaseException:
            process.kill()
            raise
        finally:
            with contextlib.suppress(BrokenPipeError):
                process.stdin.close()
            status = process.wait()
        if status:
            told.seek(0)
            lines = told.read().decode(errors="replace").strip().splitlines()
            raise UsageError(f"ffmpeg failed: {lines[-1] if lines else f'status {status}'}")


def _with_hold(frames: Iterable[np.ndarray], options: FilmOptions) -> Iterator[np.ndarray]:
    """The frames, and the last one again for a while."""
    pixels = np.zeros(0, dtype=np.uint8)
    for pixels in frames:
        yield pixels
    yield from itertools.repeat(pixels, round(LAST_FRAME_HOLD * options.frames_per_second))
