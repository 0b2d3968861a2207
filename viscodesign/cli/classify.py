"""`viscodesign classify`: specs on the plane of the paper's Figure 1."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from viscodesign.cli.options import Answer, Output, Overrides, PictureStyle, PictureWidth, Specs
from viscodesign.report.picture_options import PictureOptions, picture_options

if TYPE_CHECKING:
    from viscodesign.results.findings import Classification

EXAMPLE = """\b
Examples:
  viscodesign classify leg.yaml
  viscodesign classify configs/*.yaml --plot plane.png"""

PICTURES = (".png", ".pdf", ".svg")


def command(
    specs: Specs,
    plot: Annotated[
        Path | None,
        typer.Option(
            "--plot", metavar="FILE", help="Draw the plane of Figure 1 (.png, .pdf or .svg)."
        ),
    ] = None,
    style: PictureStyle = "plain",
    width: PictureWidth = None,
    overrides: Overrides = None,
    output: Output = None,
    *,
    answer: Answer,
) -> None:
    """Place specs on the plane of timescales.

    Prints timescales, ratios and quadrant of each spec; solves nothing. With -o also writes
    DIR/classification.json. --set applies to every spec.
    """
    from viscodesign import RobotScene
    from viscodesign.checks.check_several import classified
    from viscodesign.cli.output import json_text, write_text
    from viscodesign.cli.specs import read_any
    from viscodesign.results.findings import classification_document
    from viscodesign.results.provenance import provenance

    picture, pictures = _picture(plot), picture_options("png", style, width)
    found: list[Classification] = []
    for spec in specs:
        scene = read_any(spec, overrides)
        if isinstance(scene, RobotScene):
            from viscodesign.robot.robot_check import classify_robot

            found += classify_robot(scene)
        else:
            found += classified(scene)
    documents = [classification_document(c) for c in found]
    document = {"specs": documents, "provenance": provenance()}
    if output is not None:
        write_text(output / "classification.json", json_text(document) + "\n", overwrite=True)
    if picture is not None:
        _draw(found, picture, pictures)
    answer.give(document, _lines(found))


def _picture(plot: Path | None) -> Path | None:
    from viscodesign.errors import UsageError

    if plot is not None and plot.suffix.lower() not in PICTURES:
        raise UsageError(f"--plot {plot}: unknown format; use {', '.join(PICTURES)}")
    return plot


def _draw(found: Sequence[Classification], picture: Path, pictures: PictureOptions) -> None:
    from viscodesign.errors import UsageError
    from viscodesign.report.charts.quadrants import draw_plane
    from viscodesign.report.layout.look import drawn_as

    try:
        picture.parent.mkdir(parents=True, exist_ok=True)
        with drawn_as(pictures):
            draw_plane(found, picture)
    except OSError as error:
        raise UsageError(f"cannot write {picture}: {error.strerror or error}") from error


def _lines(found: Sequence[Classification]) -> list[str]:
    from viscodesign.cli.texts.layout import number, table

    rows: list[tuple[str, ...]] = [
        ("spec", "quadrant", "t_s", "t_f", "t_i", "t_net", "t_s/t_f", "t_s/t_i", "t_net/t_i")
    ]
    for c in found:
        scales = c.scales
        times = (number(t, "s") for t in (scales.t_s, scales.t_f, scales.t_i, scales.t_net))
        ratios = (number(r) for r in scales.ratios.values())
        rows.append((c.name, c.quadrant, *times, *ratios))
    return [*table(rows, indent=""), "", *_meanings(found)]


def _meanings(found: Sequence[Classification]) -> list[str]:
    from viscodesign.cli.texts.check_text import quadrant_lines
    from viscodesign.cli.texts.layout import wrap

    lines: list[str] = []
    for c in found:
        lines += quadrant_lines(c)
        codes = ", ".join(dict.fromkeys(notice.code for notice in c.warnings))
        lines += wrap(f"warnings (see check): {codes}", "  ", "    ") if codes else []
    return lines
