"""The scene of a command for which a spec is optional."""

from __future__ import annotations

from pathlib import Path

from viscodesign.errors import UsageError
from viscodesign.loading import load
from viscodesign.scene.scene import Scene


def optional_scene(spec: Path | None, overrides: list[str] | None) -> Scene | None:
    """A spec's scene, if one is given."""
    if spec is not None:
        return load(spec, overrides or ())
    if overrides:
        raise UsageError("--set overrides a spec, and none is given")
    return None
