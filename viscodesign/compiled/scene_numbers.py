"""From the free numbers of a scene to all numbers of its problem, with exact derivatives."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

import numpy as np

from viscodesign.compiled.branch import Branch, NumberSlopes, Stuck
from viscodesign.compiled.branch import ProblemNumbers as ProblemNumbers
from viscodesign.compiled.free_keys import SceneKeys
from viscodesign.compiled.problem_trace import CORNERS, FrozenParts, ProblemTrace, traced
from viscodesign.effects.base import Effect
from viscodesign.effects.catalogue import catalogue
from viscodesign.errors import Fault, SpecError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.scene.scene import Scene
from viscodesign.simulation.build_problem import Settings
from viscodesign.storage.lru_cache import ONE_AT_A_TIME

MAX_BRANCHES = 16
"""Formulas that are kept for values on several sides of a decision."""
NOTHING_DEPENDS = "cannot be free: nothing in this scene's equations depends on it"
"""How what is said of such numbers begins."""


class SceneNumbers:
    """The numbers of a scene's problem as a function of its free numbers.

    Made once for a scene, the effects chosen for it and a mesh, all of which stay as they are. For
    any values that `check` accepts, the results are those of a problem that `build` makes of the
    scene with these values, except for what is frozen on purpose: effects and mesh, the sizes by
    which unknowns are scaled (parameters ``size.*``), which tubes count as wide, output times, and
    stiffnesses that the scene's accuracy cannot tell from infinite.

    `at` gives the numbers, `jacobian_at` their exact derivatives. Corners move with the numbers of
    an input. Where one passes another, the start or the end of the run, or where anything else is
    decided otherwise, other formulas hold: they are made when they are first asked for, which takes
    about as long as the first ones did, and the count of stretches may then be another. At a value
    where two formulas meet, the derivatives are those of one side; at one that has formulas of its
    own, as where two corners are one, there are none, and `SpecError` names it. `push_forward` and
    `pull_back` multiply by the derivatives, which are sparse; ``branch.function`` has the formulas
    near the scene's own numbers as a CasADi function.

    Safe in threads. Raises `SpecError` for keys that cannot be free: see `FreeKeys`; where nothing
    in the equations depends on a number, unless it ``keeps_unused`` ones; or where its value stands
    in a formula as a constant.
    """

    def __init__(
        self,
        quantities: SceneQuantities,
        effects: Sequence[Effect],
        settings: Settings,
        keys: SceneKeys,
        *,
        keeps_unused: bool = False,
    ) -> None:
        self.keys = keys
        self.names = self.keys.names
        self.values = self.keys.values
        """(f,) The scene's own numbers [SI]."""
        self._frozen = FrozenParts.of(quantities, effects, settings)
        self.branch = self._branch_at(self.values)
        if faults := self.branch.stuck.faults(self.names, self.values, "cannot be free"):
            raise SpecError(faults)
        used = zip(self.names, self.branch.is_used, strict=True)
        active = {effect.name for effect in effects}
        self.unused = tuple(_unused_fault(name, active) for name, is_used in used if not is_used)
        """Of the free numbers on which nothing depends, why that is."""
        if self.unused and not keeps_unused:
            raise SpecError(self.unused)
        self._branches: tuple[Branch, ...] = (self.branch,)
        self.parameter_names = self.branch.parameter_names

    # -- values -------------------------------------------------------------------

    def check(self, values: Sequence[float] | np.ndarray) -> None:
        """Raise `SpecError` for values (f,) with their faults: which key, what is allowed.

        They must be finite, within the ranges of the spec, and make no other equations, as a load
        of zero would.
        """
        self.checked_at(values)

    def checked_at(self, values: Sequence[float] | np.ndarray) -> ProblemNumbers:
        """The numbers of the problem at values (f,); raises what `check` does."""
        given = np.asarray(values, dtype=float)
        if given.shape != self.values.shape:
            message = f"expected {len(self.values)} values, one for each free number"
            raise SpecError.plain(f"{message}; got an array of shape {given.shape}")
        if not self.keys.are_allowed(given[None])[0]:
            faults = [n.fault(float(v)) for n, v in zip(self.keys.numbers, given, strict=True)]
            raise SpecError([fault for fault in faults if fault is not None])
        return self._numbers(given)[1]

    def at(self, values: Sequence[float] | np.ndarray) -> ProblemNumbers:
        """The numbers of the problem at values (f,) that `check` accepts."""
        return self._numbers(np.asarray(values, dtype=float))[1]

    def rows_at(self, values: np.ndarray) -> Iterator[tuple[np.ndarray, ProblemNumbers]]:
        """Rows of values (m, f) that known formulas hold for, and their numbers side by side.

        Rows that are left out are such as `checked_at` refuses or makes formulas for.
        """
        left = np.flatnonzero(self.keys.are_allowed(values))
        for branch in self._branches:
            if not len(left):
                return
            is_valid, numbers = branch.rows(values[left])
            if is_valid.any():
                yield left[is_valid], numbers.row(is_valid)
            left = left[~is_valid]

    def jacobian_at(self, values: Sequence[float] | np.ndarray) -> ProblemNumbers:
        """Their derivatives, each with one more axis of length f."""
        return self._slopes(values).dense()

    def push_forward(
        self, values: Sequence[float] | np.ndarray, dots: np.ndarray
    ) -> ProblemNumbers:
        """Rates of the numbers where the values change at rates ``dots`` (f,)."""
        return self._slopes(values).push_forward(dots)

    def pull_back(self, values: Sequence[float] | np.ndarray, bars: ProblemNumbers) -> np.ndarray:
        """Gradient (f,) of the sum of ``bars`` times the numbers."""
        return self._slopes(values).pull_back(bars)

    def scene(self, values: Sequence[float] | np.ndarray) -> Scene:
        """The scene with these values, validated like a loaded one."""
        return self.keys.validated(values)

    # -- formulas -----------------------------------------------------------------

    def _slopes(self, values: Sequence[float] | np.ndarray) -> NumberSlopes:
        """The derivatives at values (f,). Raises `SpecError` where a number has none."""
        given = np.asarray(values, dtype=float)
        branch = self._branch(given)
        if faults := branch.stuck.faults(self.names, given, "has no derivative"):
            raise SpecError(faults)
        return branch.slopes(given)

    def _branch(self, values: np.ndarray) -> Branch:
        """The formulas that hold at values (f,)."""
        return self._numbers(values)[0]

    def _numbers(self, values: np.ndarray) -> tuple[Branch, ProblemNumbers]:
        """The formulas that hold at values (f,), and the numbers by them."""
        for branch in self._branches:
            numbers = branch.at(values)
            if numbers is not None:
                return branch, numbers
        found = self._branch_at(values)
        if found.structure != self.branch.structure:
            raise SpecError.plain(
                "these values make other equations than those of the compiled scene, as a number "
                "that is zero may do; compile the scene with them"
            )
        # Replaced as a whole: another thread sees either of the two.
        self._branches = (self.branch, found, *self._branches[1:][: MAX_BRANCHES - 2])
        numbers = found.at(values)
        assert numbers is not None, "formulas hold where they were traced"
        return found, numbers

    def _branch_at(self, values: np.ndarray) -> Branch:
        with ONE_AT_A_TIME:
            trace = traced(self.keys, values, self._frozen)
            return Branch(trace, self._stuck(trace, values))

    def _stuck(self, trace: ProblemTrace, values: np.ndarray) -> Stuck:
        """Numbers that the formulas, or their range, let move to neither side."""
        bounds = [number.bounds for number in self.keys.numbers]
        below = np.array([v <= b.low for v, b in zip(values, bounds, strict=True)])
        above = np.array([v >= b.high for v, b in zip(values, bounds, strict=True)])
        places = dict.fromkeys(range(len(values)), "")
        for end in trace.tape.blocked(trace.symbols, values):
            below[end.number] |= end.slope > 0.0 or end.condition.is_equality
            above[end.number] |= end.slope < 0.0 or end.condition.is_equality
            places[end.number] = end.condition.place
        for k in trace.tape.parting(trace.symbols, values):
            below[k] = above[k] = True
            places[k] = CORNERS
        return Stuck({k: places[k] for k in np.flatnonzero(below & above).tolist()})


def _unused_fault(name: str, active: Collection[str]) -> Fault:
    """Why nothing depends on a number, and which neglected effects would."""
    readers = [
        effect.name
        for effect in catalogue().values()
        if effect.name not in active and effect.reads(name)
    ]
    hint = f"; effects that would are not included: {', '.join(readers)}" if readers else ""
    return Fault(f"{NOTHING_DEPENDS}{hint}", name)
