"""The schema accepts the bundled specs and refuses what the loader refuses."""

from __future__ import annotations

from typing import Any

import jsonschema
import pytest
import yaml

from tests.scenes import CONFIGS
from viscodesign.loading import schema

SPEC: dict[str, Any] = yaml.safe_load((CONFIGS / "leg_16_straight_air.yaml").read_text())


@pytest.fixture(scope="module")
def validator() -> jsonschema.Draft202012Validator:
    document = schema()
    jsonschema.Draft202012Validator.check_schema(document)
    return jsonschema.Draft202012Validator(document)


@pytest.mark.parametrize("config", [p.stem for p in sorted(CONFIGS.glob("*.yaml"))])
def test_bundled_specs_are_valid(config: str, validator: jsonschema.Draft202012Validator) -> None:
    validator.validate(yaml.safe_load((CONFIGS / f"{config}.yaml").read_text()))


@pytest.mark.parametrize(
    "change",
    [
        {"bellows": {**SPEC["bellows"], "cout": 4}},
        {"name": 3},
        {"network": {**SPEC["network"], "layout": "strait"}},
        {"input": {"kind": "wobble"}},
        {"effects": {"collapse": "sometimes"}},
        {"effects": {"nonsense": "on"}},
    ],
)
def test_broken_specs_are_invalid(
    change: dict[str, Any], validator: jsonschema.Draft202012Validator
) -> None:
    assert not validator.is_valid({**SPEC, **change})


def test_a_robot_without_damping_is_invalid(validator: jsonschema.Draft202012Validator) -> None:
    robot = yaml.safe_load((CONFIGS / "hexapod.yaml").read_text())
    assert validator.is_valid(robot)
    del robot["robot"]["damping_time"]
    assert not validator.is_valid(robot)
