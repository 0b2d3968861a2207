"""Scenes with free numbers for tests, and the same problems built anew."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from viscodesign.compiled.free_keys import FreeKeys, candidates
from viscodesign.compiled.problem_trace import FrozenParts
from viscodesign.compiled.scene_numbers import ProblemNumbers, SceneNumbers
from viscodesign.effects.base import Effect
from viscodesign.effects.select import Selection, select_effects
from viscodesign.errors import SpecError
from viscodesign.estimate.scene_quantities import SceneQuantities
from viscodesign.model.chain import Chain
from viscodesign.model.formulation import settle
from viscodesign.scene.scene import Scene
from viscodesign.simulation.build_problem import (
    Settings,
    assemble,
    pieces_between,
    sizes_of,
    stops_of,
    suggest_settings,
)

SHARED = ("network.tube_length", "network.tube_radius")
"""Keys that overlap with those of single tubes."""
FROZEN = "size."
"""Beginning of the names of parameters that stay as they are."""


@dataclass(frozen=True)
class Case:
    """A scene with its effects and mesh."""

    quantities: SceneQuantities
    selection: Selection
    settings: Settings

    @cached_property
    def usable(self) -> list[str]:
        """Keys that can be free, all at once."""
        keys = [key for key in candidates(self.quantities.scene) if key not in SHARED]
        while True:
            try:
                self.numbers(*keys)
                return keys
            except SpecError as error:
                refused = {_pattern(fault.key) for fault in error.faults}
                left = [key for key in keys if _pattern(key) not in refused]
                if len(left) == len(keys):
                    raise
                keys = left

    @classmethod
    def of(cls, scene: Scene) -> Case:
        quantities = SceneQuantities(scene)
        selection = select_effects(quantities)
        return cls(quantities, selection, suggest_settings(quantities, selection.effects))

    @property
    def scene(self) -> Scene:
        return self.quantities.scene

    def numbers(self, *free: str) -> SceneNumbers:
        keys = FreeKeys(self.scene, free)
        return SceneNumbers(self.quantities, self.selection.effects, self.settings, keys)

    def effects(self, quantities: SceneQuantities) -> list[Effect]:
        return [type(effect).of(quantities) for effect in self.selection.effects]

    def rebuilt(self, scene: Scene) -> dict[str, np.ndarray]:
        """The numbers of a scene by the code that builds problems, without its formulas."""
        quantities = SceneQuantities(scene)
        rod = Chain(quantities.body, self.settings.edges_per_section)
        frozen = FrozenParts.of(self.quantities, [], self.settings)
        body = frozen.body_of(quantities)
        system = assemble(quantities, self.effects(quantities), rod, body)
        settle(system, sizes_of(quantities))
        stops = stops_of(scene)
        pieces, initial = pieces_between(scene, stops)
        named = system.numbers().items()
        parameters = np.array([v for name, v in named if not name.startswith(FROZEN)])
        found = dict(parameters=parameters, pieces=pieces, initial_piece=initial, stops=stops)
        cycle_stops, cycle_pieces = np.zeros(0), np.zeros((0, len(initial)))
        if scene.run.start == "periodic":
            cycle_stops = stops_of(scene, scene.period)
            cycle_pieces, _ = pieces_between(scene, cycle_stops)
        return {**found, "cycle_pieces": cycle_pieces, "cycle_stops": cycle_stops}


def _pattern(key: str) -> str:
    """A key with every row or tube in the place of one."""
    head, bracket, tail = key.partition("[")
    return head + ("[*]" + tail.partition("]")[2] if bracket else "")


def of_build(numbers: SceneNumbers, found: ProblemNumbers) -> dict[str, np.ndarray]:
    """Without what is frozen on purpose."""
    own = np.array([not name.startswith(FROZEN) for name in numbers.parameter_names])
    return {**found._asdict(), "parameters": found.parameters[own]}


def valid_values(numbers: SceneNumbers, size: float) -> np.ndarray:
    """Values that differ from the scene's by a part of their size, up or down.

    Those of inputs by less where their corners would change their order.
    """
    random = np.random.default_rng(7)
    of_input = np.array([name.startswith("input") for name in numbers.names])
    for trial in range(100):
        signs = random.uniform(-1.0, 1.0, len(numbers.values))
        sizes = np.where(of_input & (trial > 20), size / 10, size)
        values = numbers.values * (1 + sizes * signs)
        try:
            numbers.check(values)
        except SpecError:
            continue
        return values
    raise AssertionError("no valid values near those of the scene")


def assert_equal(found: dict[str, np.ndarray], wanted: dict[str, np.ndarray], rel: float) -> None:
    for name, array in wanted.items():
        size = np.max(np.abs(array), initial=1e-300)
        assert found[name].shape == array.shape, name
        np.testing.assert_allclose(found[name], array, rtol=rel, atol=1e-16 * size, err_msg=name)


def assert_slopes(here: Case, numbers: SceneNumbers, values: np.ndarray, rel: float) -> None:
    """Derivatives against central differences of rebuilt numbers along random directions, each of
    which has every number in it.
    """
    dense, at = numbers.jacobian_at(values), of_build(numbers, numbers.at(values))
    random = np.random.default_rng(3)
    for _ in range(3):
        step = 1e-5 * values * random.uniform(-1.0, 1.0, len(values))
        ends = [here.rebuilt(numbers.keys.placed(values + side * step)) for side in (1, -1)]
        for name, slopes in of_build(numbers, dense).items():
            wanted = (ends[0][name] - ends[1][name]) / 2
            allowed = rel * np.abs(wanted) + 1e-13 * np.abs(at[name])
            assert np.all(np.abs(slopes @ step - wanted) <= allowed), name
