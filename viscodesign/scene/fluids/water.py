"""`fluid: water`."""

from typing import ClassVar

from viscodesign.scene.fluids.base import NamedFluid


class Water(NamedFluid):
    """Ordinary water, liquid (IAPWS-95 through CoolProp)."""

    name: ClassVar[str] = "water"
    library_name: ClassVar[str] = "Water"
    gas: ClassVar[bool] = False
