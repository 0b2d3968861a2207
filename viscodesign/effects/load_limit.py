"""The largest load of a rod that a mesh can follow."""

from __future__ import annotations

from collections.abc import Iterator

from viscodesign.errors import Fault
from viscodesign.estimate.scene_quantities import SceneQuantities

LARGEST_LOAD = 1e5
"""Force over EI/l2 beyond which a rod would turn within a thousandth of its length."""


def load_faults(quantities: SceneQuantities, load: float, key: str) -> Iterator[Fault]:
    """A fault where a load [N] bends the rod too sharply."""
    unit = quantities.bending_force
    if not load <= LARGEST_LOAD * unit:
        yield Fault(
            f"{load:.3g} N is {load / unit:.3g} times EI/l2 = {unit:.3g} N; a rod with this "
            f"load bends too sharply to be resolved (at most {LARGEST_LOAD:g} times)",
            key,
        )
