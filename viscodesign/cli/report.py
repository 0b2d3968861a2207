"""`viscodesign report`: the page of a run again, and a film of it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from viscodesign.cli.options import Answer, Output, PictureFormat, PictureStyle
from viscodesign.report.picture_options import picture_options

EXAMPLE = """\b
Examples:
  viscodesign report runs/leg
  viscodesign report runs/leg --film leg.mp4
  viscodesign report runs/leg --film leg.webp --transparent --speed 2
  viscodesign report runs/leg --pictures --style paper --format pdf"""


def command(
    run: Annotated[Path, typer.Argument(metavar="DIR", help="Folder of a run.")],
    output: Output = None,
    film: Annotated[
        Path | None,
        typer.Option(
            "--film", metavar="FILE", help="Also write a film: .gif, .webp, or .mp4 with ffmpeg."
        ),
    ] = None,
    speed: Annotated[
        float | None,
        typer.Option(
            "--speed",
            metavar="X",
            help="Of the film: seconds of motion in a second; by default real time, or about "
            "eight seconds in all.",
        ),
    ] = None,
    frames_per_second: Annotated[
        int, typer.Option("--fps", metavar="N", help="Of the film: frames a second.")
    ] = 25,
    width: Annotated[
        int,
        typer.Option(
            "--width", metavar="PX", help="Of the film, made even; its height is 9/16 of it."
        ),
    ] = 960,
    transparent: Annotated[
        bool, typer.Option("--transparent", help="Of the film: no white ground (.webp, .gif).")
    ] = False,
    no_pressures: Annotated[
        bool, typer.Option("--no-pressures", help="Of the film: the actuator alone.")
    ] = False,
    pictures: Annotated[
        bool, typer.Option("--pictures", help="Also draw the pictures again.")
    ] = False,
    picture_format: PictureFormat = "png",
    style: PictureStyle = "plain",
    picture_width: Annotated[
        str | None,
        typer.Option(
            "--picture-width",
            metavar="MM",
            help="Width of the pictures: single (89 mm), double (183 mm) or 80 to 400 mm.",
        ),
    ] = None,
    *,
    answer: Answer,
) -> None:
    """Write the page of a run again, its pictures, and a film of it.

    Reads summary.json, spec.yaml and the tables of a run, of several actuators, or of a robot's
    gait, and solves nothing. With -o page and pictures go to another folder. A film is dark with
    --style dark, else plain.
    """
    from viscodesign.cli.film_file import film_file, told_what_is_kept
    from viscodesign.report.saved_run import saved_run

    drawing = picture_options(picture_format, style, picture_width)
    options: dict[str, Any] = {
        "speed": speed,
        "frames_per_second": frames_per_second,
        "width": width,
        "transparent": transparent,
        "dark": style == "dark",
        "pressures": not no_pressures,
    }
    files: list[Path] = []
    with film_file(film, **options), told_what_is_kept(files, film):
        shown, folder = saved_run(run), output if output is not None else run
        files += shown.pages(folder)
        if pictures:
            files += shown.pictures(folder, drawing)
        if film is not None:
            files.append(shown.film(film, **options))
    answer.give({}, map(str, files), files)
