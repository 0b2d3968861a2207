"""What an effect is."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING, ClassVar, Self

from viscodesign.model.system import System

if TYPE_CHECKING:
    from viscodesign.effects.conditions import Conditions


class Effect(ABC):
    """One term of a balance: its options, its weight, and how it joins a system.

    A new effect is a new file in this folder with one concrete subclass; the
    catalogue, the verdicts and the contract tests find it there.
    """

    name: ClassVar[str]
    """Its key under `effects:` in a spec."""
    order: ClassVar[int] = 50
    """Effects are judged and joined in this order: a later one may ask what was taken."""
    formula: ClassVar[str]
    """The weight, in words of the field."""
    switchable: ClassVar[bool] = True
    """Whether a spec may name it; loads that a spec states are always carried."""

    @classmethod
    @abstractmethod
    def of(cls, conditions: Conditions) -> Self:
        """The effect with the options that a scene gives it."""

    @abstractmethod
    def weight(self, conditions: Conditions) -> float:
        """Dimensionless size of the term against the term it competes with; >= 0."""

    def threshold(self, conditions: Conditions) -> float:
        """Weight from which `auto` takes the effect: its share of the accuracy asked for."""
        return SHARE_OF_ACCURACY * conditions.accuracy

    def present(self, conditions: Conditions) -> bool:
        """Whether the scene has what the effect acts on; if not, there is nothing to take."""
        del conditions
        return True

    @abstractmethod
    def reason(self, conditions: Conditions) -> str:
        """What the weight says about this scene, in one clause."""

    @abstractmethod
    def join(self, system: System) -> None:
        """Add the term to the system's sums."""


SHARE_OF_ACCURACY = 0.2
"""Part of the accuracy that one omitted effect may spend."""
