"""Tables for tests, written into files as loggers write them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.scenes import CONFIGS
from viscodesign import Scene, load
from viscodesign.errors import SpecError
from viscodesign.scene.inputs.table import TableInput

LEG = (CONFIGS / "leg_16_straight_air.yaml").read_text()


def table(folder: Path, text: str | bytes, **keys: Any) -> TableInput:
    """The input that a file's text is read into."""
    scene = scene_of(folder, text, **keys)
    assert isinstance(scene.input, TableInput)
    return scene.input


def scene_of(folder: Path, text: str | bytes, *overrides: str, **keys: Any) -> Scene:
    """The paper's leg with the table in a file as its input."""
    (folder / "in.csv").write_bytes(text if isinstance(text, bytes) else text.encode())
    file = folder / "leg.yaml"
    file.write_text(LEG)
    given = ", ".join(f"{key}: {value}" for key, value in {"file": "in.csv", **keys}.items())
    return load(file, [f"input={{kind: table, {given}}}", *overrides])


def refusal(folder: Path, text: str | bytes, **keys: Any) -> str:
    """The message that refuses a table."""
    with pytest.raises(SpecError) as caught:
        scene_of(folder, text, **keys)
    return str(caught.value)
