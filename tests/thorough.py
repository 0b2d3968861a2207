"""How much of what could be tested at length the tests do: `VISCODESIGN_TESTS=all` asks for all."""

from __future__ import annotations

import os
from pathlib import Path

from tests.scenes import ACTUATOR_SPECS
from viscodesign import load

ALL = os.environ.get("VISCODESIGN_TESTS") == "all"


def configs() -> list[Path]:
    """Every bundled config, or the first of each kind: others differ from it by numbers alone."""
    paths = ACTUATOR_SPECS
    if ALL:
        return paths
    return list({_kind(path): path for path in reversed(paths)}.values())[::-1]


def _kind(path: Path) -> tuple[object, ...]:
    scene = load(path)
    inputs = tuple((name, source.kind) for name, source in scene.inputs.items())
    network = (scene.network.layout, scene.bellows.count, scene.fluid.name)
    return (*network, inputs, repr(scene.effects), scene.run.start, repr(scene.loads.gravity))
