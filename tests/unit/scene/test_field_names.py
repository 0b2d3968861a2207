"""A field of a part of a spec that would hide an attribute of its base is refused."""

from __future__ import annotations

import warnings
from typing import ClassVar

import pytest
from pydantic import Field

from viscodesign.errors import UsageError
from viscodesign.scene.input import INPUT_KINDS
from viscodesign.scene.inputs.base import Input, PiecewiseLinear
from viscodesign.scene.inputs.harmonics import HarmonicsInput
from viscodesign.scene.pumps.base import PumpSpec


@pytest.mark.parametrize("base", [Input, PiecewiseLinear])
@pytest.mark.parametrize("name", ["period", "corners", "gives_pressure", "name", "model_dump"])
@pytest.mark.parametrize("has_default", [True, False])
def test_an_input_cannot_name_a_field_as_an_attribute(
    base: type[Input], name: str, has_default: bool
) -> None:
    body = {"__annotations__": {name: float}, **({name: Field(gt=0)} if has_default else {})}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(UsageError, match=rf"Own\.{name}: a field cannot.*alias='{name}'"):
            type("Own", (base,), body)


def test_the_message_names_the_class_that_has_the_attribute() -> None:
    with pytest.raises(UsageError, match="of an attribute of PumpSpec; give it another name"):
        type("Own", (PumpSpec,), {"__annotations__": {"axes": "int"}})


def test_keys_by_alias_class_variables_and_fields_of_the_base_may_be_given() -> None:
    class Own(HarmonicsInput):
        coefficients: ClassVar[int] = 26
        mean: float = 1.0

    assert Own.model_fields["cycle"].alias == "period"
    assert Own.model_fields["mean"].default == 1.0
    assert "harmonics" in INPUT_KINDS
