"""`spec:` the version of the keys."""

from __future__ import annotations

from collections.abc import Callable

import pytest
import yaml

from tests.scenes import CONFIGS, leg
from viscodesign import load_robot, load_several
from viscodesign.errors import SpecError
from viscodesign.scene.reading.write import resolved_yaml


def test_a_spec_without_a_version_is_of_the_first_and_is_written_with_it() -> None:
    scene = leg()
    assert scene.spec == 1
    assert "spec" not in scene.model_fields_set
    assert next(iter(yaml.safe_load(resolved_yaml(scene)).items())) == ("spec", 1)
    assert leg("spec=1").spec == 1


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ("2", "reads version 1 only. Install a newer viscodesign"),
        ("0", "there is no version 0 of the keys; write `spec: 1`"),
        ("-1", "there is no version -1"),
        ("1.0", "expected 1, the version of the keys; got 1.0"),
        ("on", "got 'on'"),
        ("leg.yaml", "got 'leg.yaml'"),
        ("null", "got nothing"),
    ],
)
def test_another_version_is_refused_before_its_keys(given: str, words: str) -> None:
    with pytest.raises(SpecError) as refusal:
        leg(f"spec={given}", "key_of_a_later_version=3")
    assert words in str(refusal.value)
    assert len(refusal.value.faults) == 1


@pytest.mark.parametrize(
    ("load_kind", "config"), [(load_robot, "hexapod"), (load_several, "three_legs")]
)
def test_other_kinds_of_spec_say_the_same_of_their_version(
    load_kind: Callable[..., object], config: str
) -> None:
    with pytest.raises(SpecError, match=r"reads version 1 only\. Install"):
        load_kind(CONFIGS / f"{config}.yaml", ["spec=2"])
