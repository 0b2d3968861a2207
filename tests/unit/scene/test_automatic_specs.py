"""Every scene of the paper has a twin that differs by its effects alone."""

from __future__ import annotations

import pytest

from tests.scenes import ACTUATOR_SPECS, CONFIGS, leg
from viscodesign.scene.reading.write import resolved_yaml

PINNED = sorted(
    path.stem for path in ACTUATOR_SPECS if leg(config=path.stem).effects.others == "off"
)
TWINS = sorted(path.stem for path in CONFIGS.glob("*_auto.yaml"))


def test_the_scenes_of_the_paper_are_pinned() -> None:
    assert len(PINNED) >= 15


def test_every_pinned_spec_has_an_automatic_counterpart() -> None:
    assert [f"{name}_auto" for name in PINNED] == TWINS


@pytest.mark.parametrize("name", PINNED)
def test_an_automatic_spec_differs_in_its_effects_only(name: str) -> None:
    original, twin = leg(config=name), leg(config=f"{name}_auto")
    own, other = original.model_dump(), twin.model_dump()
    assert twin.effects.others == "auto"
    assert not twin.effects.modes
    assert {key for key in own if own[key] != other[key]} == {"name", "effects"}
    assert twin.name == f"{name}_auto"


@pytest.mark.parametrize("name", PINNED)
def test_resolved_specs_differ_in_their_effects_only(name: str) -> None:
    texts = [resolved_yaml(leg(config=stem)) for stem in (name, f"{name}_auto")]
    own, other = (_without_effects(text) for text in texts)
    assert own[:2] == ["spec: 1", f"name: {name}"]
    assert other == ["spec: 1", f"name: {name}_auto", *own[2:]]


@pytest.mark.parametrize("name", PINNED)
def test_apart_from_effects_an_automatic_spec_equals_its_original(name: str) -> None:
    """Comments as well: one of the two is changed only with the other."""
    bodies = []
    for stem in (name, f"{name}_auto"):
        text = (CONFIGS / f"{stem}.yaml").read_text(encoding="utf-8")
        bodies.append(_without_effects(text[text.index("\nactuator:") :]))
    assert bodies[0] == bodies[1]


def _without_effects(text: str) -> list[str]:
    """Lines of a spec but for the block `effects:` and empty ones."""
    lines, inside = [], False
    for line in text.splitlines():
        if line and not line.startswith(" "):
            inside = line.startswith("effects:")
        if line and not inside:
            lines.append(line)
    return lines


@pytest.mark.parametrize("twin", TWINS)
def test_the_first_line_describes_an_automatic_spec(twin: str) -> None:
    first, second = (CONFIGS / f"{twin}.yaml").read_text(encoding="utf-8").splitlines()[:2]
    assert first.startswith(
        f"# {twin.removesuffix('_auto')} with automatically selected effects instead"
    )
    assert second == "#"
