"""`fluid: air`."""

from typing import ClassVar

from viscodesign.scene.fluids.base import NamedFluid


class Air(NamedFluid):
    """Dry air."""

    name: ClassVar[str] = "air"
    library_name: ClassVar[str] = "Air"
    gas: ClassVar[bool] = True
