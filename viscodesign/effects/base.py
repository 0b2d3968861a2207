"""What an effect is."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import TYPE_CHECKING, ClassVar, Self

import numpy as np

from viscodesign.estimate.estimate import Sketch
from viscodesign.model.system import System

if TYPE_CHECKING:
    from viscodesign.estimate.scene_quantities import SceneQuantities


class Effect(ABC):
    """One term of a balance: its options, its weight, and how it joins a system.

    A new effect is a new file in this folder with one concrete subclass; the
    catalogue, the verdicts, the documentation and the contract tests find it there.
    """

    name: ClassVar[str]
    """Its key under `effects:` in a spec."""
    order: ClassVar[int] = 50
    """Effects are told and joined in this order."""
    formula: ClassVar[str]
    """The weight, in words of the field."""
    switchable: ClassVar[bool] = True
    """Whether a spec may name it; loads that a spec states are always carried."""
    needs: ClassVar[str | None] = None
    """Another effect without which this one has nothing to act on."""
    companion: ClassVar[str | None] = None
    """Another effect that comes along when this one is switched on, unless it is forbidden."""
    free_with: ClassVar[str | None] = None
    """Another effect beside which this one costs nothing, so that `auto` keeps it."""
    validity: ClassVar[str] = ""
    """Where the term as computed here holds, in one sentence."""
    source: ClassVar[str] = ""
    """Where it is taken from."""
    keys: ClassVar[tuple[str, ...]] = ()
    """Keys of the spec that it reads."""

    @classmethod
    @abstractmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        """The effect with the options that a scene gives it."""

    @abstractmethod
    def weight(self, quantities: SceneQuantities) -> float:
        """Dimensionless size of the term against the term it competes with; >= 0."""

    def present(self, quantities: SceneQuantities) -> bool:
        """Whether the scene has what the effect acts on; if not, there is nothing to take."""
        del quantities
        return True

    def indispensable(self, quantities: SceneQuantities) -> bool:
        """Whether the scene has no sense without it."""
        del quantities
        return False

    @abstractmethod
    def reason(self, quantities: SceneQuantities) -> str:
        """What the weight says about this scene, in one clause."""

    def sketch(self, sketch: Sketch) -> Sketch | None:
        """The sketch with the term added; None where a sketch cannot show it.

        Then the weight itself, in actuator lengths, stands for what it may do to the tip.
        """
        del sketch
        return None

    def lost_pressure(self, flow: np.ndarray) -> np.ndarray | None:
        """What it takes of the pressure along each tube, at flows (T, Q) [m3/s], in size [Pa].

        By it a run that left the effect out sees whether that was right; None where the
        effect takes nothing of a flow.
        """
        del flow
        return None

    @abstractmethod
    def join(self, system: System) -> None:
        """Add the term to the system's sums."""
