"""What can be asked of a picture: its format, its style and its width."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Literal, get_args

from viscodesign.errors import UsageError, not_among
from viscodesign.lazy_dataclass import dataclass

Format = Literal["png", "pdf", "svg"]
"""Formats of the pictures."""
FORMATS: tuple[Format, ...] = get_args(Format)
Style = Literal["plain", "paper", "talk", "dark"]
"""Styles of the pictures: `plain` to look at, `paper` without titles and as wide as a page."""
STYLES: tuple[Style, ...] = get_args(Style)
COLUMNS_MM = {"single": 89.0, "double": 183.0}
"""Widths of one column and of a page of two in journals [mm]."""
STYLE_WIDTHS_MM = {"paper": COLUMNS_MM["double"], "talk": 130.0}
"""Widths of styles that do not leave it to the picture [mm]; narrow is large on a slide."""
WIDTHS_MM = (80.0, 400.0)
"""Widths that pictures are laid out for [mm]."""


@dataclass(frozen=True)
class PictureOptions:
    """Format, style and width of pictures."""

    format: Format = "png"
    style: Style = "plain"
    width_mm: float | None = None
    """[mm]; None: each picture has its own."""


AS_USUAL = PictureOptions()


def picture_options(
    picture_format: Format = "png", style: Style = "plain", width: str | float | None = None
) -> PictureOptions:
    """Options as they are given: ``width`` is `single`, `double` or a number of millimetres.

    Raises `UsageError` for a style or a width that there is not.
    """
    if picture_format not in FORMATS:
        raise UsageError(f"format of pictures: {not_among(picture_format, FORMATS)}")
    if style not in STYLES:
        raise UsageError(f"style of pictures: {not_among(style, STYLES)}")
    return PictureOptions(
        picture_format, style, STYLE_WIDTHS_MM.get(style) if width is None else _width_mm(width)
    )


def _width_mm(width: str | float) -> float:
    words = str(width).strip().removesuffix("mm").strip()
    if words in COLUMNS_MM:
        return COLUMNS_MM[words]
    low, high = WIDTHS_MM
    try:
        found = float(words)
    except ValueError:
        found = math.nan
    if not low <= found <= high:
        raise UsageError(
            f"width of pictures: got '{width}'; use single ({COLUMNS_MM['single']:g} mm), "
            f"double ({COLUMNS_MM['double']:g} mm), or {low:g} to {high:g} mm"
        )
    return found


def picture_name(name: str, picture_format: Format) -> str:
    """The name of a picture in another format."""
    return str(Path(name).with_suffix(f".{picture_format}"))
