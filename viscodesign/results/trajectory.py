"""The result of a run: arrays, decisions, status and provenance.

Plain data. Nothing here knows how a number was computed; `report` draws it,
the command line prints it, and a script reads it.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import asdict, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, Protocol

import numpy as np

from viscodesign.lazy_dataclass import dataclass
from viscodesign.lazy_names import module_above
from viscodesign.results.channels import (
    TRAJECTORY,
    Per,
    channel,
    channels_of,
    columns_of,
    shape_columns,
)
from viscodesign.results.coefficient_band import CoefficientBand
from viscodesign.results.findings import (
    Classification,
    EffectAblation,
    Notice,
    RetryAttempt,
    Verdict,
    classification_document,
    documents,
    json_ready,
    validity_document,
)
from viscodesign.results.metrics import MetricInputs, metric_values
from viscodesign.results.motion_arrays import AbsentQuantityError, MotionArrays
from viscodesign.storage.cached_property import cached_property

if TYPE_CHECKING:
    from pathlib import Path

    import pandas as pd
    import xarray
    from matplotlib.axes import Axes

    class RunPlots(Protocol):
        """Pictures of a run, as `report.plots` draws them."""

        def tip(self, *, style: PictureStyle = ..., width: PictureWidth = ...) -> Axes: ...

        def pressures(
            self, *, style: PictureStyle = ..., width: PictureWidth = ...
        ) -> tuple[Axes, Axes]: ...

        def shapes(self, *, style: PictureStyle = ..., width: PictureWidth = ...) -> Axes: ...

    class InlinePage(Protocol):
        """The page of a run in a notebook, as `report.page.inline_page` makes it."""

        content: bytes

        def _repr_html_(self) -> str: ...


PictureStyle = Literal["plain", "paper", "talk", "dark"]
PictureWidth = str | float | None
Status = Literal["complete", "failed", "interrupted"]


@dataclass(frozen=True)
class Accuracy:
    """Requested and estimated error of the tip, over all output times [m]."""

    requested_m: float
    """As the spec asks, times the actuator length [m]."""
    estimated_tip_error_m: float | None
    """Sum of the parts below; None where the run was not verified."""
    method: str
    """How it was estimated, in words."""
    time_m: float | None = None
    """Part of the time steps."""
    space_m: float | None = None
    """Part of the mesh along the rod."""
    omitted_m: float | None = None
    """Part of the effects that were neglected by choice, without those that the spec forbids.

    Where the two above are None, theirs is in it: one distance held all parts."""


@dataclass(frozen=True)
class Cost:
    """What a run cost: wall times [s], and counts that do not depend on the machine."""

    load_s: float = 0.0
    """Starting the command and reading its spec."""
    choose_s: float = 0.0
    """Choosing the effects, before and after solving."""
    build_s: float = 0.0
    """Building the equations of the solution that was kept."""
    solve_s: float = 0.0
    """Solving them."""
    verify_s: float = 0.0
    """All other solutions: coarser ones, with fewer effects, with effects switched."""
    read_s: float = 0.0
    """From the unknowns of the kept solution to its motion, balances and warnings."""
    write_s: float = 0.0
    """Writing tables and pictures."""
    steps: int = 0
    """Time steps of the kept solution."""
    residual_calls: int = 0
    """Evaluations of its equations."""
    jacobian_calls: int = 0
    """Evaluations of their derivatives."""

    @property
    def total_s(self) -> float:
        """From the call to its end, all but writing the summary [s]: the sum of the parts."""
        solved = self.build_s + self.solve_s + self.verify_s
        return self.load_s + self.choose_s + solved + self.read_s + self.write_s

    def document(self) -> dict[str, Any]:
        """As JSON has it."""
        return {"total_s": self.total_s, **asdict(self)}


@dataclass(frozen=True)
class Invariants:
    """Balances that must hold in every run, as relative errors."""

    volume_imbalance_rel: float | None = None
    """Fluid that flowed in against fluid stored, relative to what moved."""
    energy_imbalance_rel: float | None = None
    """Work done against energy stored and dissipated, relative to what was exchanged."""
    coupling_work_j: float | None = None
    """Work created by coefficients that are not reciprocal (None without feedback)."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Trajectory(MotionArrays):
    """One run: its arrays, whose they are, and all that was found on the way.

    ``run["pressure"]`` is the array of a quantity; `results.channels` lists them. Pressures
    are gauge, relative to the ambient; lengths in m, times in s.
    """

    name: str
    """That of the scene."""
    status: Status
    """Whether it is complete, failed or was interrupted; arrays end where it ended."""
    inlets: tuple[str, ...]
    """Names of the U inlets."""
    bellows: tuple[str, ...]
    """R1..RS, then L1..LS."""
    tubes: tuple[str, ...]
    """Names of the Q tubes by their ends, such as R1-R2."""
    junctions: tuple[str, ...] = ()
    """Names of the J nodes that are neither inlets nor bellows."""
    contacts: tuple[str, ...] = ()
    """Names of the points that may touch the ground."""
    length: float
    """Actuator length [m]."""
    width: float
    """Actuator size along x (the YAML's `height`) [m], for drawing."""
    section_widths: tuple[float, ...] = ()
    """Size along x of every section, where sections differ [m]."""
    classification: Classification
    """Timescales and quadrant."""
    effects: tuple[Verdict, ...]
    """The decision on every effect."""
    accuracy: Accuracy
    """Requested and estimated error of the tip [m]."""
    cost: Cost
    """Wall times [s] and counts."""
    invariants: Invariants
    """Balances that must hold."""
    warnings: tuple[Notice, ...]
    """What the user should know, with place and time."""
    spec_text: str
    """The spec as resolved, YAML, runnable again."""
    spec_sha256: str
    """Digest of the spec's file as it was read, without overrides."""
    version: str
    """Version of this program."""
    ambient_pressure: float = 101325.0
    """Absolute [Pa]."""
    period: float | None = None
    """Time after which all inputs repeat together [s]; None where they do not."""
    uncertainty: CoefficientBand | None = None
    """How uncertain the tip is by the coefficients of its spec; None where that says nothing."""
    proof: tuple[EffectAblation, ...] = ()
    """The measured change by every effect, if that was requested."""
    ladder: tuple[RetryAttempt, ...] = ()
    """Retries where a solver had stopped, in order."""
    settings: Mapping[str, Any] = field(default_factory=dict)
    """Settings of the solver: edges, tolerance, form of rod and network."""
    failure: str | None = None
    """Why the run ended early."""
    failure_time_s: float | None = None
    """When what ended it happened [s], to all digits; None where that is not one moment."""
    notes: tuple[str, ...] = ()
    """What was read from files for its inputs, what was taken out, and what it cannot have."""
    violations: tuple[Notice, ...] = ()
    """Those of the warnings that say where the run is outside of what its model describes."""
    provenance: Mapping[str, Any] = field(default_factory=dict)
    """Versions and platform that it was computed with."""

    @property
    def sections(self) -> int:
        """Number of equal sections along the axis (bellows come in pairs)."""
        return len(self.bellows) // 2

    @property
    def inlet_pressure(self) -> dict[str, np.ndarray]:
        """Inlet name -> (T,) gauge [Pa]."""
        return dict(zip(self.inlets, self["inlet_pressure"].T, strict=True))

    @property
    def inflow(self) -> dict[str, np.ndarray]:
        """Inlet name -> (T,) fluid that it has delivered since all was filled at the baseline,
        unloaded [m3 at ambient density]; from what is stored, not from flows."""
        return dict(zip(self.inlets, self["inflow"].T, strict=True))

    @cached_property
    def metrics(self) -> Mapping[str, float]:
        """The numbers that the run comes down to, in SI; NaN where one is not defined.

        `results.metrics` lists and defines them.
        """
        return metric_values(
            MetricInputs.of(self.time, self.tip, self.pressure, self.bellows, self.period)
        )

    @property
    def validity(self) -> Literal["inside", "outside"]:
        """Whether the run stays within what its model describes; elsewhere its stated error is
        that of a model that does not hold."""
        return "outside" if self.violations else "inside"

    @property
    def error_qualifier(self) -> str:
        """Which model the stated error belongs to, in words; empty where the scene had its
        choice."""
        if self.violations:
            return "of a model that does not hold here"
        pinned = any(v.present and not v.taken and v.mode == "off" for v in self.effects)
        return "of the model as pinned" if pinned else ""

    def with_time(self, **parts: float) -> Trajectory:
        """The same with parts of its cost replaced: ``load_s``, ``write_s`` [s]."""
        return replace(self, cost=replace(self.cost, **parts))  # type: ignore[arg-type]

    def members(self, per: Per) -> tuple[str, ...]:
        """Names of what a quantity has one value of."""
        return {
            Per.INLET: self.inlets,
            Per.BELLOW: self.bellows,
            Per.TUBE: self.tubes,
            Per.JUNCTION: self.junctions,
            Per.CONTACT: self.contacts,
            Per.SECTION: tuple(str(k + 1) for k in range(self.sections)),
        }[per]

    def save(
        self,
        directory: str | Path,
        *,
        plots: bool = True,
        report: bool = True,
        force: bool = False,
        picture_format: Literal["png", "pdf", "svg"] = "png",
        style: PictureStyle = "plain",
        width: PictureWidth = None,
    ) -> list[Path]:
        """Write the run's files to a folder, as `viscodesign simulate` does; returns them.

        ``plots``, ``report``: whether pictures and the page are written. ``style`` and ``width``
        of the pictures: as `--style` and `--width` have them, ``width`` `single`, `double` or a
        number [mm]. Raises `UsageError` for others, where the folder cannot be written, or
        (without ``force``) holds files that are not of a run.
        """
        pictures = module_above("report.picture_options").picture_options(
            picture_format, style, width
        )
        files: list[Path] = module_above("report.run_folder").write_run(
            self, directory, plots=plots, report=report, force=force, pictures=pictures
        )
        return files

    @staticmethod
    def read(directory: str | Path) -> Trajectory:
        """The run in a folder, to the last digit of its tables.

        Quantities that no table has, such as ``volume``, are absent from ``arrays``. Raises
        `UsageError` where the folder holds no complete run.
        """
        found: Trajectory = module_above("report.read_run").read_run(directory)
        return found

    @property
    def plot(self) -> RunPlots:
        """Pictures to look at: ``plot.tip()``, ``plot.pressures()``, ``plot.shapes()``.

        Each draws a new figure of pyplot and returns its axes; ``style`` and ``width`` are those of
        `--style` and `--width`.
        """
        plots: RunPlots = module_above("report.plots").TrajectoryPlots(self)
        return plots

    def to_xarray(self) -> xarray.Dataset:
        """All arrays with named dimensions, coordinates and units (needs the package xarray).

        Dimensions: time, inlet, bellow, tube, junction, section, arc, shape_time.
        """
        dataset: xarray.Dataset = module_above("report.dataset").dataset(self)
        return dataset

    def __repr__(self) -> str:
        error, requested = self.accuracy.estimated_tip_error_m, self.accuracy.requested_m
        stated = "not estimated" if error is None else f"{1e3 * error:.3g} mm"
        times = f"{len(self.time)} times to {self.time[-1]:g} s" if len(self.time) else "no times"
        return (
            f"<Trajectory {self.name}: {self.status}, {times}, {len(self.bellows)} bellows, "
            f"tip error {stated} (requested {1e3 * requested:.3g} mm)>"
        )

    def _repr_html_(self) -> str:
        """What a notebook shows: a table, and the path of the tip."""
        shown: str = module_above("report.notebook").trajectory_html(self)
        return shown

    @property
    def interrupted_afterwards(self) -> str:
        """What is said of a complete run when the user stopped what came after it."""
        done = len(self.proof)
        measured = f" while effects were measured, {done} of them done" if done else " afterwards"
        return f"interrupted{measured}: the run itself is complete"

    def summary(self) -> dict[str, Any]:
        """The run without its arrays, ready for JSON (numbers that are not finite as None).

        ``proof`` is there where it was asked for; ``uncertainty`` is None where there is no band.
        """
        document = {
            "name": self.name,
            "version": self.version,
            "spec_sha256": self.spec_sha256,
            "resolved_sha256": hashlib.sha256(self.spec_text.encode()).hexdigest(),
            "status": self.status,
            "failure": self.failure,
            "failure_time_s": self.failure_time_s,
            **{
                key: value
                for key, value in classification_document(self.classification).items()
                if key not in ("name", "warnings")
            },
            "metrics": self.metrics,
            "validity": validity_document(self.violations),
            "effects": documents(self.effects),
            **({"proof": documents(self.proof)} if self.proof else {}),
            "accuracy": asdict(self.accuracy),
            "uncertainty": self.uncertainty.document() if self.uncertainty else None,
            "cost": self.cost.document(),
            "invariants": asdict(self.invariants),
            "ladder": documents(self.ladder),
            "settings": dict(self.settings),
            "provenance": {**self.provenance, "settings": dict(self.settings)},
            "notes": list(self.notes),
            "warnings": documents(self.warnings),
        }
        return dict(json_ready(document))

    def report(self, file: str | Path) -> Path:
        """Write the page of the run, one self-contained HTML file; returns its path.

        Raises `UsageError` where it cannot be written.
        """
        return Path(module_above("report.page.page").write_page(self, file))

    def page(self, height: int = 720) -> InlinePage:
        """The page of the run for the output of a notebook's cell, ``height`` pixels high."""
        page: InlinePage = module_above("report.page.inline_page").inline_page(self, height)
        return page

    def film(
        self,
        file: str | Path,
        *,
        speed: float | None = None,
        frames_per_second: int = 25,
        width: int = 960,
        transparent: bool = False,
        dark: bool = False,
        pressures: bool = True,
    ) -> Path:
        """Write a film of the run in 16:9 and return its path: GIF or WebP, or MP4 with ffmpeg.

        ``speed``: seconds of motion in a second of film; None: real time, or about eight seconds
        in all. ``width`` [pixel]. ``transparent`` instead of a ground, not for MP4; ``dark``:
        light lines on a dark one. ``pressures``: whether they are drawn against time beside the
        actuator. Raises `UsageError` where it cannot be made or written.
        """
        made = module_above("report.film.film").write_film(
            self,
            file,
            speed=speed,
            frames_per_second=frames_per_second,
            width=width,
            transparent=transparent,
            dark=dark,
            pressures=pressures,
        )
        return Path(made)

    def frame(self, *quantities: str) -> pd.DataFrame:
        """Quantities against time, by their names; without any, `trajectory.csv`.

        Raises `AbsentQuantityError`, a `KeyError`.
        """
        import pandas as pd

        try:
            chosen = [channel(name) for name in quantities] or channels_of(TRAJECTORY)
        except KeyError as error:
            raise AbsentQuantityError(str(error.args[0]), list(self.arrays)) from None
        names, values = columns_of(chosen, self)
        return pd.DataFrame(values, columns=names)

    def shape_frame(self) -> pd.DataFrame:
        """The axis at the times of its shapes: `shape.csv`."""
        import pandas as pd

        names, values = shape_columns(self)
        return pd.DataFrame(values, columns=names)


class RunInterruptedError(KeyboardInterrupt):
    """Ctrl-C ended a run; ``trajectory`` is what it came to, None before its first step."""

    def __init__(self, trajectory: Trajectory | None) -> None:
        self.trajectory = trajectory
        message = "interrupted"
        if trajectory is not None:
            message = trajectory.failure or trajectory.interrupted_afterwards
        super().__init__(message)
