"""Several actuators that were simulated side by side."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.lazy_names import module_above
from viscodesign.results.channels import trajectory_columns
from viscodesign.results.coupled_motion import CoupledMotion
from viscodesign.results.trajectory import Trajectory

if TYPE_CHECKING:
    import pandas as pd

TIME = "time_s"
"""The column that all actuators have in common."""


@dataclass(frozen=True)
class SeveralRuns:
    """The motions of several actuators, each with its effects and its error.

    Of those that share fluid these are the same: they are one system.
    """

    name: str
    """That of the scene."""
    runs: Mapping[str, Trajectory]
    """By actuator, in the order of the spec."""
    equal_to: Mapping[str, str]
    """By actuator that was not solved: the equal one that was."""
    sources: Mapping[str, Mapping[str, str]]
    """By actuator: the input that feeds each of its inlets."""
    failures: Mapping[str, str]
    """By actuator: why it has no run at all."""
    interrupted: tuple[str, ...]
    """Actuators that Ctrl-C left out."""
    spec_text: str
    """The spec as resolved, YAML, runnable again."""
    spec_sha256: str
    """SHA-256 of the spec's file as it was read, without overrides."""
    version: str
    """Version of this program."""
    coupled: tuple[CoupledMotion, ...] = ()
    """What actuators share that were solved as one system: one for each such system."""
    known_supplies: Mapping[str, dict[str, Any]] | None = None
    """`supplies` of runs that were read from files, which do not have what they follow from."""

    @property
    def status(self) -> Literal["complete", "failed", "interrupted"]:
        """The worst of all: whether every actuator has a complete run."""
        states = {run.status for run in self.runs.values()}
        if self.interrupted or "interrupted" in states:
            return "interrupted"
        return "failed" if self.failures or "failed" in states else "complete"

    @property
    def failure(self) -> str | None:
        """Why actuators have no complete run; None where all have."""
        told = {**{n: r.failure for n, r in self.runs.items() if r.failure}, **self.failures}
        together = {n: " and ".join(s.actuators) for s in self.coupled for n in s.actuators}
        lines = (f"{together.get(name, name)}: {why}" for name, why in told.items())
        return "\n".join(dict.fromkeys(lines)) or None

    def __getitem__(self, actuator: str) -> Trajectory:
        return self.runs[actuator]

    def __iter__(self) -> Iterator[str]:
        return iter(self.runs)

    def table(self) -> tuple[list[str], np.ndarray]:
        """Columns and rows (T, n) of `trajectory.csv`: those of every actuator after its name.

        What belongs to none of them comes last. Beyond the end of a run that ended early all are
        NaN.
        """
        longest = max((run.time for run in self.runs.values()), key=len, default=np.zeros(0))
        names, columns = [TIME], [np.asarray(longest)[:, None]]
        for actuator, run in self.runs.items():
            own, values = trajectory_columns(run)
            names += [f"{actuator}.{column}" for column in own[1:]]
            columns.append(_filled(values[:, 1:], len(longest)))
        for shared in self.coupled:
            found = shared.columns()
            names += list(found)
            values = np.array(list(found.values())).reshape(len(found), len(shared.time)).T
            columns.append(_filled(values, len(longest)))
        return names, np.column_stack(columns)

    def supply(self, source: str) -> tuple[np.ndarray, np.ndarray]:
        """What an input has delivered to all actuators that it feeds, over time.

        Times (T,) [s] that all of them have reached, and the volume (T,) at ambient density
        since all was filled at the baseline pressure, unloaded [m3].
        """
        linked = {name for shared in self.coupled for name in shared.actuators}
        parts = [
            (run.time, run.inflow[inlet])
            for name, run in self.runs.items()
            for inlet, own in self.sources[name].items()
            if own == source and name not in linked
        ]
        parts += [(s.time, s.inflow[source]) for s in self.coupled if source in s.inflow]
        both = min((len(time) for time, _ in parts), default=0)
        time = parts[0][0][:both] if parts else np.zeros(0)
        return np.asarray(time), np.sum([volume[:both] for _, volume in parts], axis=0)

    def supplies(self) -> dict[str, dict[str, Any]]:
        """What every input feeds, and the volume and the flow that it takes for that."""
        if self.known_supplies is not None:
            return dict(self.known_supplies)
        found: dict[str, dict[str, Any]] = {}
        named = [s for own in self.sources.values() for s in own.values()]
        for source in dict.fromkeys([*named, *(s for own in self.coupled for s in own.inflow)]):
            through = {n for own in self.coupled if source in own.inflow for n in own.actuators}
            fed = [n for n in self.runs if n in through or source in self.sources[n].values()]
            if not fed:
                continue
            time, volume = self.supply(source)
            flow = np.gradient(volume, time) if len(time) > 1 else np.zeros(1)
            found[source] = {
                "feeds": fed,
                "volume_swing_m3": float(np.ptp(volume)) if len(volume) else 0.0,
                "largest_flow_m3_s": float(np.abs(flow).max()),
            }
        return found

    def frame(self) -> pd.DataFrame:
        """The same as a table."""
        import pandas as pd

        names, values = self.table()
        return pd.DataFrame(values, columns=names)

    def summary(self) -> dict[str, Any]:
        """All runs without their arrays, ready for JSON."""
        return {
            "name": self.name,
            "version": self.version,
            "spec_sha256": self.spec_sha256,
            "resolved_sha256": hashlib.sha256(self.spec_text.encode()).hexdigest(),
            "status": self.status,
            "failure": self.failure,
            "actuators": {
                name: {
                    "sources": dict(self.sources[name]),
                    "equal_to": self.equal_to.get(name),
                    **run.summary(),
                }
                for name, run in self.runs.items()
            },
            "sources": self.supplies(),
            "share_fluid": [list(shared.actuators) for shared in self.coupled],
            "failures": dict(self.failures),
            "interrupted": list(self.interrupted),
        }

    def save(
        self, directory: str | Path, *, plots: bool = True, report: bool = True, force: bool = False
    ) -> Sequence[Path]:
        """Write the files of all runs to a folder, as `viscodesign simulate` does; returns them."""
        files: Sequence[Path] = module_above("report.several_folder").write_several(
            self, directory, plots=plots, report=report, force=force
        )
        return files

    def __repr__(self) -> str:
        return f"<SeveralRuns {self.name}: {self.status}, {', '.join(self.runs)}>"


def _filled(values: np.ndarray, rows: int) -> np.ndarray:
    """Values (T, n) with rows of NaN behind them (rows, n)."""
    filled = np.full((rows, values.shape[1]), np.nan)
    filled[: len(values)] = values
    return filled
