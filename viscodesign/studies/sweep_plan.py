"""What a sweep is to compute: its designs, and what identifies it."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from viscodesign._version import __version__
from viscodesign.checks.plausibility import plausibility_notices
from viscodesign.errors import SpecError
from viscodesign.lazy_dataclass import dataclass
from viscodesign.results.findings import Notice
from viscodesign.results.sweep_table import Sweep, SweptColumn
from viscodesign.scene.scene import Scene
from viscodesign.studies.designs import Design, grid, latin_hypercube
from viscodesign.studies.key_values import choices_of
from viscodesign.studies.swept_keys import SweptKey, changed, swept_keys


@dataclass(frozen=True)
class SweepPlan:
    """What a sweep is to compute."""

    scene: Scene
    keys: tuple[SweptKey, ...]
    designs: tuple[Design, ...]
    sample: int | None
    seed: int | None

    @classmethod
    def of(
        cls,
        scene: Scene,
        over: Mapping[str, Any] | Sequence[str] | str,
        sample: int | None,
        seed: int,
    ) -> SweepPlan:
        """From what each key takes."""
        if not isinstance(scene, Scene):
            raise SpecError.plain(f"scene: needs a scene, such as load({scene!r}); got {scene!r}")
        keys = swept_keys(scene, choices_of(over))
        if sample is None:
            return cls(scene, tuple(keys), tuple(grid(keys)), None, None)
        designs = latin_hypercube(keys, sample, seed)
        return cls(scene, tuple(keys), tuple(designs), sample, seed)

    @property
    def words(self) -> str:
        """The plan in words, for messages."""
        names = ", ".join(key.name for key in self.keys[:4])
        more = len(self.keys) - 4
        names += f" and {more} more" if more > 0 else ""
        drawn = "" if self.sample is None else f", drawn with seed {self.seed}"
        version = f"viscodesign {__version__}"
        return f"{self.scene.name} over {names}, {len(self.designs)} rows{drawn} ({version})"

    @property
    def digest(self) -> str:
        """Equal for sweeps with the same rows of the same scene, by the same version."""
        content = __version__, [key.name for key in self.keys], self.designs
        return hashlib.sha256(self.scene.digest + repr(content).encode()).hexdigest()

    def table(self) -> Sweep:
        """Its table without results."""
        return Sweep(
            name=self.scene.name,
            version=__version__,
            spec_sha256=self.scene.source.sha256,
            status="incomplete",
            columns=tuple(self._column(key) for key in self.keys),
            designs=self.designs,
            results={},
            requested_m=self.scene.accuracy * self.scene.actuator.length,
            sample=self.sample,
            seed=self.seed,
            warnings=tuple(self._notices()),
        )

    def _column(self, key: SweptKey) -> SweptColumn:
        own = key.values
        if self.sample is None or own.listed:
            return SweptColumn(key.name, own.unit, own.grid())
        return SweptColumn(
            key.name, own.unit, None, own.low, own.high, "log" if own.is_log else "linear"
        )

    def _notices(self) -> Iterator[Notice]:
        """Values of keys that are hardly meant, once each."""
        usual = {notice.where for notice in plausibility_notices(self.scene)}
        for key in self.keys:
            own = key.values
            ends = (min(own.listed), max(own.listed)) if own.listed else (own.low, own.high)
            for value in dict.fromkeys(ends) if own.unit is not None else ():
                try:
                    other = changed(self.scene, {key: value})
                except SpecError:  # a tube by its name, or a value that its rows will refuse
                    continue
                for notice in plausibility_notices(other):
                    if notice.where == key.name and notice.where not in usual:
                        usual.add(notice.where)
                        yield notice
