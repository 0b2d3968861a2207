"""The site: `make docs`, or python -m sphinx -W -b html docs site."""

from __future__ import annotations

import re
from functools import partial
from pathlib import Path, PurePosixPath
from typing import TYPE_CHECKING

from viscodesign import __version__

if TYPE_CHECKING:
    from sphinx.application import Sphinx

project = "viscodesign"
release = __version__
extensions = ["myst_parser", "sphinx.ext.autodoc"]
html_theme = "furo"
html_title = f"viscodesign {__version__}"
html_show_sphinx = False
html_show_copyright = False
default_role = "code"
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_default_options = {
    "members": True,
    "undoc-members": True,
    "inherited-members": "BaseModel, SpecPart, Exception, BaseException, KeyboardInterrupt, object",
    "exclude-members": "model_config, model_post_init",
}
"""Fields without a text of their own are named, and so is what a class has of a base of ours."""
myst_heading_anchors = 3
myst_enable_extensions = ["attrs_inline"]
suppress_warnings = ["myst.header"]  # the README begins with a picture, not with a title

DOCS = Path(__file__).resolve().parent
README = (DOCS.parent / "README.md").read_text(encoding="utf-8")
LINK = re.compile(r"(?<!!)\[([^\]]*)\]\((?!https?:|#)([^)\s]+)\)")


def setup(app: Sphinx) -> None:
    """The README is the first page, and links stay inside of the site."""
    app.connect("source-read", _prepare)


def _prepare(app: Sphinx, name: str, source: list[str]) -> None:
    del app
    if name == "index":
        source[0] = README.replace("](docs/", "](") + source[0]
    folder = (DOCS / name).parent
    source[0] = LINK.sub(partial(_inside, folder), source[0])


def _inside(folder: Path, match: re.Match[str]) -> str:
    """A link of a page in a folder to a file that the site does not have, as this file's name."""
    words, target = match[1], match[2].partition("#")[0]
    file = (folder / target).resolve()
    if file.is_file() and file.is_relative_to(DOCS):
        return match[0]
    name = str(PurePosixPath(target)).replace("../", "")
    return words if name in words else f"{words} (`{name}`)"
