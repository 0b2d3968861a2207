"""`input:` one of the kinds in `inputs/`, chosen by `kind`."""

from __future__ import annotations

from functools import reduce
from operator import or_
from typing import Annotated, Any

from pydantic import Field

from viscodesign.plugins import members
from viscodesign.scene.inputs import __name__ as inputs_package
from viscodesign.scene.inputs.base import Input

INPUT_KINDS: dict[str, type[Input]] = members(inputs_package, Input)  # type: ignore[type-abstract]

AnyInput: Any = Annotated[reduce(or_, INPUT_KINDS.values()), Field(discriminator="kind")]
