"""What an effect is."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from enum import Enum
from typing import TYPE_CHECKING, Any, ClassVar, Self

from viscodesign.errors import Fault, UsageError
from viscodesign.estimate.term import EstimateTerm
from viscodesign.lazy_dataclass import dataclass
from viscodesign.model.system import System
from viscodesign.references import LiteratureReference
from viscodesign.results.findings import Notice
from viscodesign.scene.effects_choice import EFFECTS, MODE, EffectsChoice, Mode
from viscodesign.scene.spec_part import SpecPart
from viscodesign.solve.obstacles import Obstacle

if TYPE_CHECKING:
    from viscodesign.estimate.scene_quantities import SceneQuantities
    from viscodesign.postprocess.motion import Motion
    from viscodesign.postprocess.motion_limits import Limit
    from viscodesign.solve.problem import Problem
    from viscodesign.solve.statics import Start


class Trait(Enum):
    """What an effect makes of the model, for code that must not know its name."""

    DISTRIBUTED_PRESSURE = "every node of a network has a pressure of its own"
    COMPRESSIBLE_FLUID = "the fluid in bellows and tubes is compressible"
    TUBE_STORAGE = "tubes hold fluid of their own"
    LIMITED_EMPTYING = "the law of a bellow keeps it from emptying"
    ROD_INERTIA = "the rod resists acceleration"
    ROD_DAMPING = "strain rates of the rod dissipate"
    CONTACT = "the rod may touch a rigid surface"
    FLOW_LOSSES = "flow loses pressure by its inertia, at the ends of tubes or in turbulence"


@dataclass(frozen=True)
class Missed:
    """Why a solved run calls for an effect that it neglected."""

    reason: str
    tip_m: float
    """How far the effect may move the tip; infinite where the run cannot go on without it [m]."""
    time_s: float
    """Where the run showed it [s]."""
    leaves_validity: bool = False
    """Whether the run is outside of its model without the effect, however little the tip moves."""


class Effect(ABC):
    """One term of a balance, with everything of its own.

    1. A new effect is a new file in this folder with one concrete subclass. The catalogue, the
       verdicts, the checks, the documentation and the contract tests find it there; no other
       file names it.
    2. `of`, `weight`, `reason` and `join` are required; every other hook has a default.
    3. Hooks that are given ``active``, the names of the effects to be simulated, are asked whether
       the effect itself is among them or not: what its absence means is its own knowledge, too.
    4. Code outside asks for `traits`, never for a name.
    """

    name: ClassVar[str]
    """Its key under `effects:` in a spec."""
    order: ClassVar[int] = 50
    """Effects are listed and joined in this order."""
    formula: ClassVar[str]
    """The weight, in words of the field."""
    own_rule: ClassVar[str] = ""
    """How a spec decides on it, in a sentence, where `others` does not."""
    needs: ClassVar[tuple[str, ...]] = ()
    """Other effects without each of which this one has nothing to act on."""
    companion: ClassVar[str | None] = None
    """Another effect that is included with this one, unless the spec switches it off."""
    free_with: ClassVar[str | None] = None
    """Another effect beside which this one costs nothing, so that `auto` keeps it."""
    replaced_by: ClassVar[str | None] = None
    """Another effect that takes the place of this one wherever the scene has it."""
    considers: ClassVar[str | None] = None
    """Another effect whose mode in the spec decides what this one acts on."""
    traits: ClassVar[frozenset[Trait]] = frozenset()
    remedies: ClassVar[Mapping[Obstacle, str]] = {}
    """What stops a run without it, and a clause on how to include it: "set effects.x to auto"."""
    validity: ClassVar[str] = ""
    """Where the term as computed here holds, in one sentence."""
    source: ClassVar[str] = ""
    """Where it is taken from."""
    references: ClassVar[tuple[LiteratureReference, ...]] = ()
    """What to cite for it."""
    keys: ClassVar[tuple[str, ...]] = ()
    """Keys of the spec that it reads, but for those below its own."""
    options: ClassVar[type[SpecPart] | None] = None
    """Its own keys, which stand below `effects.NAME` beside `mode`; each has a default."""

    def __init_subclass__(cls, **given: Any) -> None:
        super().__init_subclass__(**given)
        if "options" in vars(cls) and cls.options is not None:
            _refuse_options(cls, cls.options)

    # -- whether it matters -----------------------------------------------------

    @classmethod
    def mode_in(cls, choice: EffectsChoice) -> Mode:
        """Its mode by the spec, before what other effects need."""
        is_named = not cls.own_rule or cls.name in choice.modes
        return choice.mode(cls.name) if is_named else "auto"

    @classmethod
    def reads(cls, key: str) -> bool:
        """Whether it reads a key of the spec, or a section in which the key stands."""
        own = () if cls.options is None else (f"{EFFECTS}.{cls.name}",)
        return any(key == read or key.startswith(f"{read}.") for read in (*cls.keys, *own))

    @classmethod
    @abstractmethod
    def of(cls, quantities: SceneQuantities) -> Self:
        """The effect with the options that a scene gives it."""

    @abstractmethod
    def weight(self, quantities: SceneQuantities) -> float:
        """Dimensionless size of the term against the term it competes with; >= 0."""

    @abstractmethod
    def reason(self, quantities: SceneQuantities) -> str:
        """What the weight means for this scene, in one clause."""

    def present(self, quantities: SceneQuantities) -> bool:
        """Whether the scene has what the effect acts on; if not, it is not applicable."""
        del quantities
        return True

    def indispensable(self, quantities: SceneQuantities) -> bool:
        """Whether the scene requires it."""
        del quantities
        return False

    def estimate_term(self) -> EstimateTerm | None:
        """Its contribution to a quick estimate of the motion; None where there is none.

        Then the weight itself, in actuator lengths, is taken as the displacement of the tip.
        """
        return None

    # -- the term ---------------------------------------------------------------

    @abstractmethod
    def join(self, system: System) -> None:
        """Add the term to the system's sums.

        A dissipation must be quadratic in the rod's rates, P(2v) = 4 P(v): its force is half the
        gradient of the power. `SpecError` where it is not, of an effect from another package.
        """

    def node_storage(self, node: str, compressible: bool) -> tuple[float, float]:
        """What it makes a node hold: volume at zero gauge [m3], and volume per pressure [m3/Pa].

        ``compressible``: whether the density of the fluid follows pressure.
        """
        del node, compressible
        return 0.0, 0.0

    # -- what a user is told ----------------------------------------------------

    def numeric_faults(self, quantities: SceneQuantities) -> Iterator[Fault]:
        """Numbers of a scene that double precision cannot carry, unless the spec switches it off.

        Asked before any effect is weighed.
        """
        del quantities
        return iter(())

    def changed_default(self, quantities: SceneQuantities) -> str:
        """What the spec leaves unsaid and earlier versions took otherwise, and what to write.

        Empty where the spec says it.
        """
        del quantities
        return ""

    def refusals(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Fault]:
        """Why the scene has no bounded solution with these effects."""
        del quantities, active
        return iter(())

    def warnings(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Notice]:
        """Assumptions that the numbers of the scene violate, before anything is solved."""
        del quantities, active
        return iter(())

    def limits(self, quantities: SceneQuantities, active: frozenset[str]) -> Iterator[Limit]:
        """Bounds on the motion beyond which the model with these effects is doubtful."""
        del quantities, active
        return iter(())

    def start_warnings(
        self, quantities: SceneQuantities, active: frozenset[str], problem: Problem, start: Start
    ) -> Iterator[Notice]:
        """What the first state of a run shows."""
        del quantities, active, problem, start
        return iter(())

    def missed_in(
        self, quantities: SceneQuantities, problem: Problem, motion: Motion
    ) -> Missed | None:
        """What a run that neglects the effect shows of it; None where nothing calls for it."""
        del quantities, problem, motion
        return None


def _refuse_options(effect: type[Effect], options: type[SpecPart]) -> None:
    """Raise `UsageError` for options that a spec could not leave out, or that hide the mode."""
    for name, found in options.model_fields.items():
        key = found.alias or name
        if found.is_required() or key == MODE:
            wrong = "is the key of the effect's mode" if key == MODE else "has no default"
            raise UsageError(
                f"{effect.__module__}: {options.__name__}.{name}: {wrong}; every option of an "
                f"effect has a default and another name than '{MODE}'"
            )
