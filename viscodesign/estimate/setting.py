"""What all estimates of one scene share."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from typing import Any, TypeVar

import numpy as np

from viscodesign.estimate.linear_network import LinearNetworks, UniformNetworks
from viscodesign.estimate.modal_response import FilterStart
from viscodesign.estimate.sample_grid import SampleGrid
from viscodesign.model.bellow_law import BellowLaws
from viscodesign.model.rod import Body
from viscodesign.model.scene_number import Numbers
from viscodesign.scene.scene import Scene
from viscodesign.storage.cached_property import cached_property

T = TypeVar("T")

TIME_OF_MODES = 0.25
"""Part of the run in which a flow's inertance is compared with its resistance."""
PIECES = 8
"""Pieces of the axis of an estimate."""
STIFFEST = 1e6
"""Stiffness of a blocked piece over that of the uniform rod."""


class EstimateSetting:
    """A scene in the numbers that estimates need: times, drives, network and stiffnesses."""

    def __init__(
        self,
        scene: Scene,
        body: Body,
        law: BellowLaws,
        resistances: Mapping[str, float],
        barrels: Mapping[str, float],
        swing: float,
    ) -> None:
        self._scene = scene
        self._grid = SampleGrid(scene)
        self.syringes = dict(barrels)
        """Volume per pressure of the barrel of every syringe [m3/Pa]."""
        self._memory: dict[Hashable, Any] = {}
        self.averages: dict[Hashable, Any] = {}
        """Networks with their means over the motion, by what they depend on."""
        self.first_pressures: dict[Hashable, np.ndarray] = {}
        """Pressures of all nodes (N, T) before any mean is known, by what they depend on [Pa]."""
        self.length = body.length
        self.sections = body.sections
        self.mass_per_length = body.mass_per_length
        self.bending_stiffness = body.bending_stiffness
        self.extension_stiffness = body.extension_stiffness
        self._varied = body.varied
        self.compliance = law.compliance
        self.rest_volume = law.rest_volume
        self.curvature = law.curvature_per_pressure
        self.stretch = law.stretch_per_pressure
        self.ambient = scene.ambient_pressure
        self.baseline = scene.gauge_pressure
        self.swing = swing
        self.start = FilterStart(scene.run.start)
        self.graph = scene.graph
        self.bellows = len(self.graph.bellows)
        self.resistance = np.array([resistances[t.name] for t in self.graph.tubes])
        self.pieces = PIECES

    def remembered(self, key: Hashable, make: Callable[[], T]) -> T:
        """The value made for this key before, or made now."""
        if key not in self._memory:
            self._memory[key] = make()
        found: T = self._memory[key]
        return found

    @property
    def time(self) -> np.ndarray:
        """Samples (T,); the start and each corner twice [s]."""
        return self._grid.time

    @property
    def is_cut(self) -> bool:
        """Whether estimates end before an input that does not repeat itself does."""
        return self._grid.is_cut

    @property
    def output_mask(self) -> np.ndarray:
        """Indices of the samples that are output times (n,)."""
        return self._grid.output_mask

    # -- network --------------------------------------------------------------

    @cached_property
    def pressure_inlets(self) -> list[str]:
        """Inlets whose pressure is given."""
        inputs = self._scene.inputs
        return [name for name in self.graph.inlets if inputs[name].gives_pressure]

    @cached_property
    def drive(self) -> np.ndarray:
        """Pressures of the inlets above the baseline (U, T) [Pa]."""
        rows = [self._grid.values(name) for name in self.pressure_inlets]
        return np.array(rows).reshape(len(rows), len(self.time))

    def _pushed(self, nodes: tuple[str, ...]) -> np.ndarray:
        """Volume that plungers push into every node (N, T) [m3]."""
        pushed = np.zeros((len(nodes), len(self.time)))
        for name in self.syringes:
            pushed[nodes.index(name)] = self._grid.values(name)
        return pushed

    def stores(self, names: Iterable[str]) -> tuple[str, ...]:
        """Those of these nodes that store without being a bellow, and the syringes."""
        return (*(n for n in names if n in self.graph.junctions), *self.syringes)

    def nodes_storing(self, names: Iterable[str]) -> tuple[str, ...]:
        """All nodes that store, where these nodes do so besides: the bellows first."""
        return (*self.graph.bellows, *self.stores(names))

    def stored(self, nodes: tuple[str, ...], storage: Sequence[Mapping[str, float]]) -> np.ndarray:
        """Volume per pressure of nodes besides the bellows' own, for several networks (S, N)."""
        both = [{**own, **self.syringes} for own in storage]
        return np.array([[own.get(n, 0.0) for n in nodes] for own in both])

    def networks(
        self,
        nodes: tuple[str, ...],
        stored: np.ndarray,
        compliance: np.ndarray,
        multiplier: np.ndarray,
        inertance: np.ndarray,
        uniform: bool,
    ) -> LinearNetworks | UniformNetworks:
        """Linear networks of ``nodes``, bellows with a ``compliance`` (S, B), and tubes (S, Q).

        ``stored`` (S, N): see `stored`; ``multiplier``: of the tubes' resistance.
        """
        capacity = stored.copy()
        capacity[:, : self.bellows] += compliance
        pushed = self.remembered(("pushed", nodes), lambda: self._pushed(nodes))
        if uniform:
            return self._uniform(nodes, capacity, pushed)
        resistance = self.resistance * multiplier
        impedance = resistance + inertance / (TIME_OF_MODES * self.time[-1])
        incidence = self.remembered(("incidence", nodes), lambda: self._incidence(nodes))
        known = len(nodes) + len(self.pressure_inlets)
        tubes = self._tubes(incidence, known, 1 / impedance)
        ends = np.abs(incidence[:, :known])
        leaving = incidence[:, : len(nodes)].T @ tubes
        return LinearNetworks(
            self.time,
            leaving[..., : len(nodes)],
            -leaving[..., len(nodes) :],
            capacity,
            self.drive,
            pushed,
            self.baseline,
            inertance,
            resistance,
            impedance,
            self.start,
            tubes,
            ends / np.maximum(ends.sum(axis=1, keepdims=True), 1.0),
        )

    def _uniform(
        self, nodes: tuple[str, ...], capacity: np.ndarray, pushed: np.ndarray
    ) -> UniformNetworks:
        held = np.full((len(nodes), len(self.time)), self.baseline)
        sealed = []
        for part in self.graph.components():
            names = set(part.nodes)
            own = np.array([k for k, n in enumerate(nodes) if n in names], dtype=int)
            inlets = [n for n in part.inlets if n in self.pressure_inlets]
            if inlets:
                held[own] = self.baseline + self.drive[self.pressure_inlets.index(inlets[0])]
            elif own.size:
                sealed.append(own)
        return UniformNetworks(held, tuple(sealed), capacity, pushed, self.baseline)

    def _incidence(self, nodes: tuple[str, ...]) -> np.ndarray:
        """Which tube leaves (1) or comes to (-1) which node: storing, inlets, bare (Q, ...)."""
        bare = [n for n in self.graph.junctions if n not in nodes]
        names = {n: k for k, n in enumerate([*nodes, *self.pressure_inlets, *bare])}
        incidence = np.zeros((len(self.graph.tubes), len(names)))
        for k, tube in enumerate(self.graph.tubes):
            incidence[k, names[tube.start]], incidence[k, names[tube.end]] = 1.0, -1.0
        return incidence

    def _tubes(self, incidence: np.ndarray, kept: int, conductance: np.ndarray) -> np.ndarray:
        """Flow of every tube per pressure of the first ``kept`` nodes, bare ones out.

        ``conductance`` (S, Q); (S, Q, kept).
        """
        flows = conductance[..., None] * incidence
        if kept == incidence.shape[1]:
            return np.asarray(flows)
        balance = incidence[:, kept:].T @ flows
        follow = -np.linalg.solve(balance[..., kept:], balance[..., :kept])
        return np.asarray(flows[..., :kept] + flows[..., kept:] @ follow)

    @cached_property
    def straight(self) -> np.ndarray:
        """Ends x, z of the pieces of the unstrained axis (2, K) [m]."""
        along = self.length * np.arange(1, self.pieces + 1) / self.pieces
        return np.stack([np.zeros(self.pieces), along])

    @cached_property
    def spread(self) -> np.ndarray:
        """Part of every piece that each section takes up (K, S): strains of pieces are means."""
        ends = np.linspace(0.0, 1.0, self.pieces + 1)
        joints = np.linspace(0.0, 1.0, self.sections + 1)
        upper = np.minimum(ends[1:, None], joints[None, 1:])
        lower = np.maximum(ends[:-1, None], joints[None, :-1])
        return np.asarray(np.maximum(upper - lower, 0.0) * self.pieces)

    @cached_property
    def piece_masses(self) -> Numbers:
        """Mass per length of every piece, one for all or (K,) [kg/m]."""
        varied = self._varied
        if varied is None or not isinstance(varied.mass_per_length, np.ndarray):
            return self.mass_per_length
        return np.asarray(self.spread @ varied.mass_per_length)

    @cached_property
    def piece_stiffnesses(self) -> tuple[Numbers, Numbers]:
        """In bending [N m2] and extension [N] of every piece, each one for all or (K,)."""
        if self._varied is None:
            return self.bending_stiffness, self.extension_stiffness
        bending = self._softened(self._varied.bending_stiffness, self.bending_stiffness)
        return bending, self._softened(self._varied.extension_stiffness, self.extension_stiffness)

    def _softened(self, stiffness: Numbers, typical: float) -> Numbers:
        """Stiffness of every piece under a load that all of its sections carry (K,)."""
        compliance = self.spread @ (1 / (stiffness * np.ones(self.sections)))
        return np.asarray(1 / np.maximum(compliance, 1 / (STIFFEST * typical)))

    @cached_property
    def share(self) -> np.ndarray:
        """Part of every section that each piece is (K, S): each column adds up to one."""
        return np.asarray(self.spread / self.spread.sum(axis=0))
