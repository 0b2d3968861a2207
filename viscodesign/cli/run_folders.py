"""The folder of a run: one of its own for every spec that has the same name."""

from __future__ import annotations

import json
from collections.abc import Container
from pathlib import Path

from viscodesign.report.folder_names import folder_name as folder_name
from viscodesign.report.folder_names import numbered
from viscodesign.scene.reading.write import resolved_sha256
from viscodesign.scene.scene import Scene
from viscodesign.scene.several_scene import SeveralScene

RUNS = Path("runs")
KEY = "resolved_sha256"
"""Key of every document in such a folder that says which resolved spec it belongs to."""


def folder_for(
    scene: Scene | SeveralScene,
    output: Path | None,
    taken: Container[Path] | None = None,
    suffix: str = "",
) -> tuple[Path, str]:
    """The folder for a scene's results, and a remark where that is not the one expected.

    ``output``: the folder given by -o; that of all specs where some folders are ``taken``.
    """
    if output is None:
        return own_folder(scene, suffix)
    return (output if taken is None else folder_in(output, scene, taken)), ""


def named_folder(name: str, output: Path | None, suffix: str = "") -> Path:
    """The folder given by -o, or that of a name in `runs`, whatever is in it."""
    return RUNS / (folder_name(name) + suffix) if output is None else output


def own_folder(scene: Scene | SeveralScene, suffix: str = "") -> tuple[Path, str]:
    """The folder in `runs` for a scene, and what to say where that is not the plain one.

    Results of an equal scene are replaced there; those of another one with the same name stay
    (another file, other values by `--set`), and the next free number is taken.
    """
    plain = named_folder(scene.name, None, suffix)
    digest = resolved_sha256(scene)
    chosen = next(path for path in numbered(plain) if not holds_another(path, digest))
    if chosen == plain:
        return plain, ""
    return chosen, (
        f"{plain} holds results of another spec of this name; these are in {chosen} "
        "(-o DIR chooses a folder, and replaces what is there)"
    )


def folder_in(output: Path, scene: Scene | SeveralScene, taken: Container[Path]) -> Path:
    """The folder in a chosen one for a scene, none of those that are taken."""
    return next(path for path in numbered(output / folder_name(scene.name)) if path not in taken)


def holds_another(folder: Path, digest: str) -> bool:
    """Whether a folder holds results of another resolved spec than the one of this SHA-256."""
    from viscodesign.report.folder import DOCUMENTS

    return any(_digest_in(folder / name) not in (None, digest) for name in DOCUMENTS)


def _digest_in(document: Path) -> str | None:
    """The resolved spec that a document is of; None without a document, '' if it does not say."""
    try:
        found = json.loads(document.read_bytes())
    except FileNotFoundError:
        return None
    except (OSError, ValueError):
        return ""
    return str(found.get(KEY, "")) if isinstance(found, dict) else ""
